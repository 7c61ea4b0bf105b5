// SPDX-License-Identifier: MIT
// OpenGL 1.5's equations for vertices and fragments, written down from the specification in double,
// as a truth to compare with. `Fault` plants an error, so that a comparison can be seen to fail.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "libsmart/shading/fixed_function.h"

namespace smart::test {

enum class Fault {
    None, HalfwayNotNormalised, NoAttenuation, SpotCosineOfTwice, EyeAtInfinity, SidesSwapped,
    ModelAmbientTwice, AlphaOfAmbient, SecondaryLost, NotNormalised, SphereWithoutHalf,
    MatrixTransposed, TexelAlphaIgnored, ArgumentsSwapped, NoScale, FogOfTwice, FogOfAlpha
};

using Vec3 = std::array<double, 3>;
using Vec4 = std::array<double, 4>;

inline double dot(const Vec3& a, const Vec3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vec3 normalised(const Vec3& a) {
    const double length = std::sqrt(dot(a, a));
    return length > 0 ? Vec3{a[0] / length, a[1] / length, a[2] / length} : Vec3{};
}
inline double clamp01(double x) {
    return std::min(std::max(x, 0.0), 1.0);
}
template <class V>
Vec4 four(const V& v) {
    return {double(v[0]), double(v[1]), double(v[2]), double(v[3])};
}
template <class V>
Vec3 three(const V& v) {
    return {double(v[0]), double(v[1]), double(v[2])};
}

/// Section 2.10.3, the last step.
inline Vec3 referenceNormal(const FixedState& state, const FixedVertex& v, Fault fault) {
    Vec3 n = three(v.normal);
    if (state.lighting.rescaleNormal)
        for (double& x : n) x *= v.normalScale;
    return state.lighting.normalize && fault != Fault::NotNormalised ? normalised(n) : n;
}

struct ReferenceColors {
    Vec4 primary;
    Vec3 secondary;
};

/// Section 2.13.1 with 2.13.3 (colour material) and 2.13.6 (clamping).
inline ReferenceColors referenceLighting(const FixedState& state, const FixedVertex& v, bool back,
                                         Fault fault = Fault::None) {
    const FixedLighting& lighting = state.lighting;
    if (!lighting.enabled) {
        ReferenceColors colors{four(v.color), {}};
        for (double& x : colors.primary) x = clamp01(x);
        return colors;
    }
    if (fault == Fault::SidesSwapped) back = !back;
    const bool useBack = back && lighting.twoSided;
    const FixedMaterials initial;
    const FixedMaterials& both = v.materials ? *v.materials : initial;
    FixedMaterial m = useBack ? both.back : both.front;
    const bool follows =
        lighting.colorMaterial &&
        (lighting.colorMaterialFace == FixedFace::FrontAndBack ||
         (lighting.colorMaterialFace == FixedFace::Back) == useBack);
    if (follows) {
        const ColorMaterialMode mode = lighting.colorMaterialMode;
        if (mode == ColorMaterialMode::Emission) m.emission = v.color;
        if (mode == ColorMaterialMode::Specular) m.specular = v.color;
        if (mode == ColorMaterialMode::Ambient || mode == ColorMaterialMode::AmbientAndDiffuse)
            m.ambient = v.color;
        if (mode == ColorMaterialMode::Diffuse || mode == ColorMaterialMode::AmbientAndDiffuse)
            m.diffuse = v.color;
    }
    Vec3 n = referenceNormal(state, v, fault);
    if (useBack)
        for (double& x : n) x = -x;

    Vec3 sum{}, highlights{};
    const double ambientTimes = fault == Fault::ModelAmbientTwice ? 2.0 : 1.0;
    for (int k = 0; k < 3; ++k)
        sum[k] = m.emission[k] + double(m.ambient[k]) * lighting.modelAmbient[k] * ambientTimes;
    for (const FixedLight& l : lighting.lights) {
        if (!l.enabled) continue;
        Vec3 toLight;
        double att = 1.0;
        if (l.position.w == 0.0f) {
            toLight = normalised(three(l.position));
        } else {
            for (int k = 0; k < 3; ++k)
                toLight[k] = l.position[k] / double(l.position.w) - v.position[k];
            const double d = std::sqrt(dot(toLight, toLight));
            if (fault != Fault::NoAttenuation)
                att = 1.0 / (l.constantAttenuation + l.linearAttenuation * d +
                             l.quadraticAttenuation * d * d);
            toLight = normalised(toLight);
        }
        double spot = 1.0;
        if (l.spotCutoff != 180.0f) {
            const double cosine = -dot(toLight, normalised(three(l.spotDirection)));
            const double degrees = l.spotCutoff * (fault == Fault::SpotCosineOfTwice ? 2.0 : 1.0);
            if (cosine < std::cos(degrees * 3.14159265358979323846 / 180.0))
                spot = 0.0;
            else
                spot = std::pow(std::max(cosine, 0.0), double(l.spotExponent));
        }
        Vec3 half{0.0, 0.0, 1.0};
        if (lighting.localViewer && fault != Fault::EyeAtInfinity)
            half = normalised({-v.position.x, -v.position.y, -v.position.z});
        for (int k = 0; k < 3; ++k) half[k] += toLight[k];
        if (fault != Fault::HalfwayNotNormalised) half = normalised(half);
        const double nl = std::max(dot(n, toLight), 0.0);
        const double nh = std::max(dot(n, half), 0.0);
        const double f = nl != 0.0 ? 1.0 : 0.0;
        const double shine = f * (m.shininess == 0.0f ? 1.0 : std::pow(nh, double(m.shininess)));
        for (int k = 0; k < 3; ++k) {
            sum[k] += att * spot * (double(m.ambient[k]) * l.ambient[k] +
                                    nl * m.diffuse[k] * l.diffuse[k]);
            const double highlight = att * spot * shine * m.specular[k] * l.specular[k];
            (lighting.separateSpecular ? highlights : sum)[k] += highlight;
        }
    }
    ReferenceColors colors{};
    for (int k = 0; k < 3; ++k) {
        colors.primary[k] = clamp01(sum[k]);
        colors.secondary[k] = fault == Fault::SecondaryLost ? 0.0 : clamp01(highlights[k]);
    }
    colors.primary[3] =
        clamp01(double(fault == Fault::AlphaOfAmbient ? m.ambient.w : m.diffuse.w));
    return colors;
}

/// Section 2.10.4, then the texture matrix.
inline Vec4 referenceTexCoord(const FixedState& state, const FixedVertex& v,
                              Fault fault = Fault::None) {
    const Vec3 n = referenceNormal(state, v, fault);
    const Vec3 u = normalised(three(v.position));
    Vec3 r;
    for (int k = 0; k < 3; ++k) r[k] = u[k] - 2.0 * n[k] * dot(n, u);
    const double m = 2.0 * std::sqrt(r[0] * r[0] + r[1] * r[1] + (r[2] + 1) * (r[2] + 1));
    const Vec4 normal{n[0], n[1], n[2], 0.0}, mirrored{r[0], r[1], r[2], 0.0};
    Vec4 given = four(v.texCoord);
    for (int k = 0; k < 4; ++k) {
        const TexGen& gen = state.texture.generate[k];
        if (!gen.enabled) continue;
        const Vec4 o = four(v.objectPosition), e{v.position.x, v.position.y, v.position.z, 1.0};
        double linear = 0.0;
        for (int i = 0; i < 4; ++i)
            linear += gen.mode == TexGenMode::ObjectLinear ? gen.objectPlane[i] * o[i]
                                                           : gen.eyePlane[i] * e[i];
        switch (gen.mode) {
        case TexGenMode::ObjectLinear:
        case TexGenMode::EyeLinear: given[k] = linear; break;
        case TexGenMode::SphereMap:
            given[k] = mirrored[k] / m + (fault == Fault::SphereWithoutHalf ? 0.0 : 0.5);
            break;
        case TexGenMode::NormalMap: given[k] = normal[k]; break;
        case TexGenMode::ReflectionMap: given[k] = mirrored[k]; break;
        }
    }
    Vec4 result{};
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            result[row] += given[column] * (fault == Fault::MatrixTransposed
                                                ? state.texture.matrix[row][column]
                                                : state.texture.matrix[column][row]);
    return result;
}

/// Section 3.8.13: tables 3.21 and 3.22, entry by entry; NaN where they say nothing.
inline Vec4 referenceTexEnv(TexEnvMode mode, TexelFormat format, const Vec4& f, const Vec4& t,
                            const Vec4& c, Fault fault = Fault::None) {
    Vec4 v{};
    const bool colored = format != TexelFormat::Alpha;
    const bool alpha = format != TexelFormat::Luminance && format != TexelFormat::Rgb &&
                       fault != Fault::TexelAlphaIgnored;
    const bool intensity = format == TexelFormat::Intensity;
    for (int k = 0; k < 3; ++k) {
        switch (mode) {
        case TexEnvMode::Replace: v[k] = colored ? t[k] : f[k]; break;
        case TexEnvMode::Modulate: v[k] = colored ? f[k] * t[k] : f[k]; break;
        case TexEnvMode::Decal:
            v[k] = format == TexelFormat::Rgb    ? t[k]
                   : format == TexelFormat::Rgba ? f[k] * (1 - t[3]) + t[k] * t[3]
                                                 : std::nan("");
            break;
        case TexEnvMode::Blend: v[k] = colored ? f[k] * (1 - t[k]) + c[k] * t[k] : f[k]; break;
        case TexEnvMode::Add: v[k] = colored ? f[k] + t[k] : f[k]; break;
        case TexEnvMode::Combine: break;
        }
    }
    switch (mode) {
    case TexEnvMode::Replace: v[3] = alpha ? t[3] : f[3]; break;
    case TexEnvMode::Decal: v[3] = f[3]; break;
    case TexEnvMode::Blend:
        v[3] = intensity ? f[3] * (1 - t[3]) + c[3] * t[3] : alpha ? f[3] * t[3] : f[3];
        break;
    case TexEnvMode::Add: v[3] = intensity ? f[3] + t[3] : alpha ? f[3] * t[3] : f[3]; break;
    default: v[3] = alpha ? f[3] * t[3] : f[3]; break;
    }
    for (double& x : v) x = clamp01(x);
    return v;
}

/// Tables 3.23 to 3.25.
template <class Source>
Vec4 referenceCombine(const TexEnvCombine& how, const Source& source, Fault fault = Fault::None) {
    double arguments[3][4];
    for (int i = 0; i < 3; ++i) {
        const int from = fault == Fault::ArgumentsSwapped && i < 2 ? 1 - i : i;
        const Vec4 rgb = source(how.rgbSource[from]), a = source(how.alphaSource[from]);
        for (int k = 0; k < 3; ++k) {
            const bool ofAlpha = how.rgbOperand[from] == CombineOperand::Alpha ||
                                 how.rgbOperand[from] == CombineOperand::OneMinusAlpha;
            const bool minus = how.rgbOperand[from] == CombineOperand::OneMinusColor ||
                               how.rgbOperand[from] == CombineOperand::OneMinusAlpha;
            const double x = ofAlpha ? rgb[3] : rgb[k];
            arguments[i][k] = minus ? 1 - x : x;
        }
        arguments[i][3] = how.alphaOperand[from] == CombineOperand::OneMinusAlpha ? 1 - a[3] : a[3];
    }
    const auto combine = [&](CombineFunction function, int k) {
        const double a0 = arguments[0][k], a1 = arguments[1][k], a2 = arguments[2][k];
        switch (function) {
        case CombineFunction::Replace: return a0;
        case CombineFunction::Modulate: return a0 * a1;
        case CombineFunction::Add: return a0 + a1;
        case CombineFunction::AddSigned: return a0 + a1 - 0.5;
        case CombineFunction::Interpolate: return a0 * a2 + a1 * (1 - a2);
        case CombineFunction::Subtract: return a0 - a1;
        default: break;
        }
        double sum = 0;
        for (int i = 0; i < 3; ++i) sum += (arguments[0][i] - 0.5) * (arguments[1][i] - 0.5);
        return 4 * sum;
    };
    const double scale = fault == Fault::NoScale ? 1.0 : double(how.rgbScale);
    Vec4 v{};
    for (int k = 0; k < 3; ++k) v[k] = clamp01(combine(how.rgb, k) * scale);
    const bool dotted = how.rgb == CombineFunction::Dot3Rgba;
    v[3] = clamp01(combine(dotted ? how.rgb : how.alpha, 3) * how.alphaScale);
    return v;
}

inline Vec4 referenceCombine(const TexEnvCombine& how, const Vec4& f, const Vec4& t, const Vec4& c,
                             Fault fault = Fault::None) {
    const auto source = [&](CombineSource s) {
        return s == CombineSource::Texture ? t : s == CombineSource::Constant ? c : f;
    };
    return referenceCombine(how, source, fault);
}

/// Section 3.10.
inline Vec4 referenceFog(const FixedFog& fog, const Vec4& color, double distance,
                         Fault fault = Fault::None) {
    if (!fog.enabled) return color;
    if (fault == Fault::FogOfTwice) distance *= 2;
    double f = 0;
    switch (fog.mode) {
    case FogMode::Linear: f = (fog.end - distance) / (double(fog.end) - fog.start); break;
    case FogMode::Exp: f = std::exp(-fog.density * distance); break;
    case FogMode::Exp2: f = std::exp(-std::pow(fog.density * distance, 2)); break;
    }
    f = clamp01(f);
    Vec4 v = color;
    for (int k = 0; k < (fault == Fault::FogOfAlpha ? 4 : 3); ++k)
        v[k] = clamp01(f * color[k] + (1 - f) * fog.color[k]);
    return v;
}

} // namespace smart::test

// SPDX-License-Identifier: MIT
#include "libsmart/shading/fixed_function.h"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <random>
#include <vector>

#include "tests/libsmart/shading/fixed_reference.h"

namespace smart::test {
namespace {

constexpr double kTolerance = 1e-5;

/// Random states and vertices, of all that the equations tell apart.
class Dice {
public:
    explicit Dice(uint32_t seed) : engine_(seed) {}
    double real(double low, double high) {
        return low + (high - low) * double(engine_()) / 4294967295.0;
    }
    float number(double low, double high) { return float(real(low, high)); }
    bool often() { return engine_() % 4 != 0; }
    bool coin() { return engine_() % 2 == 0; }
    template <class Enum>
    Enum any(int count) {
        return Enum(engine_() % uint32_t(count));
    }
    glm::vec4 color() { return {number(0, 1), number(0, 1), number(0, 1), number(0, 1)}; }
    glm::vec4 vector(double size) {
        return {number(-size, size), number(-size, size), number(-size, size),
                number(-size, size)};
    }
    FixedMaterial material() {
        FixedMaterial m{color(), color(), color(), 0.2f * color(), 0.0f, number(0, 1)};
        m.shininess = coin() ? number(0, 128) : coin() ? 0.0f : 1.0f;
        return m;
    }
    FixedLight light() {
        FixedLight l;
        l.enabled = coin();
        l.ambient = 0.1f * color();
        l.diffuse = 0.5f * color();
        l.specular = color();
        l.position = vector(5);
        l.position.w = coin() ? 0.0f : coin() ? 1.0f : number(0.5, 2);
        if (coin()) {
            l.spotDirection = glm::vec3(vector(1));
            l.spotCutoff = coin() ? number(10, 90) : 90.0f;
            l.spotExponent = coin() ? number(0, 20) : 0.0f;
        }
        if (coin()) {
            l.constantAttenuation = number(0.5, 1);
            l.linearAttenuation = number(0, 0.2);
            l.quadraticAttenuation = number(0, 0.1);
        }
        return l;
    }
    FixedState lit() {
        FixedState state;
        FixedLighting& lighting = state.lighting;
        lighting.enabled = often();
        lighting.normalize = often();
        lighting.rescaleNormal = coin();
        lighting.twoSided = coin();
        lighting.localViewer = coin();
        lighting.separateSpecular = coin();
        lighting.colorMaterial = coin();
        lighting.colorMaterialMode = any<ColorMaterialMode>(5);
        lighting.colorMaterialFace = any<FixedFace>(3);
        lighting.modelAmbient = 0.2f * color();
        for (FixedLight& l : lighting.lights) l = light();
        return state;
    }
    FixedVertex vertex(const FixedMaterials& materials) {
        FixedVertex v;
        v.position = glm::dvec3(vector(4)) - glm::dvec3(0, 0, 6);
        v.normal = normalisedNormal() * real(0.9, 1.1);
        v.objectPosition = glm::dvec4(glm::vec3(vector(3)), 1.0);
        v.color = color();
        v.texCoord = vector(2);
        v.materials = often() ? &materials : nullptr;
        v.normalScale = real(0.8, 1.2);
        return v;
    }

private:
    glm::dvec3 normalisedNormal() {
        const Vec3 n = normalised({real(-1, 1), real(-1, 1), real(-0.5, 1)});
        return {n[0], n[1], n[2]};
    }
    std::mt19937 engine_;
};

template <class A, class B>
double distanceOf(const A& a, const B& b, int count) {
    double largest = 0;
    for (int k = 0; k < count; ++k) {
        const double d = std::fabs(double(a[k]) - b[k]);
        largest = std::max(largest, std::isfinite(d) ? d : 1e9);
    }
    return largest;
}

double lightingError(Fault fault, int cases) {
    Dice dice(1);
    double worst = 0;
    for (int i = 0; i < cases; ++i) {
        const FixedState state = dice.lit();
        const FixedMaterials materials{dice.material(), dice.material()};
        const FixedVertex vertex = dice.vertex(materials);
        const bool back = dice.coin();
        const LitVertex lit = litVertex(state, vertex, back);
        const ReferenceColors truth = referenceLighting(state, vertex, back, fault);
        worst = std::max({worst, distanceOf(lit.primary, truth.primary, 4),
                          distanceOf(lit.secondary, truth.secondary, 3)});
    }
    return worst;
}

TEST(FixedLighting, IsOpenGLsEquation) {
    EXPECT_LE(lightingError(Fault::None, 20000), kTolerance);
}

TEST(FixedLighting, ComparisonSeesFaults) {
    for (const Fault fault :
         {Fault::HalfwayNotNormalised, Fault::NoAttenuation, Fault::SpotCosineOfTwice,
          Fault::EyeAtInfinity, Fault::SidesSwapped, Fault::ModelAmbientTwice,
          Fault::AlphaOfAmbient, Fault::SecondaryLost, Fault::NotNormalised})
        EXPECT_GT(lightingError(fault, 500), 100 * kTolerance) << int(fault);
}

TEST(FixedLighting, VisibilityScalesALightsShare) {
    Dice dice(2);
    for (int i = 0; i < 500; ++i) {
        FixedState state = dice.lit();
        state.lighting.enabled = true;
        const FixedMaterials materials{dice.material(), dice.material()};
        const FixedVertex vertex = dice.vertex(materials);
        // All of the light: the same bits as without a word about it.
        glm::vec3 visibility[kFixedLights];
        for (glm::vec3& v : visibility) v = glm::vec3(1.0f);
        const LitVertex plain = litVertex(state, vertex, false);
        const LitVertex seen = litVertex(state, vertex, false, {}, visibility);
        EXPECT_EQ(seen.primary, plain.primary);
        EXPECT_EQ(seen.secondary, plain.secondary);
        // None of a light is that light switched off, half of it the light at half its colours.
        const int n = i % kFixedLights;
        visibility[n] = glm::vec3(0.0f);
        FixedState off = state;
        off.lighting.lights[n].enabled = false;
        const LitVertex dark = litVertex(off, vertex, false);
        const LitVertex hidden = litVertex(state, vertex, false, {}, visibility);
        EXPECT_LE(distanceOf(hidden.primary, dark.primary, 4), 1e-6);
        if (!(plain.lightsIn >> n & 1u)) { EXPECT_EQ(dark.primary, plain.primary); }
        visibility[n] = glm::vec3(0.5f);
        FixedState half = state;
        FixedLight& light = half.lighting.lights[n];
        light.ambient *= 0.5f;
        light.diffuse *= 0.5f;
        light.specular *= 0.5f;
        EXPECT_LE(distanceOf(litVertex(state, vertex, false, {}, visibility).primary,
                             litVertex(half, vertex, false).primary, 4),
                  1e-6);
    }
}

TEST(FixedLighting, RescalesByTheMatrix) {
    // A uniform scaling by 3 makes normals a third as long.
    glm::dmat4x3 matrix(3.0);
    EXPECT_DOUBLE_EQ(rescaleFactor(matrix), 3.0);
    EXPECT_EQ(rescaleFactor(glm::dmat4x3(0.0)), 1.0);
    // Turned, moved and mirrored it stays that.
    const double c = 0.6, s = 0.8;
    matrix = glm::dmat4x3(glm::dvec3(3 * c, 3 * s, 0), glm::dvec3(3 * s, -3 * c, 0),
                          glm::dvec3(0, 0, 3), glm::dvec3(7, 8, 9));
    EXPECT_NEAR(rescaleFactor(matrix), 3.0, 1e-12);
}

std::shared_ptr<const Texture> texture(TexelFormat format) {
    TextureOptions options;
    options.format = format;
    const uint32_t channels = format == TexelFormat::Luminance        ? 1
                              : format == TexelFormat::LuminanceAlpha ? 2
                              : format == TexelFormat::Rgb            ? 3
                                                                      : 4;
    return std::make_shared<const Texture>(1, 1, channels, TexelType::Byte,
                                           std::vector<std::byte>(channels), options);
}

double texCoordError(Fault fault, int cases) {
    Dice dice(3);
    double worst = 0;
    for (int i = 0; i < cases; ++i) {
        FixedState state = dice.lit();
        if (fault == Fault::NotNormalised) state.lighting.normalize = true;
        state.texture.image = texture(TexelFormat::Rgb);
        for (int k = 0; k < 4; ++k) {
            TexGen& gen = state.texture.generate[k];
            gen.enabled = dice.often();
            do gen.mode = dice.any<TexGenMode>(5);
            while ((k > 1 && gen.mode == TexGenMode::SphereMap) ||
                   (k > 2 && gen.mode > TexGenMode::EyeLinear));
            gen.objectPlane = dice.vector(1);
            gen.eyePlane = dice.vector(1);
        }
        if (dice.coin())
            for (int k = 0; k < 4; ++k) state.texture.matrix[k] = glm::dvec4(dice.vector(1));
        const FixedMaterials materials;
        const FixedVertex vertex = dice.vertex(materials);
        const LitVertex lit = litVertex(state, vertex, false);
        worst = std::max(
            worst, distanceOf(lit.texCoord, referenceTexCoord(state, vertex, fault), 4));
    }
    return worst;
}

TEST(FixedTexCoords, AreOpenGLs) {
    EXPECT_LE(texCoordError(Fault::None, 5000), kTolerance);
    for (const Fault fault :
         {Fault::SphereWithoutHalf, Fault::MatrixTransposed, Fault::NotNormalised})
        EXPECT_GT(texCoordError(fault, 200), 100 * kTolerance) << int(fault);
}

/// A texel as a look-up gives it for the format.
glm::vec4 texelOf(TexelFormat format, const glm::vec4& c) {
    switch (format) {
    case TexelFormat::Alpha: return {0, 0, 0, c.a};
    case TexelFormat::Luminance: return {c.r, c.r, c.r, 1};
    case TexelFormat::LuminanceAlpha: return {c.r, c.r, c.r, c.a};
    case TexelFormat::Intensity: return glm::vec4(c.r);
    case TexelFormat::Rgb: return {c.r, c.g, c.b, 1};
    default: return c;
    }
}

constexpr TexelFormat kFormats[] = {TexelFormat::Alpha, TexelFormat::Luminance,
                                    TexelFormat::LuminanceAlpha, TexelFormat::Intensity,
                                    TexelFormat::Rgb, TexelFormat::Rgba};

double texEnvError(Fault fault, int cases) {
    Dice dice(4);
    double worst = 0;
    for (int i = 0; i < cases; ++i) {
        const TexelFormat format = kFormats[i % 6];
        FixedState state;
        state.texture.image = texture(format);
        state.texture.mode = TexEnvMode(i / 6 % 6);
        state.texture.color = dice.color();
        TexEnvCombine& combine = state.texture.combine;
        combine.rgb = dice.any<CombineFunction>(8);
        combine.alpha = dice.any<CombineFunction>(6);
        for (int k = 0; k < 3; ++k) {
            combine.rgbSource[k] = dice.any<CombineSource>(4);
            combine.alphaSource[k] = dice.any<CombineSource>(4);
            combine.rgbOperand[k] = dice.any<CombineOperand>(4);
            combine.alphaOperand[k] = dice.coin() ? CombineOperand::Alpha
                                                  : CombineOperand::OneMinusAlpha;
        }
        combine.rgbScale = float(1 << dice.any<int>(3));
        combine.alphaScale = float(1 << dice.any<int>(3));
        LitVertex fragment;
        fragment.primary = dice.color();
        fragment.secondary = glm::vec3(dice.color());
        state.lighting.enabled = state.lighting.separateSpecular = dice.coin();
        const glm::vec4 texel = texelOf(format, dice.color());
        const Vec4 f = four(fragment.primary), t = four(texel), c = four(state.texture.color);
        Vec4 truth = state.texture.mode == TexEnvMode::Combine
                         ? referenceCombine(combine, f, t, c, fault)
                         : referenceTexEnv(state.texture.mode, format, f, t, c, fault);
        const bool isDefined = state.texture.mode != TexEnvMode::Decal ||
                               format == TexelFormat::Rgb || format == TexelFormat::Rgba;
        if (!isDefined) continue;
        if (state.lighting.enabled && fault != Fault::SecondaryLost)
            for (int k = 0; k < 3; ++k) truth[k] = clamp01(truth[k] + fragment.secondary[k]);
        worst = std::max(worst, distanceOf(surfaceColor(state, fragment, &texel), truth, 4));
    }
    return worst;
}

TEST(FixedTextureEnvironment, IsOpenGLs) {
    EXPECT_LE(texEnvError(Fault::None, 36 * 500), kTolerance);
    for (const Fault fault : {Fault::TexelAlphaIgnored, Fault::ArgumentsSwapped, Fault::NoScale,
                              Fault::SecondaryLost})
        EXPECT_GT(texEnvError(fault, 36 * 10), 100 * kTolerance) << int(fault);
}

/// Units one after the other, each on what the one before left; a combiner may look at the
/// textures of others.
double unitsError(bool wrongOrder) {
    Dice dice(11);
    double worst = 0;
    for (int i = 0; i < 2000; ++i) {
        FixedState state;
        state.moreTextures.resize(kMoreUnits);
        glm::vec4 texels[kTextureUnits];
        const auto unitOf = [&](std::size_t unit) -> FixedTexture& {
            return unit == 0 ? state.texture : state.moreTextures[unit - 1];
        };
        for (std::size_t unit = 0; unit < kTextureUnits; ++unit) {
            texels[unit] = texelOf(TexelFormat::Rgba, dice.color());
            if (dice.coin()) unitOf(unit).image = texture(TexelFormat::Rgba);
            unitOf(unit).mode = dice.any<TexEnvMode>(6);
            unitOf(unit).color = dice.color();
            unitOf(unit).combine.rgb = dice.any<CombineFunction>(8);
            for (CombineSource& source : unitOf(unit).combine.rgbSource)
                source = dice.any<CombineSource>(8);
        }
        LitVertex fragment;
        fragment.primary = dice.color();
        const Vec4 primary = four(fragment.primary);
        Vec4 truth = primary;
        for (std::size_t k = 0; k < kTextureUnits; ++k) {
            const std::size_t unit = wrongOrder ? kMoreUnits - k : k;
            const FixedTexture& texture = unitOf(unit);
            if (!texture.image) continue;
            const Vec4 texel = four(texels[unit]), constant = four(texture.color), before = truth;
            const auto source = [&](CombineSource from) {
                if (from == CombineSource::Texture) return texel;
                if (from == CombineSource::Constant) return constant;
                if (from == CombineSource::PrimaryColor) return primary;
                if (from == CombineSource::Previous) return before;
                const std::size_t other = std::size_t(from) - std::size_t(CombineSource::Texture0);
                return unitOf(other).image ? four(texels[other]) : Vec4{0, 0, 0, 1};
            };
            truth = texture.mode == TexEnvMode::Combine
                        ? referenceCombine(texture.combine, source)
                        : referenceTexEnv(texture.mode, TexelFormat::Rgba, before, texel, constant);
        }
        worst = std::max(worst, distanceOf(surfaceColor(state, fragment, texels), truth, 4));
    }
    return worst;
}

TEST(FixedTextureEnvironment, UnitsFollowEachOther) {
    EXPECT_LE(unitsError(false), kTolerance);
    EXPECT_GT(unitsError(true), 100 * kTolerance);
}

double fogError(Fault fault) {
    Dice dice(5);
    double worst = 0;
    for (int i = 0; i < 3000; ++i) {
        FixedState state;
        FixedFog& fog = state.fog;
        fog.enabled = dice.often();
        fog.mode = dice.any<FogMode>(3);
        fog.density = dice.number(0, 2);
        fog.start = dice.number(0, 5);
        fog.end = dice.number(6, 20);
        fog.color = dice.color();
        LitVertex fragment;
        fragment.primary = dice.color();
        fragment.fogDistance = dice.number(0, 30);
        const Vec4 truth =
            referenceFog(fog, four(fragment.primary), fragment.fogDistance, fault);
        worst = std::max(worst, distanceOf(fragmentColor(state, fragment, nullptr), truth, 4));
    }
    return worst;
}

TEST(FixedFog, IsOpenGLs) {
    EXPECT_LE(fogError(Fault::None), kTolerance);
    EXPECT_GT(fogError(Fault::FogOfTwice), 0.01);
    EXPECT_GT(fogError(Fault::FogOfAlpha), 0.01);
}

TEST(FixedFog, TakesTheDepthOrTheCoordinate) {
    FixedState state;
    state.fog.enabled = true;
    FixedVertex vertex;
    vertex.position = {3, 4, -12};
    vertex.fogCoordinate = 7;
    EXPECT_EQ(litVertex(state, vertex, false).fogDistance, 12.0f);
    state.fog.fromCoordinate = true;
    EXPECT_EQ(litVertex(state, vertex, false).fogDistance, 7.0f);
}

TEST(FixedBlend, SaysWhatShinesThrough) {
    FixedFragmentOps ops;
    const glm::vec4 color(0.5f, 0.25f, 1.0f, 0.75f);
    EXPECT_FALSE(letsThrough(ops));
    EXPECT_EQ(blendOf(ops, color).own, glm::vec3(color));
    EXPECT_EQ(blendOf(ops, color).through, glm::vec3(0.0f));
    ops.blend = true;
    EXPECT_FALSE(letsThrough(ops)); // one and zero
    ops.sourceRgb = BlendFactor::SourceAlpha;
    ops.destinationRgb = BlendFactor::OneMinusSourceAlpha;
    EXPECT_TRUE(letsThrough(ops));
    EXPECT_EQ(blendOf(ops, color).own, 0.75f * glm::vec3(color));
    EXPECT_EQ(blendOf(ops, color).through, glm::vec3(0.25f));
    ops.sourceRgb = BlendFactor::One;
    ops.destinationRgb = BlendFactor::One;
    EXPECT_EQ(blendOf(ops, color).through, glm::vec3(1.0f));
    ops.sourceRgb = BlendFactor::DestinationColor; // a filter
    ops.destinationRgb = BlendFactor::Zero;
    EXPECT_TRUE(letsThrough(ops));
    EXPECT_EQ(blendOf(ops, color).own, glm::vec3(0.0f));
    EXPECT_EQ(blendOf(ops, color).through, glm::vec3(color));
    ops = {};
    ops.alphaTest = true;
    ops.alphaFunction = CompareFunction::Greater;
    ops.alphaReference = 0.5f;
    EXPECT_TRUE(letsThrough(ops));
    EXPECT_EQ(blendOf(ops, color).through, glm::vec3(0.0f));
    ops.alphaReference = 0.8f;
    EXPECT_EQ(blendOf(ops, color).own, glm::vec3(0.0f));
    EXPECT_EQ(blendOf(ops, color).through, glm::vec3(1.0f));
}

TEST(FixedTexel, DividesByQAndTakesALevel) {
    // Levels of one colour each: 8x8 of 0, 4x4 of 1/4, 2x2 of 1/2, 1x1 of 3/4 of white.
    std::vector<TextureImagePtr> images;
    for (uint32_t level = 0; level < 4; ++level) {
        const uint32_t side = 8u >> level;
        std::vector<float> values(side * side, 0.25f * float(level));
        std::vector<std::byte> bytes(values.size() * sizeof(float));
        std::memcpy(bytes.data(), values.data(), bytes.size());
        images.push_back(std::make_shared<const TextureImage>(side, side, 1, TexelType::Float,
                                                              false, std::move(bytes)));
    }
    FixedTexture how;
    how.enabled2D = true;
    how.image = std::make_shared<const Texture>(
        std::make_shared<const TextureLevels>(std::move(images), 4), TextureOptions{});
    LitVertex fragment;
    fragment.texCoord = {1.0f, 3.0f, 0.0f, 4.0f};
    for (const double detail : {0.0, 0.5, 1.0, 1.75, 2.0, 3.0})
        EXPECT_NEAR(fixedTexel(how, fragment.texCoord, std::exp2(detail)).r, 0.25 * detail, 1e-6);
    how.lodBias = 1.0f;
    EXPECT_NEAR(fixedTexel(how, fragment.texCoord, 2.0).r, 0.5, 1e-6);
    // The division: a texture of two columns, looked up with the nearest texel.
    std::vector<std::byte> columns{std::byte{0}, std::byte{255}};
    TextureOptions nearest;
    nearest.magnification = TextureFilter::Nearest;
    how.image = std::make_shared<const Texture>(2, 1, 1, TexelType::Byte, columns, nearest);
    EXPECT_EQ(fixedTexel(how, fragment.texCoord, 0.0).r, 0.0f);
    fragment.texCoord.w = 1.5f;
    EXPECT_EQ(fixedTexel(how, fragment.texCoord, 0.0).r, 1.0f);
}

} // namespace
} // namespace smart::test

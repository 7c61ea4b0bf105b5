// SPDX-License-Identifier: MIT
#include "libsmart/shading/fixed_function.h"

#include <algorithm>
#include <cmath>

#include "libsmart/base/transcendental.h"

namespace smart {
namespace {

template <class Function>
void forEachValue(LitVertex& vertex, Function&& function) {
    for (int k = 0; k < 4; ++k) {
        function(vertex.primary[k], [k](const LitVertex& v) { return double(v.primary[k]); });
        function(vertex.texCoord[k], [k](const LitVertex& v) { return double(v.texCoord[k]); });
    }
    for (int k = 0; k < 3; ++k)
        function(vertex.secondary[k], [k](const LitVertex& v) { return double(v.secondary[k]); });
    function(vertex.fogDistance, [](const LitVertex& v) { return double(v.fogDistance); });
    function(vertex.reflection, [](const LitVertex& v) { return double(v.reflection); });
    for (uint32_t i = 0; i < vertex.moreUnits; ++i)
        for (int k = 0; k < 4; ++k)
            function(vertex.moreTexCoords[i][k],
                     [i, k](const LitVertex& v) { return double(v.moreTexCoords[i][k]); });
}

/// Of the fog's colour what is left to the fragment's.
float fogFactor(const FixedFog& fog, float distance) {
    float factor = 0.0f;
    switch (fog.mode) {
    case FogMode::Linear: factor = (fog.end - distance) / (fog.end - fog.start); break;
    case FogMode::Exp: factor = math::exp(-(fog.density * distance)); break;
    case FogMode::Exp2: {
        const float depth = fog.density * distance;
        factor = math::exp(-(depth * depth));
        break;
    }
    }
    return factor > 0.0f ? std::min(factor, 1.0f) : 0.0f;
}

bool passesAlphaTest(const FixedFragmentOps& ops, float alpha) {
    switch (ops.alphaFunction) {
    case CompareFunction::Never: return false;
    case CompareFunction::Less: return alpha < ops.alphaReference;
    case CompareFunction::Equal: return alpha == ops.alphaReference;
    case CompareFunction::LessEqual: return alpha <= ops.alphaReference;
    case CompareFunction::Greater: return alpha > ops.alphaReference;
    case CompareFunction::NotEqual: return alpha != ops.alphaReference;
    case CompareFunction::GreaterEqual: return alpha >= ops.alphaReference;
    case CompareFunction::Always: break;
    }
    return true;
}

/// A blend factor that what is behind has no part in. The destination's alpha counts as 1.
glm::vec3 factorOf(BlendFactor factor, const glm::vec4& source, const glm::vec4& constant) {
    switch (factor) {
    case BlendFactor::Zero:
    case BlendFactor::OneMinusDestinationAlpha:
    case BlendFactor::SourceAlphaSaturate: return glm::vec3(0.0f);
    case BlendFactor::SourceColor: return glm::vec3(source);
    case BlendFactor::OneMinusSourceColor: return 1.0f - glm::vec3(source);
    case BlendFactor::SourceAlpha: return glm::vec3(source.a);
    case BlendFactor::OneMinusSourceAlpha: return glm::vec3(1.0f - source.a);
    case BlendFactor::ConstantColor: return glm::vec3(constant);
    case BlendFactor::OneMinusConstantColor: return 1.0f - glm::vec3(constant);
    case BlendFactor::ConstantAlpha: return glm::vec3(constant.a);
    case BlendFactor::OneMinusConstantAlpha: return glm::vec3(1.0f - constant.a);
    case BlendFactor::One:
    case BlendFactor::DestinationAlpha:
    case BlendFactor::DestinationColor:
    case BlendFactor::OneMinusDestinationColor: break;
    }
    return glm::vec3(1.0f);
}

} // namespace

LitVertex interpolated(const LitVertex& a, const LitVertex& b, double share) {
    LitVertex result;
    result.moreUnits = a.moreUnits;
    forEachValue(result, [&](float& value, auto&& of) {
        value = float((1.0 - share) * of(a) + share * of(b));
    });
    result.lightsIn = a.lightsIn | b.lightsIn;
    return result;
}

glm::vec4 fixedTexel(const FixedTexture& texture, const glm::vec4& texCoord, double texels) {
    const Texture& image = *texture.image;
    const TextureImage& first = image.levels()[image.options().firstLevel];
    double footprint = texels / std::sqrt(double(first.width()) * double(first.height()));
    if (texture.lodBias != 0.0f) {
        constexpr double kLn2 = 0.69314718055994530942;
        const float bias =
            std::clamp(texture.lodBias, -TextureOptions::kMaxBias, TextureOptions::kMaxBias);
        footprint *= math::detail::expOf(double(bias) * kLn2);
    }
    const float q = texCoord.w;
    const float s = q == 1.0f ? texCoord.x : texCoord.x / q;
    const float t = q == 1.0f ? texCoord.y : texCoord.y / q;
    return image.sample(s, texture.enabled2D ? t : 0.5f, float(footprint));
}

const glm::vec4* fixedTexels(const FixedState& state, const LitVertex& fragment,
                             const double* distances, glm::vec4 (&memory)[kTextureUnits]) {
    if (!state.isTextured()) return nullptr;
    forEachTexture(state, fragment,
                   [&](std::size_t unit, const FixedTexture& texture, const glm::vec4& at) {
                       memory[unit] = fixedTexel(texture, at, distances[unit]);
                   });
    return memory;
}

glm::vec4 fogged(const FixedFog& fog, const glm::vec4& color, float fogDistance) {
    if (!fog.enabled) return color;
    const float left = fogFactor(fog, fogDistance);
    glm::vec4 result = color;
    for (int k = 0; k < 3; ++k) {
        const float value = left * color[k] + (1.0f - left) * fog.color[k];
        result[k] = value > 0.0f ? std::min(value, 1.0f) : 0.0f;
    }
    return result;
}

glm::vec4 fragmentColor(const FixedState& state, const LitVertex& fragment,
                        const glm::vec4* texels) {
    return fogged(state.fog, surfaceColor(state, fragment, texels), fragment.fogDistance);
}

FixedBlend blendOf(const FixedFragmentOps& ops, const glm::vec4& color) {
    FixedBlend result{glm::vec3(color), glm::vec3(0.0f)};
    glm::vec4 source;
    for (int k = 0; k < 4; ++k) source[k] = color[k] > 0.0f ? std::min(color[k], 1.0f) : 0.0f;
    if (ops.alphaTest && !passesAlphaTest(ops, source.a)) return {glm::vec3(0.0f), glm::vec3(1.0f)};
    if (!ops.blend || ops.colorLogicOp || ops.blendEquation != BlendEquation::Add) return result;
    result.own = glm::vec3(source) * factorOf(ops.sourceRgb, source, ops.blendColor);
    result.through = factorOf(ops.destinationRgb, source, ops.blendColor);
    if (ops.sourceRgb == BlendFactor::DestinationColor) { // source * behind
        result.own = glm::vec3(0.0f);
        result.through += glm::vec3(source);
    }
    return result;
}

bool letsThrough(const FixedFragmentOps& ops) {
    if (ops.alphaTest && ops.alphaFunction != CompareFunction::Always) return true;
    if (!ops.blend || ops.colorLogicOp || ops.blendEquation != BlendEquation::Add) return false;
    return ops.destinationRgb != BlendFactor::Zero ||
           ops.sourceRgb == BlendFactor::DestinationColor;
}

} // namespace smart

// SPDX-License-Identifier: MIT
// Texture environment and colour sum (OpenGL 1.5, sections 3.8.13 and 3.9).
#include <algorithm>

#include "libsmart/shading/fixed_function.h"

namespace smart {
namespace {

glm::vec4 clamped(const glm::vec4& color) {
    glm::vec4 result;
    for (int k = 0; k < 4; ++k) result[k] = color[k] > 0.0f ? std::min(color[k], 1.0f) : 0.0f;
    return result;
}

bool hasColor(TexelFormat format) {
    return format != TexelFormat::Alpha;
}
bool hasAlpha(TexelFormat format) {
    return format != TexelFormat::Luminance && format != TexelFormat::Rgb;
}

/// Tables 3.21 and 3.22; what they leave undefined is the fragment's colour.
glm::vec4 combined(TexEnvMode mode, TexelFormat format, const glm::vec4& fragment,
                   const glm::vec4& texel, const glm::vec4& constant) {
    const glm::vec3 cf(fragment), ct(texel);
    const float af = fragment.a, at = texel.a;
    glm::vec3 color = cf;
    float alpha = hasAlpha(format) ? af * at : af;
    switch (mode) {
    case TexEnvMode::Replace:
        color = ct;
        alpha = hasAlpha(format) ? at : af;
        break;
    case TexEnvMode::Modulate: color = cf * ct; break;
    case TexEnvMode::Decal:
        if (format != TexelFormat::Rgb && format != TexelFormat::Rgba) return fragment;
        color = cf * (1.0f - at) + ct * at;
        alpha = af;
        break;
    case TexEnvMode::Blend:
        color = cf * (1.0f - ct) + glm::vec3(constant) * ct;
        if (format == TexelFormat::Intensity) alpha = af * (1.0f - at) + constant.a * at;
        break;
    case TexEnvMode::Add:
        color = cf + ct;
        if (format == TexelFormat::Intensity) alpha = af + at;
        break;
    case TexEnvMode::Combine: break;
    }
    return {hasColor(format) ? color : cf, alpha};
}

/// What the units' environments work on.
struct EnvInput {
    const FixedState& state;
    const glm::vec4& primary;
    const glm::vec4* texels; ///< by unit

    bool hasTexture(std::size_t unit) const {
        if (unit == 0) return state.texture.image != nullptr;
        return unit <= state.moreTextures.size() && state.moreTextures[unit - 1].image;
    }
};

/// `previous`: what the unit before has left. The texture of a unit without one, which OpenGL
/// leaves undefined, is black.
glm::vec4 sourceOf(CombineSource source, const EnvInput& input, std::size_t unit,
                   const glm::vec4& previous, const glm::vec4& constant) {
    switch (source) {
    case CombineSource::Texture: return input.texels[unit];
    case CombineSource::Constant: return constant;
    case CombineSource::PrimaryColor: return input.primary;
    case CombineSource::Previous: return previous;
    case CombineSource::Texture0: break;
    }
    const std::size_t other = std::size_t(source) - std::size_t(CombineSource::Texture0);
    return input.hasTexture(other) ? input.texels[other] : glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
}

template <class Value>
Value combine(CombineFunction function, const Value (&arguments)[3]) {
    const Value &a = arguments[0], &b = arguments[1], &c = arguments[2];
    switch (function) {
    case CombineFunction::Replace: return a;
    case CombineFunction::Modulate: return a * b;
    case CombineFunction::Add: return a + b;
    case CombineFunction::AddSigned: return a + b - 0.5f;
    case CombineFunction::Interpolate: return a * c + b * (1.0f - c);
    case CombineFunction::Subtract: return a - b;
    case CombineFunction::Dot3Rgb:
    case CombineFunction::Dot3Rgba: break; // of colours only
    }
    return a;
}

float dot3(const glm::vec3& a, const glm::vec3& b) {
    const glm::vec3 product = (a - 0.5f) * (b - 0.5f);
    return 4.0f * (product.x + product.y + product.z);
}

/// Tables 3.23 to 3.25.
glm::vec4 combined(const TexEnvCombine& how, const EnvInput& input, std::size_t unit,
                   const glm::vec4& previous, const glm::vec4& constant) {
    glm::vec3 colors[3];
    float alphas[3];
    for (int i = 0; i < 3; ++i) {
        const glm::vec4 source = sourceOf(how.rgbSource[i], input, unit, previous, constant);
        switch (how.rgbOperand[i]) {
        case CombineOperand::Color: colors[i] = glm::vec3(source); break;
        case CombineOperand::OneMinusColor: colors[i] = 1.0f - glm::vec3(source); break;
        case CombineOperand::Alpha: colors[i] = glm::vec3(source.a); break;
        case CombineOperand::OneMinusAlpha: colors[i] = glm::vec3(1.0f - source.a); break;
        }
        const float alpha = sourceOf(how.alphaSource[i], input, unit, previous, constant).a;
        alphas[i] = how.alphaOperand[i] == CombineOperand::OneMinusAlpha ? 1.0f - alpha : alpha;
    }
    const bool dotted =
        how.rgb == CombineFunction::Dot3Rgb || how.rgb == CombineFunction::Dot3Rgba;
    const glm::vec3 color =
        dotted ? glm::vec3(dot3(colors[0], colors[1])) : combine(how.rgb, colors);
    const float alpha =
        how.rgb == CombineFunction::Dot3Rgba ? color.x : combine(how.alpha, alphas);
    return {color * how.rgbScale, alpha * how.alphaScale};
}

} // namespace

glm::vec4 surfaceColor(const FixedState& state, const LitVertex& fragment,
                       const glm::vec4* texels) {
    glm::vec4 color = fragment.primary;
    if (texels) {
        const EnvInput input{state, fragment.primary, texels};
        forEachTexture(state, fragment,
                       [&](std::size_t unit, const FixedTexture& texture, const glm::vec4&) {
                           const glm::vec4 constant = clamped(texture.color);
                           color = clamped(
                               texture.mode == TexEnvMode::Combine
                                   ? combined(texture.combine, input, unit, color, constant)
                                   : combined(texture.mode, texture.image->format(), color,
                                              texels[unit], constant));
                       });
    }
    if (!state.lighting.hasSecondary()) return color;
    return clamped(color + glm::vec4(fragment.secondary, 0.0f));
}

} // namespace smart

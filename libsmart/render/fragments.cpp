// SPDX-License-Identifier: MIT
#include "libsmart/render/fragments.h"

#include <algorithm>
#include <cmath>

namespace smart {
namespace {

bool passes(CompareFunction function, float value, float reference) {
    switch (function) {
    case CompareFunction::Never: return false;
    case CompareFunction::Less: return value < reference;
    case CompareFunction::Equal: return value == reference;
    case CompareFunction::LessEqual: return value <= reference;
    case CompareFunction::Greater: return value > reference;
    case CompareFunction::NotEqual: return value != reference;
    case CompareFunction::GreaterEqual: return value >= reference;
    case CompareFunction::Always: return true;
    }
    return true;
}

glm::vec4 clamped(const glm::vec4& color) {
    glm::vec4 result;
    for (int k = 0; k < 4; ++k) result[k] = color[k] > 0.0f ? std::min(color[k], 1.0f) : 0.0f;
    return result;
}

glm::vec4 factorOf(BlendFactor factor, const glm::vec4& source, const glm::vec4& destination,
                   const glm::vec4& constant) {
    const glm::vec4 one(1.0f);
    switch (factor) {
    case BlendFactor::Zero: return glm::vec4(0.0f);
    case BlendFactor::One: return one;
    case BlendFactor::SourceColor: return source;
    case BlendFactor::OneMinusSourceColor: return one - source;
    case BlendFactor::DestinationColor: return destination;
    case BlendFactor::OneMinusDestinationColor: return one - destination;
    case BlendFactor::SourceAlpha: return glm::vec4(source.a);
    case BlendFactor::OneMinusSourceAlpha: return glm::vec4(1.0f - source.a);
    case BlendFactor::DestinationAlpha: return glm::vec4(destination.a);
    case BlendFactor::OneMinusDestinationAlpha: return glm::vec4(1.0f - destination.a);
    case BlendFactor::ConstantColor: return constant;
    case BlendFactor::OneMinusConstantColor: return one - constant;
    case BlendFactor::ConstantAlpha: return glm::vec4(constant.a);
    case BlendFactor::OneMinusConstantAlpha: return glm::vec4(1.0f - constant.a);
    case BlendFactor::SourceAlphaSaturate: {
        const float f = std::min(source.a, 1.0f - destination.a);
        return {f, f, f, 1.0f};
    }
    }
    return one;
}

glm::vec4 blended(const FixedFragmentOps& ops, const glm::vec4& source,
                  const glm::vec4& destination) {
    if (ops.blendEquation == BlendEquation::Min) return glm::min(source, destination);
    if (ops.blendEquation == BlendEquation::Max) return glm::max(source, destination);
    const auto weight = [&](BlendFactor rgb, BlendFactor alpha) {
        glm::vec4 factor = factorOf(rgb, source, destination, ops.blendColor);
        factor.a = factorOf(alpha, source, destination, ops.blendColor).a;
        return factor;
    };
    const glm::vec4 from = source * weight(ops.sourceRgb, ops.sourceAlpha);
    const glm::vec4 to = destination * weight(ops.destinationRgb, ops.destinationAlpha);
    switch (ops.blendEquation) {
    case BlendEquation::Subtract: return from - to;
    case BlendEquation::ReverseSubtract: return to - from;
    default: return from + to;
    }
}

// On colours as an 8-bit buffer holds them (OpenGL 1.5, table 4.2).
glm::vec4 combinedLogically(uint8_t operation, const glm::vec4& source,
                            const glm::vec4& destination) {
    glm::vec4 result;
    for (int k = 0; k < 4; ++k) {
        const auto s = uint32_t(std::lround(source[k] * 255.0f));
        const auto d = uint32_t(std::lround(destination[k] * 255.0f));
        // The token's bits: what becomes of (s, d) = (1, 1), (1, 0), (0, 1), (0, 0).
        const auto bit = [&](int n) { return (operation >> n & 1) != 0 ? 0xFFu : 0u; };
        const uint32_t value = (s & d & bit(0)) | (s & ~d & bit(1)) | (~s & d & bit(2)) |
                               (~s & ~d & bit(3));
        result[k] = float(value & 0xFFu) / 255.0f;
    }
    return result;
}

const FixedFragmentOps& operationsOn(const Fragment& fragment) {
    static const FixedFragmentOps kPlain = [] {
        FixedFragmentOps ops;
        ops.depthTest = true;
        return ops;
    }();
    return fragment.state ? fragment.state->ops : kPlain;
}

bool writesAll(const FixedFragmentOps& ops) {
    return ops.colorMask[0] && ops.colorMask[1] && ops.colorMask[2] && ops.colorMask[3];
}
bool writesNothing(const FixedFragmentOps& ops) {
    return !ops.colorMask[0] && !ops.colorMask[1] && !ops.colorMask[2] && !ops.colorMask[3];
}

void take(const Fragment& fragment, PixelValue& pixel) {
    const FixedFragmentOps& ops = operationsOn(fragment);
    const glm::vec4 source = fragment.state ? clamped(fragment.color) : fragment.color;
    if (ops.alphaTest && !passes(ops.alphaFunction, source.a, ops.alphaReference)) return;
    if (ops.depthTest) {
        if (!passes(ops.depthFunction, fragment.depth, pixel.depth)) return;
        if (ops.depthMask) pixel.depth = fragment.depth;
    }
    if (ops.depthMask || !ops.depthTest) pixel.source = fragment.source;
    const glm::vec4 result = ops.colorLogicOp ? combinedLogically(ops.logicOp, source, pixel.color)
                             : ops.blend      ? clamped(blended(ops, source, pixel.color))
                                              : source;
    for (int k = 0; k < 4; ++k)
        if (ops.colorMask[k]) pixel.color[k] = result[k];
}

} // namespace

void replay(std::span<const Fragment> fragments, PixelValue& pixel) {
    for (const Fragment& fragment : fragments) take(fragment, pixel);
}

void findNeeded(std::span<const Fragment> fragments, float depth, uint8_t* needed) {
    bool known = true; // the depth at this point
    for (std::size_t i = 0; i < fragments.size(); ++i) {
        const Fragment& fragment = fragments[i];
        const FixedFragmentOps& ops = operationsOn(fragment);
        const bool mayFail =
            (ops.depthTest && !known) ||
            (ops.alphaTest && ops.alphaFunction != CompareFunction::Always);
        if (ops.depthTest && known && !passes(ops.depthFunction, fragment.depth, depth)) {
            needed[i] = false;
            continue;
        }
        needed[i] = mayFail || !writesNothing(ops);
        if (ops.depthTest && ops.depthMask) {
            known = !mayFail;
            depth = fragment.depth;
        }
        if (mayFail || !writesAll(ops) || ops.blend || ops.colorLogicOp) continue;
        for (std::size_t j = 0; j < i; ++j) // whose alpha decides on a depth stay
            if (!operationsOn(fragments[j]).alphaTest) needed[j] = false;
    }
}

} // namespace smart

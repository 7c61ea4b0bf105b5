// SPDX-License-Identifier: MIT
// How textures are looked up, and what is known of their levels.
#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>

#include "compat/openrt/guard.h"
#include "compat/openrt/image_formats.h"
#include "compat/openrt/state_values.h"
#include "openrt/rt_textures.h"

using namespace smart;
using namespace smart::compat;

namespace {

[[noreturn]] void refuseParameter(RTenum pname) {
    switch (pname) {
    case RT_DEPTH_TEXTURE_MODE:
    case RT_TEXTURE_COMPARE_MODE:
    case RT_TEXTURE_COMPARE_FUNC:
        throwError(ErrorCode::InvalidOperation,
                   "this texture parameter is not part of this release");
    default: throwError(ErrorCode::InvalidEnum, "unknown texture parameter");
    }
}

// A parameter's value as a token, a level or a number. Integers pass exactly through double.

RTint tokenIn(double value) {
    return std::fabs(value) < 0x1p30 ? RTint(std::floor(value + 0.5)) : -1;
}

uint32_t levelIn(double value) {
    if (!(value > -0.5)) throwError(ErrorCode::InvalidValue, "a level is negative");
    return uint32_t(std::min(std::floor(value + 0.5), 0x1p30));
}

float numberIn(double value) {
    if (std::isnan(value)) throwError(ErrorCode::InvalidValue, "the value is not a number");
    return float(value);
}

/// `value`: the first, or only, one; nullptr border: the call has one value only.
void setParameter(Context& c, RTenum target, RTenum pname, double value, const glm::vec4* border) {
    TextureStore& textures = c.recorder().textures();
    const TextureTarget bound = textureTargetOf(target);
    TextureParameters p = textures.parameters(bound);
    TextureOptions& options = p.options;
    switch (pname) {
    case RT_TEXTURE_WRAP_S: options.wrapS = textureWrapOf(tokenIn(value)); break;
    case RT_TEXTURE_WRAP_T: options.wrapT = textureWrapOf(tokenIn(value)); break;
    case RT_TEXTURE_MAG_FILTER: options.magnification = magFilterOf(tokenIn(value)); break;
    case RT_TEXTURE_MIN_FILTER: options.minification = minFilterOf(tokenIn(value)); break;
    case RT_TEXTURE_BORDER_COLOR:
        if (!border)
            throwError(ErrorCode::InvalidEnum, "a colour is set by a call that takes an array");
        for (int k = 0; k < 4; ++k)
            options.border[k] = std::clamp(numberIn(double((*border)[k])), 0.0f, 1.0f);
        break;
    case RT_TEXTURE_MIN_LOD: options.minLevel = numberIn(value); break;
    case RT_TEXTURE_MAX_LOD: options.maxLevel = numberIn(value); break;
    case RT_TEXTURE_LOD_BIAS: options.levelBias = numberIn(value); break;
    case RT_TEXTURE_BASE_LEVEL: options.firstLevel = levelIn(value); break;
    case RT_TEXTURE_MAX_LEVEL: options.lastLevel = levelIn(value); break;
    case RT_GENERATE_MIPMAP: p.generateMipmap = value != 0; break;
    case RT_TEXTURE_PRIORITY: p.priority = std::clamp(numberIn(value), 0.0f, 1.0f); break;
    case RT_TEXTURE_WRAP_R: p.wrapR = textureWrapOf(tokenIn(value)); break;
    default: refuseParameter(pname);
    }
    textures.setParameters(p, bound);
}

void setOne(const char* function, RTenum target, RTenum pname, double value) noexcept {
    recorded(function, [=](Context& c) { setParameter(c, target, pname, value, nullptr); });
}

/// Integers as the components of a colour: the whole range is -1 to 1.
float componentOf(RTint value) {
    return float((2.0 * value + 1.0) / 4294967295.0);
}
float componentOf(RTfloat value) {
    return value;
}

template <class T>
void setSome(const char* function, RTenum target, RTenum pname, const T* params) noexcept {
    glm::vec4 border(0.0f);
    if (params && pname == RT_TEXTURE_BORDER_COLOR)
        for (int k = 0; k < 4; ++k) border[k] = componentOf(params[k]);
    recorded(function, [=, isNull = !params, value = params ? double(params[0]) : 0](Context& c) {
        c.recorder().textures(); // between begin and end nothing is looked at
        if (isNull) throwError(ErrorCode::InvalidValue, "params is NULL");
        setParameter(c, target, pname, value, &border);
    });
}

StateValue one(double value) {
    StateValue result;
    result.values[0] = value;
    return result;
}

StateValue parameterValue(const TextureParameters& p, RTenum pname) {
    const TextureOptions& options = p.options;
    switch (pname) {
    case RT_TEXTURE_WRAP_S: return one(tokenOf(options.wrapS));
    case RT_TEXTURE_WRAP_T: return one(tokenOf(options.wrapT));
    case RT_TEXTURE_MAG_FILTER:
        return one(tokenOf(MinificationFilter{options.magnification, LevelChoice::First}));
    case RT_TEXTURE_MIN_FILTER: return one(tokenOf(options.minification));
    case RT_TEXTURE_BORDER_COLOR: {
        StateValue color;
        color.count = 4;
        color.normalised = true;
        for (int k = 0; k < 4; ++k) color.values[k] = double(options.border[k]);
        return color;
    }
    case RT_TEXTURE_MIN_LOD: return one(double(options.minLevel));
    case RT_TEXTURE_MAX_LOD: return one(double(options.maxLevel));
    case RT_TEXTURE_LOD_BIAS: return one(double(options.levelBias));
    case RT_TEXTURE_BASE_LEVEL: return one(options.firstLevel);
    case RT_TEXTURE_MAX_LEVEL: return one(options.lastLevel);
    case RT_GENERATE_MIPMAP: return one(p.generateMipmap);
    case RT_TEXTURE_RESIDENT: return one(RT_TRUE);
    case RT_TEXTURE_PRIORITY: {
        StateValue priority = one(double(p.priority));
        priority.normalised = true;
        return priority;
    }
    case RT_TEXTURE_WRAP_R: return one(tokenOf(p.wrapR));
    default: refuseParameter(pname);
    }
}

double bitsOf(TexelType type) {
    return 8.0 * double(bytesPerChannel(type));
}

StateValue levelValue(const TextureLevelInfo& info, RTenum pname) {
    const bool alphaOnly = info.format == TexelFormat::Alpha;
    const bool intensity = info.format == TexelFormat::Intensity;
    const uint32_t channels = intensity ? 0 : info.channels;
    switch (pname) {
    case RT_TEXTURE_WIDTH: return one(info.width);
    case RT_TEXTURE_HEIGHT: return one(info.height);
    case RT_TEXTURE_INTERNAL_FORMAT: return one(info.internalFormat);
    case RT_TEXTURE_BORDER: return one(0);
    case RT_TEXTURE_RED_SIZE:
    case RT_TEXTURE_GREEN_SIZE:
    case RT_TEXTURE_BLUE_SIZE: return one(channels > 2 && !alphaOnly ? bitsOf(info.type) : 0.0);
    case RT_TEXTURE_LUMINANCE_SIZE:
        return one(channels == 1 || channels == 2 ? bitsOf(info.type) : 0.0);
    case RT_TEXTURE_ALPHA_SIZE:
        return one(channels > 0 && channels % 2 == 0 ? bitsOf(info.type) : 0.0);
    case RT_TEXTURE_INTENSITY_SIZE: return one(intensity ? bitsOf(info.type) : 0.0);
    case RT_TEXTURE_DEPTH_SIZE:
    case RT_TEXTURE_COMPRESSED: return one(0);
    case RT_TEXTURE_DEPTH: return one(info.channels ? 1 : 0);
    case RT_TEXTURE_COMPRESSED_IMAGE_SIZE:
        throwError(ErrorCode::InvalidOperation, "the image is not compressed");
    default: throwError(ErrorCode::InvalidEnum, "unknown value of a level");
    }
}

template <class T>
void getParameter(const char* function, RTenum target, RTenum pname, T* params) noexcept {
    guarded(function, [&](Context& c) {
        const TextureStore& textures = c.recorder().textures();
        const StateValue value =
            parameterValue(textures.parameters(textureTargetOf(target)), pname);
        requirePointer(params, "params");
        for (int i = 0; i < value.count; ++i) params[i] = value.as<T>(i);
    });
}

template <class T>
void getLevelParameter(const char* function, RTenum target, RTint level, RTenum pname,
                       T* params) noexcept {
    guarded(function, [&](Context& c) {
        const TextureStore& textures = c.recorder().textures();
        const std::optional<TextureTarget> proxied = proxiedTargetOf(target);
        const TextureTarget bound = proxied ? *proxied : textureTargetOf(target);
        if (level < 0 || uint32_t(level) > TextureStore::kMaxLevel)
            throwError(ErrorCode::InvalidValue, "levels go from 0 to 14");
        const auto number = uint32_t(level);
        const StateValue value = levelValue(
            proxied ? textures.proxy(number, bound) : textures.info(number, bound), pname);
        requirePointer(params, "params");
        *params = value.as<T>(0);
    });
}

} // namespace

RTAPI void RTAPIENTRY rtTexParameteri(RTenum target, RTenum pname, RTint param) {
    setOne(__func__, target, pname, param);
}
RTAPI void RTAPIENTRY rtTexParameterf(RTenum target, RTenum pname, RTfloat param) {
    setOne(__func__, target, pname, double(param));
}
RTAPI void RTAPIENTRY rtTexParameteriv(RTenum target, RTenum pname, const RTint* params) {
    setSome(__func__, target, pname, params);
}
RTAPI void RTAPIENTRY rtTexParameterfv(RTenum target, RTenum pname, const RTfloat* params) {
    setSome(__func__, target, pname, params);
}
RTAPI void RTAPIENTRY rtGetTexParameteriv(RTenum target, RTenum pname, RTint* params) {
    getParameter(__func__, target, pname, params);
}
RTAPI void RTAPIENTRY rtGetTexParameterfv(RTenum target, RTenum pname, RTfloat* params) {
    getParameter(__func__, target, pname, params);
}
RTAPI void RTAPIENTRY rtGetTexLevelParameteriv(RTenum target, RTint level, RTenum pname,
                                               RTint* params) {
    getLevelParameter(__func__, target, level, pname, params);
}
RTAPI void RTAPIENTRY rtGetTexLevelParameterfv(RTenum target, RTint level, RTenum pname,
                                               RTfloat* params) {
    getLevelParameter(__func__, target, level, pname, params);
}

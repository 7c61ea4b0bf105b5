// SPDX-License-Identifier: MIT
// The texture units and their environments (OpenGL 1.5, sections 3.8.13 to 3.8.16).
#include <glm/common.hpp>

#include "compat/openrt/call_values.h"
#include "compat/openrt/fixed_tokens.h"
#include "openrt/rt_fixed.h"

using namespace smart;
using namespace smart::compat;

namespace {

int envValues(RTenum pname) {
    return pname == RT_TEXTURE_ENV_COLOR ? 4 : 1;
}

float scaleIn(const CallValues& values) {
    const float scale = values.number();
    if (scale != 1 && scale != 2 && scale != 4)
        throwError(ErrorCode::InvalidValue, "a scale is 1, 2 or 4");
    return scale;
}

void setCombine(TexEnvCombine& combine, RTenum pname, const CallValues& values) {
    switch (pname) {
    case RT_COMBINE_RGB: combine.rgb = combineFunctionOf(values.token(), false); break;
    case RT_COMBINE_ALPHA: combine.alpha = combineFunctionOf(values.token(), true); break;
    case RT_SOURCE0_RGB:
    case RT_SOURCE1_RGB:
    case RT_SOURCE2_RGB:
        combine.rgbSource[pname - RT_SOURCE0_RGB] = combineSourceOf(values.token());
        break;
    case RT_SOURCE0_ALPHA:
    case RT_SOURCE1_ALPHA:
    case RT_SOURCE2_ALPHA:
        combine.alphaSource[pname - RT_SOURCE0_ALPHA] = combineSourceOf(values.token());
        break;
    case RT_OPERAND0_RGB:
    case RT_OPERAND1_RGB:
    case RT_OPERAND2_RGB:
        combine.rgbOperand[pname - RT_OPERAND0_RGB] = combineOperandOf(values.token(), false);
        break;
    case RT_OPERAND0_ALPHA:
    case RT_OPERAND1_ALPHA:
    case RT_OPERAND2_ALPHA:
        combine.alphaOperand[pname - RT_OPERAND0_ALPHA] = combineOperandOf(values.token(), true);
        break;
    case RT_RGB_SCALE: combine.rgbScale = scaleIn(values); break;
    case RT_ALPHA_SCALE: combine.alphaScale = scaleIn(values); break;
    default: throwError(ErrorCode::InvalidEnum, "unknown property of the texture environment");
    }
}

void setTexEnv(const char* function, RTenum target, RTenum pname,
               const CallValues& values) noexcept {
    recorded(function, [=](Context& c) {
        FixedStateRecorder& fixed = c.recorder().fixedState();
        FixedTexture texture = fixed.texture();
        if (target == RT_TEXTURE_FILTER_CONTROL) {
            if (pname != RT_TEXTURE_LOD_BIAS)
                throwError(ErrorCode::InvalidEnum, "the filter control is RT_TEXTURE_LOD_BIAS");
            texture.lodBias = values.number();
        } else if (target != RT_TEXTURE_ENV) {
            throwError(ErrorCode::InvalidEnum,
                       "the target is RT_TEXTURE_ENV or RT_TEXTURE_FILTER_CONTROL");
        } else if (pname == RT_TEXTURE_ENV_MODE) {
            texture.mode = texEnvModeOf(values.token());
        } else if (pname == RT_TEXTURE_ENV_COLOR) {
            texture.color = glm::clamp(values.color(), glm::vec4(0.0f), glm::vec4(1.0f));
        } else {
            setCombine(texture.combine, pname, values);
        }
        fixed.changeTexture() = texture;
    });
}

StateValue combineValue(const TexEnvCombine& combine, RTenum pname) {
    switch (pname) {
    case RT_COMBINE_RGB: return StateValue::number(tokenOf(combine.rgb));
    case RT_COMBINE_ALPHA: return StateValue::number(tokenOf(combine.alpha));
    case RT_SOURCE0_RGB:
    case RT_SOURCE1_RGB:
    case RT_SOURCE2_RGB:
        return StateValue::number(tokenOf(combine.rgbSource[pname - RT_SOURCE0_RGB]));
    case RT_SOURCE0_ALPHA:
    case RT_SOURCE1_ALPHA:
    case RT_SOURCE2_ALPHA:
        return StateValue::number(tokenOf(combine.alphaSource[pname - RT_SOURCE0_ALPHA]));
    case RT_OPERAND0_RGB:
    case RT_OPERAND1_RGB:
    case RT_OPERAND2_RGB:
        return StateValue::number(tokenOf(combine.rgbOperand[pname - RT_OPERAND0_RGB]));
    case RT_OPERAND0_ALPHA:
    case RT_OPERAND1_ALPHA:
    case RT_OPERAND2_ALPHA:
        return StateValue::number(tokenOf(combine.alphaOperand[pname - RT_OPERAND0_ALPHA]));
    case RT_RGB_SCALE: return StateValue::number(combine.rgbScale);
    case RT_ALPHA_SCALE: return StateValue::number(combine.alphaScale);
    default: throwError(ErrorCode::InvalidEnum, "unknown property of the texture environment");
    }
}

template <class T>
void getTexEnv(const char* function, RTenum target, RTenum pname, T* params) noexcept {
    guarded(function, [&](Context& c) {
        c.recorder().requireOutsidePrimitive();
        const FixedTexture& texture = c.recorder().fixedTextureNow();
        if (target == RT_TEXTURE_FILTER_CONTROL && pname == RT_TEXTURE_LOD_BIAS)
            return give(StateValue::number(texture.lodBias), params);
        if (target != RT_TEXTURE_ENV)
            throwError(ErrorCode::InvalidEnum,
                       "the target is RT_TEXTURE_ENV, or RT_TEXTURE_FILTER_CONTROL for "
                       "RT_TEXTURE_LOD_BIAS");
        switch (pname) {
        case RT_TEXTURE_ENV_MODE: return give(StateValue::number(tokenOf(texture.mode)), params);
        case RT_TEXTURE_ENV_COLOR: return give(StateValue::vector(texture.color, true), params);
        default: return give(combineValue(texture.combine, pname), params);
        }
    });
}

} // namespace

RTAPI void RTAPIENTRY rtTexEnvf(RTenum target, RTenum pname, RTfloat param) {
    setTexEnv(__func__, target, pname, CallValues::one(param));
}
RTAPI void RTAPIENTRY rtTexEnvi(RTenum target, RTenum pname, RTint param) {
    setTexEnv(__func__, target, pname, CallValues::one(param));
}
RTAPI void RTAPIENTRY rtTexEnvfv(RTenum target, RTenum pname, const RTfloat* params) {
    setTexEnv(__func__, target, pname, CallValues::array(params, envValues(pname)));
}
RTAPI void RTAPIENTRY rtTexEnviv(RTenum target, RTenum pname, const RTint* params) {
    setTexEnv(__func__, target, pname, CallValues::array(params, envValues(pname)));
}
RTAPI void RTAPIENTRY rtGetTexEnvfv(RTenum target, RTenum pname, RTfloat* params) {
    getTexEnv(__func__, target, pname, params);
}
RTAPI void RTAPIENTRY rtGetTexEnviv(RTenum target, RTenum pname, RTint* params) {
    getTexEnv(__func__, target, pname, params);
}

RTAPI void RTAPIENTRY rtActiveTexture(RTenum texture) {
    recorded(__func__, [=](Context& c) {
        c.recorder().requireOutsidePrimitive();
        c.recorder().selectTextureUnit(textureUnitOf(texture));
    });
}

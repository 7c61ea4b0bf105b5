// SPDX-License-Identifier: MIT
// Lights, the light model, materials, the shade model (OpenGL 1.5, sections 2.13 and 2.14).
#include <glm/matrix.hpp>

#include "compat/openrt/call_values.h"
#include "compat/openrt/fixed_tokens.h"
#include "openrt/rt_fixed.h"

using namespace smart;
using namespace smart::compat;

namespace {

int lightNumber(RTenum light) {
    if (light < RT_LIGHT0 || light - RT_LIGHT0 >= RTenum(kFixedLights))
        throwError(ErrorCode::InvalidEnum, "there are RT_LIGHT0 to RT_LIGHT7");
    return int(light - RT_LIGHT0);
}

/// How many values rtLight's array has; 0 for an unknown name.
int lightValues(RTenum pname) {
    switch (pname) {
    case RT_AMBIENT:
    case RT_DIFFUSE:
    case RT_SPECULAR:
    case RT_POSITION: return 4;
    case RT_SPOT_DIRECTION: return 3;
    case RT_SPOT_EXPONENT:
    case RT_SPOT_CUTOFF:
    case RT_CONSTANT_ATTENUATION:
    case RT_LINEAR_ATTENUATION:
    case RT_QUADRATIC_ATTENUATION: return 1;
    default: return 0;
    }
}

float attenuation(const CallValues& values) {
    const float factor = values.number();
    if (!(factor >= 0)) throwError(ErrorCode::InvalidValue, "an attenuation is below 0");
    return factor;
}

void setLight(const char* function, RTenum name, RTenum pname, const CallValues& values) noexcept {
    recorded(function, [=](Context& c) {
        FixedStateRecorder& fixed = c.recorder().fixedState();
        const int i = lightNumber(name);
        FixedLight light = fixed.state().lighting.lights[i];
        switch (pname) {
        case RT_AMBIENT: light.ambient = values.color(); break;
        case RT_DIFFUSE: light.diffuse = values.color(); break;
        case RT_SPECULAR: light.specular = values.color(); break;
        case RT_POSITION:
            light.position =
                glm::vec4(c.recorder().matrices().modelView() * glm::dvec4(values.doubles()));
            break;
        case RT_SPOT_DIRECTION:
            light.spotDirection = glm::vec3(glm::dmat3(c.recorder().matrices().modelView()) *
                                            glm::dvec3(values.direction()));
            break;
        case RT_SPOT_EXPONENT:
            light.spotExponent = values.number();
            if (!(light.spotExponent >= 0 && light.spotExponent <= 128))
                throwError(ErrorCode::InvalidValue, "a spot exponent is 0 to 128");
            break;
        case RT_SPOT_CUTOFF:
            light.spotCutoff = values.number();
            if (!(light.spotCutoff >= 0 && light.spotCutoff <= 90) && light.spotCutoff != 180)
                throwError(ErrorCode::InvalidValue, "a spot's cut-off angle is 0 to 90, or 180");
            break;
        case RT_CONSTANT_ATTENUATION: light.constantAttenuation = attenuation(values); break;
        case RT_LINEAR_ATTENUATION: light.linearAttenuation = attenuation(values); break;
        case RT_QUADRATIC_ATTENUATION: light.quadraticAttenuation = attenuation(values); break;
        default: throwError(ErrorCode::InvalidEnum, "unknown property of a light");
        }
        fixed.change().lighting.lights[i] = light;
    });
}

template <class T>
void getLight(const char* function, RTenum name, RTenum pname, T* params) noexcept {
    guarded(function, [&](Context& c) {
        c.recorder().requireOutsidePrimitive();
        const FixedLight& light = c.recorder().fixedStateNow().lighting.lights[lightNumber(name)];
        switch (pname) {
        case RT_AMBIENT: return give(StateValue::vector(light.ambient, true), params);
        case RT_DIFFUSE: return give(StateValue::vector(light.diffuse, true), params);
        case RT_SPECULAR: return give(StateValue::vector(light.specular, true), params);
        case RT_POSITION: return give(StateValue::vector(light.position, false), params);
        case RT_SPOT_DIRECTION:
            return give(StateValue::vector(light.spotDirection, false), params);
        case RT_SPOT_EXPONENT: return give(StateValue::number(light.spotExponent), params);
        case RT_SPOT_CUTOFF: return give(StateValue::number(light.spotCutoff), params);
        case RT_CONSTANT_ATTENUATION:
            return give(StateValue::number(light.constantAttenuation), params);
        case RT_LINEAR_ATTENUATION:
            return give(StateValue::number(light.linearAttenuation), params);
        case RT_QUADRATIC_ATTENUATION:
            return give(StateValue::number(light.quadraticAttenuation), params);
        default: throwError(ErrorCode::InvalidEnum, "unknown property of a light");
        }
    });
}

void setLightModel(const char* function, RTenum pname, const CallValues& values) noexcept {
    recorded(function, [=](Context& c) {
        FixedStateRecorder& fixed = c.recorder().fixedState();
        switch (pname) {
        case RT_LIGHT_MODEL_AMBIENT: {
            const glm::vec4 ambient = values.color();
            fixed.change().lighting.modelAmbient = ambient;
            break;
        }
        case RT_LIGHT_MODEL_LOCAL_VIEWER: {
            const bool local = values.isTrue();
            fixed.change().lighting.localViewer = local;
            break;
        }
        case RT_LIGHT_MODEL_TWO_SIDE: {
            const bool twoSided = values.isTrue();
            fixed.change().lighting.twoSided = twoSided;
            break;
        }
        case RT_LIGHT_MODEL_COLOR_CONTROL: {
            const RTenum control = values.token();
            if (control != RT_SINGLE_COLOR && control != RT_SEPARATE_SPECULAR_COLOR)
                throwError(ErrorCode::InvalidEnum, "unknown colour control");
            fixed.change().lighting.separateSpecular = control == RT_SEPARATE_SPECULAR_COLOR;
            break;
        }
        default: throwError(ErrorCode::InvalidEnum, "unknown property of the light model");
        }
    });
}

int lightModelValues(RTenum pname) {
    switch (pname) {
    case RT_LIGHT_MODEL_AMBIENT: return 4;
    case RT_LIGHT_MODEL_LOCAL_VIEWER:
    case RT_LIGHT_MODEL_TWO_SIDE:
    case RT_LIGHT_MODEL_COLOR_CONTROL: return 1;
    default: return 0;
    }
}

int materialValues(RTenum pname) {
    switch (pname) {
    case RT_AMBIENT:
    case RT_DIFFUSE:
    case RT_AMBIENT_AND_DIFFUSE:
    case RT_SPECULAR:
    case RT_EMISSION: return 4;
    case RT_COLOR_INDEXES: return 3;
    case RT_SHININESS:
    case RT_REFLECTION: return 1;
    default: return 0;
    }
}

void setMaterial(FixedMaterial& material, RTenum pname, const CallValues& values) {
    switch (pname) {
    case RT_AMBIENT: material.ambient = values.color(); break;
    case RT_DIFFUSE: material.diffuse = values.color(); break;
    case RT_AMBIENT_AND_DIFFUSE: material.ambient = material.diffuse = values.color(); break;
    case RT_SPECULAR: material.specular = values.color(); break;
    case RT_EMISSION: material.emission = values.color(); break;
    case RT_SHININESS:
        material.shininess = values.number();
        if (!(material.shininess >= 0 && material.shininess <= 128))
            throwError(ErrorCode::InvalidValue, "a shininess is 0 to 128");
        break;
    case RT_REFLECTION:
        material.reflection = values.number();
        if (!(material.reflection >= 0 && material.reflection <= 1))
            throwError(ErrorCode::InvalidValue, "a reflection is 0 to 1");
        break;
    case RT_COLOR_INDEXES:
        values.direction();
        throwError(ErrorCode::InvalidOperation, "there are no colour indices");
    default: throwError(ErrorCode::InvalidEnum, "unknown property of a material");
    }
}

void setMaterial(const char* function, RTenum faces, RTenum pname,
                 const CallValues& values) noexcept {
    const uint64_t attribute = uint64_t(faces) << 32 | pname;
    recordedAttribute(function, attribute, [=](Context& c) {
        Recorder& recorder = c.recorder();
        const FixedFace face = fixedFaceOf(faces);
        FixedMaterials materials = recorder.materials();
        if (face != FixedFace::Back) setMaterial(materials.front, pname, values);
        if (face != FixedFace::Front) setMaterial(materials.back, pname, values);
        recorder.setMaterials(materials);
    });
}

template <class T>
void getMaterial(const char* function, RTenum side, RTenum pname, T* params) noexcept {
    guarded(function, [&](Context& c) {
        c.recorder().requireOutsidePrimitive();
        const FixedMaterials materials = c.recorder().materials();
        if (side != RT_FRONT && side != RT_BACK)
            throwError(ErrorCode::InvalidEnum, "a side is RT_FRONT or RT_BACK");
        const FixedMaterial& material = side == RT_FRONT ? materials.front : materials.back;
        switch (pname) {
        case RT_AMBIENT: return give(StateValue::vector(material.ambient, true), params);
        case RT_DIFFUSE: return give(StateValue::vector(material.diffuse, true), params);
        case RT_SPECULAR: return give(StateValue::vector(material.specular, true), params);
        case RT_EMISSION: return give(StateValue::vector(material.emission, true), params);
        case RT_SHININESS: return give(StateValue::number(material.shininess), params);
        case RT_REFLECTION: return give(StateValue::number(material.reflection), params);
        case RT_COLOR_INDEXES:
            throwError(ErrorCode::InvalidOperation, "there are no colour indices");
        default: throwError(ErrorCode::InvalidEnum, "unknown property of a material");
        }
    });
}

} // namespace

RTAPI void RTAPIENTRY rtLightf(RTenum light, RTenum pname, RTfloat param) {
    setLight(__func__, light, pname, CallValues::one(param));
}
RTAPI void RTAPIENTRY rtLighti(RTenum light, RTenum pname, RTint param) {
    setLight(__func__, light, pname, CallValues::one(param));
}
RTAPI void RTAPIENTRY rtLightfv(RTenum light, RTenum pname, const RTfloat* params) {
    setLight(__func__, light, pname, CallValues::array(params, lightValues(pname)));
}
RTAPI void RTAPIENTRY rtLightiv(RTenum light, RTenum pname, const RTint* params) {
    setLight(__func__, light, pname, CallValues::array(params, lightValues(pname)));
}
RTAPI void RTAPIENTRY rtGetLightfv(RTenum light, RTenum pname, RTfloat* params) {
    getLight(__func__, light, pname, params);
}
RTAPI void RTAPIENTRY rtGetLightiv(RTenum light, RTenum pname, RTint* params) {
    getLight(__func__, light, pname, params);
}

RTAPI void RTAPIENTRY rtLightModelf(RTenum pname, RTfloat param) {
    setLightModel(__func__, pname, CallValues::one(param));
}
RTAPI void RTAPIENTRY rtLightModeli(RTenum pname, RTint param) {
    setLightModel(__func__, pname, CallValues::one(param));
}
RTAPI void RTAPIENTRY rtLightModelfv(RTenum pname, const RTfloat* params) {
    setLightModel(__func__, pname, CallValues::array(params, lightModelValues(pname)));
}
RTAPI void RTAPIENTRY rtLightModeliv(RTenum pname, const RTint* params) {
    setLightModel(__func__, pname, CallValues::array(params, lightModelValues(pname)));
}

RTAPI void RTAPIENTRY rtMaterialf(RTenum face, RTenum pname, RTfloat param) {
    setMaterial(__func__, face, pname, CallValues::one(param));
}
RTAPI void RTAPIENTRY rtMateriali(RTenum face, RTenum pname, RTint param) {
    setMaterial(__func__, face, pname, CallValues::one(param));
}
RTAPI void RTAPIENTRY rtMaterialfv(RTenum face, RTenum pname, const RTfloat* params) {
    setMaterial(__func__, face, pname, CallValues::array(params, materialValues(pname)));
}
RTAPI void RTAPIENTRY rtMaterialiv(RTenum face, RTenum pname, const RTint* params) {
    setMaterial(__func__, face, pname, CallValues::array(params, materialValues(pname)));
}
RTAPI void RTAPIENTRY rtGetMaterialfv(RTenum face, RTenum pname, RTfloat* params) {
    getMaterial(__func__, face, pname, params);
}
RTAPI void RTAPIENTRY rtGetMaterialiv(RTenum face, RTenum pname, RTint* params) {
    getMaterial(__func__, face, pname, params);
}

RTAPI void RTAPIENTRY rtColorMaterial(RTenum face, RTenum mode) {
    recorded(__func__, [=](Context& c) {
        FixedStateRecorder& fixed = c.recorder().fixedState();
        const FixedFace followingFace = fixedFaceOf(face);
        const ColorMaterialMode followingMode = colorMaterialModeOf(mode);
        c.recorder().setMaterials(c.recorder().materials()); // what followed so far stays
        FixedLighting& lighting = fixed.change().lighting;
        lighting.colorMaterialFace = followingFace;
        lighting.colorMaterialMode = followingMode;
    });
}

RTAPI void RTAPIENTRY rtShadeModel(RTenum mode) {
    recorded(__func__, [=](Context& c) {
        FixedStateRecorder& fixed = c.recorder().fixedState();
        const ShadeModel model = shadeModelOf(mode);
        fixed.change().lighting.shadeModel = model;
    });
}

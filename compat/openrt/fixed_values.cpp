// SPDX-License-Identifier: MIT
#include "compat/openrt/fixed_values.h"

#include "compat/openrt/fixed_tokens.h"
#include "openrt/enums.h"

namespace smart::compat {

namespace {

StateValue list(std::initializer_list<double> numbers) {
    return StateValue::list(numbers);
}
StateValue number(double n) {
    return StateValue::number(n);
}
template <class Vector>
StateValue color(const Vector& v) {
    return StateValue::vector(v, true);
}
/// A number between -1 and 1 that becomes the whole range of integers.
StateValue normalised(double n) {
    StateValue value = number(n);
    value.normalised = true;
    return value;
}

std::optional<StateValue> currentValue(const Attributes& attributes, RTenum name) {
    switch (name) {
    case RT_EDGE_FLAG: return number(attributes.edgeFlag);
    case RT_CURRENT_SECONDARY_COLOR: return color(attributes.secondaryColor);
    case RT_CURRENT_FOG_COORDINATE: return number(attributes.fogCoordinate);
    case RT_CURRENT_INDEX: return number(1);
    default: return std::nullopt;
    }
}

std::optional<StateValue> lightingValue(const FixedState& state, RTenum name) {
    const FixedLighting& lighting = state.lighting;
    const FixedFog& fog = state.fog;
    switch (name) {
    case RT_SHADE_MODEL: return number(tokenOf(lighting.shadeModel));
    case RT_COLOR_MATERIAL_FACE: return number(tokenOf(lighting.colorMaterialFace));
    case RT_COLOR_MATERIAL_PARAMETER: return number(tokenOf(lighting.colorMaterialMode));
    case RT_LIGHT_MODEL_AMBIENT: return color(lighting.modelAmbient);
    case RT_LIGHT_MODEL_LOCAL_VIEWER: return number(lighting.localViewer);
    case RT_LIGHT_MODEL_TWO_SIDE: return number(lighting.twoSided);
    case RT_LIGHT_MODEL_COLOR_CONTROL:
        return number(lighting.separateSpecular ? RT_SEPARATE_SPECULAR_COLOR : RT_SINGLE_COLOR);
    case RT_MAX_LIGHTS: return number(kFixedLights);
    case RT_FOG_MODE: return number(tokenOf(fog.mode));
    case RT_FOG_DENSITY: return number(fog.density);
    case RT_FOG_START: return number(fog.start);
    case RT_FOG_END: return number(fog.end);
    case RT_FOG_COLOR: return color(fog.color);
    case RT_FOG_INDEX: return number(0);
    case RT_FOG_COORDINATE_SOURCE:
        return number(fog.fromCoordinate ? RT_FOG_COORDINATE : RT_FRAGMENT_DEPTH);
    default: return std::nullopt;
    }
}

std::optional<StateValue> rasterValue(const FixedRaster& raster, RTenum name) {
    switch (name) {
    case RT_POINT_SIZE: return number(raster.pointSize);
    case RT_POINT_SIZE_MIN: return number(raster.pointSizeMin);
    case RT_POINT_SIZE_MAX: return number(raster.pointSizeMax);
    case RT_POINT_FADE_THRESHOLD_SIZE: return number(raster.pointFadeThreshold);
    case RT_POINT_DISTANCE_ATTENUATION:
        return list({raster.pointAttenuation.x, raster.pointAttenuation.y,
                     raster.pointAttenuation.z});
    case RT_LINE_WIDTH: return number(raster.lineWidth);
    case RT_LINE_STIPPLE_PATTERN: return number(raster.linePattern);
    case RT_LINE_STIPPLE_REPEAT: return number(raster.lineFactor);
    case RT_CULL_FACE_MODE: return number(tokenOf(raster.cullFace));
    case RT_FRONT_FACE: return number(raster.frontFaceClockwise ? RT_CW : RT_CCW);
    case RT_POLYGON_MODE:
        return list({double(tokenOf(raster.polygonMode[0])),
                     double(tokenOf(raster.polygonMode[1]))});
    case RT_POLYGON_OFFSET_FACTOR: return number(raster.offsetFactor);
    case RT_POLYGON_OFFSET_UNITS: return number(raster.offsetUnits);
    case RT_MAX_CLIP_PLANES: return number(kFixedClipPlanes);
    // One size after the other, as far as anybody draws.
    case RT_SMOOTH_POINT_SIZE_RANGE:
    case RT_ALIASED_POINT_SIZE_RANGE:
    case RT_SMOOTH_LINE_WIDTH_RANGE:
    case RT_ALIASED_LINE_WIDTH_RANGE: return list({1, 255});
    case RT_SMOOTH_POINT_SIZE_GRANULARITY:
    case RT_SMOOTH_LINE_WIDTH_GRANULARITY: return number(0.125);
    default: return std::nullopt;
    }
}

std::optional<StateValue> fragmentValue(const FixedFragmentOps& ops, RTenum name) {
    switch (name) {
    case RT_ALPHA_TEST_FUNC: return number(tokenOf(ops.alphaFunction));
    case RT_ALPHA_TEST_REF: return normalised(ops.alphaReference);
    case RT_BLEND_SRC:
    case RT_BLEND_SRC_RGB: return number(tokenOf(ops.sourceRgb));
    case RT_BLEND_DST:
    case RT_BLEND_DST_RGB: return number(tokenOf(ops.destinationRgb));
    case RT_BLEND_SRC_ALPHA: return number(tokenOf(ops.sourceAlpha));
    case RT_BLEND_DST_ALPHA: return number(tokenOf(ops.destinationAlpha));
    case RT_BLEND_EQUATION: return number(tokenOf(ops.blendEquation));
    case RT_BLEND_COLOR: return color(ops.blendColor);
    case RT_LOGIC_OP_MODE: return number(RT_CLEAR + ops.logicOp);
    case RT_DEPTH_FUNC: return number(tokenOf(ops.depthFunction));
    case RT_DEPTH_WRITEMASK: return number(ops.depthMask);
    case RT_COLOR_WRITEMASK:
        return list({double(ops.colorMask[0]), double(ops.colorMask[1]),
                     double(ops.colorMask[2]), double(ops.colorMask[3])});
    default: return std::nullopt;
    }
}

RTenum tokenOf(HintMode mode) {
    switch (mode) {
    case HintMode::Fastest: return RT_FASTEST;
    case HintMode::Nicest: return RT_NICEST;
    case HintMode::DontCare: break;
    }
    return RT_DONT_CARE;
}

RTenum tokenOf(StencilOperation operation) {
    constexpr RTenum kTokens[] = {RT_KEEP, RT_ZERO,   RT_REPLACE,   RT_INCR,
                                  RT_DECR, RT_INVERT, RT_INCR_WRAP, RT_DECR_WRAP};
    return kTokens[int(operation)];
}

std::optional<StateValue> idleValue(const IdleState& idle, RTenum name) {
    switch (name) {
    case RT_PERSPECTIVE_CORRECTION_HINT: return number(tokenOf(idle.hints.perspectiveCorrection));
    case RT_POINT_SMOOTH_HINT: return number(tokenOf(idle.hints.pointSmooth));
    case RT_LINE_SMOOTH_HINT: return number(tokenOf(idle.hints.lineSmooth));
    case RT_POLYGON_SMOOTH_HINT: return number(tokenOf(idle.hints.polygonSmooth));
    case RT_FOG_HINT: return number(tokenOf(idle.hints.fog));
    case RT_GENERATE_MIPMAP_HINT: return number(tokenOf(idle.hints.generateMipmap));
    case RT_TEXTURE_COMPRESSION_HINT: return number(tokenOf(idle.hints.textureCompression));
    case RT_STENCIL_FUNC: return number(smart::compat::tokenOf(idle.stencil.function));
    case RT_STENCIL_REF: return number(0);
    case RT_STENCIL_VALUE_MASK: return number(idle.stencil.valueMask);
    case RT_STENCIL_WRITEMASK: return number(idle.stencil.writeMask);
    case RT_STENCIL_FAIL: return number(tokenOf(idle.stencil.fail));
    case RT_STENCIL_PASS_DEPTH_FAIL: return number(tokenOf(idle.stencil.depthFail));
    case RT_STENCIL_PASS_DEPTH_PASS: return number(tokenOf(idle.stencil.depthPass));
    case RT_STENCIL_CLEAR_VALUE: return number(idle.stencil.clear);
    case RT_ACCUM_CLEAR_VALUE: return color(idle.accumClear);
    case RT_SAMPLE_COVERAGE_VALUE: return number(idle.sampleCoverage);
    case RT_SAMPLE_COVERAGE_INVERT: return number(idle.sampleCoverageInvert);
    default: return std::nullopt;
    }
}

/// What never changes, or not by calls of OpenGL's.
std::optional<StateValue> fixedLimit(Context& context, RTenum name) {
    switch (name) {
    case RT_ATTRIB_STACK_DEPTH: return number(double(context.attribStack().depth()));
    case RT_CLIENT_ATTRIB_STACK_DEPTH:
        return number(double(context.clientAttribStack().depth()));
    case RT_MAX_ATTRIB_STACK_DEPTH: return number(double(AttribStack::kDepth));
    case RT_MAX_CLIENT_ATTRIB_STACK_DEPTH: return number(double(ClientAttribStack::kDepth));
    case RT_ACTIVE_TEXTURE:
        return number(double(RT_TEXTURE0 + context.recorder().textureUnit()));
    case RT_MAX_TEXTURE_UNITS: return number(double(kTextureUnits));
    case RT_MAX_TEXTURE_LOD_BIAS: return number(double(TextureOptions::kMaxBias));
    case RT_TEXTURE_BINDING_3D:
    case RT_TEXTURE_BINDING_CUBE_MAP:
    case RT_NUM_COMPRESSED_TEXTURE_FORMATS: return number(0);
    case RT_MAX_3D_TEXTURE_SIZE:
    case RT_MAX_CUBE_MAP_TEXTURE_SIZE: return number(0);
    case RT_RENDER_MODE: return number(RT_RENDER);
    case RT_NAME_STACK_DEPTH: return number(0);
    case RT_MAX_NAME_STACK_DEPTH: return number(64);
    case RT_SUBPIXEL_BITS:
    case RT_RED_BITS:
    case RT_GREEN_BITS:
    case RT_BLUE_BITS:
    case RT_ALPHA_BITS: return number(8);
    case RT_MAX_ELEMENTS_VERTICES:
    case RT_MAX_ELEMENTS_INDICES: return number(1 << 20);
    case RT_RGBA_MODE:
    case RT_DOUBLEBUFFER: return number(1);
    case RT_INDEX_MODE:
    case RT_STEREO:
    case RT_AUX_BUFFERS:
    case RT_SAMPLE_BUFFERS:
    case RT_INDEX_BITS:
    case RT_STENCIL_BITS:
    case RT_ACCUM_RED_BITS:
    case RT_ACCUM_GREEN_BITS:
    case RT_ACCUM_BLUE_BITS:
    case RT_ACCUM_ALPHA_BITS: return number(0);
    case RT_DEPTH_BITS: return number(32);
    default: return std::nullopt;
    }
}

} // namespace

std::optional<StateValue> fixedStateValue(Context& context, RTenum name) {
    const Recorder& recorder = context.recorder();
    const FixedState& state = recorder.fixedStateNow();
    if (const auto value = currentValue(recorder.attributes(), name)) return value;
    if (const auto value = lightingValue(state, name)) return value;
    if (const auto value = rasterValue(state.raster, name)) return value;
    if (const auto value = fragmentValue(state.ops, name)) return value;
    if (const auto value = idleValue(recorder.idleStateNow(), name)) return value;
    return fixedLimit(context, name);
}

} // namespace smart::compat

// SPDX-License-Identifier: MIT
#include "compat/openrt/capabilities.h"

#include <optional>
#include <string>

#include "compat/openrt/array_names.h"
#include "compat/openrt/guard.h"
#include "compat/openrt/tokens.h"
#include "openrt/enums.h"

namespace smart::compat {

namespace {

/// A switch of a texture unit; nullptr: none of it.
template <class Texture>
auto textureSwitchOf(Texture& texture, RTenum cap) -> decltype(&texture.enabled2D) {
    if (cap >= RT_TEXTURE_GEN_S && cap <= RT_TEXTURE_GEN_Q)
        return &texture.generate[cap - RT_TEXTURE_GEN_S].enabled;
    switch (cap) {
    case RT_TEXTURE_1D: return &texture.enabled1D;
    case RT_TEXTURE_2D: return &texture.enabled2D;
    default: return nullptr;
    }
}

/// A switch of the rest of the state that pictures depend on; nullptr: none of it.
template <class State>
auto switchOf(State& state, RTenum cap) -> decltype(&state.fog.enabled) {
    if (cap >= RT_LIGHT0 && cap - RT_LIGHT0 < RTenum(kFixedLights))
        return &state.lighting.lights[cap - RT_LIGHT0].enabled;
    if (cap >= RT_CLIP_PLANE0 && cap - RT_CLIP_PLANE0 < RTenum(kFixedClipPlanes))
        return &state.raster.clip[cap - RT_CLIP_PLANE0];
    switch (cap) {
    case RT_LIGHTING: return &state.lighting.enabled;
    case RT_NORMALIZE: return &state.lighting.normalize;
    case RT_RESCALE_NORMAL: return &state.lighting.rescaleNormal;
    case RT_COLOR_MATERIAL: return &state.lighting.colorMaterial;
    case RT_SHADOWS: return &state.lighting.shadows;
    case RT_REFLECTIONS: return &state.lighting.reflections;
    case RT_FOG: return &state.fog.enabled;
    case RT_COLOR_SUM: return &state.lighting.colorSum;
    case RT_ALPHA_TEST: return &state.ops.alphaTest;
    case RT_DEPTH_TEST: return &state.ops.depthTest;
    case RT_BLEND: return &state.ops.blend;
    case RT_COLOR_LOGIC_OP: return &state.ops.colorLogicOp;
    case RT_CULL_FACE: return &state.raster.cull;
    case RT_POLYGON_OFFSET_FILL: return &state.raster.offsetFill;
    case RT_POLYGON_OFFSET_LINE: return &state.raster.offsetLine;
    case RT_POLYGON_OFFSET_POINT: return &state.raster.offsetPoint;
    case RT_POLYGON_STIPPLE: return &state.raster.polygonStippled;
    case RT_POINT_SMOOTH: return &state.raster.pointSmooth;
    case RT_LINE_SMOOTH: return &state.raster.lineSmooth;
    case RT_POLYGON_SMOOTH: return &state.raster.polygonSmooth;
    case RT_LINE_STIPPLE: return &state.raster.lineStippled;
    default: return nullptr;
    }
}

/// One of the frame, or of what no picture depends on.
bool* otherSwitchOf(FrameSettings& settings, IdleState& idle, RTenum cap) {
    switch (cap) {
    case RT_FRAMEBUFFER_SRGB: return &settings.target.srgb;
    case RT_MULTISAMPLE: return &settings.multisample;
    case RT_SCISSOR_TEST: return &settings.scissorTest;
    case RT_DITHER: return &idle.dither;
    case RT_INDEX_LOGIC_OP: return &idle.indexLogicOp;
    default: return nullptr;
    }
}

/// Arrays are switched by rtEnableClientState, but asked for here too.
bool isArray(RTenum cap) {
    return (cap >= RT_VERTEX_ARRAY && cap <= RT_EDGE_FLAG_ARRAY) ||
           cap == RT_FOG_COORDINATE_ARRAY || cap == RT_SECONDARY_COLOR_ARRAY;
}

const char* whyNot(RTenum cap) {
    switch (cap) {
    case RT_STENCIL_TEST:
        return "there is no stencil buffer: reflections and shadows come with RT_REFLECTIONS and "
               "RT_SHADOWS";
    case RT_AUTO_NORMAL: return "there are no evaluators";
    case RT_TEXTURE_3D:
    case RT_TEXTURE_CUBE_MAP: return "textures have one or two dimensions";
    default: return "this switch is not part of this release";
    }
}

} // namespace

void setCapability(Context& context, RTenum cap, bool on) {
    Recorder& recorder = context.recorder();
    FixedStateRecorder& fixed = recorder.fixedState();
    if (cap == RT_DEPTH_TEST) {
        fixed.setDepthTest(on);
        return;
    }
    // What followed the colour so far stays; from now on it may not.
    if (cap == RT_COLOR_MATERIAL && !on) recorder.setMaterials(recorder.materials());
    if (const bool* const value = switchOf(fixed.state(), cap)) {
        if (*value != on) *switchOf(fixed.change(), cap) = on;
        return;
    }
    if (const bool* const value = textureSwitchOf(fixed.texture(), cap)) {
        if (*value != on) *textureSwitchOf(fixed.changeTexture(), cap) = on;
        return;
    }
    if (bool* const other = otherSwitchOf(recorder.frameSettings(), recorder.idleState(), cap)) {
        *other = on;
        return;
    }
    if (!isCapability(cap) || isArray(cap)) throwError(ErrorCode::InvalidEnum, "no such switch");
    if (on) refuseOnce(context, "switch " + std::to_string(cap), whyNot(cap));
}

bool isEnabled(Context& context, RTenum cap) {
    Recorder& recorder = context.recorder();
    if (const bool* const value = switchOf(recorder.fixedStateNow(), cap)) return *value;
    if (const bool* const value = textureSwitchOf(recorder.fixedTextureNow(), cap)) return *value;
    IdleState idle = recorder.idleStateNow();
    if (const bool* const other = otherSwitchOf(recorder.frameSettings(), idle, cap))
        return *other;
    if (const std::optional<ArrayKind> kind = arrayKindOf(cap))
        return context.arrays()[context.arrays().selected(*kind)].enabled;
    if (!isCapability(cap)) throwError(ErrorCode::InvalidEnum, "no such switch");
    return false;
}

} // namespace smart::compat

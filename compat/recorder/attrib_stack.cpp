// SPDX-License-Identifier: MIT
#include "compat/recorder/attrib_stack.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "compat/recorder/context.h"

namespace smart::compat {

namespace {

constexpr TextureTarget kTargets[] = {TextureTarget::OneDimensional,
                                      TextureTarget::TwoDimensional};

/// Calls with each unit selected; afterwards that of before is.
template <class Action>
void forEachUnit(Recorder& recorder, Action&& action) {
    struct Selection {
        Recorder& recorder;
        const std::size_t unit;
        ~Selection() { recorder.selectTextureUnit(unit); }
    } const before{recorder, recorder.textureUnit()};
    for (std::size_t unit = 0; unit < kTextureUnits; ++unit) {
        recorder.selectTextureUnit(unit);
        action(unit);
    }
}

SavedState saved(Context& context, uint32_t groups) {
    Recorder& recorder = context.recorder();
    SavedState state;
    state.groups = groups;
    state.depthTestChosen = recorder.fixedState().depthTestChosen();
    state.fixed = recorder.fixedStateNow();
    state.idle = recorder.idleStateNow();
    state.attributes = recorder.attributes();
    state.materials = recorder.materials();
    state.frame = recorder.frameSettings();
    state.pixels = recorder.pixelDrawingNow();
    state.matrixMode = recorder.matrices().mode();
    state.textureUnit = recorder.textureUnit();
    forEachUnit(recorder, [&](std::size_t unit) {
        for (const TextureTarget target : kTargets)
            state.textures[unit][int(target)] = {recorder.textures().bound(target),
                                                 recorder.textures().parameters(target)};
    });
    state.listBase = context.lists().base();
    return state;
}

void restoreEnables(FixedTexture& texture, const FixedTexture& was) {
    texture.enabled1D = was.enabled1D;
    texture.enabled2D = was.enabled2D;
    for (int k = 0; k < 4; ++k) texture.generate[k].enabled = was.generate[k].enabled;
}

void restoreEnables(FixedState& state, const FixedState& was) {
    FixedLighting& lighting = state.lighting;
    lighting.enabled = was.lighting.enabled;
    lighting.normalize = was.lighting.normalize;
    lighting.rescaleNormal = was.lighting.rescaleNormal;
    lighting.colorMaterial = was.lighting.colorMaterial;
    lighting.colorSum = was.lighting.colorSum;
    lighting.shadows = was.lighting.shadows;
    lighting.reflections = was.lighting.reflections;
    for (int i = 0; i < kFixedLights; ++i)
        lighting.lights[i].enabled = was.lighting.lights[i].enabled;
    state.fog.enabled = was.fog.enabled;
    restoreEnables(state.texture, was.texture);
    for (std::size_t i = 0; i < state.moreTextures.size(); ++i)
        restoreEnables(state.moreTextures[i],
                       i < was.moreTextures.size() ? was.moreTextures[i] : FixedTexture());
    state.ops.alphaTest = was.ops.alphaTest;
    state.ops.depthTest = was.ops.depthTest;
    state.ops.blend = was.ops.blend;
    state.ops.colorLogicOp = was.ops.colorLogicOp;
    state.raster.cull = was.raster.cull;
    state.raster.offsetFill = was.raster.offsetFill;
    state.raster.offsetLine = was.raster.offsetLine;
    state.raster.offsetPoint = was.raster.offsetPoint;
    state.raster.polygonStippled = was.raster.polygonStippled;
    state.raster.polygonSmooth = was.raster.polygonSmooth;
    state.raster.pointSmooth = was.raster.pointSmooth;
    state.raster.lineSmooth = was.raster.lineSmooth;
    state.raster.lineStippled = was.raster.lineStippled;
    std::copy(was.raster.clip, was.raster.clip + kFixedClipPlanes, state.raster.clip);
}

void restorePolygons(FixedRaster& raster, const FixedRaster& was) {
    raster.cull = was.cull;
    raster.cullFace = was.cullFace;
    raster.frontFaceClockwise = was.frontFaceClockwise;
    std::copy(was.polygonMode, was.polygonMode + 2, raster.polygonMode);
    raster.polygonSmooth = was.polygonSmooth;
    raster.polygonStippled = was.polygonStippled;
    raster.offsetFill = was.offsetFill;
    raster.offsetLine = was.offsetLine;
    raster.offsetPoint = was.offsetPoint;
    raster.offsetFactor = was.offsetFactor;
    raster.offsetUnits = was.offsetUnits;
}

void restorePoints(FixedRaster& raster, const FixedRaster& was) {
    raster.pointSize = was.pointSize;
    raster.pointSmooth = was.pointSmooth;
    raster.pointSizeMin = was.pointSizeMin;
    raster.pointSizeMax = was.pointSizeMax;
    raster.pointFadeThreshold = was.pointFadeThreshold;
    raster.pointAttenuation = was.pointAttenuation;
}

void restoreLines(FixedRaster& raster, const FixedRaster& was) {
    raster.lineWidth = was.lineWidth;
    raster.lineSmooth = was.lineSmooth;
    raster.lineStippled = was.lineStippled;
    raster.linePattern = was.linePattern;
    raster.lineFactor = was.lineFactor;
}

void restoreTransform(FixedState& state, const FixedState& was) {
    std::copy(was.raster.clip, was.raster.clip + kFixedClipPlanes, state.raster.clip);
    std::copy(was.raster.clipPlane, was.raster.clipPlane + kFixedClipPlanes,
              state.raster.clipPlane);
    state.lighting.normalize = was.lighting.normalize;
    state.lighting.rescaleNormal = was.lighting.rescaleNormal;
}

/// Normals are of the transformation, the colour sum is of fog, the rest of lighting is of its
/// group.
void restoreLighting(FixedLighting& lighting, const FixedLighting& was) {
    const FixedLighting now = lighting;
    lighting = was;
    lighting.normalize = now.normalize;
    lighting.rescaleNormal = now.rescaleNormal;
    lighting.colorSum = now.colorSum;
}

void restoreColorBuffer(FixedFragmentOps& ops, const FixedFragmentOps& was) {
    const FixedFragmentOps now = ops;
    ops = was;
    ops.depthTest = now.depthTest;
    ops.depthFunction = now.depthFunction;
    ops.depthMask = now.depthMask;
}

FixedState restoredFixed(const FixedState& now, const SavedState& saved) {
    FixedState state = now;
    const FixedState& was = saved.fixed;
    const auto has = [&](AttributeGroup group) { return (saved.groups & group) != 0; };
    if (has(kLightingGroup)) restoreLighting(state.lighting, was.lighting);
    if (has(kFogGroup)) {
        state.fog = was.fog;
        state.lighting.colorSum = was.lighting.colorSum;
    }
    if (has(kTextureGroup)) {
        state.texture = was.texture;
        state.moreTextures = was.moreTextures;
    }
    if (has(kColorBufferGroup)) restoreColorBuffer(state.ops, was.ops);
    if (has(kDepthBufferGroup)) {
        state.ops.depthTest = was.ops.depthTest;
        state.ops.depthFunction = was.ops.depthFunction;
        state.ops.depthMask = was.ops.depthMask;
    }
    if (has(kPointGroup)) restorePoints(state.raster, was.raster);
    if (has(kLineGroup)) restoreLines(state.raster, was.raster);
    if (has(kPolygonGroup)) restorePolygons(state.raster, was.raster);
    if (has(kPolygonStippleGroup))
        std::copy(was.raster.polygonStipple, was.raster.polygonStipple + 32,
                  state.raster.polygonStipple);
    if (has(kTransformGroup)) restoreTransform(state, was);
    if (has(kEnableGroup)) restoreEnables(state, was);
    return state;
}

/// Without their group they stay as the colour has made them until now.
FixedMaterials restoredMaterials(const Recorder& recorder, const FixedLighting& lighting,
                                 const SavedState& saved) {
    if ((saved.groups & kLightingGroup) == 0) return recorder.materials();
    const bool color = (saved.groups & kCurrentGroup) != 0;
    return withColor(saved.materials, lighting,
                     color ? saved.attributes.color : recorder.attributes().color);
}

void restoreIdle(IdleState& idle, const SavedState& saved) {
    const IdleState& was = saved.idle;
    const auto has = [&](uint32_t groups) { return (saved.groups & groups) != 0; };
    if (has(kHintGroup)) idle.hints = was.hints;
    if (has(kStencilBufferGroup)) idle.stencil = was.stencil;
    if (has(kAccumBufferGroup)) idle.accumClear = was.accumClear;
    if (has(kColorBufferGroup | kEnableGroup)) {
        idle.dither = was.dither;
        idle.indexLogicOp = was.indexLogicOp;
    }
    if (has(kMultisampleGroup)) {
        idle.sampleCoverage = was.sampleCoverage;
        idle.sampleCoverageInvert = was.sampleCoverageInvert;
    }
}

void restorePixels(PixelDrawing& pixels, const SavedState& saved) {
    const RasterPosition raster =
        (saved.groups & kCurrentGroup) != 0 ? saved.pixels.raster : pixels.raster;
    if ((saved.groups & kPixelModeGroup) != 0) pixels = saved.pixels;
    pixels.raster = raster;
}

void restoreFrame(FrameSettings& frame, const SavedState& saved) {
    const FrameSettings& was = saved.frame;
    const auto has = [&](uint32_t groups) { return (saved.groups & groups) != 0; };
    if (has(kViewportGroup)) {
        frame.viewport = was.viewport;
        frame.depthNear = was.depthNear;
        frame.depthFar = was.depthFar;
    }
    if (has(kScissorGroup)) frame.scissor = was.scissor;
    if (has(kScissorGroup | kEnableGroup)) frame.scissorTest = was.scissorTest;
    if (has(kColorBufferGroup)) {
        frame.clearColor = was.clearColor;
        frame.drawsColor = was.drawsColor;
        frame.drawBuffer = was.drawBuffer;
    }
    if (has(kPixelModeGroup)) frame.readBuffer = was.readBuffer;
    if (has(kDepthBufferGroup)) frame.clearDepth = was.clearDepth;
    if (has(kMultisampleGroup | kEnableGroup)) frame.multisample = was.multisample;
    if (has(kEnableGroup)) frame.target.srgb = was.target.srgb;
}

/// A texture that was deleted since is not made again.
void restoreTexture(TextureStore& textures, TextureTarget target,
                    const SavedState::Texture& saved) {
    const uint32_t id = saved.id;
    if (id != 0 && !textures.exists(id, target)) {
        textures.bind(0, target);
        return;
    }
    textures.bind(id, target);
    if (textures.parameters(target) != saved.parameters)
        textures.setParameters(saved.parameters, target);
}

} // namespace

void pushAttributes(Context& context, uint32_t groups) {
    context.recorder().requireOutsideObject();
    context.attribStack().push(saved(context, groups));
}

void popAttributes(Context& context) {
    Recorder& recorder = context.recorder();
    recorder.requireOutsideObject();
    const SavedState& saved = context.attribStack().top();
    const auto has = [&](uint32_t groups) { return (saved.groups & groups) != 0; };

    // What needs memory comes first.
    FixedStateRecorder& fixed = recorder.fixedState();
    FixedState state = restoredFixed(fixed.state(), saved);
    std::shared_ptr<const FixedMaterials> materials;
    if (has(kLightingGroup | kEnableGroup | kCurrentGroup))
        materials = std::make_shared<const FixedMaterials>(
            restoredMaterials(recorder, state.lighting, saved));

    fixed.change() = std::move(state);
    if (has(kDepthBufferGroup | kEnableGroup))
        fixed.setDepthTest(saved.fixed.ops.depthTest, saved.depthTestChosen);
    if (has(kCurrentGroup)) recorder.restoreAttributes(saved.attributes);
    if (materials) recorder.restoreMaterials(std::move(materials));
    restoreIdle(recorder.idleState(), saved);
    restoreFrame(recorder.frameSettings(), saved);
    restorePixels(recorder.pixelDrawing(), saved);
    if (has(kTextureGroup)) {
        forEachUnit(recorder, [&](std::size_t unit) {
            for (const TextureTarget target : kTargets)
                restoreTexture(recorder.textures(), target, saved.textures[unit][int(target)]);
        });
        recorder.selectTextureUnit(saved.textureUnit);
    }
    if (has(kTransformGroup)) recorder.matrices().setMode(saved.matrixMode);
    if (has(kListGroup)) context.lists().setBase(saved.listBase);
    context.attribStack().pop();
}

void pushClientAttributes(Context& context, bool pixelStore, bool vertexArrays) {
    context.recorder().requireOutsidePrimitive();
    context.clientAttribStack().push(
        {pixelStore, vertexArrays, context.recorder().pixelStore(),
         context.recorder().packStore(), context.arrays()});
}

void popClientAttributes(Context& context) {
    context.recorder().requireOutsidePrimitive();
    SavedClientState& saved = context.clientAttribStack().top();
    if (saved.pixelStore) {
        context.recorder().pixelStore() = saved.unpack;
        context.recorder().packStore() = saved.pack;
    }
    if (saved.vertexArrays) context.arrays() = std::move(saved.arrays);
    context.clientAttribStack().pop();
}

} // namespace smart::compat

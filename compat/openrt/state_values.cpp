// SPDX-License-Identifier: MIT
#include "compat/openrt/state_values.h"

#include <algorithm>
#include <glm/matrix.hpp>
#include <initializer_list>
#include <optional>

#include "compat/openrt/array_names.h"
#include "compat/openrt/capabilities.h"
#include "compat/openrt/fixed_values.h"
#include "compat/openrt/guard.h"
#include "compat/openrt/pixel_values.h"
#include "compat/openrt/tokens.h"
#include "compat/openrt/window_values.h"
#include "libsmart/kernel/packet.h"

namespace smart::compat {

namespace {

StateValue list(std::initializer_list<double> numbers) {
    return StateValue::list(numbers);
}
StateValue number(double n) {
    return StateValue::number(n);
}
template <class Vector>
StateValue vector(const Vector& v, bool normalised) {
    return StateValue::vector(v, normalised);
}
StateValue matrix(const glm::dmat4& m) {
    StateValue value;
    value.count = 16;
    for (int i = 0; i < 16; ++i) value.values[i] = m[i / 4][i % 4];
    return value;
}

std::optional<StateValue> matrixValue(Recorder& recorder, RTenum name) {
    const Matrices& matrices = recorder.matrices();
    const auto stack = [&](MatrixMode mode) -> const MatrixStack& { return matrices.stack(mode); };
    constexpr MatrixMode kModelView = MatrixMode::ModelView, kProjection = MatrixMode::Projection,
                         kTexture = MatrixMode::Texture;
    switch (name) {
    case RT_MATRIX_MODE: return number(tokenOf(matrices.mode()));
    case RT_MODELVIEW_MATRIX: return matrix(stack(kModelView).top());
    case RT_PROJECTION_MATRIX: return matrix(stack(kProjection).top());
    case RT_TEXTURE_MATRIX: return matrix(stack(kTexture).top());
    case RT_TRANSPOSE_MODELVIEW_MATRIX: return matrix(glm::transpose(stack(kModelView).top()));
    case RT_TRANSPOSE_PROJECTION_MATRIX: return matrix(glm::transpose(stack(kProjection).top()));
    case RT_TRANSPOSE_TEXTURE_MATRIX: return matrix(glm::transpose(stack(kTexture).top()));
    case RT_MODELVIEW_STACK_DEPTH: return number(double(stack(kModelView).depth()));
    case RT_PROJECTION_STACK_DEPTH: return number(double(stack(kProjection).depth()));
    case RT_TEXTURE_STACK_DEPTH: return number(double(stack(kTexture).depth()));
    case RT_MAX_MODELVIEW_STACK_DEPTH:
    case RT_MAX_PROJECTION_STACK_DEPTH:
    case RT_MAX_TEXTURE_STACK_DEPTH: return number(double(MatrixStack::kDepth));
    default: return std::nullopt;
    }
}

std::optional<StateValue> frameValue(Context& context, RTenum name) {
    const FrameSettings& settings = context.recorder().frameSettings();
    switch (name) {
    case RT_VIEWPORT: {
        const Viewport v = settings.viewport.value_or(
            Viewport{0, 0, settings.target.width, settings.target.height});
        return list({double(v.x), double(v.y), double(v.width), double(v.height)});
    }
    case RT_MAX_VIEWPORT_DIMS: return list({kMaxViewport, kMaxViewport});
    case RT_COLOR_CLEAR_VALUE: return vector(settings.clearColor, true);
    case RT_SAMPLES: return number(settings.samples);
    case RT_MULTISAMPLE: return number(settings.multisample);
    case RT_FRAMEBUFFER_SRGB: return number(settings.target.srgb);
    case RT_PRECISION_HINT:
        switch (settings.precision) {
        case Precision::Fast: return number(RT_FASTEST);
        case Precision::Watertight: return number(RT_DONT_CARE);
        case Precision::Precise: return number(RT_NICEST);
        }
        return std::nullopt;
    case RT_FRAME_PROGRESS: return number(context.frames().progress());
    case RT_FRAME_DEPTH: return number(context.frames().depth());
    case RT_SCENE_BINDING: return number(context.recorder().boundScene());
    default: return std::nullopt;
    }
}

std::optional<StateValue> recorderValue(Recorder& recorder, RTenum name) {
    const Attributes& attributes = recorder.attributes();
    const BuildHints& hints = recorder.buildHints();
    switch (name) {
    case RT_CURRENT_COLOR: return vector(attributes.color, true);
    case RT_CURRENT_NORMAL: return vector(attributes.normal, true);
    case RT_CURRENT_TEXTURE_COORDS: return vector(attributes.texCoordOf(recorder.textureUnit()), false);
    case RT_TEXTURE_BINDING_1D:
        return number(recorder.textures().bound(TextureTarget::OneDimensional));
    case RT_TEXTURE_BINDING_2D:
        return number(recorder.textures().bound(TextureTarget::TwoDimensional));
    case RT_MAX_TEXTURE_SIZE: return number(TextureStore::kMaxSize);
    case RT_SHADER_BINDING: return number(recorder.shaders().bound().id);
    case RT_SHADER_CLASS_BINDING: return number(recorder.shaders().boundClass());
    case RT_MAX_OBJECT_DEPTH: return number(kMaxLevels);
    case RT_OBJECT_INDEX: return number(recorder.openObject());
    case RT_BUILD_QUALITY:
        switch (hints.quality) {
        case BuildQuality::Nicest: return number(RT_NICEST);
        case BuildQuality::DontCare: return number(RT_DONT_CARE);
        case BuildQuality::Fastest: return number(RT_FASTEST);
        case BuildQuality::KdTree: return number(RT_KD_TREE);
        }
        return std::nullopt;
    case RT_LAZY_BUILD: return number(hints.lazy);
    default: return std::nullopt;
    }
}

std::optional<StateValue> statistic(Context& context, RTenum name) {
    if (name < RT_STAT_TRIANGLES || name > RT_STAT_IDLE_MICROSECONDS) return std::nullopt;
    const ModelCompiler& compiler = context.recorder().compiler();
    const RenderStatistics& frame = context.frames().frameStatistics();
    switch (name) {
    case RT_STAT_BYTES: return number(double(compiler.memory().bytes()));
    case RT_STAT_PEAK_BYTES: return number(double(compiler.memory().peak()));
    case RT_STAT_MODELS_BUILT: return number(double(compiler.modelsBuilt()));
    case RT_STAT_BUILD_MICROSECONDS: return number(std::floor(compiler.buildSeconds() * 1e6));
    case RT_STAT_RAYS:
        return number(double(frame.primaryRays + frame.shadowRays + frame.secondaryRays));
    case RT_STAT_PRIMARY_RAYS: return number(double(frame.primaryRays));
    case RT_STAT_SHADOW_RAYS: return number(double(frame.shadowRays));
    case RT_STAT_SECONDARY_RAYS: return number(double(frame.secondaryRays));
    case RT_STAT_BAD_PIXELS: return number(double(frame.badPixels));
    case RT_STAT_BUSY_MICROSECONDS: return number(std::floor(double(frame.busyNanoseconds) * 1e-3));
    case RT_STAT_IDLE_MICROSECONDS: return number(std::floor(double(frame.idleNanoseconds) * 1e-3));
    default: break;
    }
    const SceneStatistics& scene = context.frames().sceneStatistics();
    switch (name) {
    case RT_STAT_TRIANGLES: return number(double(scene.triangles));
    case RT_STAT_INSTANCES: return number(double(scene.instances));
    case RT_STAT_NODES: return number(double(scene.nodes));
    case RT_STAT_LEAVES: return number(double(scene.leaves));
    case RT_STAT_REFERENCES: return number(double(scene.references));
    case RT_STAT_DROPPED_TRIANGLES: return number(double(scene.droppedTriangles));
    case RT_STAT_DROPPED_INSTANCES: return number(double(scene.droppedInstances));
    default: return std::nullopt;
    }
}

std::optional<StateValue> listValue(DisplayLists& lists, RTenum name) {
    const ListRecording* const recording = lists.recording();
    switch (name) {
    case RT_LIST_BASE: return number(lists.base());
    case RT_LIST_INDEX: return number(recording ? recording->name() : 0);
    case RT_LIST_MODE:
        return number(!recording              ? 0
                      : recording->executes() ? RT_COMPILE_AND_EXECUTE
                                              : RT_COMPILE);
    case RT_MAX_LIST_NESTING: return number(DisplayLists::kMaxNesting);
    default: return std::nullopt;
    }
}

} // namespace

StateValue stateValue(Context& context, RTenum name) {
    Recorder& recorder = context.recorder();
    recorder.requireOutsidePrimitive();
    if (const auto value = matrixValue(recorder, name)) return *value;
    if (const auto value = frameValue(context, name)) return *value;
    if (const auto value = windowValue(recorder, name)) return *value;
    if (const auto value = pixelValue(recorder, name)) return *value;
    if (const auto value = recorderValue(recorder, name)) return *value;
    if (const auto value = fixedStateValue(context, name)) return *value;
    if (const auto value = listValue(context.lists(), name)) return *value;
    if (const auto value = arrayStateValue(context.arrays(), name)) return *value;
    if (const auto value = statistic(context, name)) return *value;
    if (isCapability(name)) return number(isEnabled(context, name));
    if (isStateVariable(name))
        throwError(ErrorCode::InvalidOperation, "this value is not part of this release");
    throwError(ErrorCode::InvalidEnum, "no such value");
}

} // namespace smart::compat

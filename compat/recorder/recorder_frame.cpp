// SPDX-License-Identifier: MIT
// Scenes and the frame under way: what it uses, and how it is frozen.
#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "compat/recorder/recorder.h"
#include "compat/recorder/transforms.h"
#include "libsmart/base/error.h"
#include "libsmart/shading/fixed_frame_light.h"
#include "libsmart/render/pixel_primitives.h"

namespace smart::compat {

namespace {

[[noreturn]] void refuse(const std::string& reason) {
    throw Error(ErrorCode::InvalidOperation, reason);
}

void checkTarget(const PixelTarget& target) {
    if (!target.memory) refuse("no frame buffer is set");
    if (target.stride == 0) return;
    if (target.stride < target.width * bytesPerPixel(target.format))
        refuse("the frame buffer's stride is shorter than a row");
    const bool bytes = target.format == PixelFormat::Rgb8 || target.format == PixelFormat::Rgba8 ||
                       target.format == PixelFormat::Bgra8;
    if (!bytes && target.stride % sizeof(float) != 0)
        refuse("the frame buffer's stride is no multiple of a float's size");
}

std::shared_ptr<const ShaderObject> frozenShader(const ShaderTable& frozen,
                                                 const std::shared_ptr<Shader>& shader) {
    auto object = shader ? frozen.at(shader->index()) : nullptr;
    if (shader && !object)
        refuse("the constructor of shader class '" + shader->shaderClass()->name() + "' failed");
    return object;
}

} // namespace

uint32_t Recorder::newScene() {
    requireOutsideObject();
    return scenes_.add();
}

void Recorder::bindScene(uint32_t id) {
    requireOutsideObject();
    scenes_.bind(id);
    resumeLooseRun();
}

void Recorder::removeScene(uint32_t id) {
    requireOutsideObject();
    const bool wasBound = id == scenes_.boundId();
    scenes_.remove(id);
    if (wasBound) resumeLooseRun();
}

// Attributes may have changed while another scene was bound: from the next vertex on a run under
// way stores those that are not what its instance inherits.
void Recorder::resumeLooseRun() noexcept {
    if (scene().loose.empty()) return;
    AttributesGiven& given = scene().loose.given;
    given.color |= attributes_.color != scene().looseInherited.color;
    given.normal |= normalEverGiven_;
    given.texCoord |= attributes_.texCoord != scene().looseInherited.texCoord;
    given.materials |= attributes_.materials != scene().looseInherited.materials;
    given.secondaryColor |=
        glm::vec3(attributes_.secondaryColor) != scene().looseInherited.secondaryColor;
    given.fogCoordinate |= attributes_.fogCoordinate != scene().looseInherited.fogCoordinate;
    const MoreTexCoords* const inherited = scene().looseInherited.moreTexCoords.get();
    for (std::size_t unit = 0; unit < kMoreUnits; ++unit)
        if (attributes_.moreTexCoords[unit] != (inherited ? *inherited : MoreTexCoords())[unit])
            given.moreTexCoords |= uint8_t(1u << unit);
}

std::shared_ptr<Shader> Recorder::shaderOfKind(uint32_t id, RTenum kind,
                                               const char* kindName) const {
    const BoundShaderPtr& shader = shaders_.shader(id);
    if (shader->kind() != kind)
        throw Error(ErrorCode::InvalidOperation,
                    "shader " + std::to_string(id) + " is not a " + kindName);
    return shader->shader;
}

void Recorder::useLight(uint32_t id, bool checkTwice) {
    requireOutsideObject();
    std::shared_ptr<Shader> light = shaderOfKind(id, RT_LIGHT_SHADER, "light shader");
    std::vector<std::shared_ptr<Shader>>& lights = scene().lights;
    if (checkTwice && std::find(lights.begin(), lights.end(), light) != lights.end())
        refuse("the frame has this light already");
    lights.push_back(std::move(light));
    ++scene().additions;
}

void Recorder::useUnique(UniqueShader what, uint32_t id) {
    requireOutsideObject();
    struct Role {
        RTenum kind;
        const char* name;
        std::shared_ptr<Shader>* place;
    };
    const Role role = what == UniqueShader::Camera
                          ? Role{RT_CAMERA_SHADER, "camera shader", &scene().camera}
                      : what == UniqueShader::Environment
                          ? Role{RT_ENV_SHADER, "environment shader", &scene().environment}
                          : Role{RT_RENDERING_OBJECT_SHADER, "rendering object",
                                 &scene().renderingObject};
    std::shared_ptr<Shader> shader = shaderOfKind(id, role.kind, role.name);
    if (*role.place) refuse("the frame has one of this kind already");
    *role.place = std::move(shader);
    ++scene().additions;
}

// Queries see the instances of all layers, whatever their cameras.
ScenePtr Recorder::compileScene() {
    requireOutsidePrimitive();
    if (scene().below.empty())
        return compiler_.makeScene(allInstances(), frameSettings_.precision);
    InstanceList all;
    for (const FinishedLayer& layer : scene().below) all.add(layer.instances);
    all.add(allInstances());
    return compiler_.makeScene(std::move(all), frameSettings_.precision);
}

std::shared_ptr<Frame> Recorder::makeFrame(const PixelTarget& target) {
    requireOutsideObject();
    checkTarget(target);
    Frame common; // of all layers
    freezeShaders(common);
    std::vector<std::shared_ptr<Frame>> layers;
    const auto add = [&](const LayerView& view, InstanceList instances,
                         const std::vector<BufferClear>& clears) {
        layers.push_back(makeLayer(common, target, view));
        layers.back()->clears = clears;
        const bool last = takesLastOfEqual(instances);
        layers.back()->scene =
            compiler_.makeScene(std::move(instances), frameSettings_.precision, last);
    };
    for (const FinishedLayer& layer : scene().below)
        add(layer.view, layer.instances, layer.clears);
    if (layers.empty() || hasContent() || !scene().clears.empty())
        add(hasContent() ? *scene().view : currentView(), allInstances(), scene().clears);

    const std::shared_ptr<Frame> top = layers.back();
    cameraRays_ += uint64_t(target.width) * target.height * top->samples;
    top->clearColor = frameSettings_.clearColor;
    startFrom(layers.front()->clears, target, *top);
    uint32_t instances = 0;
    for (const std::shared_ptr<Frame>& layer : layers) {
        layer->clearColor = top->clearColor;
        layer->firstInstance = instances;
        instances += uint32_t(layer->scene->group().instances().size());
        layer->primitives = PixelPrimitives::make(*layer);
    }
    top->below.assign(layers.begin(), layers.end() - 1);
    return top;
}

std::shared_ptr<Frame> Recorder::makeView(const Frame& frame, const PixelTarget& target) {
    requireOutsideObject();
    checkTarget(target);
    if (!scene().camera) refuse("no camera is in use to see the frame by");
    const LayerView view = currentView();
    const std::shared_ptr<const ShaderTable> shaders = shaders_.freeze();
    const auto camera = frozenShader(*shaders, scene().camera);
    const auto see = [&](const Frame& layer) {
        const auto seen = std::make_shared<Frame>(layer);
        seen->camera = camera;
        seen->target = target;
        seen->viewport = view.viewport.value_or(Viewport{0, 0, target.width, target.height});
        seen->scissor = view.scissor;
        seen->primitives = PixelPrimitives::make(*seen);
        return seen;
    };
    const std::shared_ptr<Frame> top = see(frame);
    for (std::shared_ptr<const Frame>& layer : top->below) layer = see(*layer);
    return top;
}

void Recorder::freezeShaders(Frame& frame) {
    frame.shaders = shaders_.freeze();
    frame.textures = textures_.freeze();
    const auto frozen = [&](const std::shared_ptr<Shader>& shader) {
        return frozenShader(*frame.shaders, shader);
    };
    for (const auto& light : scene().lights) frame.lights.push_back(frozen(light));
    for (const FixedLight& light : fixedState_.state().lighting.lights)
        if (light.enabled) frame.lights.push_back(makeFrameLight(light));
    frame.environment = frozen(scene().environment);
    frame.camera = frozen(scene().camera);
    frame.renderingObject = frozen(scene().renderingObject);
}

std::shared_ptr<Frame> Recorder::makeLayer(const Frame& common, const PixelTarget& target,
                                           const LayerView& view) const {
    const FrameSettings& settings = frameSettings_;
    const auto layer = std::make_shared<Frame>();
    layer->shaders = common.shaders;
    layer->textures = common.textures;
    layer->lights = common.lights;
    layer->environment = common.environment;
    layer->camera = common.camera;
    layer->renderingObject = common.renderingObject;
    layer->samples = settings.multisample && settings.samples == 1 ? 4 : settings.samples;
    layer->seed = settings.seed;
    layer->recursionLimit = settings.recursionLimit;
    layer->weightCutoff = settings.weightCutoff;
    layer->target = target;

    layer->matrixCamera.projection = view.projection;
    if (!layer->camera && !invert(view.projection, layer->matrixCamera.inverse))
        refuse("the projection matrix has no inverse, and there is no camera shader");
    layer->viewport = view.viewport.value_or(Viewport{0, 0, target.width, target.height});
    layer->scissor = view.scissor;
    layer->depthNear = view.depthNear;
    layer->depthFar = view.depthFar;
    layer->drawsColor = view.drawsColor;
    return layer;
}

} // namespace smart::compat

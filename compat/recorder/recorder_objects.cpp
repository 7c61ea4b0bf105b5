// SPDX-License-Identifier: MIT
// Objects and instances.
#include <string>
#include <utility>

#include "compat/recorder/build_choice.h"
#include "compat/recorder/recorder.h"
#include "compat/recorder/transforms.h"
#include "libsmart/base/error.h"
#include "libsmart/kernel/packet.h"

namespace smart::compat {

namespace {

std::shared_ptr<const ShaderReplacement> replacementOfAll(const std::shared_ptr<Shader>& by) {
    auto replacement = std::make_shared<ShaderReplacement>();
    replacement->all = true;
    replacement->allBy = by->index();
    replacement->keepAlive.push_back(by);
    return replacement;
}

} // namespace

InheritedAttributes Recorder::inheritedFrom(const Attributes& attributes) {
    InheritedAttributes inherited;
    inherited.color = attributes.color;
    inherited.normal = attributes.normal;
    inherited.texCoord = attributes.texCoord;
    inherited.materials = attributes.materials;
    inherited.secondaryColor = glm::vec3(attributes.secondaryColor);
    inherited.fogCoordinate = attributes.fogCoordinate;
    inherited.moreTexCoords = sharedTexCoords(attributes);
    return inherited;
}

const Recorder::Object& Recorder::object(uint32_t id) const {
    const auto found = objects_.find(id);
    if (found == objects_.end())
        throw Error(ErrorCode::InvalidValue, "no object has the id " + std::to_string(id));
    return found->second;
}

const std::vector<UsedShader>& Recorder::objectShaders(uint32_t id) const {
    requireOutsidePrimitive();
    return object(id).shaders;
}

uint32_t Recorder::newObject(ObjectMode mode) {
    requireOutsideObject();
    if (mode == ObjectMode::DefineAndInstantiate) makeAffine(matrices_.modelView());
    openObject(lastObject_ + 1, mode);
    return ++lastObject_;
}

void Recorder::replaceObject(uint32_t id) {
    requireOutsideObject();
    object(id);
    openObject(id, ObjectMode::Define);
}

void Recorder::openObject(uint32_t id, ObjectMode mode) {
    open_ = std::make_unique<OpenObject>(
        OpenObject{id, mode, GeometryRecording(), matrices_, attributes_});
    matrices_.enterObject();
}

void Recorder::endObject() {
    requireOutsidePrimitive();
    if (!open_) throw Error(ErrorCode::InvalidOperation, "no object is being defined");

    // Everything that may fail happens before the first change: the entry is made aside, and
    // compiling comes last.
    std::map<uint32_t, Object> made;
    Object& entry = made.try_emplace(open_->id).first->second;
    entry.shaders = open_->recording.usedShaders();
    entry.hints = buildHints_;
    entry.raysThen = rays();
    const auto before = objects_.find(open_->id);
    const BuildQuality quality =
        qualityFor(buildHints_, before == objects_.end() ? nullptr : &before->second,
                   open_->recording.triangleCount());
    const auto compile = [&](Instance& instance) {
        entry.model = compiler_.compile(open_->recording, quality, buildHints_.lazy);
        instance.model = entry.model;
    };
    Instance instance;
    if (open_->mode == ObjectMode::DefineAndInstantiate) {
        instance.toParent = makeAffine(open_->savedMatrices.modelView());
        instance.objectId = open_->id;
        const Attributes& attributes = open_->savedAttributes;
        instance.inherited = inheritedFrom(attributes);
        instance.state = instanceState(open_->savedMatrices);
        placeInScene(std::move(instance), compile);
    } else {
        compile(instance);
    }
    if (before != objects_.end()) objects_.erase(before);
    objects_.insert(made.extract(made.begin()));
    closeObject();
}

BuildQuality Recorder::qualityFor(const BuildHints& hints, const Object* old,
                                  std::size_t triangles) const {
    std::optional<uint64_t> raysSince;
    if (old) raysSince = rays() - old->raysThen;
    return chooseQuality(hints.quality, raysSince, triangles);
}

void Recorder::closeObject() noexcept {
    matrices_ = open_->savedMatrices;
    matrices_.selectUnit(textureUnit_);
    attributes_ = open_->savedAttributes;
    open_.reset();
}

void Recorder::requireVertices(uint32_t id, uint32_t first, uint32_t count) const {
    requireOutsideObject();
    const uint32_t vertices = object(id).model->shading.vertices;
    if (first > vertices || count > vertices - first)
        throw Error(ErrorCode::InvalidValue, "object " + std::to_string(id) + " has " +
                                                 std::to_string(vertices) + " vertices only");
}

void Recorder::updateObject(uint32_t id, uint32_t first, uint32_t count, const float* positions) {
    requireVertices(id, first, count);
    if (count == 0) return;
    Object& updated = objects_.find(id)->second;
    const BuildQuality quality =
        qualityFor(updated.hints, &updated, updated.model->triangles.size());
    updated.model = compiler_.update(*updated.model, first, count, positions, quality,
                                     updated.hints.lazy);
    updated.raysThen = rays();
}

void Recorder::removeObject(uint32_t id) {
    requireOutsideObject();
    object(id);
    objects_.erase(id);
}

void Recorder::instantiate(uint32_t id) {
    place(id, nullptr, {});
}

const BoundShaderPtr& Recorder::surface(uint32_t id) const {
    const BoundShaderPtr& shader = shaders_.shader(id);
    if (!shader->isSurface)
        throw Error(ErrorCode::InvalidOperation,
                    "shader " + std::to_string(id) + " is not a surface shader");
    return shader;
}

void Recorder::instantiateWithShader(uint32_t id, uint32_t shader) {
    requireOutsidePrimitive();
    const BoundShaderPtr& by = surface(shader);
    place(id, replacementOfAll(by->shader), {{by->shader->index(), by->id}});
}

void Recorder::instantiateWithShaders(uint32_t id, std::span<const uint32_t> shaders) {
    requireOutsidePrimitive();
    std::vector<UsedShader> used = object(id).shaders;
    if (shaders.size() > used.size())
        throw Error(ErrorCode::InvalidValue, "object " + std::to_string(id) + " has " +
                                                 std::to_string(used.size()) + " shaders only");
    const auto replacement = std::make_shared<ShaderReplacement>();
    for (std::size_t i = 0; i < shaders.size(); ++i) {
        if (shaders[i] == 0) continue;
        const BoundShaderPtr& by = surface(shaders[i]);
        replacement->pairs.emplace_back(used[i].index, by->shader->index());
        replacement->keepAlive.push_back(by->shader);
        used[i] = {by->shader->index(), by->id};
    }
    place(id, replacement, used);
}

void Recorder::place(uint32_t id, std::shared_ptr<const ShaderReplacement> replacement,
                     const std::vector<UsedShader>& shaders) {
    requireOutsidePrimitive();
    if (open_ && open_->id == id)
        throw Error(ErrorCode::InvalidOperation, "an object can not contain itself");
    const Object& placed = object(id);
    Instance instance;
    instance.model = placed.model;
    instance.toParent = makeAffine(matrices_.modelView());
    instance.objectId = id;
    instance.inherited = inheritedFrom(attributes_);
    const bool reshaded = replacement != nullptr;
    instance.replacement = std::move(replacement);
    if (!open_) {
        instance.state = instanceState(matrices_);
        placeInScene(std::move(instance), [](Instance&) {});
        return;
    }
    if (placed.model->levels + 1 > uint32_t(kMaxLevels))
        throw Error(ErrorCode::StackOverflow, "objects nest deeper than " +
                                                  std::to_string(kMaxLevels) + " levels");
    const AttributesGiven& given = open_->recording.given;
    instance.inherited.ownColor = given.color;
    instance.inherited.ownNormal = given.normal;
    instance.inherited.ownTexCoord = given.texCoord;
    instance.inherited.ownMaterials = given.materials;
    instance.inherited.ownSecondaryColor = given.secondaryColor;
    instance.inherited.ownFogCoordinate = given.fogCoordinate;
    instance.inherited.ownMoreTexCoords = given.moreTexCoords;
    open_->recording.addChild(std::move(instance), placed.model->levels,
                              reshaded ? shaders : placed.shaders);
}

void Recorder::placeRun(const CompiledRun& run) {
    if (run.model->triangles.empty()) return;
    Instance instance;
    instance.model = run.model;
    instance.toParent = makeAffine(matrices_.modelView());
    instance.inherited = inheritedFrom(attributes_);
    instance.state = instanceState(matrices_);
    const std::shared_ptr<Shader>& bound = shaders_.bound().shader;
    if (run.shader != bound->index()) instance.replacement = replacementOfAll(bound);
    placeInScene(std::move(instance), [](Instance&) {});
}

template <class Complete>
void Recorder::placeInScene(Instance instance, Complete&& complete) {
    enterLayer();
    std::optional<Instance> loose = looseInstance();
    InstanceList& list = scene().instances;
    list.makeRoom(2);
    complete(instance);
    if (loose) {
        list.add(std::move(*loose));
        ++scene().looseCount;
        scene().loose = GeometryRecording();
    }
    list.add(std::move(instance));
    ++scene().additions;
}

ModelPtr Recorder::sameLooseRun() const {
    const SceneRecording& recording = scenes_.bound();
    if (recording.looseCount >= recording.looseRuns.size()) return nullptr;
    const LooseRun& run = recording.looseRuns[recording.looseCount];
    if (!run.model || !recording.loose.givesAgain(*run.model)) return nullptr;
    const bool better =
        run.quality == BuildQuality::Fastest &&
        chooseQuality(BuildQuality::DontCare, rays() - run.raysThen,
                      run.model->triangles.size()) == BuildQuality::DontCare;
    return better ? nullptr : run.model;
}

ModelPtr Recorder::compileLooseRun(GeometryRecording& spare) {
    SceneRecording& recording = scene();
    if (recording.looseRuns.size() <= recording.looseCount)
        recording.looseRuns.resize(recording.looseCount + 1);
    LooseRun& run = recording.looseRuns[recording.looseCount];
    // Made for one frame, unless it is the same again: sameLooseRun() found a better tree to pay.
    const bool again = run.model && spare.givesAgain(*run.model);
    const BuildQuality quality = again ? BuildQuality::DontCare : BuildQuality::Fastest;
    run = {compiler_.compile(spare, quality, false), quality, rays()};
    return run.model;
}

std::optional<Instance> Recorder::looseInstance() {
    if (!scene().loose.hasPrimitives()) return std::nullopt;
    Instance instance;
    instance.model = sameLooseRun();
    if (!instance.model) {
        GeometryRecording copy = scene().loose;
        instance.model = compileLooseRun(copy);
    }
    instance.inherited = scene().looseInherited;
    instance.state = scene().looseState;
    return instance;
}

void Recorder::endLooseRun() {
    if (scene().loose.hasPrimitives()) {
        InstanceList& list = scene().instances;
        list.makeRoom(1);
        Instance instance;
        instance.model = sameLooseRun();
        if (!instance.model) // the last step that may fail
            instance.model = compileLooseRun(scene().loose);
        instance.inherited = scene().looseInherited;
        instance.state = scene().looseState;
        list.add(std::move(instance));
        ++scene().looseCount;
    }
    scene().loose = GeometryRecording();
}

void Recorder::clearScene() noexcept {
    std::vector<LooseRun> runs = std::move(scene().looseRuns);
    if (runs.size() > scene().looseCount + 1) // the last run is still open
        runs.erase(runs.begin() + std::ptrdiff_t(scene().looseCount) + 1, runs.end());
    scene() = SceneRecording();
    scene().looseRuns = std::move(runs);
}

InstanceList Recorder::allInstances() {
    const InstanceList& recorded = scene().instances;
    std::optional<Instance> loose = looseInstance();
    if (!loose) return recorded;
    InstanceList all;
    all.reserve(recorded.size() + 1);
    all.add(recorded);
    all.add(std::move(*loose));
    return all;
}

} // namespace smart::compat

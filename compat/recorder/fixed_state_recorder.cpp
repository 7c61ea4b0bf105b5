// SPDX-License-Identifier: MIT
#include "compat/recorder/fixed_state_recorder.h"

#include <algorithm>
#include <glm/matrix.hpp>
#include <utility>

#include "compat/recorder/transforms.h"

namespace smart::compat {

namespace {

/// The state that needs no block.
FixedState startState() {
    FixedState state;
    state.ops.depthTest = true;
    return state;
}

const FixedState& start() {
    static const FixedState state = startState();
    return state;
}

bool generatesFromObject(const FixedTexture& texture) {
    for (const TexGen& coordinate : texture.generate)
        if (coordinate.enabled && coordinate.mode == TexGenMode::ObjectLinear) return true;
    return false;
}

bool generatesFromObject(const FixedState& state) {
    return generatesFromObject(state.texture) ||
           std::any_of(state.moreTextures.begin(), state.moreTextures.end(),
                       [](const FixedTexture& unit) { return generatesFromObject(unit); });
}

bool same(const TextureSource& a, const TextureSource& b) {
    if (a.image != b.image) return false;
    return !a.image || (a.texture1D == b.texture1D && a.texture2D == b.texture2D &&
                        a.matrix == b.matrix);
}

/// The unit as a block holds it.
void complete(FixedTexture& texture, const TextureSource& source, const glm::dmat4& objectToEye) {
    if (!source.image) {
        texture = start().texture;
        return;
    }
    texture.image = source.image;
    texture.texture1D = source.texture1D;
    texture.texture2D = source.texture2D;
    texture.matrix = source.matrix;
    // A plane in object coordinates goes through the inverse matrix, as clip planes do.
    glm::dmat4 eyeToObject;
    if (generatesFromObject(texture) && invert(objectToEye, eyeToObject))
        for (TexGen& coordinate : texture.generate)
            coordinate.objectPlane = glm::vec4(glm::dvec4(coordinate.objectPlane) * eyeToObject);
}

void setComponent(FixedMaterial& material, ColorMaterialMode mode, const glm::vec4& color) {
    switch (mode) {
    case ColorMaterialMode::Emission: material.emission = color; break;
    case ColorMaterialMode::Ambient: material.ambient = color; break;
    case ColorMaterialMode::Diffuse: material.diffuse = color; break;
    case ColorMaterialMode::Specular: material.specular = color; break;
    case ColorMaterialMode::AmbientAndDiffuse:
        material.ambient = material.diffuse = color;
        break;
    }
}

} // namespace

FixedStateRecorder::FixedStateRecorder() : state_(startState()) {}

const FixedTexture& FixedStateRecorder::texture() const {
    if (unit_ == 0) return state_.texture;
    return unit_ <= state_.moreTextures.size() ? state_.moreTextures[unit_ - 1] : start().texture;
}

FixedTexture& FixedStateRecorder::changeTexture() {
    if (unit_ == 0) return change().texture;
    if (state_.moreTextures.size() < unit_) state_.moreTextures.resize(unit_);
    return change().moreTextures[unit_ - 1];
}

void FixedStateRecorder::setDepthTest(bool on, bool chosen) {
    change().ops.depthTest = on;
    depthTestChosen_ = chosen;
}

void FixedStateRecorder::bufferCleared() {
    if (!depthTestChosen_) setDepthTest(false);
}

bool FixedStateRecorder::sameSources(const FixedStateSources& sources) const {
    if (!same(sources.texture, sources_.texture) ||
        !std::equal(sources.moreTextures.begin(), sources.moreTextures.end(),
                    sources_.moreTextures.begin(), sources_.moreTextures.end(), same))
        return false;
    if (!sources.texture.image && sources.moreTextures.empty()) return true;
    return sources.objectToEye == sources_.objectToEye || !generatesFromObject(state_);
}

FixedState FixedStateRecorder::effective(const FixedStateSources& sources) const {
    FixedState state = state_;
    if (!state.lighting.enabled) {
        const FixedLighting was = state.lighting;
        state.lighting = start().lighting;
        state.lighting.normalize = was.normalize;
        state.lighting.rescaleNormal = was.rescaleNormal;
        state.lighting.reflections = was.reflections;
        state.lighting.shadeModel = was.shadeModel;
        state.lighting.colorSum = was.colorSum;
    } else {
        state.lighting.colorSum = false; // the sum is always taken
    }
    if (!state.fog.enabled) state.fog = start().fog;
    complete(state.texture, sources.texture, sources.objectToEye);
    state.moreTextures.resize(sources.moreTextures.size());
    for (std::size_t i = 0; i < state.moreTextures.size(); ++i)
        complete(state.moreTextures[i], sources.moreTextures[i], sources.objectToEye);
    return state;
}

FixedStatePtr FixedStateRecorder::block(FixedStateSources sources) {
    if (!changed_ && sameSources(sources)) return block_;
    const FixedState state = effective(sources);
    FixedStatePtr found;
    if (state != start()) {
        for (const FixedStatePtr& known : remembered_)
            if (known && *known == state) found = known;
        if (!found) {
            found = std::make_shared<const FixedState>(state);
            remembered_[nextRemembered_] = found;
            nextRemembered_ = (nextRemembered_ + 1) % kRemembered;
        }
    }
    block_ = std::move(found);
    sources_ = std::move(sources);
    changed_ = false;
    return block_;
}

const std::shared_ptr<const FixedMaterials>& initialMaterials() {
    static const auto materials = std::make_shared<const FixedMaterials>();
    return materials;
}

FixedMaterials withColor(FixedMaterials materials, const FixedLighting& lighting,
                         const glm::vec4& color) {
    if (!lighting.colorMaterial) return materials;
    if (lighting.colorMaterialFace != FixedFace::Back)
        setComponent(materials.front, lighting.colorMaterialMode, color);
    if (lighting.colorMaterialFace != FixedFace::Front)
        setComponent(materials.back, lighting.colorMaterialMode, color);
    return materials;
}

} // namespace smart::compat

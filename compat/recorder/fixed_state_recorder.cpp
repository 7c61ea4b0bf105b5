// SPDX-License-Identifier: MIT
#include "compat/recorder/fixed_state_recorder.h"

#include <glm/matrix.hpp>

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

void FixedStateRecorder::setDepthTest(bool on, bool chosen) {
    change().ops.depthTest = on;
    depthTestChosen_ = chosen;
}

void FixedStateRecorder::bufferCleared() {
    if (!depthTestChosen_) setDepthTest(false);
}

bool FixedStateRecorder::sameSources(const FixedStateSources& sources) const {
    if (sources.image != sources_.image) return false;
    if (!sources.image) return true;
    return sources.texture1D == sources_.texture1D && sources.texture2D == sources_.texture2D &&
           sources.textureMatrix == sources_.textureMatrix &&
           (sources.objectToEye == sources_.objectToEye || !generatesFromObject(state_.texture));
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
    if (sources.image) {
        state.texture.image = sources.image;
        state.texture.texture1D = sources.texture1D;
        state.texture.texture2D = sources.texture2D;
        state.texture.matrix = sources.textureMatrix;
        // A plane in object coordinates goes through the inverse matrix, as clip planes do.
        glm::dmat4 eyeToObject;
        if (generatesFromObject(state.texture) && invert(sources.objectToEye, eyeToObject))
            for (TexGen& coordinate : state.texture.generate)
                coordinate.objectPlane = glm::vec4(glm::dvec4(coordinate.objectPlane) *
                                                   eyeToObject);
    } else {
        state.texture = start().texture;
    }
    return state;
}

FixedStatePtr FixedStateRecorder::block(const FixedStateSources& sources) {
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
    sources_ = sources;
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

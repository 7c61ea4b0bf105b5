// SPDX-License-Identifier: MIT
#include "compat/recorder/recorder.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <iterator>

#include "compat/recorder/transforms.h"
#include "libsmart/base/error.h"

namespace smart::compat {

namespace {

bool usesNormals(const FixedState& state) {
    const TexGen* const begin = std::begin(state.texture.generate);
    return state.lighting.enabled ||
           std::any_of(begin, std::end(state.texture.generate),
                       [](const TexGen& coordinate) { return coordinate.enabled; });
}

} // namespace

void Recorder::requireOutsidePrimitive() const {
    if (insidePrimitive_)
        throw Error(ErrorCode::InvalidOperation, "not legal between begin and end");
}

void Recorder::requireOutsideObject() const {
    requireOutsidePrimitive();
    if (open_) throw Error(ErrorCode::InvalidOperation, "not legal while an object is defined");
}

void Recorder::begin(Primitive primitive) {
    if (insidePrimitive_) throw Error(ErrorCode::InvalidOperation, "begin without an end before");
    const glm::dmat3 normalMatrix =
        open_ ? makeNormalMatrix(matrices_.modelView()) : looseNormalMatrix();
    if (open_)
        open_->recording.begin(primitive);
    else
        beginLoose(primitive);
    normalMatrix_ = normalMatrix;
    insidePrimitive_ = true;
}

void Recorder::beginLoose(Primitive primitive) {
    openLooseRun();
    scene().loose.begin(primitive);
}

void Recorder::openLooseRun() {
    enterLayer();
    FixedStatePtr state = looseState();
    if (state == scene().looseState) return;
    endLooseRun();
    scene().looseState = std::move(state);
}

// Fixed function finds nothing left to rescale there.
glm::dmat3 Recorder::looseNormalMatrix() const {
    glm::dmat3 matrix = makeNormalMatrix(matrices_.modelView());
    if (!fixedState_.state().lighting.rescaleNormal) return matrix;
    const double length = glm::length(matrix[2]);
    return length > 0 ? matrix / length : matrix;
}

Viewport Recorder::viewportNow() const {
    const PixelTarget& target = frameSettings_.target;
    return frameSettings_.viewport.value_or(Viewport{0, 0, target.width, target.height});
}

FixedStatePtr Recorder::looseState() {
    return fixedState_.block(stateSources(matrices_, matrices_.modelView()));
}

FixedStatePtr Recorder::instanceState(const Matrices& matrices) {
    return fixedState_.block(stateSources(matrices, glm::dmat4(1.0)));
}

FixedStateSources Recorder::stateSources(const Matrices& matrices, const glm::dmat4& objectToEye) {
    FixedStateSources sources;
    sources.texture1D = textures_.bound(TextureTarget::OneDimensional);
    sources.texture2D = textures_.bound(TextureTarget::TwoDimensional);
    // Two dimensions go before one; an incomplete texture counts as switched off.
    const FixedTexture& texture = fixedState_.state().texture;
    if (texture.enabled2D) sources.image = textures_.completeBound(TextureTarget::TwoDimensional);
    if (texture.enabled1D && !sources.image)
        sources.image = textures_.completeBound(TextureTarget::OneDimensional);
    sources.textureMatrix = matrices.stack(MatrixMode::Texture).top();
    sources.objectToEye = objectToEye;
    return sources;
}

void Recorder::end() {
    if (!insidePrimitive_) throw Error(ErrorCode::InvalidOperation, "end without a begin");
    insidePrimitive_ = false;
}

void Recorder::vertex(const glm::dvec4& position) {
    if (!insidePrimitive_)
        throw Error(ErrorCode::InvalidOperation, "a vertex outside of begin and end");
    const BoundShader& shader = shaders_.bound();
    if (!shader.isSurface)
        throw Error(ErrorCode::InvalidOperation, "the bound shader is not a surface shader");

    const glm::dvec4 p = matrices_.modelView() * position;
    const glm::vec3 place(p.w == 1 ? glm::dvec3(p) : glm::dvec3(p) / p.w);
    const glm::vec3 normal(normalMatrix_ * glm::dvec3(attributes_.normal));
    if (open_) {
        open_->recording.vertex(place, attributes_, normal, shader);
        return;
    }
    GeometryRecording& loose = scene().loose;
    if (loose.empty()) { // a run starts
        // Fixed function sees the initial normal too, moved by the matrix of now.
        const FixedStatePtr& state = scene().looseState;
        loose.given = {};
        loose.given.normal = normalEverGiven_ || (state && usesNormals(*state));
        scene().looseInherited.color = attributes_.color;
        scene().looseInherited.normal = attributes_.normal;
        scene().looseInherited.texCoord = attributes_.texCoord;
        scene().looseInherited.materials = attributes_.materials;
        scene().looseInherited.secondaryColor = glm::vec3(attributes_.secondaryColor);
        scene().looseInherited.fogCoordinate = attributes_.fogCoordinate;
    }
    loose.vertex(place, attributes_, normal, shader);
    ++scene().additions;
}

// A loose run stores an attribute from the first call on that changes it; an object from the
// first call at all, as its instances would give it another value.
void Recorder::color(const glm::vec4& color) {
    if (open_)
        open_->recording.given.color = true;
    else if (color != attributes_.color)
        scene().loose.given.color = true;
    attributes_.color = color;
}

void Recorder::texCoord(const glm::vec4& texCoord) {
    if (open_)
        open_->recording.given.texCoord = true;
    else if (texCoord != attributes_.texCoord)
        scene().loose.given.texCoord = true;
    attributes_.texCoord = texCoord;
}

void Recorder::secondaryColor(const glm::vec4& color) {
    if (open_)
        open_->recording.given.secondaryColor = true;
    else if (color != attributes_.secondaryColor)
        scene().loose.given.secondaryColor = true;
    attributes_.secondaryColor = color;
}

void Recorder::fogCoordinate(float coordinate) {
    if (open_)
        open_->recording.given.fogCoordinate = true;
    else if (coordinate != attributes_.fogCoordinate)
        scene().loose.given.fogCoordinate = true;
    attributes_.fogCoordinate = coordinate;
}

// What follows the colour does so at once. Of geometry in objects that is not known before they
// are placed: it keeps both.
void Recorder::setMaterials(FixedMaterials materials) {
    if (!open_) materials = withColor(materials, fixedState_.state().lighting, attributes_.color);
    const FixedMaterials& before =
        attributes_.materials ? *attributes_.materials : *initialMaterials();
    const bool changes = materials != before;
    if (changes) attributes_.materials = std::make_shared<const FixedMaterials>(materials);
    if (open_)
        open_->recording.given.materials = true;
    else if (changes)
        scene().loose.given.materials = true;
}

void Recorder::restoreAttributes(const Attributes& attributes) {
    const Attributes now = attributes_;
    color(attributes.color);
    texCoord(attributes.texCoord);
    if (attributes.normal != now.normal) normal(attributes.normal);
    secondaryColor(attributes.secondaryColor);
    fogCoordinate(attributes.fogCoordinate);
    attributes_.edgeFlag = attributes.edgeFlag;
}

FixedMaterials Recorder::materials() const {
    const FixedMaterials& kept =
        attributes_.materials ? *attributes_.materials : *initialMaterials();
    if (open_) return kept;
    return withColor(kept, fixedState_.state().lighting, attributes_.color);
}

void Recorder::normal(const glm::vec3& normal) {
    if (open_) {
        open_->recording.given.normal = true;
    } else {
        scene().loose.given.normal = true;
        normalEverGiven_ = true;
    }
    attributes_.normal = normal;
}

} // namespace smart::compat

// SPDX-License-Identifier: MIT
#include "compat/recorder/recorder.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <iterator>
#include <utility>

#include "compat/recorder/transforms.h"
#include "libsmart/base/error.h"

namespace smart::compat {

namespace {

bool generates(const FixedTexture& texture) {
    return std::any_of(std::begin(texture.generate), std::end(texture.generate),
                       [](const TexGen& coordinate) { return coordinate.enabled; });
}

bool usesNormals(const FixedState& state) {
    return state.lighting.enabled || generates(state.texture) ||
           std::any_of(state.moreTextures.begin(), state.moreTextures.end(), generates);
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
    const FixedState& state = fixedState_.state();
    FixedStateSources sources;
    sources.texture = textureSource(state.texture, 0, matrices);
    for (std::size_t unit = 1; unit <= state.moreTextures.size(); ++unit) {
        TextureSource source = textureSource(state.moreTextures[unit - 1], unit, matrices);
        if (!source.image) continue;
        sources.moreTextures.resize(unit);
        sources.moreTextures.back() = std::move(source);
    }
    sources.objectToEye = objectToEye;
    return sources;
}

TextureSource Recorder::textureSource(const FixedTexture& texture, std::size_t unit,
                                      const Matrices& matrices) {
    constexpr TextureTarget k1D = TextureTarget::OneDimensional,
                            k2D = TextureTarget::TwoDimensional;
    TextureSource source;
    source.texture1D = textures_.boundTo(k1D, unit);
    source.texture2D = textures_.boundTo(k2D, unit);
    // Two dimensions go before one; an incomplete texture counts as switched off.
    if (texture.enabled2D) source.image = textures_.completeBound(k2D, unit);
    if (texture.enabled1D && !source.image) source.image = textures_.completeBound(k1D, unit);
    source.matrix = matrices.textureStack(unit).top();
    return source;
}

void Recorder::selectTextureUnit(std::size_t unit) {
    requireOutsidePrimitive();
    textureUnit_ = unit;
    textures_.selectUnit(unit);
    matrices_.selectUnit(unit);
    fixedState_.selectUnit(unit);
}

std::shared_ptr<const MoreTexCoords> Recorder::sharedTexCoords(const Attributes& attributes) {
    if (!attributes.moreTexCoordsGiven) return nullptr;
    if (!sharedTexCoords_ || *sharedTexCoords_ != attributes.moreTexCoords)
        sharedTexCoords_ = std::make_shared<const MoreTexCoords>(attributes.moreTexCoords);
    return sharedTexCoords_;
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
        scene().looseInherited = inheritedFrom(attributes_);
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

void Recorder::texCoord(const glm::vec4& texCoord, std::size_t unit) {
    const bool isFirst = unit == 0;
    glm::vec4& current =
        isFirst ? attributes_.texCoord : attributes_.moreTexCoords[unit - 1];
    if (open_ || texCoord != current) {
        AttributesGiven& given = open_ ? open_->recording.given : scene().loose.given;
        if (isFirst)
            given.texCoord = true;
        else
            given.moreTexCoords |= uint8_t(1u << (unit - 1));
    }
    if (!isFirst) attributes_.moreTexCoordsGiven = true;
    current = texCoord;
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
    if (now.moreTexCoordsGiven)
        for (std::size_t unit = 1; unit < kTextureUnits; ++unit)
            texCoord(attributes.texCoordOf(unit), unit);
    if (attributes.normal != now.normal) normal(attributes.normal);
    secondaryColor(attributes.secondaryColor);
    fogCoordinate(attributes.fogCoordinate);
    attributes_.edgeFlag = attributes.edgeFlag;
}

void Recorder::restoreMaterials(std::shared_ptr<const FixedMaterials> materials) noexcept {
    const auto& now = attributes_.materials ? attributes_.materials : initialMaterials();
    if (*materials == *now) return;
    attributes_.materials = std::move(materials);
    scene().loose.given.materials = true;
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

// SPDX-License-Identifier: MIT
#include "compat/recorder/recorder.h"

#include "compat/recorder/transforms.h"
#include "libsmart/base/error.h"

namespace smart::compat {

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
    GeometryRecording& geometry = open_ ? open_->recording : scene().loose;
    geometry.begin(primitive);
    normalMatrix_ = makeNormalMatrix(matrices_.modelView());
    insidePrimitive_ = true;
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
        loose.given = {false, normalEverGiven_, false};
        scene().looseInherited.color = attributes_.color;
        scene().looseInherited.normal = attributes_.normal;
        scene().looseInherited.texCoord = attributes_.texCoord;
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

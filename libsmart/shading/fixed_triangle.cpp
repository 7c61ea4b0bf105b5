// SPDX-License-Identifier: MIT
#include "libsmart/shading/fixed_triangle.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "libsmart/shading/corner_attributes.h"

namespace smart {
namespace {

glm::dvec3 toVector(const float (&v)[3]) {
    return {v[0], v[1], v[2]};
}

/// Inverse transpose; of a singular matrix the cofactors.
glm::dmat3 normalMatrix(const glm::dmat4x3& matrix) {
    const glm::dvec3 x = matrix[0], y = matrix[1], z = matrix[2];
    const glm::dmat3 cofactors{glm::cross(y, z), glm::cross(z, x), glm::cross(x, y)};
    const double determinant = glm::dot(x, cofactors[0]);
    return determinant != 0.0 ? cofactors / determinant : cofactors;
}

glm::vec4 mix(const glm::vec4& a, const glm::vec4& b, const glm::vec4& c,
              const glm::dvec3& weights) {
    return glm::vec4(weights[0] * glm::dvec4(a) + weights[1] * glm::dvec4(b) +
                     weights[2] * glm::dvec4(c));
}
glm::vec3 mix(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
              const glm::dvec3& weights) {
    return glm::vec3(weights[0] * glm::dvec3(a) + weights[1] * glm::dvec3(b) +
                     weights[2] * glm::dvec3(c));
}
float mix(float a, float b, float c, const glm::dvec3& weights) {
    return float(weights[0] * a + weights[1] * b + weights[2] * c);
}

FixedMaterial mix(const FixedMaterial& a, const FixedMaterial& b, const FixedMaterial& c,
                  const glm::dvec3& weights) {
    return {mix(a.ambient, b.ambient, c.ambient, weights),
            mix(a.diffuse, b.diffuse, c.diffuse, weights),
            mix(a.specular, b.specular, c.specular, weights),
            mix(a.emission, b.emission, c.emission, weights),
            mix(a.shininess, b.shininess, c.shininess, weights),
            mix(a.reflection, b.reflection, c.reflection, weights)};
}

/// As litVertex wants it.
const glm::vec3* visibilityOf(uint32_t hidden, glm::vec3 (&memory)[kFixedLights]) {
    for (int i = 0; i < kFixedLights; ++i)
        memory[i] = glm::vec3(hidden >> i & 1u ? 0.0f : 1.0f);
    return memory;
}

/// Reads the vertices of a model as fixed function has them.
class VertexReader {
public:
    explicit VertexReader(const FixedWay& way)
        : way_(way),
          chain_(way.chain),
          state_(*chain_.instances[0]->traits->state),
          attributes_(chain_) {}

    FixedVertex read(uint32_t triangle, int corner) const {
        const ShadingData& shading = chain_.model->shading;
        const Triangle& corners = chain_.model->triangles[triangle];
        const auto& place = corner == 0 ? corners.v0 : corner == 1 ? corners.v1 : corners.v2;
        const auto attribute = [&](const auto& values, uint32_t first, auto own, auto inherited) {
            const auto* value = attributes_.find(values, first, triangle, corner);
            return value ? *value : attributes_.inheritedValue(own, inherited);
        };
        using Inherited = InheritedAttributes;
        FixedVertex vertex;
        const glm::dvec3 position = toVector(place);
        vertex.objectPosition = glm::dvec4(position, 1.0);
        vertex.position = chain_.toWorld * vertex.objectPosition;
        vertex.normal = way_.normals * glm::dvec3(attribute(shading.normals, shading.firstNormal,
                                                        &Inherited::ownNormal,
                                                        &Inherited::normal));
        vertex.color = attribute(shading.colors, shading.firstColor, &Inherited::ownColor,
                                 &Inherited::color);
        vertex.texCoord = attribute(shading.texCoords, shading.firstTexCoord,
                                    &Inherited::ownTexCoord, &Inherited::texCoord);
        const uint32_t* material = attributes_.find(shading.vertexMaterials,
                                                    shading.firstMaterial, triangle, corner);
        vertex.materials =
            material ? shading.materials[*material].get()
                     : attributes_.inheritedValue(&Inherited::ownMaterials, &Inherited::materials)
                           .get();
        vertex.normalScale = way_.normalScale;
        if (state_.lighting.colorSum)
            vertex.secondaryColor = attribute(shading.secondaryColors, shading.firstSecondaryColor,
                                              &Inherited::ownSecondaryColor,
                                              &Inherited::secondaryColor);
        if (state_.fog.fromCoordinate)
            vertex.fogCoordinate = attribute(shading.fogCoordinates, shading.firstFogCoordinate,
                                             &Inherited::ownFogCoordinate,
                                             &Inherited::fogCoordinate);
        for (std::size_t unit = 0; unit < state_.moreTextures.size(); ++unit)
            vertex.moreTexCoords[unit] = texCoordOf(unit, triangle, corner);
        return vertex;
    }

private:
    glm::vec4 texCoordOf(std::size_t unit, uint32_t triangle, int corner) const {
        const std::vector<UnitTexCoords>& units = chain_.model->shading.moreTexCoords;
        if (!units.empty())
            if (const glm::vec4* const own = attributes_.find(units[unit].values,
                                                              units[unit].first, triangle, corner))
                return *own;
        return attributes_.inheritedTexCoord(unit);
    }

    const FixedWay& way_;
    const HitChain& chain_;
    const FixedState& state_;
    const CornerAttributes attributes_;
};

} // namespace

FixedWay::FixedWay(const HitChain& way)
    : chain(way), normals(normalMatrix(way.toWorld)), normalScale(rescaleFactor(way.toWorld)) {}

void FixedTriangle::set(const FixedWay& way, uint32_t triangle, const FixedViewer& viewer) {
    const HitChain& chain = way.chain;
    state_ = chain.instances[0]->traits->state.get();
    viewer_ = viewer;
    seen_[0].known = seen_[1].known = shadowed_.known = false;
    const VertexReader reader(way);
    for (int corner = 0; corner < 3; ++corner) vertices_[corner] = reader.read(triangle, corner);
    const std::vector<uint8_t>& provoking = chain.model->shading.provoking;
    provoking_ = provoking.empty() ? ShadingData::kLastCorner : provoking[triangle];
    if (provoking_ >= ShadingData::kOfNext) {
        vertices_[kProvoking] = reader.read(triangle + 1, provoking_ - ShadingData::kOfNext);
        provoking_ = kProvoking;
    }
}

LitVertex FixedTriangle::lit(const FixedVertex& vertex, bool back,
                             const glm::vec3* visibility) const {
    return litVertex(*state_, vertex, back, viewer_, visibility);
}

void FixedTriangle::light(Lit& to, bool back, const glm::vec3* visibility) const {
    for (int corner = 0; corner < 3; ++corner)
        to.corners[corner] = lit(vertices_[corner], back, visibility);
    if (state_->lighting.shadeModel == ShadeModel::Flat)
        to.flat = provoking_ == kProvoking ? lit(vertices_[kProvoking], back, visibility)
                                           : to.corners[provoking_];
}

const FixedTriangle::Lit& FixedTriangle::lit(bool back, uint32_t hidden) {
    Lit& found = hidden == 0 ? seen_[back] : shadowed_;
    if (found.known && found.hidden == hidden && (hidden == 0 || shadowedBack_ == back))
        return found;
    glm::vec3 visibility[kFixedLights];
    light(found, back, hidden == 0 ? nullptr : visibilityOf(hidden, visibility));
    if (hidden != 0) shadowedBack_ = back;
    found.hidden = hidden;
    found.known = true;
    return found;
}

const LitVertex (&FixedTriangle::corners(bool back))[3] { return lit(back, 0).corners; }

FixedVertex FixedTriangle::vertexAt(const glm::dvec3& weights, FixedMaterials& memory) const {
    const auto sum = [&](auto member) {
        return weights[0] * (vertices_[0].*member) + weights[1] * (vertices_[1].*member) +
               weights[2] * (vertices_[2].*member);
    };
    FixedVertex vertex = vertices_[0];
    vertex.position = sum(&FixedVertex::position);
    vertex.normal = glm::dvec3(0.0);
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3& normal = vertices_[i].normal;
        const double squared = glm::dot(normal, normal);
        const bool unit = state_->lighting.normalize && squared > 0.0;
        vertex.normal += weights[i] * (unit ? normal / std::sqrt(squared) : normal);
    }
    const double squared = glm::dot(vertex.normal, vertex.normal);
    if (squared > 0.0) vertex.normal /= std::sqrt(squared);
    vertex.normalScale = 1.0;
    vertex.color = mix(vertices_[0].color, vertices_[1].color, vertices_[2].color, weights);
    vertex.secondaryColor = mix(vertices_[0].secondaryColor, vertices_[1].secondaryColor,
                                vertices_[2].secondaryColor, weights);
    if (vertices_[0].materials != vertices_[1].materials ||
        vertices_[0].materials != vertices_[2].materials) {
        static const FixedMaterials initial;
        const auto of = [&](int i) -> const FixedMaterials& {
            return vertices_[i].materials ? *vertices_[i].materials : initial;
        };
        memory = {mix(of(0).front, of(1).front, of(2).front, weights),
                  mix(of(0).back, of(1).back, of(2).back, weights)};
        vertex.materials = &memory;
    }
    return vertex;
}

LitVertex FixedTriangle::interpolated(const LitVertex (&corners)[3],
                                      const glm::dvec3& weights) const {
    const auto& [a, b, c] = corners;
    LitVertex result;
    result.primary = mix(a.primary, b.primary, c.primary, weights);
    if (state_->lighting.hasSecondary())
        result.secondary = mix(a.secondary, b.secondary, c.secondary, weights);
    if (state_->texture.image) result.texCoord = mix(a.texCoord, b.texCoord, c.texCoord, weights);
    if (state_->fog.enabled)
        result.fogDistance = mix(a.fogDistance, b.fogDistance, c.fogDistance, weights);
    result.moreUnits = a.moreUnits;
    for (uint32_t i = 0; i < a.moreUnits; ++i)
        result.moreTexCoords[i] =
            mix(a.moreTexCoords[i], b.moreTexCoords[i], c.moreTexCoords[i], weights);
    if (state_->lighting.reflections)
        result.reflection = mix(a.reflection, b.reflection, c.reflection, weights);
    result.lightsIn = a.lightsIn | b.lightsIn | c.lightsIn;
    return result;
}

uint32_t FixedTriangle::lightsAt(const glm::dvec3& weights, bool back) {
    switch (state_->lighting.shadeModel) {
    case ShadeModel::Flat: return lit(back, 0).flat.lightsIn;
    case ShadeModel::Phong: return at(weights, back).lightsIn;
    case ShadeModel::Smooth: break;
    }
    const auto& [a, b, c] = corners(back);
    return a.lightsIn | b.lightsIn | c.lightsIn;
}

glm::vec4 FixedTriangle::primaryAt(const glm::dvec3& weights, bool back, uint32_t hidden) {
    const Lit& known = lit(back, hidden);
    if (state_->lighting.shadeModel == ShadeModel::Flat) return known.flat.primary;
    const auto& [a, b, c] = known.corners;
    return mix(a.primary, b.primary, c.primary, weights);
}

LitVertex FixedTriangle::at(const glm::dvec3& weights, bool back, const FixedArrival& arrival) {
    const auto withColorsOf = [&](const LitVertex& lit) {
        LitVertex result = interpolated(corners(back), weights);
        result.primary = lit.primary;
        result.secondary = lit.secondary;
        result.reflection = lit.reflection;
        result.lightsIn = lit.lightsIn;
        return result;
    };
    if (state_->lighting.shadeModel == ShadeModel::Phong) {
        FixedMaterials memory;
        glm::vec3 visibility[kFixedLights];
        const glm::vec3* shares = arrival.shares;
        if (!shares && arrival.hidden != 0) shares = visibilityOf(arrival.hidden, visibility);
        return withColorsOf(lit(vertexAt(weights, memory), back, shares));
    }
    const auto of = [&](const Lit& known) {
        return state_->lighting.shadeModel == ShadeModel::Flat
                   ? withColorsOf(known.flat)
                   : interpolated(known.corners, weights);
    };
    if (!arrival.shares) return of(lit(back, arrival.hidden));
    Lit memory;
    light(memory, back, arrival.shares);
    return of(memory);
}

} // namespace smart

// SPDX-License-Identifier: MIT
// The vertex stage of fixed function. In double, so that the order of sums leaves no trace in
// eight bits.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "libsmart/base/transcendental.h"
#include "libsmart/shading/fixed_function.h"

namespace smart {
namespace {

/// Length 1; zero where there is no direction.
glm::dvec3 unit(const glm::dvec3& v) {
    const double length = std::sqrt(glm::dot(v, v));
    return length > 0.0 ? v / length : glm::dvec3(0.0);
}

/// base^exponent for what lighting raises to powers: 0 for a base that is not positive, unless the
/// exponent is 0.
double power(double base, double exponent) {
    if (exponent == 0.0) return 1.0;
    if (!(base > 1e-300)) return 0.0;
    const double value = exponent * math::detail::logOf(base);
    return value < -690.0 ? 0.0 : math::detail::expOf(std::min(value, 690.0));
}

float clamped(double value) {
    return value > 0.0 ? float(std::min(value, 1.0)) : 0.0f;
}
glm::vec3 clamped(const glm::dvec3& color) {
    return {clamped(color.x), clamped(color.y), clamped(color.z)};
}

glm::dvec3 rgb(const glm::vec4& color) {
    return glm::dvec3(glm::vec3(color));
}

FixedMaterial materialOf(const FixedLighting& lighting, const FixedVertex& vertex, bool back) {
    FixedMaterial material;
    if (vertex.materials) material = back ? vertex.materials->back : vertex.materials->front;
    const FixedFace other = back ? FixedFace::Front : FixedFace::Back;
    if (!lighting.colorMaterial || lighting.colorMaterialFace == other) return material;
    switch (lighting.colorMaterialMode) {
    case ColorMaterialMode::Emission: material.emission = vertex.color; break;
    case ColorMaterialMode::Ambient: material.ambient = vertex.color; break;
    case ColorMaterialMode::Diffuse: material.diffuse = vertex.color; break;
    case ColorMaterialMode::Specular: material.specular = vertex.color; break;
    case ColorMaterialMode::AmbientAndDiffuse:
        material.ambient = material.diffuse = vertex.color;
        break;
    }
    return material;
}

/// From a vertex to a light.
struct LightRay {
    glm::dvec3 direction; ///< length 1
    double intensity;     ///< attenuation and spotlight
};

LightRay rayTo(const FixedLight& light, const glm::dvec3& position) {
    LightRay ray{glm::dvec3(light.position), 1.0};
    if (light.position.w != 0.0f) {
        ray.direction = ray.direction / double(light.position.w) - position;
        const double distance = std::sqrt(glm::dot(ray.direction, ray.direction));
        ray.intensity = 1.0 / (light.constantAttenuation + light.linearAttenuation * distance +
                               light.quadraticAttenuation * distance * distance);
    }
    ray.direction = unit(ray.direction);
    if (light.spotCutoff != 180.0f) {
        const double cosine = -glm::dot(ray.direction, unit(glm::dvec3(light.spotDirection)));
        const float edge = math::cos(float(double(light.spotCutoff) * math::kPi / 180.0));
        ray.intensity *= cosine < double(edge) ? 0.0 : power(cosine, light.spotExponent);
    }
    return ray;
}

/// What the lights add up to (OpenGL 1.5, section 2.13.1).
void illuminate(const FixedLighting& lighting, const FixedVertex& vertex, const glm::dvec3& normal,
                bool back, const FixedViewer& viewer, const glm::vec3* visibility,
                LitVertex& result) {
    const FixedMaterial material = materialOf(lighting, vertex, back);
    const bool local = lighting.localViewer || viewer.alwaysLocal;
    const glm::dvec3 toViewer =
        local ? unit(viewer.position - vertex.position) : glm::dvec3(0.0, 0.0, 1.0);
    glm::dvec3 primary =
        rgb(material.emission) + rgb(material.ambient) * rgb(lighting.modelAmbient);
    glm::dvec3 secondary(0.0);
    for (int i = 0; i < kFixedLights; ++i) {
        const FixedLight& light = lighting.lights[i];
        if (!light.enabled) continue;
        const LightRay ray = rayTo(light, vertex.position);
        const double cosine = std::max(glm::dot(normal, ray.direction), 0.0);
        glm::dvec3 own = rgb(material.ambient) * rgb(light.ambient) +
                         cosine * rgb(material.diffuse) * rgb(light.diffuse);
        glm::dvec3 highlight(0.0);
        const bool glossy = rgb(material.specular) * rgb(light.specular) != glm::dvec3(0.0);
        if (cosine > 0.0 && glossy) {
            const glm::dvec3 halfway = unit(ray.direction + toViewer);
            highlight = power(std::max(glm::dot(normal, halfway), 0.0), material.shininess) *
                        rgb(material.specular) * rgb(light.specular);
        }
        own *= ray.intensity;
        highlight *= ray.intensity;
        if (own != glm::dvec3(0.0) || highlight != glm::dvec3(0.0)) result.lightsIn |= 1u << i;
        if (visibility) {
            own *= glm::dvec3(visibility[i]);
            highlight *= glm::dvec3(visibility[i]);
        }
        primary += own;
        (lighting.separateSpecular ? secondary : primary) += highlight;
    }
    result.primary = glm::vec4(clamped(primary), clamped(double(material.diffuse.a)));
    result.secondary = clamped(secondary);
    result.reflection = clamped(double(material.reflection));
}

/// OpenGL 1.5, section 2.10.4.
glm::dvec4 generatedTexCoord(const FixedTexture& texture, const FixedVertex& vertex,
                             const glm::vec4& given, const glm::dvec3& normal,
                             const FixedViewer& viewer) {
    glm::dvec4 result(given);
    glm::dvec3 mirrored(0.0);
    for (const TexGen& generated : texture.generate)
        if (generated.enabled && (generated.mode == TexGenMode::SphereMap ||
                                  generated.mode == TexGenMode::ReflectionMap)) {
            const glm::dvec3 incoming = unit(vertex.position - viewer.position);
            mirrored = incoming - 2.0 * glm::dot(normal, incoming) * normal;
            break;
        }
    for (int k = 0; k < 4; ++k) {
        const TexGen& generated = texture.generate[k];
        if (!generated.enabled) continue;
        switch (generated.mode) {
        case TexGenMode::ObjectLinear:
            result[k] = glm::dot(glm::dvec4(generated.objectPlane), vertex.objectPosition);
            break;
        case TexGenMode::EyeLinear:
            result[k] =
                glm::dot(glm::dvec4(generated.eyePlane), glm::dvec4(vertex.position, 1.0));
            break;
        case TexGenMode::SphereMap:
            if (k < 2) {
                const glm::dvec3 r = mirrored + glm::dvec3(0.0, 0.0, 1.0);
                const double m = 2.0 * std::sqrt(glm::dot(r, r));
                result[k] = m > 0.0 ? r[k] / m + 0.5 : 0.5;
            }
            break;
        case TexGenMode::NormalMap:
            if (k < 3) result[k] = normal[k];
            break;
        case TexGenMode::ReflectionMap:
            if (k < 3) result[k] = mirrored[k];
            break;
        }
    }
    return result;
}

glm::dvec3 normalOf(const FixedLighting& lighting, const FixedVertex& vertex) {
    glm::dvec3 normal = vertex.normal;
    if (lighting.rescaleNormal) normal *= vertex.normalScale;
    return lighting.normalize ? unit(normal) : normal;
}

} // namespace

glm::vec4 transformedTexCoord(const FixedState& state, const FixedTexture& texture,
                              const FixedVertex& vertex, const glm::vec4& given) {
    return glm::vec4(texture.matrix * generatedTexCoord(texture, vertex, given,
                                                        normalOf(state.lighting, vertex), {}));
}

double rescaleFactor(const glm::dmat4x3& modelView) {
    // Row 2 of the inverse, by the cofactors of the matrix's columns.
    const glm::dvec3 cofactors = glm::cross(modelView[0], modelView[1]);
    const double determinant = glm::dot(cofactors, modelView[2]);
    const double length = std::sqrt(glm::dot(cofactors, cofactors));
    return length > 0.0 && determinant != 0.0 ? std::fabs(determinant) / length : 1.0;
}

LitVertex litVertex(const FixedState& state, const FixedVertex& vertex, bool back,
                    const FixedViewer& viewer, const glm::vec3* visibility) {
    const FixedLighting& lighting = state.lighting;
    LitVertex result;
    result.texCoord = vertex.texCoord;
    const glm::dvec3 normal = normalOf(lighting, vertex);
    if (lighting.enabled) {
        const bool other = back && lighting.twoSided;
        illuminate(lighting, vertex, other ? -normal : normal, other, viewer, visibility, result);
    } else {
        for (int k = 0; k < 4; ++k) result.primary[k] = clamped(double(vertex.color[k]));
        if (lighting.colorSum) result.secondary = clamped(glm::dvec3(vertex.secondaryColor));
        if (vertex.materials)
            result.reflection =
                clamped(double((back ? vertex.materials->back : vertex.materials->front)
                                   .reflection));
    }
    result.moreUnits = uint32_t(state.moreTextures.size());
    forEachTexture(state, vertex,
                   [&](std::size_t unit, const FixedTexture& texture, const glm::vec4& given) {
                       glm::vec4& to =
                           unit == 0 ? result.texCoord : result.moreTexCoords[unit - 1];
                       to = glm::vec4(texture.matrix *
                                      generatedTexCoord(texture, vertex, given, normal, viewer));
                   });
    if (state.fog.enabled)
        result.fogDistance = state.fog.fromCoordinate ? vertex.fogCoordinate
                                                      : float(std::fabs(vertex.position.z));
    return result;
}

} // namespace smart

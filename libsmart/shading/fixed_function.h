// SPDX-License-Identifier: MIT
// OpenGL's fixed-function pipeline as functions of a state block: what becomes of a vertex (OpenGL
// 1.5, sections 2.10.3, 2.10.4 and 2.13) and of a fragment (sections 3.8.13, 3.9 and 3.10). Eye
// space is the space that the scene's instance matrices map to.
#pragma once

#include <cstdint>
#include <glm/mat4x3.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "libsmart/geometry/texture_units.h"
#include "libsmart/shading/fixed_state.h"
#include "libsmart/shading/texture.h"

namespace smart {

/// A vertex as the application gave it.
struct FixedVertex {
    glm::dvec3 position{0.0};               ///< in eye space
    glm::dvec3 normal{0.0, 0.0, 1.0};       ///< in eye space, not yet normalised or rescaled
    glm::dvec4 objectPosition{0.0, 0.0, 0.0, 1.0};
    glm::vec4 color{1.0f};
    glm::vec3 secondaryColor{0.0f};
    glm::vec4 texCoord{0.0f, 0.0f, 0.0f, 1.0f};
    const FixedMaterials* materials = nullptr; ///< nullptr: OpenGL's initial ones
    double normalScale = 1.0;                  ///< rescaleFactor() of the instance's matrices
    float fogCoordinate = 0.0f;
    MoreTexCoords moreTexCoords;
};

/// What RT_RESCALE_NORMAL multiplies normals by that went through this model-view matrix; 1 for a
/// singular one.
double rescaleFactor(const glm::dmat4x3& modelView);

/// Where a vertex is seen from. In OpenGL the eye is at the origin of eye space, and without a
/// local viewer at infinity on the z axis.
struct FixedViewer {
    glm::dvec3 position{0.0};
    bool alwaysLocal = false; ///< for cameras of which eye space knows nothing
};

/// A vertex behind the vertex stage; colours are within 0..1. All of it is interpolated
/// perspective-correctly, but for the colours with ShadeModel::Flat.
struct LitVertex {
    glm::vec4 primary{0.0f};
    glm::vec3 secondary{0.0f};
    glm::vec4 texCoord{0.0f, 0.0f, 0.0f, 1.0f};
    float fogDistance = 0.0f;
    float reflection = 0.0f;  ///< the material's
    uint32_t lightsIn = 0;    ///< bit i: light i adds something, were it visible
    uint32_t moreUnits = 0;   ///< so many of what follows are interpolated
    MoreTexCoords moreTexCoords;
};

/// `back`: the vertex of a polygon that shows its back, which matters with two-sided lighting.
/// `visibility`: share of each of the kFixedLights that arrives; nullptr: all of it.
LitVertex litVertex(const FixedState& state, const FixedVertex& vertex, bool back,
                    const FixedViewer& viewer = {}, const glm::vec3* visibility = nullptr);

/// Texture coordinates of a unit behind generation and texture matrix (section 2.10.4).
glm::vec4 transformedTexCoord(const FixedState& state, const FixedTexture& texture,
                              const FixedVertex& vertex, const glm::vec4& given);

/// (1 - share) * a + share * b.
LitVertex interpolated(const LitVertex& a, const LitVertex& b, double share);

/// The texel of a unit's texture. `texels`: distance to the neighbouring pixels' texture
/// coordinates, in texels of the first level, from which the level of detail comes.
/// Precondition: the unit has a texture.
glm::vec4 fixedTexel(const FixedTexture& texture, const glm::vec4& texCoord, double texels);

/// Calls with the number, texture and texture coordinates of each unit that has a texture.
template <class Coordinates, class Action>
void forEachTexture(const FixedState& state, const Coordinates& from, Action&& action) {
    if (state.texture.image) action(std::size_t(0), state.texture, from.texCoord);
    for (std::size_t i = 0; i < state.moreTextures.size(); ++i)
        if (state.moreTextures[i].image)
            action(i + 1, state.moreTextures[i], from.moreTexCoords[i]);
}

/// The texels at a fragment, each in its unit's place of `memory`, with a distance to the
/// neighbours for each; nullptr: no unit has a texture.
const glm::vec4* fixedTexels(const FixedState& state, const LitVertex& fragment,
                             const double* distances, glm::vec4 (&memory)[kTextureUnits]);

/// Texture environment of all units, and colour sum. `texels`: by unit; nullptr where the state
/// has no texture.
glm::vec4 surfaceColor(const FixedState& state, const LitVertex& fragment,
                       const glm::vec4* texels);
/// Fog on top of it.
glm::vec4 fogged(const FixedFog& fog, const glm::vec4& color, float fogDistance);
/// Both. Within 0..1.
glm::vec4 fragmentColor(const FixedState& state, const LitVertex& fragment,
                        const glm::vec4* texels);

/// What a fragment adds to, and leaves of, what is behind it: colour = own + through * behind.
/// Alpha test and blending, as far as they do not need to know what is behind.
struct FixedBlend {
    glm::vec3 own, through;
};
FixedBlend blendOf(const FixedFragmentOps& ops, const glm::vec4& color);
/// Whether fragments may leave something of what is behind.
bool letsThrough(const FixedFragmentOps& ops);

} // namespace smart

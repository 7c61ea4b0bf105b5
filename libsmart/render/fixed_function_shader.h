// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <optional>
#include <vector>

#include "libsmart/render/frame.h"
#include "libsmart/render/ray_group.h"
#include "libsmart/render/thread_loan.h"
#include "libsmart/render/way_cache.h"
#include "libsmart/shading/fixed_triangle.h"

namespace smart {

struct PointState;

/// Shades hits by fixed function, and keeps what the hits of a triangle have in common. Belongs to
/// one thread.
class FixedFunctionShader {
public:
    explicit FixedFunctionShader(const Frame& frame) : frame_(frame) {}

    /// RGBA of the point where a surface was hit whose outermost instance has a state. Shadow rays
    /// and mirrored ones go through the point's function table.
    glm::vec4 shade(PointState& point, const Hit& hit);

    /// Whether the colour of what a camera ray hits depends on the hit alone: the layer's camera is
    /// the projection matrix, and no rays go on.
    bool dependsOnHitAlone(const FixedState& state) const {
        return dependsOnLight(state) && !asksForShadows(state);
    }
    /// The same but for what arrives of the lights.
    bool dependsOnLight(const FixedState& state) const {
        return !frame_.camera && !state.lighting.reflections;
    }
    static bool asksForShadows(const FixedState& state) {
        return state.lighting.enabled && state.lighting.shadows;
    }
    /// That colour.
    glm::vec4 shadeAlone(const Ray& ray, const Hit& hit, const FixedArrival& arrival = {});
    /// The same for lanes that hit one triangle on one way. hidden: by lane, as FixedArrival's.
    void shadeAlone(const RayGroup& rays, uint32_t lanes, const uint32_t (&hidden)[kPacketSize],
                    glm::vec4 (&colors)[kPacketSize]);
    /// The lights that add something to such a colour, were they seen: bit i for light i, by lane.
    void findLights(const RayGroup& rays, uint32_t lanes, uint32_t (&lights)[kPacketSize]);

    /// The way from a point to a light.
    struct ToLight {
        glm::dvec3 place; ///< of the light, or its direction
        bool isPlace;

        explicit ToLight(const FixedLight& light)
            : place(glm::vec3(light.position)), isPlace(light.position.w != 0.0f) {
            if (isPlace) place = place / double(light.position.w);
        }
        /// Returns the distance.
        float from(const glm::dvec3& point, float (&direction)[3]) const {
            const glm::dvec3 towards = isPlace ? place - point : place;
            for (int k = 0; k < 3; ++k) direction[k] = float(towards[k]);
            return isPlace ? float(std::sqrt(glm::dot(towards, towards)))
                           : std::numeric_limits<float>::infinity();
        }
    };

private:
    /// A triangle in the window of a layer whose camera is the projection matrix: homogeneous,
    /// so that nothing has to be clipped. Olano, Greer: "Triangle Scan Conversion using 2D
    /// Homogeneous Coordinates", Graphics Hardware 1997.
    struct OnScreen {
        glm::dvec3 corners[3]; ///< x, y in pixels, each times w; w
        double doubleArea;     ///< its sign is the winding's: positive anticlockwise
    };
    /// Texture coordinates on the screen, as linear functions of (x, y, 1).
    struct TexturePlanes {
        glm::dvec3 s, t, q;
    };
    struct Known {
        FixedTriangle triangle;
        bool hasScreen = false, hasTexture = false;
        OnScreen screen;
        TexturePlanes texture; ///< of the first unit
        std::vector<TexturePlanes> moreTextures;
    };
    /// How far the texture coordinates of the neighbouring pixels lie away, in texels, by unit;
    /// where the level of detail does not matter, 0.
    using Texels = std::array<double, kTextureUnits>;

    /// Valid up to the next one that is asked for.
    Known& find(const Hit& hit, const FixedViewer& viewer);
    FixedViewer viewerOf(const RTSstate& state) const;
    const OnScreen& screenOf(Known& known) const;
    /// Whether a side matters to the state's colours.
    static bool hasSides(const FixedState& state);
    bool showsBackOnScreen(Known& known, const float (&rayDirection)[3]) const;
    void findPlanes(Known& known, bool back) const;
    Texels texelsToNeighbours(Known& known, const glm::dvec3& weights, bool back) const;
    double distanceInTexels(const TexturePlanes& planes, const glm::dvec3& pixel,
                            const glm::dvec2& size) const;
    /// The same by the ray's cone.
    static Texels texelsInCone(Known& known, const RTSstate& state, bool back);
    glm::vec4 colorAlone(Known& known, const glm::dvec3& weights, bool back,
                         const FixedArrival& arrival) const;
    static glm::vec4 colorOf(const FixedState& state, const LitVertex& fragment,
                             const Texels& texels);
    /// What of these lights arrives at the point.
    FixedArrival findArrival(PointState& point, uint32_t lights,
                             glm::vec3 (&shares)[kFixedLights]) const;
    glm::vec4 reflected(PointState& point, const glm::vec4& color, float share) const;

    const Frame& frame_;
    std::optional<ThreadLoan<WayCache<Known>>> known_; ///< from the first hit on
    std::optional<FixedWay> way_;                      ///< of the triangle that was last new
    uint32_t path_[kMaxLevels];                        ///< of that
};

} // namespace smart

// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec4.hpp>

#include "libsmart/render/frame.h"
#include "libsmart/scene/hit_chain.h"
#include "libsmart/shading/fixed_triangle.h"

namespace smart {

struct PointState;

/// Shades hits by fixed function, and keeps what the hits of a triangle have in common from one
/// to the next. Belongs to one thread.
class FixedFunctionShader {
public:
    explicit FixedFunctionShader(const Frame& frame) : frame_(frame) {}

    /// RGBA of a point at a surface whose outermost instance has a state. Shadow rays and mirrored
    /// ones go through the point's function table.
    glm::vec4 shade(PointState& point);

private:
    /// A triangle in the window of a layer whose camera is the projection matrix: homogeneous,
    /// so that nothing has to be clipped. Olano, Greer: "Triangle Scan Conversion using 2D
    /// Homogeneous Coordinates", Graphics Hardware 1997.
    struct OnScreen {
        glm::dvec3 corners[3]; ///< x, y in pixels, each times w; w
        double doubleArea;     ///< its sign is the winding's: positive anticlockwise
        glm::dvec3 s, t, q;    ///< texture coordinates, as linear functions of (x, y, 1)
    };

    void useTriangle(const HitChain& chain, const FixedViewer& viewer);
    FixedViewer viewerOf(const RTSstate& state) const;
    bool showsBack(const RTSstate& state, bool fromCamera);
    /// How far the texture coordinates of the neighbouring pixels lie away, in texels.
    double texelsToNeighbours(const glm::dvec3& weights, bool back);
    /// The same by the ray's cone.
    double texelsInCone(const RTSstate& state, bool back);
    /// Shares of the lights that arrive at the point; false: all do.
    bool findVisibility(PointState& point, uint32_t lights,
                        glm::vec3 (&visibility)[kFixedLights]) const;
    glm::vec4 reflected(PointState& point, const glm::vec4& color, float share) const;

    const Frame& frame_;
    FixedTriangle triangle_;
    bool hasScreen_ = false, hasTexture_ = false; ///< of triangle_
    OnScreen screen_;
};

} // namespace smart

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "libsmart/kernel/packet.h"
#include "libsmart/render/frame.h"
#include "libsmart/scene/hit_chain.h"

namespace smart {

/// A triangle that a camera ray met, in eye space.
struct RasterTriangle {
    glm::dvec3 corners[3];
    glm::dvec3 normal; ///< (v1 - v0) x (v2 - v0), of any length

    RasterTriangle() = default;
    explicit RasterTriangle(const HitChain& chain)
        : corners{chain.worldVertex(0), chain.worldVertex(1), chain.worldVertex(2)},
          normal(chain.worldNormal()) {}
};

/// A triangle's corners on the screen, in units of 2^-20 pixels.
struct SnappedTriangle {
    int64_t x[3], y[3];
};

/// Where a pixel's sample lies with regard to a triangle on the screen.
enum class Coverage : uint8_t {
    Owned,    ///< inside, or on an edge that this triangle fills
    Boundary, ///< on an edge that the neighbour fills
    Outside
};

/// What OpenGL's rasterisation makes of triangles of one layer (OpenGL 1.5, section 3.5), for the
/// hits of camera rays. The frame has to live as long. Thread-safe.
class PolygonRaster {
public:
    explicit PolygonRaster(const Frame& layer);

    /// Whether the corners go round counterclockwise on the screen; with a camera shader: as seen
    /// from the ray.
    bool isCounterclockwise(const RasterTriangle& triangle, const Ray& ray) const;

    struct Depth {
        double window; ///< of the triangle's plane there
        double slope;  ///< its largest change for a pixel to the right or up
    };
    /// What depthAt needs of a triangle.
    struct Plane {
        double clip[4] = {};    ///< in clip coordinates
        double slope = 0.0;     ///< Depth::slope
        bool hasDepth = false;  ///< false: seen edge-on, or by a camera shader
    };
    Plane planeOf(const RasterTriangle& triangle) const;
    /// At a point of the picture, in pixels. Precondition: hasDepth; else what the ray says of the
    /// window depth holds, without a slope.
    Depth depthAt(const Plane& plane, const glm::dvec2& at) const;

    /// False where there is no such thing: behind the eye, or with a camera shader.
    bool snap(const RasterTriangle& triangle, SnappedTriangle& snapped) const;
    /// Of triangles that share an edge exactly one owns a point on it: filled are left edges, and
    /// horizontal ones at the bottom.
    static Coverage coverage(const SnappedTriangle& triangle, const glm::dvec2& at);

private:
    const Frame& layer_;
    // The triangle winds counterclockwise if dot(eye_, normal) + plane_ * dot(normal, corner) > 0.
    glm::dvec3 eye_{0.0};
    double plane_ = 0.0;
};

} // namespace smart

// SPDX-License-Identifier: MIT
// Vertices of points, lines and polygons' edges on their way to the window (OpenGL 1.5, sections
// 2.10 and 2.11).
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "libsmart/render/frame.h"
#include "libsmart/shading/fixed_function.h"

namespace smart {

struct ClipVertex {
    glm::dvec4 clip{0.0};
    glm::dvec3 eye{0.0};
    LitVertex lit;

    bool isFinite() const;
};

struct WindowVertex {
    glm::dvec2 at{0.0}; ///< in pixels from the picture's lower left corner
    double depth = 0.0; ///< in the window
    double inverseW = 1.0;
    LitVertex lit;
};

/// The vertex at a share of the way in the window: depth is linear there, the rest is
/// perspective-correct (equation 3.6).
WindowVertex between(const WindowVertex& a, const WindowVertex& b, double share);
/// The two values alone that a fragment needs of it.
double depthBetween(const WindowVertex& a, const WindowVertex& b, double share);
LitVertex litBetween(const WindowVertex& a, const WindowVertex& b, double share);

/// From clip coordinates to the window of one layer.
class WindowTransform {
public:
    WindowTransform(const Viewport& viewport, double depthNear, double depthFar);
    WindowVertex operator()(const ClipVertex& vertex) const;

private:
    glm::dvec2 center_, halfSize_;
    double nearDepth_, depthRange_;
};

/// A state's clip planes and the view volume. Precondition of all: vertices are finite.
class ClipVolume {
public:
    /// nullptr: no planes of the application's.
    explicit ClipVolume(const FixedState* state);

    bool contains(const ClipVertex& vertex) const;
    enum class Line : uint8_t { Gone, Whole, EndCut }; ///< Whole: but for its start
    Line clipLine(ClipVertex& a, ClipVertex& b) const;
    /// Clips by all but the volume's sides. drawn[i]: whether the edge that starts at vertex i is
    /// to be seen; edges that planes of the application's make are, those of the volume are not.
    void clipPolygon(std::vector<ClipVertex>& polygon, std::vector<bool>& drawn) const;

private:
    static constexpr int kFrustumPlanes = 6; ///< left, right, bottom, top, near, far
    static constexpr int kFirstDepthPlane = 4;
    double distance(int plane, const ClipVertex& vertex) const;
    ClipVertex meeting(int plane, const ClipVertex& a, const ClipVertex& b) const;

    int planes_ = kFrustumPlanes;
    glm::dvec4 userPlanes_[kFixedClipPlanes];
};

/// Cuts a line to what the rasteriser can take; false: nothing is left.
bool cutToWindow(WindowVertex& a, WindowVertex& b);

} // namespace smart

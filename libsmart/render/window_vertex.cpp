// SPDX-License-Identifier: MIT
#include "libsmart/render/window_vertex.h"

#include <algorithm>
#include <cmath>

#include "libsmart/render/line_raster.h"

namespace smart {
namespace {

ClipVertex between(const ClipVertex& a, const ClipVertex& b, double share) {
    return {a.clip + (b.clip - a.clip) * share, a.eye + (b.eye - a.eye) * share,
            interpolated(a.lit, b.lit, share)};
}

} // namespace

bool ClipVertex::isFinite() const {
    for (int k = 0; k < 4; ++k)
        if (!std::isfinite(clip[k])) return false;
    return true;
}

double depthBetween(const WindowVertex& a, const WindowVertex& b, double share) {
    return a.depth + (b.depth - a.depth) * share;
}

LitVertex litBetween(const WindowVertex& a, const WindowVertex& b, double share) {
    const double ofA = (1.0 - share) * a.inverseW, ofB = share * b.inverseW;
    return interpolated(a.lit, b.lit, ofB / (ofA + ofB));
}

WindowVertex between(const WindowVertex& a, const WindowVertex& b, double share) {
    return {a.at + (b.at - a.at) * share, depthBetween(a, b, share),
            a.inverseW + (b.inverseW - a.inverseW) * share, litBetween(a, b, share)};
}

WindowTransform::WindowTransform(const Viewport& viewport, double depthNear, double depthFar)
    : halfSize_(viewport.width / 2.0, viewport.height / 2.0),
      nearDepth_(depthNear),
      depthRange_(depthFar - depthNear) {
    center_ = glm::dvec2(viewport.x, viewport.y) + halfSize_;
}

WindowVertex WindowTransform::operator()(const ClipVertex& vertex) const {
    WindowVertex result;
    const glm::dvec4& clip = vertex.clip;
    result.inverseW = 1.0 / clip.w;
    result.at = center_ + halfSize_ * (glm::dvec2(clip) / clip.w);
    result.depth = nearDepth_ + depthRange_ * (clip.z / clip.w + 1.0) / 2.0;
    result.lit = vertex.lit;
    return result;
}

ClipVolume::ClipVolume(const FixedState* state) {
    if (!state) return;
    for (int i = 0; i < kFixedClipPlanes; ++i)
        if (state->raster.clip[i])
            userPlanes_[planes_++ - kFrustumPlanes] = state->raster.clipPlane[i];
}

double ClipVolume::distance(int plane, const ClipVertex& vertex) const {
    if (plane < kFrustumPlanes)
        return vertex.clip.w + (plane % 2 == 0 ? 1.0 : -1.0) * vertex.clip[plane / 2];
    const glm::dvec4& p = userPlanes_[plane - kFrustumPlanes];
    return p.x * vertex.eye.x + p.y * vertex.eye.y + p.z * vertex.eye.z + p.w;
}

bool ClipVolume::contains(const ClipVertex& vertex) const {
    for (int plane = 0; plane < planes_; ++plane)
        if (!(distance(plane, vertex) >= 0.0)) return false;
    return vertex.clip.w > 0.0;
}

// Where the line meets a plane that its ends lie on both sides of. Far ends leave no digit to the
// point itself: on the volume's planes it is put where it belongs.
ClipVertex ClipVolume::meeting(int plane, const ClipVertex& a, const ClipVertex& b) const {
    const double da = distance(plane, a), db = distance(plane, b);
    ClipVertex vertex = between(a, b, da / (da - db));
    if (plane < kFrustumPlanes)
        vertex.clip[plane / 2] = plane % 2 == 0 ? -vertex.clip.w : vertex.clip.w;
    return vertex;
}

ClipVolume::Line ClipVolume::clipLine(ClipVertex& a, ClipVertex& b) const {
    Line left = Line::Whole;
    for (int plane = 0; plane < planes_; ++plane) {
        const bool aInside = distance(plane, a) >= 0.0, bInside = distance(plane, b) >= 0.0;
        if (!aInside && !bInside) return Line::Gone;
        if (aInside && bInside) continue;
        (aInside ? b : a) = meeting(plane, a, b);
        if (aInside) left = Line::EndCut;
    }
    return a.clip.w > 0.0 && b.clip.w > 0.0 ? left : Line::Gone;
}

void ClipVolume::clipPolygon(std::vector<ClipVertex>& polygon, std::vector<bool>& drawn) const {
    std::vector<ClipVertex> kept;
    std::vector<bool> keptDrawn;
    for (int plane = kFirstDepthPlane; plane < planes_ && !polygon.empty(); ++plane) {
        kept.clear();
        keptDrawn.clear();
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const ClipVertex& a = polygon[i];
            const ClipVertex& b = polygon[(i + 1) % polygon.size()];
            const bool aInside = distance(plane, a) >= 0.0, bInside = distance(plane, b) >= 0.0;
            if (aInside) {
                kept.push_back(a);
                keptDrawn.push_back(drawn[i]);
            }
            if (aInside == bInside) continue;
            kept.push_back(meeting(plane, a, b));
            keptDrawn.push_back(aInside ? plane >= kFrustumPlanes : bool(drawn[i]));
        }
        polygon.swap(kept);
        drawn.swap(keptDrawn);
    }
    const auto behindEye = [](const ClipVertex& vertex) { return !(vertex.clip.w > 0.0); };
    if (std::any_of(polygon.begin(), polygon.end(), behindEye)) polygon.clear();
}

bool cutToWindow(WindowVertex& a, WindowVertex& b) {
    for (const WindowVertex* vertex : {&a, &b})
        if (!std::isfinite(vertex->at.x) || !std::isfinite(vertex->at.y)) return false;
    for (int side = 0; side < 4; ++side) {
        const int axis = side / 2;
        const double limit = side % 2 == 0 ? kWindowMin : kWindowMax;
        const auto isInside = [&](const WindowVertex& vertex) {
            return side % 2 == 0 ? vertex.at[axis] >= limit : vertex.at[axis] <= limit;
        };
        const bool aInside = isInside(a), bInside = isInside(b);
        if (!aInside && !bInside) return false;
        if (aInside && bInside) continue;
        WindowVertex cut = between(a, b, (limit - a.at[axis]) / (b.at[axis] - a.at[axis]));
        cut.at[axis] = limit;
        (aInside ? b : a) = cut;
    }
    return true;
}

} // namespace smart

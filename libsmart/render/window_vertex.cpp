// SPDX-License-Identifier: MIT
#include "libsmart/render/window_vertex.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

bool ClipVolume::clipLine(ClipVertex& a, ClipVertex& b) const {
    double start = 0.0, end = 1.0;
    for (int plane = 0; plane < planes_; ++plane) {
        const double da = distance(plane, a), db = distance(plane, b);
        if (!(da >= 0.0) && !(db >= 0.0)) return false;
        if (!(da >= 0.0))
            start = std::max(start, da / (da - db));
        else if (!(db >= 0.0))
            end = std::min(end, da / (da - db));
    }
    if (!(start < end) && (start > 0.0 || end < 1.0)) return false;
    const ClipVertex from = start > 0.0 ? between(a, b, start) : a;
    if (end < 1.0) b = between(a, b, end);
    a = from;
    return a.clip.w > 0.0 && b.clip.w > 0.0;
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
            const double da = distance(plane, a), db = distance(plane, b);
            const bool aInside = da >= 0.0, bInside = db >= 0.0;
            if (aInside) {
                kept.push_back(a);
                keptDrawn.push_back(drawn[i]);
            }
            if (aInside == bInside) continue;
            kept.push_back(between(a, b, da / (da - db)));
            keptDrawn.push_back(aInside ? plane >= kFrustumPlanes : bool(drawn[i]));
        }
        polygon.swap(kept);
        drawn.swap(keptDrawn);
    }
    const auto behindEye = [](const ClipVertex& vertex) { return !(vertex.clip.w > 0.0); };
    if (std::any_of(polygon.begin(), polygon.end(), behindEye)) polygon.clear();
}

bool cutToWindow(WindowVertex& a, WindowVertex& b) {
    double start = 0.0, end = 1.0;
    for (int axis = 0; axis < 2; ++axis) {
        const double from = a.at[axis], run = b.at[axis] - from;
        if (!std::isfinite(from) || !std::isfinite(run)) return false;
        if (run == 0.0) {
            if (from < kWindowMin || from > kWindowMax) return false;
            continue;
        }
        double enter = (kWindowMin - from) / run, leave = (kWindowMax - from) / run;
        if (enter > leave) std::swap(enter, leave);
        start = std::max(start, enter);
        end = std::min(end, leave);
    }
    if (!(start <= end)) return false;
    const WindowVertex first = start > 0.0 ? between(a, b, start) : a;
    if (end < 1.0) b = between(a, b, end);
    a = first;
    // Rounding may leave a cut end beyond the limit by a little.
    for (WindowVertex* vertex : {&a, &b})
        for (int axis = 0; axis < 2; ++axis)
            vertex->at[axis] = std::min(std::max(vertex->at[axis], kWindowMin), kWindowMax);
    return true;
}

} // namespace smart

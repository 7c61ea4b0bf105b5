// SPDX-License-Identifier: MIT
// Which of a ray's hits OpenGL draws where the pixel lies on an edge.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "libsmart/render/layer_pass.h"

namespace smart {
namespace {

bool isNear(float a, float b) {
    return std::fabs(a - b) <= 0x1p-16f * std::max(std::fabs(a), std::fabs(b));
}

bool sharesCorner(const SnappedTriangle& a, const SnappedTriangle& b) {
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (a.x[i] == b.x[j] && a.y[i] == b.y[j]) return true;
    return false;
}

bool isSame(const Hit& a, const Hit& b) {
    return a.triangle == b.triangle && a.levels == b.levels &&
           std::equal(a.path, a.path + a.levels, b.path, b.path + b.levels);
}

float leastWeight(const Hit& hit) {
    return std::min({hit.u, hit.v, 1.0f - hit.u - hit.v});
}

} // namespace

// A ray that meets an edge meets both triangles, but OpenGL draws the pixel once. One goes where
// another one that meets it at a corner, or along the edge, owns the place; or where the place lies
// on its own edge and that is not filled. But rounding may let a ray pass by the owner, and then
// the other one stands for it.
void LayerPass::keepOwned(std::span<LayerHit> hits, const glm::dvec2& at, bool complete) {
    constexpr float kNearEdge = 0x1p-12f;
    if (std::none_of(hits.begin(), hits.end(), [](const LayerHit& kept) {
            return kept.counts && leastWeight(kept.hit) < kNearEdge;
        }))
        return;
    struct OnScreen {
        LayerHit* kept;
        SnappedTriangle triangle;
        Coverage coverage;
    };
    std::vector<OnScreen> nearEdge;
    for (LayerHit& kept : hits) {
        OnScreen found{&kept, {}, Coverage::Owned};
        if (!kept.counts || leastWeight(kept.hit) >= kNearEdge) continue;
        if (!raster_.snap(surfaceOf(kept.hit).triangle, found.triangle)) continue;
        found.coverage = PolygonRaster::coverage(found.triangle, at);
        nearEdge.push_back(found);
    }
    std::optional<bool> missed;
    for (OnScreen& one : nearEdge) {
        if (one.coverage == Coverage::Owned) continue;
        const bool taken =
            std::any_of(nearEdge.begin(), nearEdge.end(), [&](const OnScreen& other) {
                return other.coverage == Coverage::Owned &&
                       isNear(one.kept->hit.t, other.kept->hit.t) &&
                       one.kept->hit.path[0] == other.kept->hit.path[0] &&
                       sharesCorner(one.triangle, other.triangle);
            });
        if (!taken && one.coverage != Coverage::Boundary) continue;
        if (!taken && complete) {
            if (!missed) missed = missesOwner(hits, at);
            if (*missed) {
                one.coverage = Coverage::Owned;
                continue;
            }
        }
        one.kept->counts = false;
    }
}

bool LayerPass::missesOwner(std::span<const LayerHit> hits, const glm::dvec2& at) {
    constexpr double kAside = 0x1p-5; // of a pixel: far more than rounding moves a ray
    double x[kPacketSize], y[kPacketSize];
    for (int i = 0; i < kPacketSize; ++i) {
        const double angle = (i + 0.5) * 2.0 * std::numbers::pi / kPacketSize;
        x[i] = at.x + kAside * std::cos(angle);
        y[i] = at.y + kAside * std::sin(angle);
    }
    LoneRayGroup around;
    around.rays.active = services_.makeCameraRays(camera_, x, y, (1u << kPacketSize) - 1, around);
    if (around.rays.active == 0) return false;
    services_.findAllHits(around.rays, pass_->around);
    const auto owns = [&](const Hit& hit) {
        const LayerSurface& surface = surfaceOf(hit);
        SnappedTriangle triangle;
        return surface.isShown && raster_.snap(surface.triangle, triangle) &&
               PolygonRaster::coverage(triangle, at) == Coverage::Owned;
    };
    for (uint32_t lane = 0; lane < kLanes; ++lane)
        for (const Hit& hit : pass_->around.of(lane))
            if (owns(hit) && std::none_of(hits.begin(), hits.end(), [&](const LayerHit& kept) {
                    return isSame(kept.hit, hit);
                }))
                return true;
    return false;
}

} // namespace smart

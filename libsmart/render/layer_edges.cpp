// SPDX-License-Identifier: MIT
// Which of a ray's hits OpenGL draws where the pixel lies on an edge.
#include <algorithm>
#include <cmath>
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

float leastWeight(const Hit& hit) {
    return std::min({hit.u, hit.v, 1.0f - hit.u - hit.v});
}
int edgesOf(const Hit& hit) {
    return (hit.u == 0.0f) + (hit.v == 0.0f) + (hit.u + hit.v >= 1.0f);
}

} // namespace

// A ray that meets an edge meets both triangles, but OpenGL draws the pixel once. One goes where
// another one that meets it at a corner, or along the edge, owns the place; or where it lies on its
// own edge exactly and that is not filled.
void LayerPass::keepOwned(std::span<LayerHit> hits, const glm::dvec2& at) {
    constexpr float kNearEdge = 0x1p-12f;
    if (std::none_of(hits.begin(), hits.end(), [](const LayerHit& kept) {
            return kept.counts && leastWeight(kept.hit) < kNearEdge;
        }))
        return;
    struct OnScreen {
        LayerHit* kept;
        SnappedTriangle triangle;
        Coverage coverage;
        int edges; ///< on which the place lies
    };
    std::vector<OnScreen> nearEdge;
    for (LayerHit& kept : hits) {
        OnScreen found{&kept, {}, Coverage::Owned, 0};
        if (!kept.counts || leastWeight(kept.hit) >= kNearEdge) continue;
        if (!raster_.snap(surfaceOf(kept.hit).triangle, found.triangle)) continue;
        found.coverage = PolygonRaster::coverage(found.triangle, at, found.edges);
        nearEdge.push_back(found);
    }
    for (const OnScreen& one : nearEdge) {
        if (one.coverage == Coverage::Owned) continue;
        const bool taken =
            std::any_of(nearEdge.begin(), nearEdge.end(), [&](const OnScreen& other) {
                return other.coverage == Coverage::Owned &&
                       isNear(one.kept->hit.t, other.kept->hit.t) &&
                       one.kept->hit.path[0] == other.kept->hit.path[0] &&
                       sharesCorner(one.triangle, other.triangle);
            });
        // On as many edges of the triangle as on the screen. Otherwise a corner was snapped to the
        // place, and its owner may be one that the ray passes by.
        const bool exact = one.edges > 0 && one.edges == edgesOf(one.kept->hit);
        if (taken || (one.coverage == Coverage::Boundary && exact))
            one.kept->counts = false;
    }
}

} // namespace smart

// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "compat/rtu/planar_arrangement.h"
#include "openrt/types.h"

namespace smart::compat {

/// The inside of an arrangement under one of GLU's winding rules. Vertices are those of the
/// arrangement.
class PolygonRegions {
public:
    PolygonRegions(const PlanarArrangement& arrangement, RTenum windingRule);

    /// Anticlockwise triangles that cover the inside once.
    std::vector<std::array<uint32_t, 3>> triangles() const;
    /// The boundary as closed loops, the inside on their left.
    std::vector<std::vector<uint32_t>> loops() const;
    /// Whether an edge belongs to the boundary.
    bool isBoundary(uint32_t a, uint32_t b) const;

private:
    /// From a to b, a left of b; the inside is above or below.
    struct Edge {
        uint32_t a, b;
        bool insideAbove;
    };
    struct HalfEdge {
        uint32_t from, to;
    };
    std::vector<HalfEdge> boundaryHalfEdges() const;
    std::vector<HalfEdge> diagonals() const;
    std::vector<std::vector<uint32_t>> faces(std::vector<HalfEdge> halfEdges) const;
    void triangulateMonotone(const std::vector<uint32_t>& face,
                             std::vector<std::array<uint32_t, 3>>& out) const;

    const std::vector<GridPoint>& points_;
    std::vector<Edge> boundary_; ///< sorted by the vertices' numbers
};

} // namespace smart::compat

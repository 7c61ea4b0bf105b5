// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace smart::compat {

/// A point of the grid on which polygons are cut up; |x|, |y| <= 2^28, so that the predicates are
/// exact in 64 bits.
struct GridPoint {
    int32_t x, y;
    auto operator<=>(const GridPoint&) const = default;
};

inline constexpr int kMaxGridBits = 28;

/// Twice the area of a, b, c; positive where they are anticlockwise.
inline int64_t orientation(GridPoint a, GridPoint b, GridPoint c) {
    return (int64_t(b.x) - a.x) * (int64_t(c.y) - a.y) -
           (int64_t(b.y) - a.y) * (int64_t(c.x) - a.x);
}

/// A vertex that stands where edges cross or vertices meet, from up to four others.
struct Combination {
    uint32_t vertex;
    uint32_t from[4]; ///< kNoVertex: fewer
    double weight[4];
};

inline constexpr uint32_t kNoVertex = 0xFFFFFFFF;

/// Closed contours as edges that meet at their ends only. Edges that cross are cut where they do,
/// rounded to the grid, until none cross any more: coordinates move by a few cells, topology is
/// exact thereafter.
class PlanarArrangement {
public:
    /// An edge with a < b; delta: how often contours go from a to b, less the ways back.
    struct Edge {
        uint32_t a, b;
        int32_t delta;
    };

    /// A new vertex, or the one that is there already: then a combination of both.
    uint32_t addVertex(GridPoint point);
    void addEdge(uint32_t from, uint32_t to);
    /// False where cutting does not come to an end; a coarser grid will do then.
    bool resolve();

    const std::vector<GridPoint>& points() const { return points_; }
    /// In the order in which they came to be: each from earlier vertices.
    const std::vector<Combination>& combinations() const { return combinations_; }
    const std::vector<Edge>& edges() const { return edges_; }

private:
    struct Cut {
        uint32_t edge, vertex;
    };
    /// `delta` times the way from one to the other.
    Edge oriented(uint32_t from, uint32_t to, int32_t delta) const;
    void mergeEdges();
    void findCuts(std::vector<Cut>& cuts);
    bool cutAtEnds(uint32_t e, uint32_t f, std::vector<Cut>& cuts) const;
    void cutAtCrossing(uint32_t e, uint32_t f, std::vector<Cut>& cuts);
    uint32_t crossing(const Edge& e, const Edge& f, double share);
    void apply(std::vector<Cut>& cuts);

    std::vector<GridPoint> points_;
    std::map<GridPoint, uint32_t> vertexAt_;
    std::vector<Combination> combinations_;
    std::vector<Edge> edges_;
};

} // namespace smart::compat

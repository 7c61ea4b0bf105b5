// SPDX-License-Identifier: MIT
#include "compat/rtu/polygon_regions.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <set>
#include <span>
#include <tuple>

#include "openrt/rtu_enums.h"

namespace smart::compat {

namespace {

bool isInside(RTenum rule, int32_t winding) {
    switch (rule) {
    case RTU_TESS_WINDING_NONZERO: return winding != 0;
    case RTU_TESS_WINDING_POSITIVE: return winding > 0;
    case RTU_TESS_WINDING_NEGATIVE: return winding < 0;
    case RTU_TESS_WINDING_ABS_GEQ_TWO: return std::abs(winding) >= 2;
    default: return winding % 2 != 0;
    }
}

/// Walks a vertical line over edges that meet at their ends only, from left to right (a point
/// before another where it is left of it or, in a column, below). `Entry` has members a and b.
template <class Entry>
class SweepLine {
public:
    SweepLine(const std::vector<GridPoint>& points, const std::vector<Entry>& edges)
        : points_(points), starts_(edges) {
        // Edges that start at a vertex lie together, from bottom to top.
        std::sort(starts_.begin(), starts_.end(), [&](const Entry& e, const Entry& f) {
            if (e.a != f.a) return points_[e.a] < points_[f.a];
            return orientation(points_[e.a], points_[e.b], points_[f.b]) > 0;
        });
        for (const Entry& edge : edges) {
            events_.push_back(edge.a);
            events_.push_back(edge.b);
        }
        std::sort(events_.begin(), events_.end(),
                  [&](uint32_t a, uint32_t b) { return points_[a] < points_[b]; });
        events_.erase(std::unique(events_.begin(), events_.end()), events_.end());
    }

    /// At each vertex: visit(vertex, below, ending, starting), where `below` is the edge under the
    /// vertex or nullptr, and `ending` and `starting` are the edges there from bottom to top.
    template <class Visit>
    void run(Visit&& visit) {
        std::multiset<uint32_t, IsBelow> active(IsBelow{*this}); // by their places in starts_
        std::vector<Entry> ending;
        uint32_t next = 0;
        for (const uint32_t vertex : events_) {
            const auto first = active.lower_bound(Vertex{vertex});
            auto last = first;
            ending.clear();
            for (; last != active.end() && starts_[*last].b == vertex; ++last)
                ending.push_back(starts_[*last]);
            uint32_t start = next;
            while (next < starts_.size() && starts_[next].a == vertex) ++next;
            const std::span<Entry> starting(starts_.data() + start, next - start);
            visit(vertex, first == active.begin() ? nullptr : &starts_[*std::prev(first)], ending,
                  starting);
            const auto place = active.erase(first, last);
            for (; start < next; ++start) active.insert(place, start);
        }
    }

private:
    struct Vertex {
        uint32_t index;
    };
    /// Of edges that the line meets at once, and of these and the vertex that it is at.
    struct IsBelow {
        using is_transparent = void;
        const SweepLine& line;

        bool operator()(uint32_t edge, Vertex vertex) const {
            const Entry& e = line.starts_[edge];
            return e.b != vertex.index && side(e, vertex.index) > 0;
        }
        bool operator()(uint32_t edge, uint32_t other) const {
            const Entry &e = line.starts_[edge], &f = line.starts_[other];
            if (e.a == f.a) return side(e, f.b) > 0;
            return line.points_[e.a] < line.points_[f.a] ? side(e, f.a) > 0 : side(f, e.a) < 0;
        }
        int64_t side(const Entry& e, uint32_t vertex) const {
            return orientation(line.points_[e.a], line.points_[e.b], line.points_[vertex]);
        }
    };

    const std::vector<GridPoint>& points_;
    std::vector<Entry> starts_;
    std::vector<uint32_t> events_;
};

struct WindingEdge {
    uint32_t a, b;
    int32_t delta;
    int32_t above = 0; ///< winding number above the edge
};

/// An edge of the boundary on the sweep line, and what is known of the inside above it.
struct MonotoneEdge {
    uint32_t a, b;
    bool insideAbove;
    uint32_t helper = 0;   ///< the last vertex that touched the inside between this and the next
    bool isMerge = false;  ///< two parts of the inside met there: it waits for a diagonal
};

/// Angles of directions, anticlockwise from the negative x axis exclusive.
bool lessByAngle(GridPoint centre, GridPoint p, GridPoint q) {
    const auto half = [&](GridPoint r) {
        return r.y > centre.y || (r.y == centre.y && r.x > centre.x) ? 1 : 0;
    };
    if (half(p) != half(q)) return half(p) < half(q);
    return orientation(centre, p, q) > 0;
}

} // namespace

PolygonRegions::PolygonRegions(const PlanarArrangement& arrangement, RTenum windingRule)
    : points_(arrangement.points()) {
    std::vector<WindingEdge> edges;
    edges.reserve(arrangement.edges().size());
    for (const auto& edge : arrangement.edges()) edges.push_back({edge.a, edge.b, edge.delta});
    SweepLine<WindingEdge>(points_, edges)
        .run([&](uint32_t, const WindingEdge* below, const auto&, auto& starting) {
            int32_t winding = below ? below->above : 0;
            for (WindingEdge& edge : starting) {
                const bool under = isInside(windingRule, winding);
                winding += edge.delta;
                edge.above = winding;
                const bool over = isInside(windingRule, winding);
                if (under != over) boundary_.push_back({edge.a, edge.b, over});
            }
        });
    std::sort(boundary_.begin(), boundary_.end(), [](const Edge& e, const Edge& f) {
        return std::tie(e.a, e.b) < std::tie(f.a, f.b);
    });
}

bool PolygonRegions::isBoundary(uint32_t a, uint32_t b) const {
    if (points_[b] < points_[a]) std::swap(a, b);
    return std::binary_search(boundary_.begin(), boundary_.end(), Edge{a, b, false},
                              [](const Edge& e, const Edge& f) {
                                  return std::tie(e.a, e.b) < std::tie(f.a, f.b);
                              });
}

std::vector<PolygonRegions::HalfEdge> PolygonRegions::boundaryHalfEdges() const {
    std::vector<HalfEdge> result;
    result.reserve(boundary_.size());
    for (const Edge& edge : boundary_)
        result.push_back(edge.insideAbove ? HalfEdge{edge.a, edge.b} : HalfEdge{edge.b, edge.a});
    return result;
}

/// The diagonals that cut the inside into pieces which every vertical line meets at most once:
/// Garey, Johnson, Preparata, Tarjan, Triangulating a simple polygon, 1978; as in de Berg et al.,
/// Computational Geometry, chapter 3, here with any number of edges at a vertex.
std::vector<PolygonRegions::HalfEdge> PolygonRegions::diagonals() const {
    std::vector<HalfEdge> result;
    std::vector<MonotoneEdge> edges;
    edges.reserve(boundary_.size());
    for (const Edge& edge : boundary_) edges.push_back({edge.a, edge.b, edge.insideAbove});
    const auto connect = [&](uint32_t a, uint32_t b) {
        result.push_back({a, b});
        result.push_back({b, a});
    };
    SweepLine<MonotoneEdge>(points_, edges)
        .run([&](uint32_t vertex, MonotoneEdge* below, const auto& ending, auto& starting) {
            const bool insideBelow = below && below->insideAbove;
            if (ending.empty()) {
                if (insideBelow) connect(vertex, below->helper);
            } else {
                if (insideBelow && below->isMerge) connect(vertex, below->helper);
                for (const MonotoneEdge& edge : ending)
                    if (edge.insideAbove && edge.isMerge) connect(vertex, edge.helper);
            }
            if (insideBelow) {
                below->helper = vertex;
                below->isMerge = starting.empty();
            }
            for (MonotoneEdge& edge : starting) {
                edge.helper = vertex;
                edge.isMerge = false;
            }
        });
    return result;
}

/// The closed walks with the inside on their left.
std::vector<std::vector<uint32_t>> PolygonRegions::faces(std::vector<HalfEdge> halfEdges) const {
    std::sort(halfEdges.begin(), halfEdges.end(), [&](const HalfEdge& e, const HalfEdge& f) {
        if (e.from != f.from) return e.from < f.from;
        return lessByAngle(points_[e.from], points_[e.to], points_[f.to]);
    });
    // The walk turns at each vertex to the next way out clockwise from where it came.
    const auto follow = [&](const HalfEdge& edge) {
        const auto [first, last] = std::equal_range(
            halfEdges.begin(), halfEdges.end(), HalfEdge{edge.to, 0},
            [](const HalfEdge& e, const HalfEdge& f) { return e.from < f.from; });
        const auto after = std::partition_point(first, last, [&](const HalfEdge& out) {
            return lessByAngle(points_[edge.to], points_[out.to], points_[edge.from]);
        });
        return std::size_t((after == first ? last : after) - 1 - halfEdges.begin());
    };
    std::vector<bool> used(halfEdges.size());
    std::vector<std::vector<uint32_t>> result;
    for (std::size_t start = 0; start < halfEdges.size(); ++start) {
        if (used[start]) continue;
        std::vector<uint32_t>& face = result.emplace_back();
        for (std::size_t at = start; !used[at]; at = follow(halfEdges[at])) {
            used[at] = true;
            face.push_back(halfEdges[at].from);
        }
    }
    return result;
}

std::vector<std::vector<uint32_t>> PolygonRegions::loops() const {
    return faces(boundaryHalfEdges());
}

std::vector<std::array<uint32_t, 3>> PolygonRegions::triangles() const {
    std::vector<HalfEdge> halfEdges = boundaryHalfEdges();
    const std::vector<HalfEdge> cuts = diagonals();
    halfEdges.insert(halfEdges.end(), cuts.begin(), cuts.end());
    std::vector<std::array<uint32_t, 3>> result;
    for (const std::vector<uint32_t>& face : faces(std::move(halfEdges)))
        triangulateMonotone(face, result);
    return result;
}

/// The stack of the same algorithm: vertices from left to right, each joined to those it sees.
void PolygonRegions::triangulateMonotone(const std::vector<uint32_t>& face,
                                         std::vector<std::array<uint32_t, 3>>& out) const {
    if (face.size() < 3) return;
    const auto isLeft = [&](uint32_t a, uint32_t b) { return points_[a] < points_[b]; };
    const auto emit = [&](uint32_t a, uint32_t b, uint32_t c, bool clockwise) {
        if (clockwise) std::swap(b, c);
        if (orientation(points_[a], points_[b], points_[c]) > 0) out.push_back({a, b, c});
    };
    // Anticlockwise, the lower chain leads from the leftmost vertex to the rightmost.
    const std::size_t count = face.size();
    const auto leftmost =
        std::size_t(std::min_element(face.begin(), face.end(), isLeft) - face.begin());
    struct ChainVertex {
        uint32_t vertex;
        bool lower;
    };
    std::vector<ChainVertex> order{{face[leftmost], true}};
    for (std::size_t up = leftmost + 1, down = leftmost + count - 1; order.size() < count;) {
        const uint32_t low = face[up % count], high = face[down % count];
        if (up < down && isLeft(low, high)) {
            order.push_back({low, true});
            ++up;
        } else {
            order.push_back({high, false});
            --down;
        }
    }
    std::vector<ChainVertex> stack{order[0], order[1]};
    for (std::size_t i = 2; i < count; ++i) {
        const ChainVertex next = order[i];
        const bool last = i + 1 == count;
        if (last || next.lower != stack.back().lower) {
            const ChainVertex top = stack.back();
            while (stack.size() > 1) {
                const ChainVertex inner = stack.back();
                stack.pop_back();
                // The chain runs on the other side of `next`.
                emit(stack.back().vertex, inner.vertex, next.vertex, !inner.lower);
            }
            stack = {top, next};
        } else {
            ChainVertex inner = stack.back();
            stack.pop_back();
            while (!stack.empty()) {
                const int64_t turn = orientation(points_[stack.back().vertex],
                                                 points_[inner.vertex], points_[next.vertex]);
                if (next.lower ? turn <= 0 : turn >= 0) break;
                emit(stack.back().vertex, inner.vertex, next.vertex, !next.lower);
                inner = stack.back();
                stack.pop_back();
            }
            stack.push_back(inner);
            stack.push_back(next);
        }
    }
}

} // namespace smart::compat

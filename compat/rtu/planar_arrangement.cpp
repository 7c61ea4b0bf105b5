// SPDX-License-Identifier: MIT
#include "compat/rtu/planar_arrangement.h"

#include <algorithm>
#include <cmath>

#include "compat/rtu/box_pairs.h"

namespace smart::compat {

namespace {

double distance(GridPoint a, GridPoint b) {
    return std::fabs(double(a.x) - b.x) + std::fabs(double(a.y) - b.y);
}

bool differInSign(int64_t a, int64_t b) { return (a < 0 && b > 0) || (a > 0 && b < 0); }

} // namespace

uint32_t PlanarArrangement::addVertex(GridPoint point) {
    const uint32_t index = uint32_t(points_.size());
    points_.push_back(point);
    const auto [place, isNew] = vertexAt_.emplace(point, index);
    if (isNew) return index;
    // The point keeps its first vertex; both contribute to its data.
    combinations_.push_back(
        {place->second, {place->second, index, kNoVertex, kNoVertex}, {0.5, 0.5, 0, 0}});
    return place->second;
}

void PlanarArrangement::addEdge(uint32_t from, uint32_t to) {
    if (from != to) edges_.push_back(oriented(from, to, 1));
}

PlanarArrangement::Edge PlanarArrangement::oriented(uint32_t from, uint32_t to,
                                                    int32_t delta) const {
    return points_[from] < points_[to] ? Edge{from, to, delta} : Edge{to, from, -delta};
}

bool PlanarArrangement::resolve() {
    constexpr int kMaxRounds = 40; // two or three are usual
    for (int round = 0; round < kMaxRounds; ++round) {
        mergeEdges();
        std::vector<Cut> cuts;
        findCuts(cuts);
        if (cuts.empty()) return true;
        apply(cuts);
    }
    return false;
}

/// Edges between the same vertices become one; those that cancel out go.
void PlanarArrangement::mergeEdges() {
    std::sort(edges_.begin(), edges_.end(), [&](const Edge& e, const Edge& f) {
        return std::pair(points_[e.a], points_[e.b]) < std::pair(points_[f.a], points_[f.b]);
    });
    std::size_t kept = 0;
    for (const Edge& edge : edges_) {
        if (kept > 0 && edges_[kept - 1].a == edge.a && edges_[kept - 1].b == edge.b) {
            edges_[kept - 1].delta += edge.delta;
        } else {
            if (kept > 0 && edges_[kept - 1].delta == 0) --kept;
            edges_[kept++] = edge;
        }
    }
    if (kept > 0 && edges_[kept - 1].delta == 0) --kept;
    edges_.resize(kept);
}

void PlanarArrangement::findCuts(std::vector<Cut>& cuts) {
    std::vector<GridBox> boxes; // edges are in the order of their left ends
    boxes.reserve(edges_.size());
    for (const Edge& edge : edges_) {
        const GridPoint a = points_[edge.a], b = points_[edge.b];
        boxes.push_back({{a.x, std::min(a.y, b.y)}, {b.x, std::max(a.y, b.y)}});
    }
    std::vector<std::pair<uint32_t, uint32_t>> crossings;
    BoxPairs(boxes, [&](uint32_t e, uint32_t f) {
        if (boxes[e].high[1] < boxes[f].low[1] || boxes[f].high[1] < boxes[e].low[1]) return;
        if (cutAtEnds(e, f, cuts)) crossings.emplace_back(e, f);
    });
    // New vertices come in an order that does not depend on how the pairs were found.
    std::sort(crossings.begin(), crossings.end());
    crossings.erase(std::unique(crossings.begin(), crossings.end()), crossings.end());
    for (const auto& [e, f] : crossings) cutAtCrossing(e, f, cuts);
}

/// Where an end of one is inside the other; true where they cross instead.
bool PlanarArrangement::cutAtEnds(uint32_t e, uint32_t f, std::vector<Cut>& cuts) const {
    const Edge edgeE = edges_[e], edgeF = edges_[f];
    const GridPoint ea = points_[edgeE.a], eb = points_[edgeE.b];
    const GridPoint fa = points_[edgeF.a], fb = points_[edgeF.b];
    const int64_t faSide = orientation(ea, eb, fa), fbSide = orientation(ea, eb, fb);
    const int64_t eaSide = orientation(fa, fb, ea), ebSide = orientation(fa, fb, eb);
    if (faSide == 0 && ea < fa && fa < eb) cuts.push_back({e, edgeF.a});
    if (fbSide == 0 && ea < fb && fb < eb) cuts.push_back({e, edgeF.b});
    if (eaSide == 0 && fa < ea && ea < fb) cuts.push_back({f, edgeE.a});
    if (ebSide == 0 && fa < eb && eb < fb) cuts.push_back({f, edgeE.b});
    return differInSign(faSide, fbSide) && differInSign(eaSide, ebSide);
}

void PlanarArrangement::cutAtCrossing(uint32_t e, uint32_t f, std::vector<Cut>& cuts) {
    const Edge edgeE = edges_[e], edgeF = edges_[f];
    const GridPoint fa = points_[edgeF.a], fb = points_[edgeF.b];
    const double eaSide = double(orientation(fa, fb, points_[edgeE.a]));
    const double ebSide = double(orientation(fa, fb, points_[edgeE.b]));
    const uint32_t vertex = crossing(edgeE, edgeF, eaSide / (eaSide - ebSide));
    if (vertex != edgeE.a && vertex != edgeE.b) cuts.push_back({e, vertex});
    if (vertex != edgeF.a && vertex != edgeF.b) cuts.push_back({f, vertex});
}

/// The vertex where two edges cross, at `share` of e; weighted by distances as GLU has it.
uint32_t PlanarArrangement::crossing(const Edge& e, const Edge& f, double share) {
    const GridPoint ea = points_[e.a], eb = points_[e.b];
    const GridPoint point{int32_t(std::lround(ea.x + share * (double(eb.x) - ea.x))),
                          int32_t(std::lround(ea.y + share * (double(eb.y) - ea.y)))};
    const auto known = vertexAt_.find(point);
    if (known != vertexAt_.end()) return known->second;

    const uint32_t vertex = uint32_t(points_.size());
    Combination combination{vertex, {e.a, e.b, f.a, f.b}, {}};
    for (int pair = 0; pair < 4; pair += 2) {
        const double near = distance(point, points_[combination.from[pair]]);
        const double far = distance(point, points_[combination.from[pair + 1]]);
        combination.weight[pair] = 0.5 * far / (near + far);
        combination.weight[pair + 1] = 0.5 * near / (near + far);
    }
    combinations_.push_back(combination);
    points_.push_back(point);
    vertexAt_.emplace(point, vertex);
    return vertex;
}

void PlanarArrangement::apply(std::vector<Cut>& cuts) {
    // By edge, then along it: an edge's points are in the order of their places.
    std::sort(cuts.begin(), cuts.end(), [&](const Cut& c, const Cut& d) {
        if (c.edge != d.edge) return c.edge < d.edge;
        const GridPoint a = points_[edges_[c.edge].a], b = points_[edges_[c.edge].b];
        const auto along = [&](uint32_t vertex) {
            return (int64_t(b.x) - a.x) * (int64_t(points_[vertex].x) - a.x) +
                   (int64_t(b.y) - a.y) * (int64_t(points_[vertex].y) - a.y);
        };
        const int64_t alongC = along(c.vertex), alongD = along(d.vertex);
        return alongC != alongD ? alongC < alongD : points_[c.vertex] < points_[d.vertex];
    });
    const std::size_t edgeCount = edges_.size();
    std::vector<Edge> pieces;
    pieces.reserve(edgeCount + cuts.size());
    std::size_t next = 0;
    for (uint32_t e = 0; e < edgeCount; ++e) {
        uint32_t from = edges_[e].a;
        const auto addPiece = [&](uint32_t to) {
            if (from != to) pieces.push_back(oriented(from, to, edges_[e].delta));
            from = to;
        };
        for (; next < cuts.size() && cuts[next].edge == e; ++next) addPiece(cuts[next].vertex);
        addPiece(edges_[e].b);
    }
    edges_ = std::move(pieces);
}

} // namespace smart::compat

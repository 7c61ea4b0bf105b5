// SPDX-License-Identifier: MIT
#include "compat/rtu/tessellator.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "compat/rtu/planar_arrangement.h"
#include "compat/rtu/polygon_regions.h"
#include "openrt/enums.h"

namespace smart::compat {

namespace {

using Vec = std::array<double, 3>;

Vec cross(const Vec& a, const Vec& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vec minus(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double largest(const Vec& v) {
    return std::max({std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2])});
}

struct Box {
    Vec low, high;
    explicit Box(const std::vector<TessVertex>& vertices)
        : low(vertices.front().location), high(low) {
        for (const TessVertex& vertex : vertices)
            for (std::size_t k = 0; k < 3; ++k) {
                low[k] = std::min(low[k], vertex.location[k]);
                high[k] = std::max(high[k], vertex.location[k]);
            }
    }
    double size() const { return largest(minus(high, low)); }
};

/// Calls visit(vertex, the one after it on its contour) for all.
template <class Visit>
void forEachSide(const TessPolygon& polygon, Visit&& visit) {
    std::size_t first = 0;
    for (const std::size_t end : polygon.contourEnds) {
        for (std::size_t i = first; i < end; ++i) visit(i, i + 1 < end ? i + 1 : first);
        first = end;
    }
}

/// The sum of the contours' areas as vectors (Newell), in units of the polygon's size.
Vec areaVector(const TessPolygon& polygon, const Box& box) {
    Vec sum{};
    const double unit = 1 / box.size();
    const auto relative = [&](std::size_t i) {
        Vec v = minus(polygon.vertices[i].location, box.low);
        for (double& x : v) x *= unit;
        return v;
    };
    forEachSide(polygon, [&](std::size_t i, std::size_t next) {
        const Vec part = cross(relative(i), relative(next));
        for (std::size_t k = 0; k < 3; ++k) sum[k] += part[k];
    });
    return sum;
}

/// The normal of a polygon whose areas cancel out: of the largest triangle over its longest side.
Vec spanningNormal(const TessPolygon& polygon, const Box& box) {
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k)
        if (box.high[k] - box.low[k] > box.high[axis] - box.low[axis]) axis = k;
    const auto [low, high] = std::minmax_element(
        polygon.vertices.begin(), polygon.vertices.end(),
        [&](const auto& v, const auto& w) { return v.location[axis] < w.location[axis]; });
    const double unit = 1 / box.size();
    Vec base = minus(high->location, low->location), normal{};
    for (double& x : base) x *= unit;
    for (const TessVertex& vertex : polygon.vertices) {
        Vec side = minus(vertex.location, low->location);
        for (double& x : side) x *= unit;
        const Vec candidate = cross(base, side);
        if (largest(candidate) > largest(normal)) normal = candidate;
    }
    return normal;
}

/// The polygon seen along the axis that its normal is nearest to.
std::vector<std::array<double, 2>> project(const TessPolygon& polygon, const Vec& normal) {
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k)
        if (std::fabs(normal[k]) > std::fabs(normal[axis])) axis = k;
    const double sign = normal[axis] > 0 ? 1 : -1;
    std::vector<std::array<double, 2>> flat;
    flat.reserve(polygon.vertices.size());
    for (const TessVertex& vertex : polygon.vertices)
        flat.push_back({vertex.location[(axis + 1) % 3], sign * vertex.location[(axis + 2) % 3]});
    return flat;
}

/// Rounds to a grid of `bits` bits to each side of the polygon's middle.
std::vector<GridPoint> toGrid(const std::vector<std::array<double, 2>>& flat, double bits,
                              bool& isFlat) {
    std::array<double, 2> low = flat[0], high = flat[0];
    for (const auto& point : flat)
        for (std::size_t k = 0; k < 2; ++k) {
            low[k] = std::min(low[k], point[k]);
            high[k] = std::max(high[k], point[k]);
        }
    const double half = std::max(high[0] / 2 - low[0] / 2, high[1] / 2 - low[1] / 2);
    isFlat = !(half > 0);
    const double scale = std::exp2(bits);
    std::vector<GridPoint> grid;
    grid.reserve(flat.size());
    for (const auto& point : flat) {
        int32_t place[2] = {};
        for (std::size_t k = 0; k < 2 && !isFlat; ++k)
            place[k] = int32_t(std::lround((point[k] - (low[k] / 2 + high[k] / 2)) / half * scale));
        grid.push_back({place[0], place[1]});
    }
    return grid;
}

/// +1 or -1: a convex contour that goes round once, anticlockwise or clockwise; 0: another.
int convexTurn(const std::vector<GridPoint>& grid) {
    const std::size_t n = grid.size();
    int turn = 0, changesOfX = 0;
    bool wasRight = false, any = false;
    for (std::size_t i = 0; i < n; ++i) {
        const GridPoint a = grid[i], b = grid[(i + 1) % n], c = grid[(i + 2) % n];
        if (a == b) return 0;
        const int64_t area = orientation(a, b, c);
        if (area == 0) return 0;
        const int sign = area > 0 ? 1 : -1;
        if (turn != 0 && sign != turn) return 0;
        turn = sign;
    }
    for (std::size_t i = 0; i <= n; ++i) {
        const bool right = grid[i % n] < grid[(i + 1) % n];
        changesOfX += any && right != wasRight;
        wasRight = right;
        any = true;
    }
    return changesOfX == 2 ? turn : 0;
}

bool drawsWinding(RTenum rule, int winding) {
    switch (rule) {
    case RTU_TESS_WINDING_POSITIVE: return winding > 0;
    case RTU_TESS_WINDING_NEGATIVE: return winding < 0;
    case RTU_TESS_WINDING_ABS_GEQ_TWO: return false;
    default: return true;
    }
}

class Tessellation {
public:
    Tessellation(TessPolygon polygon, const TessSettings& settings, const TessCallbacks& callbacks)
        : polygon_(std::move(polygon)), settings_(settings), call_(callbacks) {}

    RTenum run() {
        if (polygon_.vertices.size() < 3) return 0;
        const Box box(polygon_.vertices);
        if (!(box.size() > 0)) return 0;
        Vec normal = settings_.normal;
        const bool found = largest(normal) == 0;
        if (found) {
            normal = areaVector(polygon_, box);
            if (!(largest(normal) > 1e-9)) normal = spanningNormal(polygon_, box);
        }
        if (!(largest(normal) > 0)) return 0;
        flat_ = project(polygon_, normal);
        if (drawConvex()) return 0;
        // A coarser grid has fewer crossings that rounding moves onto other edges.
        double bits = kMaxGridBits;
        if (settings_.tolerance > 0)
            bits = std::clamp(-1 - std::log2(settings_.tolerance), 1.0, bits);
        for (; bits >= 1; bits -= 6) {
            bool isFlat = false;
            PlanarArrangement arrangement;
            if (!arrange(toGrid(flat_, bits, isFlat), arrangement)) continue;
            return isFlat ? 0 : finish(arrangement);
        }
        return RTU_OUT_OF_MEMORY;
    }

private:
    bool arrange(const std::vector<GridPoint>& grid, PlanarArrangement& arrangement) {
        std::vector<uint32_t> vertexOf;
        vertexOf.reserve(grid.size());
        for (const GridPoint point : grid) vertexOf.push_back(arrangement.addVertex(point));
        forEachSide(polygon_, [&](std::size_t i, std::size_t next) {
            arrangement.addEdge(vertexOf[i], vertexOf[next]);
        });
        return arrangement.resolve();
    }

    /// GLU draws a convex contour as a fan from its first vertex.
    bool drawConvex() {
        if (polygon_.contourEnds.size() != 1 || call_.wantsEdgeFlags() || settings_.tolerance > 0 ||
            polygon_.vertices.size() > 100)
            return false;
        bool isFlat = false;
        const int turn = convexTurn(toGrid(flat_, kMaxGridBits, isFlat));
        if (turn == 0 || isFlat) return false;
        if (!drawsWinding(settings_.windingRule, turn)) return true;
        const std::size_t n = polygon_.vertices.size();
        call_.callBegin(settings_.boundaryOnly ? RT_LINE_LOOP
                                               : n > 3 ? RT_TRIANGLE_FAN : RT_TRIANGLES,
                        polygon_.data);
        for (std::size_t i = 0; i < n; ++i)
            call_.callVertex(polygon_.vertices[turn > 0 ? i : (n - i) % n].data, polygon_.data);
        call_.callEnd(polygon_.data);
        return true;
    }

    RTenum finish(const PlanarArrangement& arrangement) {
        const PolygonRegions regions(arrangement, settings_.windingRule);
        const auto triangles = settings_.boundaryOnly ? std::vector<std::array<uint32_t, 3>>()
                                                      : regions.triangles();
        const auto loops =
            settings_.boundaryOnly ? regions.loops() : std::vector<std::vector<uint32_t>>();
        if (const RTenum error = combine(arrangement)) return error;
        if (!triangles.empty()) drawTriangles(triangles, regions);
        for (const std::vector<uint32_t>& loop : loops) {
            call_.callBegin(RT_LINE_LOOP, polygon_.data);
            for (const uint32_t vertex : loop)
                call_.callVertex(polygon_.vertices[vertex].data, polygon_.data);
            call_.callEnd(polygon_.data);
        }
        return 0;
    }

    /// Gives the vertices that the polygon lacked their data.
    RTenum combine(const PlanarArrangement& arrangement) {
        std::vector<TessVertex>& vertices = polygon_.vertices;
        const std::size_t given = vertices.size();
        vertices.resize(arrangement.points().size(), {{}, nullptr});
        for (const Combination& combination : arrangement.combinations()) {
            const bool isNew = combination.vertex >= given;
            if (!call_.canCombine()) {
                if (isNew) return RTU_TESS_NEED_COMBINE_CALLBACK;
                continue;
            }
            Vec location{};
            void* from[4] = {};
            float weights[4] = {};
            bool differ = isNew;
            for (int k = 0; k < 4 && combination.from[k] != kNoVertex; ++k) {
                const TessVertex& source = vertices[combination.from[k]];
                for (std::size_t axis = 0; axis < 3; ++axis)
                    location[axis] += combination.weight[k] * source.location[axis];
                from[k] = source.data;
                weights[k] = float(combination.weight[k]);
                differ = differ || from[k] != from[0];
            }
            if (!differ) continue;
            void* data = nullptr;
            Vec passed = location;
            call_.callCombine(passed.data(), from, weights, &data, polygon_.data);
            if (!data && isNew) return RTU_TESS_NEED_COMBINE_CALLBACK;
            vertices[combination.vertex] = {location, data ? data : from[0]};
        }
        return 0;
    }

    void drawTriangles(const std::vector<std::array<uint32_t, 3>>& triangles,
                       const PolygonRegions& regions) const {
        int flag = -1; // the current edge flag; unknown
        call_.callBegin(RT_TRIANGLES, polygon_.data);
        for (const auto& triangle : triangles)
            for (std::size_t k = 0; k < 3; ++k) {
                if (call_.wantsEdgeFlags()) {
                    const bool boundary =
                        regions.isBoundary(triangle[k], triangle[(k + 1) % 3]);
                    if (flag != int(boundary)) call_.callEdgeFlag(boundary, polygon_.data);
                    flag = boundary;
                }
                call_.callVertex(polygon_.vertices[triangle[k]].data, polygon_.data);
            }
        call_.callEnd(polygon_.data);
    }

    TessPolygon polygon_;
    const TessSettings settings_;
    const TessCallbacks call_;
    std::vector<std::array<double, 2>> flat_;
};

} // namespace

void TessCallbacks::callBegin(RTenum mode, void* data) const {
    if (beginData)
        beginData(mode, data);
    else if (begin)
        begin(mode);
}
void TessCallbacks::callEdgeFlag(bool flag, void* data) const {
    if (edgeFlagData)
        edgeFlagData(flag, data);
    else if (edgeFlag)
        edgeFlag(flag);
}
void TessCallbacks::callVertex(void* of, void* data) const {
    if (vertexData)
        vertexData(of, data);
    else if (vertex)
        vertex(of);
}
void TessCallbacks::callEnd(void* data) const {
    if (endData)
        endData(data);
    else if (end)
        end();
}
void TessCallbacks::callCombine(double* location, void** from, float* weights, void** out,
                                void* data) const {
    if (combineData)
        combineData(location, from, weights, out, data);
    else
        combine(location, from, weights, out);
}
void TessCallbacks::callError(RTenum number, void* data) const {
    if (errorData)
        errorData(number, data);
    else if (error)
        error(number);
}

RTenum tessellate(TessPolygon polygon, const TessSettings& settings,
                  const TessCallbacks& callbacks) {
    return Tessellation(std::move(polygon), settings, callbacks).run();
}

} // namespace smart::compat

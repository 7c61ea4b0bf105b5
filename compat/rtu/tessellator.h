// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "openrt/rtu.h"

namespace smart::compat {

struct TessVertex {
    std::array<double, 3> location;
    void* data;
};

/// A polygon as it was given: vertices, and where each contour ends.
struct TessPolygon {
    std::vector<TessVertex> vertices;
    std::vector<std::size_t> contourEnds;
    void* data = nullptr;
};

/// The application's functions; of each pair the one with the polygon's data has precedence.
struct TessCallbacks {
    void(RTAPIENTRY* begin)(RTenum) = nullptr;
    void(RTAPIENTRY* beginData)(RTenum, void*) = nullptr;
    void(RTAPIENTRY* edgeFlag)(RTboolean) = nullptr;
    void(RTAPIENTRY* edgeFlagData)(RTboolean, void*) = nullptr;
    void(RTAPIENTRY* vertex)(void*) = nullptr;
    void(RTAPIENTRY* vertexData)(void*, void*) = nullptr;
    void(RTAPIENTRY* end)(void) = nullptr;
    void(RTAPIENTRY* endData)(void*) = nullptr;
    void(RTAPIENTRY* combine)(RTdouble*, void**, RTfloat*, void**) = nullptr;
    void(RTAPIENTRY* combineData)(RTdouble*, void**, RTfloat*, void**, void*) = nullptr;
    void(RTAPIENTRY* error)(RTenum) = nullptr;
    void(RTAPIENTRY* errorData)(RTenum, void*) = nullptr;

    bool wantsEdgeFlags() const { return edgeFlag || edgeFlagData; }
    bool canCombine() const { return combine || combineData; }
    void callBegin(RTenum mode, void* data) const;
    void callEdgeFlag(bool flag, void* data) const;
    void callVertex(void* vertexData, void* data) const;
    void callEnd(void* data) const;
    void callCombine(double* location, void** from, float* weights, void** out, void* data) const;
    void callError(RTenum number, void* data) const;
};

struct TessSettings {
    RTenum windingRule = RTU_TESS_WINDING_ODD;
    bool boundaryOnly = false;
    double tolerance = 0;
    std::array<double, 3> normal{}; ///< all zero: to be found
};

/// Cuts a polygon up and hands the pieces to the callbacks. Returns 0, or the RTU_ number of an
/// error: then no piece was handed on.
RTenum tessellate(TessPolygon polygon, const TessSettings& settings,
                  const TessCallbacks& callbacks);

} // namespace smart::compat

// SPDX-License-Identifier: MIT
// The calls of tessellation: a state machine that collects a polygon.
#include <cmath>
#include <new>
#include <utility>

#include "compat/openrt/guard.h"
#include "compat/rtu/report.h"
#include "compat/rtu/tessellator.h"

using namespace smart;
using namespace smart::compat;

struct RTUtesselator {
    enum State { Dormant, InPolygon, InContour };

    TessSettings settings;
    TessCallbacks callbacks;
    State state = Dormant;
    TessPolygon polygon;

    void fail(RTenum number, const char* function) {
        const char* const text = reinterpret_cast<const char*>(rtuErrorString(number));
        const ErrorCode code = number == RTU_INVALID_ENUM    ? ErrorCode::InvalidEnum
                               : number == RTU_INVALID_VALUE ? ErrorCode::InvalidValue
                               : number == RTU_OUT_OF_MEMORY ? ErrorCode::OutOfMemory
                                                             : ErrorCode::InvalidOperation;
        recordError(code, function, text);
        callbacks.callError(number, polygon.data);
    }

    void beginPolygon(void* data) {
        polygon = TessPolygon();
        polygon.data = data;
        state = InPolygon;
    }
    void endContour() {
        const std::size_t first = polygon.contourEnds.empty() ? 0 : polygon.contourEnds.back();
        if (polygon.vertices.size() > first)
            polygon.contourEnds.push_back(polygon.vertices.size());
        state = InPolygon;
    }

    /// Reports and makes up for the calls that are missing on the way to a state.
    void require(State wanted, const char* function) {
        while (state < wanted) {
            const bool dormant = state == Dormant;
            fail(dormant ? RTU_TESS_MISSING_BEGIN_POLYGON : RTU_TESS_MISSING_BEGIN_CONTOUR,
                 function);
            if (dormant) beginPolygon(nullptr);
            else state = InContour;
        }
        while (state > wanted) {
            const bool contour = state == InContour;
            fail(contour ? RTU_TESS_MISSING_END_CONTOUR : RTU_TESS_MISSING_END_POLYGON, function);
            if (contour) endContour();
            else state = Dormant;
        }
    }
};

namespace {

/// The only things that can go wrong in body are that memory runs out and that a callback throws.
template <class Body>
void withTess(RTUtesselator* tess, const char* function, Body&& body) noexcept {
    if (isMissing(tess, function, "the tessellator is NULL")) return;
    try {
        body(*tess);
    } catch (const std::bad_alloc&) {
        try {
            tess->fail(RTU_OUT_OF_MEMORY, function);
        } catch (...) {
            report(function);
        }
    } catch (...) {
        report(function);
    }
}

/// Not a number counts as 0.
double clamped(double coordinate, bool& tooLarge) {
    if (std::isnan(coordinate)) return 0;
    if (std::fabs(coordinate) <= RTU_TESS_MAX_COORD) return coordinate;
    tooLarge = true;
    return std::copysign(RTU_TESS_MAX_COORD, coordinate);
}

} // namespace

RTAPI RTUtesselator* RTAPIENTRY rtuNewTess(void) {
    RTUtesselator* const tess = new (std::nothrow) RTUtesselator;
    if (!tess) recordError(ErrorCode::OutOfMemory, __func__, "out of memory");
    return tess;
}

RTAPI void RTAPIENTRY rtuDeleteTess(RTUtesselator* tess) {
    if (!tess) return;
    withTess(tess, __func__,
             [](RTUtesselator& t) { t.require(RTUtesselator::Dormant, "rtuDeleteTess"); });
    delete tess;
}

RTAPI void RTAPIENTRY rtuTessCallback(RTUtesselator* tess, RTenum which, RTUfuncptr cb) {
    withTess(tess, __func__, [&](RTUtesselator& t) {
        TessCallbacks& c = t.callbacks;
        const auto set = [&]<class Function>(Function*& place) {
            place = reinterpret_cast<Function*>(cb);
        };
        switch (which) {
        case RTU_TESS_BEGIN: return set(c.begin);
        case RTU_TESS_BEGIN_DATA: return set(c.beginData);
        case RTU_TESS_EDGE_FLAG: return set(c.edgeFlag);
        case RTU_TESS_EDGE_FLAG_DATA: return set(c.edgeFlagData);
        case RTU_TESS_VERTEX: return set(c.vertex);
        case RTU_TESS_VERTEX_DATA: return set(c.vertexData);
        case RTU_TESS_END: return set(c.end);
        case RTU_TESS_END_DATA: return set(c.endData);
        case RTU_TESS_COMBINE: return set(c.combine);
        case RTU_TESS_COMBINE_DATA: return set(c.combineData);
        case RTU_TESS_ERROR: return set(c.error);
        case RTU_TESS_ERROR_DATA: return set(c.errorData);
        default: return t.fail(RTU_INVALID_ENUM, "rtuTessCallback");
        }
    });
}

RTAPI void RTAPIENTRY rtuTessProperty(RTUtesselator* tess, RTenum which, RTdouble data) {
    withTess(tess, __func__, [&](RTUtesselator& t) {
        const char* const function = "rtuTessProperty";
        switch (which) {
        case RTU_TESS_WINDING_RULE:
            if (!(data >= RTU_TESS_WINDING_ODD && data <= RTU_TESS_WINDING_ABS_GEQ_TWO) ||
                data != std::floor(data))
                return t.fail(RTU_INVALID_VALUE, function);
            t.settings.windingRule = RTenum(data);
            return;
        case RTU_TESS_BOUNDARY_ONLY: t.settings.boundaryOnly = data != 0; return;
        case RTU_TESS_TOLERANCE:
            if (!(data >= 0 && data <= 1)) return t.fail(RTU_INVALID_VALUE, function);
            t.settings.tolerance = data;
            return;
        default: return t.fail(RTU_INVALID_ENUM, function);
        }
    });
}

RTAPI void RTAPIENTRY rtuGetTessProperty(RTUtesselator* tess, RTenum which, RTdouble* data) {
    if (isMissing(data, __func__, "data is NULL")) return;
    withTess(tess, __func__, [&](RTUtesselator& t) {
        switch (which) {
        case RTU_TESS_WINDING_RULE: *data = t.settings.windingRule; return;
        case RTU_TESS_BOUNDARY_ONLY: *data = t.settings.boundaryOnly; return;
        case RTU_TESS_TOLERANCE: *data = t.settings.tolerance; return;
        default:
            *data = 0;
            return t.fail(RTU_INVALID_ENUM, "rtuGetTessProperty");
        }
    });
}

RTAPI void RTAPIENTRY rtuTessNormal(RTUtesselator* tess, RTdouble valueX, RTdouble valueY,
                                    RTdouble valueZ) {
    withTess(tess, __func__, [&](RTUtesselator& t) {
        if (!std::isfinite(valueX) || !std::isfinite(valueY) || !std::isfinite(valueZ))
            return t.fail(RTU_INVALID_VALUE, "rtuTessNormal");
        t.settings.normal = {valueX, valueY, valueZ};
    });
}

RTAPI void RTAPIENTRY rtuTessBeginPolygon(RTUtesselator* tess, void* data) {
    withTess(tess, __func__, [&](RTUtesselator& t) {
        t.require(RTUtesselator::Dormant, "rtuTessBeginPolygon");
        t.beginPolygon(data);
    });
}

RTAPI void RTAPIENTRY rtuTessBeginContour(RTUtesselator* tess) {
    withTess(tess, __func__, [](RTUtesselator& t) {
        t.require(RTUtesselator::InPolygon, "rtuTessBeginContour");
        t.state = RTUtesselator::InContour;
    });
}

RTAPI void RTAPIENTRY rtuTessVertex(RTUtesselator* tess, const RTdouble* location, void* data) {
    if (isMissing(location, __func__, "location is NULL")) return;
    withTess(tess, __func__, [&](RTUtesselator& t) {
        t.require(RTUtesselator::InContour, "rtuTessVertex");
        bool tooLarge = false;
        TessVertex vertex{{}, data};
        for (std::size_t k = 0; k < 3; ++k) vertex.location[k] = clamped(location[k], tooLarge);
        if (tooLarge) t.fail(RTU_TESS_COORD_TOO_LARGE, "rtuTessVertex");
        t.polygon.vertices.push_back(vertex);
    });
}

RTAPI void RTAPIENTRY rtuTessEndContour(RTUtesselator* tess) {
    withTess(tess, __func__, [](RTUtesselator& t) {
        t.require(RTUtesselator::InContour, "rtuTessEndContour");
        t.endContour();
    });
}

RTAPI void RTAPIENTRY rtuTessEndPolygon(RTUtesselator* tess) {
    withTess(tess, __func__, [](RTUtesselator& t) {
        t.require(RTUtesselator::InPolygon, "rtuTessEndPolygon");
        // Callbacks may begin the next polygon.
        t.state = RTUtesselator::Dormant;
        TessPolygon polygon = std::exchange(t.polygon, TessPolygon());
        void* const data = t.polygon.data = polygon.data;
        const RTenum error = tessellate(std::move(polygon), t.settings, t.callbacks);
        if (error) t.fail(error, "rtuTessEndPolygon");
        if (t.state == RTUtesselator::Dormant && t.polygon.data == data) t.polygon.data = nullptr;
    });
}

RTAPI void RTAPIENTRY rtuBeginPolygon(RTUtesselator* tess) {
    rtuTessBeginPolygon(tess, nullptr);
    rtuTessBeginContour(tess);
}

RTAPI void RTAPIENTRY rtuNextContour(RTUtesselator* tess, RTenum) {
    rtuTessEndContour(tess);
    rtuTessBeginContour(tess);
}

RTAPI void RTAPIENTRY rtuEndPolygon(RTUtesselator* tess) {
    rtuTessEndContour(tess);
    rtuTessEndPolygon(tess);
}

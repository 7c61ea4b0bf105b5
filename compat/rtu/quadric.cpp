// SPDX-License-Identifier: MIT
#include "compat/rtu/quadric.h"

#include <cmath>
#include <new>

#include "compat/openrt/guard.h"
#include "compat/rtu/report.h"

using namespace smart;
using namespace smart::compat;

namespace {

void fail(const RTUquadric& quad, RTenum rtuError, const char* function,
          const char* text) noexcept {
    recordError(rtuError == RTU_INVALID_ENUM ? ErrorCode::InvalidEnum : ErrorCode::InvalidValue,
                function, text);
    try {
        if (quad.error) quad.error(rtuError);
    } catch (...) { // the callback may be of C++
        report(function);
    }
}

bool isMissingQuadric(const RTUquadric* quad, const char* function) {
    return isMissing(quad, function, "the quadric is NULL");
}

template <class... Numbers>
bool areFinite(Numbers... numbers) {
    return (std::isfinite(numbers) && ...);
}

} // namespace

RTAPI RTUquadric* RTAPIENTRY rtuNewQuadric(void) {
    RTUquadric* const quad = new (std::nothrow) RTUquadric;
    if (!quad) recordError(ErrorCode::OutOfMemory, __func__, "out of memory");
    return quad;
}

RTAPI void RTAPIENTRY rtuDeleteQuadric(RTUquadric* quad) { delete quad; }

RTAPI void RTAPIENTRY rtuQuadricDrawStyle(RTUquadric* quad, RTenum draw) {
    if (isMissingQuadric(quad, __func__)) return;
    if (draw < RTU_POINT || draw > RTU_SILHOUETTE)
        return fail(*quad, RTU_INVALID_ENUM, __func__, "draw is no style of quadrics");
    quad->style = draw;
}

RTAPI void RTAPIENTRY rtuQuadricNormals(RTUquadric* quad, RTenum normal) {
    if (isMissingQuadric(quad, __func__)) return;
    if (normal < RTU_SMOOTH || normal > RTU_NONE)
        return fail(*quad, RTU_INVALID_ENUM, __func__, "normal is no kind of normals");
    quad->normals = normal;
}

RTAPI void RTAPIENTRY rtuQuadricOrientation(RTUquadric* quad, RTenum orientation) {
    if (isMissingQuadric(quad, __func__)) return;
    if (orientation != RTU_OUTSIDE && orientation != RTU_INSIDE)
        return fail(*quad, RTU_INVALID_ENUM, __func__, "neither RTU_OUTSIDE nor RTU_INSIDE");
    quad->inside = orientation == RTU_INSIDE;
}

RTAPI void RTAPIENTRY rtuQuadricTexture(RTUquadric* quad, RTboolean texture) {
    if (isMissingQuadric(quad, __func__)) return;
    quad->texture = texture != 0;
}

RTAPI void RTAPIENTRY rtuQuadricCallback(RTUquadric* quad, RTenum which, RTUfuncptr cb) {
    if (isMissingQuadric(quad, __func__)) return;
    if (which != RTU_ERROR)
        return fail(*quad, RTU_INVALID_ENUM, __func__, "quadrics have the callback RTU_ERROR");
    quad->error = reinterpret_cast<void(RTAPIENTRY*)(RTenum)>(cb);
}

RTAPI void RTAPIENTRY rtuSphere(RTUquadric* quad, RTdouble radius, RTint slices, RTint stacks) {
    if (isMissingQuadric(quad, __func__)) return;
    if (slices < 2 || stacks < 1 || stacks > kMaxStacks || !areFinite(radius) || radius < 0)
        return fail(*quad, RTU_INVALID_VALUE, __func__, "not the measures of a sphere");
    guarded(__func__, [&](Context& c) {
        c.recorder().requireOutsidePrimitive();
        drawSphere(*quad, radius, slices, stacks);
    });
}

RTAPI void RTAPIENTRY rtuCylinder(RTUquadric* quad, RTdouble base, RTdouble top, RTdouble height,
                                  RTint slices, RTint stacks) {
    if (isMissingQuadric(quad, __func__)) return;
    if (slices < 2 || stacks < 1 || stacks > kMaxStacks || !areFinite(base, top, height) ||
        base < 0 || top < 0 || height < 0 || (base == top && height == 0))
        return fail(*quad, RTU_INVALID_VALUE, __func__, "not the measures of a cylinder");
    guarded(__func__, [&](Context& c) {
        c.recorder().requireOutsidePrimitive();
        drawCylinder(*quad, base, top, height, slices, stacks);
    });
}

RTAPI void RTAPIENTRY rtuDisk(RTUquadric* quad, RTdouble inner, RTdouble outer, RTint slices,
                              RTint loops) {
    rtuPartialDisk(quad, inner, outer, slices, loops, 0, 360);
}

RTAPI void RTAPIENTRY rtuPartialDisk(RTUquadric* quad, RTdouble inner, RTdouble outer,
                                     RTint slices, RTint loops, RTdouble start, RTdouble sweep) {
    if (isMissingQuadric(quad, __func__)) return;
    if (slices < 2 || loops < 1 || loops > kMaxStacks || !areFinite(inner, outer, start, sweep) ||
        outer <= 0 || inner < 0 || inner > outer)
        return fail(*quad, RTU_INVALID_VALUE, __func__, "not the measures of a disk");
    guarded(__func__, [&](Context& c) {
        c.recorder().requireOutsidePrimitive();
        drawPartialDisk(*quad, inner, outer, slices, loops, start, sweep);
    });
}

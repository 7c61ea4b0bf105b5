// SPDX-License-Identifier: MIT
// The raster position: families of functions over the number and type of components.
#include "compat/openrt/call_families.h"
#include "compat/openrt/guard.h"
#include "openrt/rt_pixels.h"

using namespace smart;
using namespace smart::compat;

namespace {

template <int n, class T>
void rasterPos(const char* function, const T* v) noexcept {
    glm::dvec4 position(0.0, 0.0, 0.0, 1.0);
    for (int k = 0; v && k < n; ++k) position[k] = double(v[k]);
    recorded(function, [position, isNull = !v](Context& c) {
        if (isNull) throwError(ErrorCode::InvalidValue, "v is NULL");
        c.recorder().setRasterPosition(position);
    });
}

template <int n, class T>
void windowPos(const char* function, const T* v) noexcept {
    glm::dvec3 position(0.0);
    for (int k = 0; v && k < n; ++k) position[k] = double(v[k]);
    recorded(function, [position, isNull = !v](Context& c) {
        if (isNull) throwError(ErrorCode::InvalidValue, "v is NULL");
        c.recorder().setWindowPosition(position);
    });
}

} // namespace

OPENRT_SIFD(OPENRT_2, rtRasterPos, rasterPos)
OPENRT_SIFD(OPENRT_3, rtRasterPos, rasterPos)
OPENRT_SIFD(OPENRT_4, rtRasterPos, rasterPos)

OPENRT_SIFD(OPENRT_2, rtWindowPos, windowPos)
OPENRT_SIFD(OPENRT_3, rtWindowPos, windowPos)

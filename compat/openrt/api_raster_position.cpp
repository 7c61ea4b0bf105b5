// SPDX-License-Identifier: MIT
// The raster position: families of functions over the number and type of components.
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

// The two functions, by value and by pointer, of n components of type T with suffix s.
#define OPENRT_POINTER(name, action, n, T, s) \
    RTAPI void RTAPIENTRY name##n##s##v(const T* v) { action<n>(__func__, v); }
#define OPENRT_2(name, action, T, s)             \
    RTAPI void RTAPIENTRY name##2##s(T x, T y) { \
        const T v[] = {x, y};                    \
        action<2>(__func__, v);                  \
    }                                            \
    OPENRT_POINTER(name, action, 2, T, s)
#define OPENRT_3(name, action, T, s)                  \
    RTAPI void RTAPIENTRY name##3##s(T x, T y, T z) { \
        const T v[] = {x, y, z};                      \
        action<3>(__func__, v);                       \
    }                                                 \
    OPENRT_POINTER(name, action, 3, T, s)
#define OPENRT_4(name, action, T, s)                       \
    RTAPI void RTAPIENTRY name##4##s(T x, T y, T z, T w) { \
        const T v[] = {x, y, z, w};                        \
        action<4>(__func__, v);                            \
    }                                                      \
    OPENRT_POINTER(name, action, 4, T, s)

#define OPENRT_SIFD(count, name, action) \
    count(name, action, RTshort, s)      \
    count(name, action, RTint, i)        \
    count(name, action, RTfloat, f)      \
    count(name, action, RTdouble, d)

OPENRT_SIFD(OPENRT_2, rtRasterPos, rasterPos)
OPENRT_SIFD(OPENRT_3, rtRasterPos, rasterPos)
OPENRT_SIFD(OPENRT_4, rtRasterPos, rasterPos)

OPENRT_SIFD(OPENRT_2, rtWindowPos, windowPos)
OPENRT_SIFD(OPENRT_3, rtWindowPos, windowPos)

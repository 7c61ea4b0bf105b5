// SPDX-License-Identifier: MIT
// Vertices and current values: families of functions over the number and type of components.
#include <limits>
#include <type_traits>

#include "compat/openrt/guard.h"
#include "openrt/rt_objects.h"
#include "openrt/rt_state.h"

using namespace smart;
using namespace smart::compat;

namespace {

/// A component of a colour or normal: OpenGL 1.5, table 2.6.
template <class T>
float normalised(T value) {
    if constexpr (std::is_floating_point_v<T>)
        return float(value);
    else if constexpr (std::is_unsigned_v<T>)
        return float(double(value) / std::numeric_limits<T>::max());
    else
        return float((2.0 * value + 1.0) / std::numeric_limits<std::make_unsigned_t<T>>::max());
}

template <int n, class T>
void vertex(const char* function, const T* v) noexcept {
    guarded(function, [&](Context& c) {
        requirePointer(v, "v");
        glm::dvec4 position(0.0, 0.0, 0.0, 1.0);
        for (int k = 0; k < n; ++k) position[k] = v[k];
        ListRecording* const list = c.lists().recording();
        if (list && !list->vertex(position)) return;
        c.recorder().vertex(position);
    });
}

template <int n, class T>
void normal(const char* function, const T* v) noexcept {
    guarded(function, [&](Context& c) {
        requirePointer(v, "v");
        glm::vec3 value(0.0f);
        for (int k = 0; k < (n < 3 ? n : 3); ++k) value[k] = normalised(v[k]);
        ListRecording* const list = c.lists().recording();
        if (list && !list->normal(value)) return;
        c.recorder().normal(value);
    });
}

template <int n, class T>
void texCoord(const char* function, const T* v) noexcept {
    guarded(function, [&](Context& c) {
        requirePointer(v, "v");
        glm::vec4 value(0.0f, 0.0f, 0.0f, 1.0f);
        for (int k = 0; k < n; ++k) value[k] = float(v[k]);
        ListRecording* const list = c.lists().recording();
        if (list && !list->texCoord(value)) return;
        c.recorder().texCoord(value);
    });
}

template <int n, class T>
void color(const char* function, const T* v) noexcept {
    guarded(function, [&](Context& c) {
        requirePointer(v, "v");
        glm::vec4 value(1.0f);
        for (int k = 0; k < n; ++k) value[k] = normalised(v[k]);
        ListRecording* const list = c.lists().recording();
        if (list && !list->color(value)) return;
        c.recorder().color(value);
    });
}

} // namespace

// The two functions, by value and by pointer, of n components of type T with suffix s.
#define OPENRT_POINTER(name, action, n, T, s) \
    RTAPI void RTAPIENTRY name##n##s##v(const T* v) { action<n>(__func__, v); }
#define OPENRT_1(name, action, T, s)                  \
    RTAPI void RTAPIENTRY name##1##s(T x) {           \
        action<1>(__func__, &x);                      \
    }                                                 \
    OPENRT_POINTER(name, action, 1, T, s)
#define OPENRT_2(name, action, T, s)                  \
    RTAPI void RTAPIENTRY name##2##s(T x, T y) {      \
        const T v[] = {x, y};                         \
        action<2>(__func__, v);                       \
    }                                                 \
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

OPENRT_SIFD(OPENRT_2, rtVertex, vertex)
OPENRT_SIFD(OPENRT_3, rtVertex, vertex)
OPENRT_SIFD(OPENRT_4, rtVertex, vertex)

OPENRT_SIFD(OPENRT_2, rtNormal, normal)
OPENRT_SIFD(OPENRT_3, rtNormal, normal)
OPENRT_SIFD(OPENRT_4, rtNormal, normal)
OPENRT_3(rtNormal, normal, RTbyte, b)

OPENRT_SIFD(OPENRT_1, rtTexCoord, texCoord)
OPENRT_SIFD(OPENRT_2, rtTexCoord, texCoord)
OPENRT_SIFD(OPENRT_3, rtTexCoord, texCoord)
OPENRT_SIFD(OPENRT_4, rtTexCoord, texCoord)

#define OPENRT_COLOR(count)                \
    OPENRT_SIFD(count, rtColor, color)     \
    count(rtColor, color, RTbyte, b)       \
    count(rtColor, color, RTubyte, ub)     \
    count(rtColor, color, RTushort, us)    \
    count(rtColor, color, RTuint, ui)

OPENRT_COLOR(OPENRT_3)
OPENRT_COLOR(OPENRT_4)

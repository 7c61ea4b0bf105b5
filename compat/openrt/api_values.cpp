// SPDX-License-Identifier: MIT
// Vertices and current values: families of functions over the number and type of components.
#include "compat/openrt/call_families.h"
#include "compat/openrt/component_values.h"
#include "compat/openrt/fixed_tokens.h"
#include "compat/openrt/guard.h"
#include "openrt/rt_fixed.h"
#include "openrt/rt_objects.h"
#include "openrt/rt_state.h"

using namespace smart;
using namespace smart::compat;

namespace {

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
void texCoordOf(Context& c, std::size_t unit, const T* v) {
    requirePointer(v, "v");
    glm::vec4 value(0.0f, 0.0f, 0.0f, 1.0f);
    for (int k = 0; k < n; ++k) value[k] = float(v[k]);
    ListRecording* const list = c.lists().recording();
    if (list && !list->texCoord(value, unit)) return;
    c.recorder().texCoord(value, unit);
}

template <int n, class T>
void texCoord(const char* function, const T* v) noexcept {
    guarded(function, [&](Context& c) { texCoordOf<n>(c, 0, v); });
}

template <int n, class T>
void multiTexCoord(const char* function, RTenum target, const T* v) noexcept {
    guarded(function, [&](Context& c) { texCoordOf<n>(c, textureUnitOf(target), v); });
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

template <int n, class T>
void secondaryColor(const char* function, const T* v) noexcept {
    glm::vec4 value(0.0f, 0.0f, 0.0f, 1.0f);
    if (v)
        for (int k = 0; k < n; ++k) value[k] = normalised(v[k]);
    recordedAttribute(function, RT_CURRENT_SECONDARY_COLOR, [=, isNull = !v](Context& c) {
        if (isNull) throwError(ErrorCode::InvalidValue, "v is NULL");
        c.recorder().secondaryColor(value);
    });
}

void fogCoordinate(const char* function, bool isNull, float value) noexcept {
    recordedAttribute(function, RT_CURRENT_FOG_COORDINATE, [=](Context& c) {
        if (isNull) throwError(ErrorCode::InvalidValue, "coord is NULL");
        c.recorder().fogCoordinate(value);
    });
}

void edgeFlag(const char* function, bool isNull, RTboolean flag) noexcept {
    recordedAttribute(function, RT_EDGE_FLAG, [=](Context& c) {
        if (isNull) throwError(ErrorCode::InvalidValue, "flag is NULL");
        c.recorder().setEdgeFlag(flag != RT_FALSE);
    });
}

} // namespace

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

#define OPENRT_SECONDARY(T, s) OPENRT_3(rtSecondaryColor, secondaryColor, T, s)
OPENRT_SECONDARY(RTbyte, b)
OPENRT_SECONDARY(RTshort, s)
OPENRT_SECONDARY(RTint, i)
OPENRT_SECONDARY(RTfloat, f)
OPENRT_SECONDARY(RTdouble, d)
OPENRT_SECONDARY(RTubyte, ub)
OPENRT_SECONDARY(RTushort, us)
OPENRT_SECONDARY(RTuint, ui)

// Of each texture unit: the same with the unit first.
#define OPENRT_UNIT_POINTER(n, T, s)                                          \
    RTAPI void RTAPIENTRY rtMultiTexCoord##n##s##v(RTenum target, const T* v) { \
        multiTexCoord<n>(__func__, target, v);                                \
    }
#define OPENRT_UNIT(T, s)                                                     \
    RTAPI void RTAPIENTRY rtMultiTexCoord1##s(RTenum target, T x) {           \
        multiTexCoord<1>(__func__, target, &x);                               \
    }                                                                         \
    RTAPI void RTAPIENTRY rtMultiTexCoord2##s(RTenum target, T x, T y) {      \
        const T v[] = {x, y};                                                 \
        multiTexCoord<2>(__func__, target, v);                                \
    }                                                                         \
    RTAPI void RTAPIENTRY rtMultiTexCoord3##s(RTenum target, T x, T y, T z) { \
        const T v[] = {x, y, z};                                              \
        multiTexCoord<3>(__func__, target, v);                                \
    }                                                                         \
    RTAPI void RTAPIENTRY rtMultiTexCoord4##s(RTenum target, T x, T y, T z, T w) { \
        const T v[] = {x, y, z, w};                                           \
        multiTexCoord<4>(__func__, target, v);                                \
    }                                                                         \
    OPENRT_UNIT_POINTER(1, T, s)                                              \
    OPENRT_UNIT_POINTER(2, T, s)                                              \
    OPENRT_UNIT_POINTER(3, T, s)                                              \
    OPENRT_UNIT_POINTER(4, T, s)

OPENRT_UNIT(RTshort, s)
OPENRT_UNIT(RTint, i)
OPENRT_UNIT(RTfloat, f)
OPENRT_UNIT(RTdouble, d)

RTAPI void RTAPIENTRY rtFogCoordf(RTfloat coord) {
    fogCoordinate(__func__, false, coord);
}
RTAPI void RTAPIENTRY rtFogCoordd(RTdouble coord) {
    fogCoordinate(__func__, false, float(coord));
}
RTAPI void RTAPIENTRY rtFogCoordfv(const RTfloat* coord) {
    fogCoordinate(__func__, !coord, coord ? *coord : 0.0f);
}
RTAPI void RTAPIENTRY rtFogCoorddv(const RTdouble* coord) {
    fogCoordinate(__func__, !coord, coord ? float(*coord) : 0.0f);
}
RTAPI void RTAPIENTRY rtEdgeFlag(RTboolean flag) {
    edgeFlag(__func__, false, flag);
}
RTAPI void RTAPIENTRY rtEdgeFlagv(const RTboolean* flag) {
    edgeFlag(__func__, !flag, flag ? *flag : RTboolean(RT_TRUE));
}

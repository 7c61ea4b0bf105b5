// SPDX-License-Identifier: MIT
// Families of functions over the number and type of components, as rtVertex2s to rtVertex4dv.
#pragma once

#include "openrt/types.h"

// The two functions, by value and by pointer, of n components of type T with suffix s. Both call
// action<n>(name of the function, components).
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

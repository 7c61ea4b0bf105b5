// SPDX-License-Identifier: MIT
// base/transcendental.h for the lanes of a packet, each with the bits of the function of one float.
#pragma once

#include "libsmart/base/transcendental.h"
#include "openrt/shader.hpp"

namespace smart::math {

inline openrt::Floats pow(const openrt::Floats& base, float exponent) {
    return openrt::forEachLane([exponent](float x) { return pow(x, exponent); }, base);
}
inline openrt::Floats exp(const openrt::Floats& a) {
    return openrt::forEachLane([](float x) { return exp(x); }, a);
}
inline openrt::Floats sin(const openrt::Floats& a) {
    return openrt::forEachLane([](float x) { return sin(x); }, a);
}
inline openrt::Floats cos(const openrt::Floats& a) {
    return openrt::forEachLane([](float x) { return cos(x); }, a);
}
inline openrt::Floats asin(const openrt::Floats& a) {
    return openrt::forEachLane([](float x) { return asin(x); }, a);
}
inline openrt::Floats atan2(const openrt::Floats& y, const openrt::Floats& x) {
    return openrt::forEachLane([](float a, float b) { return atan2(a, b); }, y, x);
}

} // namespace smart::math

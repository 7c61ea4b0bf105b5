// SPDX-License-Identifier: MIT
// base/transcendental.h for the lanes of a packet, each with the bits of the function of one float.
#pragma once

#include "libsmart/base/transcendental.h"
#include "openrt/shader.hpp"

namespace smart::math {

inline openrt::Floats pow(const openrt::Floats& base, float exponent) {
    return openrt::forEachLane([exponent](float x) { return pow(x, exponent); }, base);
}

} // namespace smart::math

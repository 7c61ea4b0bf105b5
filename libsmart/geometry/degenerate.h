// SPDX-License-Identifier: MIT
#pragma once

#include "libsmart/kernel/view.h"

namespace smart {

bool isFinite(const Triangle& triangle);

/// Whether (v1 - v0) x (v2 - v0) is exactly zero, as in exact arithmetic.
/// Precondition: isFinite(triangle), and rounding to nearest.
bool isDegenerate(const Triangle& triangle);

} // namespace smart

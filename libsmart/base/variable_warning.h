// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>

namespace smart {

/// The line on the error output for a variable of the environment that can not be followed.
inline void warnOfVariable(const char* name, const char* value, const char* reason) noexcept {
    std::fprintf(stderr, "openrt: %s=%.200s: %s\n", name, value, reason);
}

} // namespace smart

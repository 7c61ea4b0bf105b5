// SPDX-License-Identifier: MIT
#pragma once

#include "libsmart/base/error.h"

namespace smart::compat {

/// Records an error in the calling thread's context, if it has one.
void recordError(ErrorCode code, const char* function, const char* text) noexcept;

/// Records InvalidValue and returns true where the pointer is nullptr.
bool isMissing(const void* pointer, const char* function, const char* text) noexcept;

} // namespace smart::compat

// SPDX-License-Identifier: MIT
#pragma once

#include "libsmart/base/error.h"

namespace smart::compat {

/// Writes a line about an error to where the environment variable OPENRT_LOG says: `stderr`, or a
/// file that is appended to. Without it, and in set-uid programs, writes nothing. The variable is
/// read once. Thread-safe; allocates nothing after the first call.
void logError(ErrorCode code, const char* function, const char* text) noexcept;

} // namespace smart::compat

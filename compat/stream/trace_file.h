// SPDX-License-Identifier: MIT
#pragma once

#include "compat/stream/call_sink.h"

namespace smart::compat {

/// A sink that writes a file which there is not yet, named by the environment variable
/// OPENRT_TRACE; nullptr without it, in set-uid programs, and, after a line on stderr, where the
/// file can not be made. It lives as long as the process.
CallSink* traceFileFromEnvironment() noexcept;

} // namespace smart::compat

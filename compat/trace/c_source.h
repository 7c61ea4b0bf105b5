// SPDX-License-Identifier: MIT
#pragma once

#include <iosfwd>

#include "compat/trace/trace_input.h"

namespace smart::compat {

/// Writes a C99 program that makes the recorded calls, but for those whose results the application
/// alone sees and for tessellation, whose outcome is among the calls; it compares each frame with
/// the recorded one. Throws StreamError for recordings of several threads, and of shader classes
/// that are part of the recorded program.
void writeSource(const TraceInput& input, std::ostream& out);

} // namespace smart::compat

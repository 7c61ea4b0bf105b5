// SPDX-License-Identifier: MIT
#pragma once

#include <iosfwd>

#include "compat/trace/trace_input.h"

namespace smart::compat {

/// A line for each call, and one for each outcome that is told of.
void listCalls(const TraceInput& input, std::ostream& out);
/// How many calls, frames, errors and bytes there are, and of which functions.
void summarise(const TraceInput& input, std::ostream& out);

} // namespace smart::compat

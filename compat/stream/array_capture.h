// SPDX-License-Identifier: MIT
// The vertex arrays that a call draws, where they lie in the application's memory.
#pragma once

#include "compat/recorder/context.h"
#include "compat/stream/call_table.h"
#include "compat/stream/record_format.h"

namespace smart::compat {

/// Attaches to a drawing call the elements that it reads of each array in the application's
/// memory, and to rtArrayElement those of all arrays, as it is played by the calls for each.
/// Nothing, where the call draws nothing or is none of these.
void captureArrays(RecordWriter& record, const CallSignature& call, const CallValue* arguments,
                   Context& context);

} // namespace smart::compat

// SPDX-License-Identifier: MIT
// Vertex arrays for the calls of a player: read from the stream, and nowhere else.
#pragma once

#include "compat/stream/call_reader.h"
#include "compat/stream/played_memory.h"

namespace smart::compat {

/// Makes a drawing call with the arrays that its record brings, which have no memory afterwards.
/// `arguments` are those of this process. Throws StreamError where it would read elements that the
/// record has not; what it might read elsewhere the library knows the size of, or refuses.
void playDrawing(const CallRecord& record, const CallValue* arguments, CallArena& arena);

/// Makes rtArrayElement by the calls that give its values one by one.
void playElement(const CallRecord& record, CallArena& arena);

} // namespace smart::compat

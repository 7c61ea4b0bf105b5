// SPDX-License-Identifier: MIT
// The memory that a call reads, copied as the call finds it.
#pragma once

#include <cstdint>

#include "compat/recorder/context.h"
#include "compat/stream/call_memory.h"
#include "compat/stream/call_table.h"
#include "compat/stream/record_format.h"

namespace smart::compat {

/// A number for each place in memory that pictures go to, from 1.
uint64_t keyOfFrameBuffer(const void* memory);
/// Whether it has one: the library's own memory has not.
bool isFrameBuffer(const void* memory);

/// Where images lie for the calls of a context now.
ImageStores imageStoresOf(Context* context);

/// Writes all arguments and attachments of a call. `context`: the thread's, or nullptr. Pointers
/// that lead nowhere are written as such where the call would not read them either.
void captureArguments(RecordWriter& record, const CallSignature& call, const CallValue* arguments,
                      Context* context);

} // namespace smart::compat

// SPDX-License-Identifier: MIT
// Recorded arguments as arguments of a call in this process.
#pragma once

#include <cstdint>
#include <map>

#include "compat/stream/call_player.h"
#include "compat/stream/call_reader.h"
#include "compat/stream/played_memory.h"

namespace smart::compat {

/// What the library returned when the stream was recorded, and what it returns now.
class PlayedNames {
public:
    void add(Meaning meaning, uint32_t context, uint64_t recorded, uint64_t now);
    void remove(Meaning meaning, uint64_t recorded);
    /// What a name that was never returned stands for is none of ours either.
    uint64_t find(Meaning meaning, uint32_t context, uint64_t recorded) const;
    /// rtExit: contexts, frames and compiled scenes are gone.
    void forgetProcess();

private:
    using Key = std::pair<uint32_t, uint64_t>; ///< context, or 0; name
    static Key keyOf(Meaning meaning, uint32_t context, uint64_t name);

    std::map<Meaning, std::map<Key, uint64_t>> names_;
};

/// The arguments of one call.
struct PlayedArguments {
    CallValue values[kMaxParameters + 1];
    /// The call would read what was not recorded: it can only be one that is refused before.
    bool lacksMemory = false;
};

/// Where images lie for the calls of the current context.
ImageStores imageStores();

/// Fills all but what points to pictures, shader classes and functions, which stay NULL. Memory is
/// as large as the call reads. Throws StreamError where a damaged stream has less.
void makeArguments(const CallRecord& record, uint32_t context, const PlayedNames& names,
                   CallArena& arena, PlayedArguments& arguments);

} // namespace smart::compat

// SPDX-License-Identifier: MIT
// Where a recording of the interface's calls goes.
#pragma once

#include <cstddef>
#include <span>

namespace smart::compat {

/// Gets every call of the process, as records (record_format.h), in one order for all threads.
class CallSink {
public:
    virtual ~CallSink() = default;
    /// One whole record or several: of a call before it runs, of its outcome afterwards. Called by
    /// one thread at a time, which must not call the interface. The first record is the stream's
    /// header. What is thrown ends the recording.
    virtual void record(std::span<const std::byte> wholeRecords) = 0;
    /// Players should have what was recorded so far: the call that runs next takes its time.
    virtual void flush() {}
    /// Whether finished pictures are to be recorded, by their hashes.
    virtual bool wantsPictures() const { return true; }
};

/// From now on; nullptr: nothing is recorded. A player can repeat what was recorded from the start
/// of a program only, so that sinks are set before rtInit. The sink before gets no more records
/// once this has returned.
void setCallSink(CallSink* sink) noexcept;
/// The same as with nullptr, in the child of a fork, where another thread may have been recording.
void abandonCallSink() noexcept;

} // namespace smart::compat

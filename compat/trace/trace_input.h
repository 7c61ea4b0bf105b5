// SPDX-License-Identifier: MIT
// A file of recorded calls, read from its start to its end.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "compat/stream/call_reader.h"
#include "compat/stream/record_format.h"

namespace smart::compat {

/// The whole file in memory; what a program that was killed left behind its last record is not
/// looked at. Throws StreamError where the file can not be read, or is no recording.
class TraceInput {
public:
    explicit TraceInput(const std::string& path);
    std::span<const std::byte> records() const;
    uint64_t bytes() const { return bytes_.size(); }
    bool isCutOff() const { return whole_ < bytes_.size(); }

private:
    std::vector<std::byte> bytes_;
    std::size_t whole_ = 0;
};

/// Hears of the records of a file, in order.
class TraceVisitor {
public:
    virtual ~TraceVisitor() = default;
    virtual void call(const RecordHead& head, const CallRecord& record) = 0;
    virtual void outcome(const RecordHead& head, const OutcomeRecord& record) = 0;
    virtual void picture(const RecordHead& head, const PictureRecord& record) = 0;
};

/// Throws StreamError where a record is damaged. The version of the library that recorded.
std::string visit(const TraceInput& input, TraceVisitor& visitor);

} // namespace smart::compat

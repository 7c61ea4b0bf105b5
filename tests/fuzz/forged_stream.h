// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "compat/stream/call_table.h"
#include "compat/stream/record_format.h"
#include "tests/fuzz/api_program.h"

namespace openrt::test {

/// A recording of calls that nobody made: each record is one that a recorder could have written,
/// but for what the input wants otherwise; all checksums are right.
class ForgedStream {
public:
    explicit ForgedStream(Input& input);
    const std::vector<std::byte>& bytes() const { return bytes_; }

private:
    void start();
    void next();
    void call();
    void putPointer(const smart::compat::CallSignature& call, std::size_t i,
                    const ApiParameter& parameter, uint8_t choice);
    void putAnyPointer(int nesting = 0);
    void putBytes(uint64_t count, uint8_t pattern);
    void putAttachments();
    void outcome(const smart::compat::CallSignature& call, bool isHonest);
    void picture();
    void begin(smart::compat::RecordKind kind, uint8_t where);
    void end(uint8_t damage);

    Input& input_;
    smart::compat::RecordWriter writer_;
    std::vector<std::byte> bytes_;
    smart::compat::CallValue values_[smart::compat::kMaxParameters + 1]; ///< of the call under way
    const smart::compat::CallSignature* last_ = nullptr;
    std::map<smart::compat::Meaning, uint64_t> made_; ///< how many names were
};

} // namespace openrt::test

// SPDX-License-Identifier: MIT
// Calls as a stream of bytes: each is its length (8 bytes, the lowest first) and its record, of
// which nothing is known here.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace smart {

/// Appends a call to bytes of the stream.
void appendCall(std::vector<std::byte>& bytes, std::span<const std::byte> record);

/// Cuts the stream into calls again, however its bytes arrive.
class CallAssembler {
public:
    static constexpr uint64_t kMaxRecord = uint64_t(1) << 40;

    void add(std::span<const std::byte> bytes);
    /// Takes the next call out; false: it is not complete. Throws Error for a length that can not
    /// be.
    bool take(std::vector<std::byte>& record);

private:
    std::vector<std::byte> bytes_;
    std::size_t begin_ = 0; ///< of what was not taken
};

} // namespace smart

// SPDX-License-Identifier: MIT
#include "libsmart/remote/call_bytes.h"

#include "libsmart/base/error.h"

namespace smart {
namespace {
constexpr std::size_t kLengthSize = 8;
} // namespace

void appendCall(std::vector<std::byte>& bytes, std::span<const std::byte> record) {
    for (std::size_t i = 0; i < kLengthSize; ++i)
        bytes.push_back(std::byte(uint64_t(record.size()) >> (8 * i) & 0xFF));
    bytes.insert(bytes.end(), record.begin(), record.end());
}

void CallAssembler::add(std::span<const std::byte> bytes) {
    if (begin_ > bytes_.size() / 2) { // so that each byte is moved once on average
        bytes_.erase(bytes_.begin(), bytes_.begin() + std::ptrdiff_t(begin_));
        begin_ = 0;
    }
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

bool CallAssembler::take(std::vector<std::byte>& record) {
    const std::span<const std::byte> left = std::span(bytes_).subspan(begin_);
    if (left.size() < kLengthSize) return false;
    uint64_t length = 0;
    for (std::size_t i = kLengthSize; i-- > 0;) length = length << 8 | uint64_t(left[i]);
    if (length > kMaxRecord)
        throw Error(ErrorCode::InvalidValue, "a call is longer than any can be");
    if (left.size() - kLengthSize < length) return false;
    const std::span<const std::byte> call = left.subspan(kLengthSize, std::size_t(length));
    record.assign(call.begin(), call.end());
    begin_ += kLengthSize + std::size_t(length);
    return true;
}

} // namespace smart

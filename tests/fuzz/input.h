// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace openrt::test {

/// Takes an input apart from its front; at its end everything is 0.
class Input {
public:
    Input(const uint8_t* data, std::size_t size) : at_(data), end_(data + size) {}

    bool atEnd() const { return at_ == end_; }
    std::size_t left() const { return std::size_t(end_ - at_); }
    const uint8_t* rest() const { return at_; }
    uint8_t byte() { return atEnd() ? 0 : *at_++; }
    uint16_t word() {
        const unsigned low = byte();
        return uint16_t(low | unsigned(byte()) << 8);
    }
    uint32_t below(uint32_t limit) { return limit > 256 ? word() % limit : byte() % limit; }
    float number() {
        uint8_t bytes[4] = {byte(), byte(), byte(), byte()};
        float value;
        std::memcpy(&value, bytes, sizeof value);
        return value;
    }

private:
    const uint8_t* at_;
    const uint8_t* end_;
};

} // namespace openrt::test

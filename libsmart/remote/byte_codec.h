// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

namespace smart {

/// Makes bytes fewer and whole again; all processes of a job have the same. Thread-safe.
class ByteCodec {
public:
    virtual ~ByteCodec() = default;
    /// How many bytes of `packed` it took; 0: they are not enough.
    virtual std::size_t pack(std::span<const std::byte> bytes,
                             std::span<std::byte> packed) const = 0;
    /// Whether `packed`, any bytes whatever, gives exactly so many bytes.
    virtual bool unpack(std::span<const std::byte> packed, std::span<std::byte> bytes) const = 0;
};

} // namespace smart

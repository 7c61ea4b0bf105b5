// SPDX-License-Identifier: MIT
#pragma once

#include "libsmart/remote/byte_codec.h"

namespace smart::compat {

/// Blocks of LZ4 <https://lz4.org>, of at most 2 GB.
class Lz4Codec final : public ByteCodec {
public:
    std::size_t pack(std::span<const std::byte> bytes, std::span<std::byte> packed) const override;
    bool unpack(std::span<const std::byte> packed, std::span<std::byte> bytes) const override;
};

} // namespace smart::compat

// SPDX-License-Identifier: MIT
#include "compat/mpi/lz4_codec.h"

#include <lz4.h>

namespace smart::compat {
namespace {

bool isBlock(std::size_t size) {
    return size <= std::size_t(LZ4_MAX_INPUT_SIZE);
}

} // namespace

std::size_t Lz4Codec::pack(std::span<const std::byte> bytes, std::span<std::byte> packed) const {
    if (!isBlock(bytes.size()) || !isBlock(packed.size())) return 0;
    const int size = LZ4_compress_default(reinterpret_cast<const char*>(bytes.data()),
                                          reinterpret_cast<char*>(packed.data()), int(bytes.size()),
                                          int(packed.size()));
    return size > 0 ? std::size_t(size) : 0;
}

bool Lz4Codec::unpack(std::span<const std::byte> packed, std::span<std::byte> bytes) const {
    if (!isBlock(bytes.size()) || !isBlock(packed.size())) return false;
    const int size = LZ4_decompress_safe(reinterpret_cast<const char*>(packed.data()),
                                         reinterpret_cast<char*>(bytes.data()), int(packed.size()),
                                         int(bytes.size()));
    return size >= 0 && std::size_t(size) == bytes.size();
}

} // namespace smart::compat

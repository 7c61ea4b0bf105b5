// SPDX-License-Identifier: MIT
#include "libsmart/remote/tile_planes.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace smart {
namespace {

/// Of the k-th byte in memory of a word.
constexpr unsigned shiftOf(unsigned k) {
    return std::endian::native == std::endian::little ? 8 * k : 24 - 8 * k;
}

// The size of a pixel is a constant for the compiler, and loops are such that it makes vector
// instructions of them: long ones without aliases; pixels of whole words are taken apart to words
// first.
template <std::size_t size>
void split(std::size_t count, const std::byte* __restrict pixels, std::byte* __restrict planes) {
    if constexpr (size % 4 != 0) {
        for (std::size_t plane = 0; plane < size; ++plane)
            for (std::size_t i = 0; i < count; ++i)
                planes[plane * count + i] = pixels[i * size + plane];
    } else {
        uint32_t words[TilePixels::kCount];
        for (std::size_t at = 0; at < size; at += 4) {
            for (std::size_t i = 0; i < count; ++i)
                std::memcpy(&words[i], pixels + i * size + at, 4);
            for (unsigned k = 0; k < 4; ++k, planes += count)
                for (std::size_t i = 0; i < count; ++i)
                    planes[i] = std::byte(words[i] >> shiftOf(k));
        }
    }
}

template <std::size_t size>
void join(std::size_t count, const std::byte* __restrict planes, std::byte* __restrict pixels) {
    if constexpr (size % 4 != 0) {
        for (std::size_t plane = 0; plane < size; ++plane)
            for (std::size_t i = 0; i < count; ++i)
                pixels[i * size + plane] = planes[plane * count + i];
    } else {
        uint32_t words[TilePixels::kCount];
        for (std::size_t at = 0; at < size; at += 4, planes += 4 * count) {
            const std::byte* const p[] = {planes, planes + count, planes + 2 * count,
                                          planes + 3 * count};
            for (std::size_t i = 0; i < count; ++i)
                words[i] = uint32_t(p[0][i]) << shiftOf(0) | uint32_t(p[1][i]) << shiftOf(1) |
                           uint32_t(p[2][i]) << shiftOf(2) | uint32_t(p[3][i]) << shiftOf(3);
            for (std::size_t i = 0; i < count; ++i)
                std::memcpy(pixels + i * size + at, &words[i], 4);
        }
    }
}

/// to = from less the row before, of so many bytes.
void subtractRows(std::size_t bytes, std::size_t row, const std::byte* __restrict from,
                  std::byte* __restrict to) {
    std::memcpy(to, from, row);
    for (std::size_t i = row; i < bytes; ++i)
        to[i] = std::byte(unsigned(from[i]) - unsigned(from[i - row]));
}

void addRows(std::size_t bytes, std::size_t row, std::byte* pixels) {
    for (std::size_t begin = row; begin < bytes; begin += row) {
        const std::byte* __restrict const before = pixels + begin - row;
        std::byte* __restrict const here = pixels + begin;
        for (std::size_t i = 0; i < row; ++i)
            here[i] = std::byte(unsigned(here[i]) + unsigned(before[i]));
    }
}

/// Calls use(a constant) with the size of a stored pixel.
template <class Use>
void withSize(unsigned size, const Use& use) {
    switch (size) {
        case 3:
            return use(std::integral_constant<std::size_t, 3>());
        case 4:
            return use(std::integral_constant<std::size_t, 4>());
        case 12:
            return use(std::integral_constant<std::size_t, 12>());
        case 16:
            return use(std::integral_constant<std::size_t, 16>());
    }
}

} // namespace

void splitTile(const StoredLayout& layout, const Tile& tile, const std::byte* stored,
               std::byte* planes) {
    const std::size_t count = std::size_t(tile.width) * tile.height;
    for (unsigned part = 0; part < layout.parts; ++part)
        withSize(layout.pixelSize[part], [&](auto size) {
            std::byte differences[size() * TilePixels::kCount];
            subtractRows(size() * count, size() * tile.width, stored, differences);
            split<size()>(count, differences, planes);
            stored += size() * count;
            planes += size() * count;
        });
}

void joinTile(const StoredLayout& layout, const Tile& tile, const std::byte* planes,
              std::byte* stored) {
    const std::size_t count = std::size_t(tile.width) * tile.height;
    for (unsigned part = 0; part < layout.parts; ++part)
        withSize(layout.pixelSize[part], [&](auto size) {
            join<size()>(count, planes, stored);
            addRows(size() * count, size() * tile.width, stored);
            planes += size() * count;
            stored += size() * count;
        });
}

} // namespace smart

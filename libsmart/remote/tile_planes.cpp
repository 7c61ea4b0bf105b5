// SPDX-License-Identifier: MIT
#include "libsmart/remote/tile_planes.h"

#include <type_traits>

namespace smart {
namespace {

std::byte less(std::byte a, std::byte b) {
    return std::byte(unsigned(a) - unsigned(b));
}
std::byte plus(std::byte a, std::byte b) {
    return std::byte(unsigned(a) + unsigned(b));
}

// The size of a pixel is a constant for the compiler, which then vectorises.
template <std::size_t size>
void split(std::size_t width, std::size_t height, const std::byte* in, std::byte* out) {
    for (std::size_t plane = 0; plane < size; ++plane) {
        const std::byte* from = in + plane;
        for (std::size_t i = 0; i < width; ++i) *out++ = from[i * size];
        for (std::size_t row = 1; row < height; ++row) {
            const std::byte* const before = from;
            from += width * size;
            for (std::size_t i = 0; i < width; ++i)
                out[i] = less(from[i * size], before[i * size]);
            out += width;
        }
    }
}

template <std::size_t size>
void join(std::size_t width, std::size_t height, const std::byte* in, std::byte* out) {
    for (std::size_t plane = 0; plane < size; ++plane) {
        std::byte* to = out + plane;
        for (std::size_t i = 0; i < width; ++i) to[i * size] = *in++;
        for (std::size_t row = 1; row < height; ++row) {
            const std::byte* const before = to;
            to += width * size;
            for (std::size_t i = 0; i < width; ++i)
                to[i * size] = plus(in[i], before[i * size]);
            in += width;
        }
    }
}

/// Calls use(a constant) with the size of a stored pixel.
template <class Use>
void withSize(unsigned size, const Use& use) {
    switch (size) {
        case 3: return use(std::integral_constant<std::size_t, 3>());
        case 4: return use(std::integral_constant<std::size_t, 4>());
        case 12: return use(std::integral_constant<std::size_t, 12>());
        case 16: return use(std::integral_constant<std::size_t, 16>());
    }
}

} // namespace

void splitTile(const StoredLayout& layout, const Tile& tile, const std::byte* stored,
               std::byte* planes) {
    for (unsigned part = 0; part < layout.parts; ++part)
        withSize(layout.pixelSize[part], [&](auto size) {
            split<size()>(tile.width, tile.height, stored, planes);
            stored += size() * tile.width * tile.height;
            planes += size() * tile.width * tile.height;
        });
}

void joinTile(const StoredLayout& layout, const Tile& tile, const std::byte* planes,
              std::byte* stored) {
    for (unsigned part = 0; part < layout.parts; ++part)
        withSize(layout.pixelSize[part], [&](auto size) {
            join<size()>(tile.width, tile.height, planes, stored);
            planes += size() * tile.width * tile.height;
            stored += size() * tile.width * tile.height;
        });
}

} // namespace smart

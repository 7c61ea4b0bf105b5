// SPDX-License-Identifier: MIT
#include "libsmart/render/stored_tile.h"

#include <cstring>
#include <type_traits>

namespace smart {
namespace {

/// Calls use(member of AuxBuffers, bytes of a pixel) for each that there may be.
template <class Use>
void forEachAux(const Use& use) {
    use(&AuxBuffers::depth, 4u);
    use(&AuxBuffers::distance, 4u);
    use(&AuxBuffers::normal, 12u);
    use(&AuxBuffers::objectId, 4u);
    use(&AuxBuffers::instanceId, 4u);
    use(&AuxBuffers::primitiveId, 4u);
}

/// Calls use(a row of the tile in the picture's memory, bytes of the row) for all of what is
/// stored, in its order.
template <class Use>
void forEachRow(const PixelTarget& target, const Tile& tile, const Use& use) {
    const auto rows = [&](void* memory, std::size_t stride, std::size_t pixelSize) {
        for (uint32_t j = 0; memory && j < tile.height; ++j)
            use(static_cast<std::byte*>(memory) + (std::size_t(tile.y) + j) * stride +
                    tile.x * pixelSize,
                tile.width * pixelSize);
    };
    forEachAux([&](auto member, unsigned size) {
        rows(target.aux.*member, std::size_t(target.width) * size, size);
    });
    const std::size_t pixel = bytesPerPixel(target.format);
    rows(target.memory, target.stride ? target.stride : target.width * pixel, pixel);
}

} // namespace

StoredLayout storedLayout(const PixelTarget& target) {
    StoredLayout layout;
    const auto add = [&](std::size_t size) { layout.pixelSize[layout.parts++] = uint8_t(size); };
    forEachAux([&](auto member, unsigned size) {
        if (target.aux.*member) add(size);
    });
    if (target.memory) add(bytesPerPixel(target.format));
    return layout;
}

std::size_t storedTileSize(const PixelTarget& target, const Tile& tile) {
    const StoredLayout layout = storedLayout(target);
    std::size_t pixel = 0;
    for (unsigned part = 0; part < layout.parts; ++part) pixel += layout.pixelSize[part];
    return pixel * tile.width * tile.height;
}

void storeTile(const PixelTarget& target, const Tile& tile, const TilePixels& pixels,
               std::byte* bytes) {
    PixelTarget stored;
    stored.width = tile.width;
    stored.height = tile.height;
    stored.format = target.format;
    stored.srgb = target.srgb;
    const std::size_t count = std::size_t(tile.width) * tile.height;
    forEachAux([&](auto member, unsigned size) {
        if (!(target.aux.*member)) return;
        using Values = std::remove_reference_t<decltype(stored.aux.*member)>;
        stored.aux.*member = reinterpret_cast<Values>(bytes);
        bytes += size * count;
    });
    if (target.memory) stored.memory = bytes;
    writeTile(stored, {0, 0, tile.width, tile.height}, pixels);
}

void placeTile(const PixelTarget& target, const Tile& tile, const std::byte* bytes) {
    forEachRow(target, tile, [&](std::byte* row, std::size_t size) {
        std::memcpy(row, bytes, size);
        bytes += size;
    });
}

void gatherTile(const PixelTarget& target, const Tile& tile, std::byte* bytes) {
    forEachRow(target, tile, [&](const std::byte* row, std::size_t size) {
        std::memcpy(bytes, row, size);
        bytes += size;
    });
}

} // namespace smart

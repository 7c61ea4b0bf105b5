// SPDX-License-Identifier: MIT
#include "libsmart/remote/answer_packing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <random>
#include <string>

#include "compat/mpi/lz4_codec.h"
#include "libsmart/base/error.h"
#include "libsmart/remote/tile_planes.h"

namespace smart {
namespace {

const compat::Lz4Codec kCodec;

/// Targets of every format, with and without values beside the colours; and those alone.
std::vector<PixelTarget> targets() {
    static float floats[1];
    static uint32_t numbers[1];
    std::vector<PixelTarget> all;
    for (const PixelFormat format : {PixelFormat::Bgr32f, PixelFormat::Rgb8, PixelFormat::Rgba8,
                                     PixelFormat::Bgra8, PixelFormat::Rgb32f, PixelFormat::Rgba32f})
        for (const unsigned aux : {0u, 1u, 2u, 3u}) {
            PixelTarget target;
            target.width = target.height = 100;
            target.format = format;
            target.memory = aux == 3 ? nullptr : floats;
            if (aux > 0) target.aux.depth = target.aux.normal = floats;
            if (aux > 1) target.aux.objectId = target.aux.primitiveId = numbers;
            all.push_back(target);
        }
    return all;
}

/// What varies slowly, as pictures do, or anything.
std::vector<std::byte> someBytes(std::size_t count, bool smooth, std::mt19937& random) {
    std::vector<std::byte> bytes(count);
    for (std::size_t i = 0; i < count; ++i)
        bytes[i] = std::byte(smooth ? unsigned(i / 400) + (i % 4) * 50 : random());
    return bytes;
}

std::vector<std::byte> packedTile(const PixelTarget& target, const Tile& tile,
                                  std::span<const std::byte> bytes) {
    AnswerPacker packer(&kCodec, Packing::Always, 1);
    PackMemory memory;
    const std::span<const std::byte> packed =
        packer.pack(storedLayout(target), tile, bytes, 1e-3, false, memory);
    return {packed.begin(), packed.end()};
}

constexpr Tile kTiles[] = {
    {0, 0, 32, 32}, {0, 0, 1, 1}, {32, 0, 7, 32}, {0, 32, 32, 3}, {5, 5, 1, 32}};

TEST(AnswerPacking, TilesOfAllKindsAreWholeAgain) {
    std::mt19937 random(1);
    AnswerUnpacker unpacker(&kCodec);
    std::size_t fewer = 0, all = 0;
    for (const PixelTarget& target : targets())
        for (const Tile& tile : kTiles)
            for (const bool smooth : {true, false}) {
                const std::size_t size = storedTileSize(target, tile);
                const std::vector<std::byte> bytes = someBytes(size, smooth, random);
                const std::vector<std::byte> packed = packedTile(target, tile, bytes);
                if (packed.size() == size) { // as it was
                    EXPECT_EQ(packed, bytes);
                    continue;
                }
                EXPECT_LT(packed.size(), size);
                fewer += packed.size(), all += size;
                const auto whole = unpacker.unpack(storedLayout(target), tile, size, packed);
                EXPECT_TRUE(std::equal(whole.begin(), whole.end(), bytes.begin(), bytes.end()));
            }
    EXPECT_GT(all, 3 * fewer);
}

// Byte by byte, as the order is defined.
TEST(AnswerPacking, PlanesHoldDifferencesOfRows) {
    std::mt19937 random(2);
    for (const PixelTarget& target : targets())
        for (const Tile& tile : kTiles) {
            const StoredLayout layout = storedLayout(target);
            const std::vector<std::byte> bytes =
                someBytes(storedTileSize(target, tile), false, random);
            std::vector<std::byte> planes(bytes.size()), back(bytes.size());
            splitTile(layout, tile, bytes.data(), planes.data());
            std::size_t at = 0, begin = 0;
            for (unsigned part = 0; part < layout.parts; ++part) {
                const std::size_t size = layout.pixelSize[part];
                for (std::size_t k = 0; k < size; ++k)
                    for (uint32_t j = 0; j < tile.height; ++j)
                        for (uint32_t i = 0; i < tile.width; ++i) {
                            const std::size_t p = (j * tile.width + i) * size + k;
                            const unsigned below =
                                j > 0 ? unsigned(bytes[begin + p - tile.width * size]) : 0;
                            ASSERT_EQ(planes[at++], std::byte(unsigned(bytes[begin + p]) - below));
                        }
                begin += size * tile.width * tile.height;
            }
            ASSERT_EQ(at, bytes.size());
            joinTile(layout, tile, planes.data(), back.data());
            EXPECT_EQ(back, bytes);
        }
}

bool isRefused(AnswerUnpacker& unpacker, const PixelTarget& target, std::size_t size,
               std::span<const std::byte> packed) {
    try {
        const auto whole = unpacker.unpack(storedLayout(target), kTiles[0], size, packed);
        EXPECT_EQ(whole.size(), size);
    } catch (const Error&) {
        return true;
    }
    return false;
}

TEST(AnswerPacking, OtherLengthsAreRefused) {
    std::mt19937 random(3);
    AnswerUnpacker unpacker(&kCodec), none(nullptr);
    for (const PixelTarget& target : targets()) {
        const std::size_t size = storedTileSize(target, kTiles[0]);
        std::vector<std::byte> packed =
            packedTile(target, kTiles[0], someBytes(size, true, random));
        ASSERT_LT(packed.size(), size);
        EXPECT_FALSE(isRefused(unpacker, target, size, packed)); // the control
        EXPECT_TRUE(isRefused(none, target, size, packed));
        for (std::size_t length = 0; length < packed.size(); ++length)
            ASSERT_TRUE(isRefused(unpacker, target, size, std::span(packed).first(length)));
        packed.push_back(packed[0]);
        EXPECT_TRUE(isRefused(unpacker, target, size, packed));
        EXPECT_TRUE(isRefused(unpacker, target, size, std::vector<std::byte>(size)));
        EXPECT_TRUE(isRefused(unpacker, target, size, std::vector<std::byte>(size + 1)));
        // One pixel more or less, and very many, from few bytes.
        for (const std::size_t pretended : {size - 1, size + 1, std::size_t(2000000)}) {
            const std::vector<std::byte> zeros(pretended);
            std::vector<std::byte> bomb(pretended);
            bomb.resize(kCodec.pack(zeros, bomb));
            ASSERT_GT(bomb.size(), 0u);
            EXPECT_TRUE(isRefused(unpacker, target, size, bomb)) << pretended;
        }
    }
}

TEST(AnswerPacking, AnythingIsTakenWithoutHarm) {
    std::mt19937 random(4);
    AnswerUnpacker unpacker(&kCodec);
    const PixelTarget target = targets()[8]; // four bytes a pixel
    const std::size_t size = storedTileSize(target, kTiles[0]);
    const std::vector<std::byte> good = packedTile(target, kTiles[0], [&] {
        std::vector<std::byte> bytes = someBytes(size, true, random);
        for (std::size_t i = 0; i < size; i += 1 + random() % 20) bytes[i] = std::byte(random());
        return bytes;
    }());
    ASSERT_LT(good.size(), size);
    std::size_t refused = 0;
    for (int i = 0; i < 20000; ++i) {
        std::vector<std::byte> mutant = good;
        for (unsigned changes = 1 + random() % 6; changes > 0 && !mutant.empty(); --changes) {
            const std::size_t at = random() % mutant.size();
            switch (random() % 4) {
                case 0:
                    mutant[at] = std::byte(random());
                    break;
                case 1:
                    mutant[at] = std::byte(0xFF);
                    break; // lengths go on
                case 2:
                    mutant.insert(mutant.begin() + std::ptrdiff_t(at), std::byte(at));
                    break;
                case 3:
                    mutant.erase(mutant.begin() + std::ptrdiff_t(at));
                    break;
            }
        }
        refused += isRefused(unpacker, target, size, mutant);
    }
    EXPECT_GT(refused, 10000u);
}

// Eight threads that make eight tiles a second, of which so many come through unpacked.
struct Sums {
    unsigned packed = 0, plain = 0;
};
Sums sendTiles(AnswerPacker& packer, double throughput, unsigned count, bool mayPack) {
    const PixelTarget target = targets()[8];
    const std::size_t size = storedTileSize(target, kTiles[0]);
    std::mt19937 random(5);
    const std::vector<std::byte> bytes = someBytes(size, true, random);
    PackMemory memory;
    static PackingChoice::Clock::time_point now;
    static uint64_t sent = 0;
    Sums sums;
    for (unsigned i = 0; i < count; ++i) {
        const std::size_t travels =
            packer.pack(storedLayout(target), kTiles[0], bytes, 1.0, mayPack, memory).size();
        (travels < size ? sums.packed : sums.plain) += 1;
        const double seconds = std::max(1 / 8.0, double(travels) / double(size) / throughput);
        now += std::chrono::nanoseconds(std::llround(seconds * 1e9));
        packer.arrived(sent += travels, now);
    }
    return sums;
}

TEST(AnswerPacking, SlowLinesArePackedForAndTriedAgain) {
    AnswerPacker packer(&kCodec, Packing::WhenItPays, 8);
    const Sums fast = sendTiles(packer, 100, 4000, true);
    EXPECT_LT(fast.packed, 100u); // to see what it would give
    EXPECT_GT(fast.packed, 10u);
    const Sums slow = sendTiles(packer, 1, 40000, true);
    EXPECT_GT(slow.packed, 20 * slow.plain);
    EXPECT_GT(slow.plain, 400u); // to see what the line carries
    const Sums vetoed = sendTiles(packer, 1, 1000, false);
    EXPECT_EQ(vetoed.packed, 0u);
    const Sums again = sendTiles(packer, 100, 20000, true);
    EXPECT_GT(again.plain, 10 * again.packed);
}

TEST(AnswerPacking, WishesAreFollowed) {
    AnswerPacker never(&kCodec, Packing::Never, 8), none(nullptr, Packing::Always, 8),
        always(&kCodec, Packing::Always, 8);
    EXPECT_EQ(sendTiles(never, 1, 1000, true).packed, 0u);
    EXPECT_EQ(sendTiles(none, 1, 1000, true).packed, 0u);
    EXPECT_EQ(sendTiles(always, 100, 1000, true).plain, 0u);
}

} // namespace
} // namespace smart

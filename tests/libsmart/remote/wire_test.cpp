// SPDX-License-Identifier: MIT
#include "libsmart/remote/wire.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

namespace smart {
namespace {

std::vector<std::byte> randomBytes(std::mt19937& random, std::size_t count) {
    std::vector<std::byte> bytes(count);
    for (std::byte& b : bytes) b = std::byte(random());
    return bytes;
}

/// One of each type, with all fields set.
std::vector<Message> samples(const std::vector<std::byte>& bytes) {
    return {Hello{"0.1.0 abc", 12},
            FrameReady{{1, 2}, 0x123456789ABCDEF0u},
            TileAnswer{1, 2, 3, 4, 5, 6, true, bytes},
            Progress{1u << 30},
            Trouble{"plug-in missing"},
            CallBytes{bytes},
            TileRequest{9, {1, 7}, {64, 32, 32, 16}, 640, 480, 2048, true, 77},
            FrameOver{{1, 7}, true},
            PictureBytes{{2, 3}, false, bytes},
            Leave{}};
}

TEST(Wire, WhatIsSentArrives) {
    std::mt19937 random(1);
    const std::vector<std::byte> bytes = randomBytes(random, 4097);
    const std::vector<Message> all = samples(bytes);
    ASSERT_EQ(all.size(), std::variant_size_v<Message>);
    for (const Message& message : all) {
        const Packet packet = encode(message);
        const Parsed parsed = parseMessage(*packet);
        ASSERT_EQ(parsed.problem, nullptr) << message.index();
        EXPECT_EQ(parsed.message.index(), message.index());
        EXPECT_EQ(*encode(parsed.message), *packet) << message.index(); // every field
        EXPECT_EQ(messageLength(std::span(*packet).first<kHeaderSize>()), packet->size());
    }
    const Packet request = encode(all[6]);
    const auto tile = std::get<TileRequest>(parseMessage(*request).message);
    EXPECT_EQ(tile.tile.x, 64u);
    EXPECT_EQ(tile.tile.height, 16u);
    EXPECT_EQ(tile.frame, (FrameKey{1, 7}));
    EXPECT_EQ(tile.bytes, 2048u);
}

TEST(Wire, LongTextsAreCut) {
    const Packet packet = encode(Trouble{std::string(5000, 'x')});
    const Parsed parsed = parseMessage(*packet);
    ASSERT_EQ(parsed.problem, nullptr);
    EXPECT_EQ(std::get<Trouble>(parsed.message).text, std::string(kMaxText, 'x'));
}

// The checksum finds every change within one word; others pass with probability 2^-64.
TEST(Wire, DamageIsFoundOut) {
    std::mt19937 random(2);
    const std::vector<std::byte> bytes = randomBytes(random, 300);
    for (const Message& message : samples(bytes)) {
        const Packet packet = encode(message);
        for (std::size_t bit = 0; bit < 8 * packet->size(); ++bit) {
            std::vector<std::byte> damaged = *packet;
            damaged[bit / 8] ^= std::byte(1u << bit % 8);
            EXPECT_NE(parseMessage(damaged).problem, nullptr) << message.index() << " " << bit;
        }
        for (std::size_t length = 0; length < packet->size(); ++length)
            EXPECT_NE(parseMessage(std::span(*packet).first(length)).problem, nullptr);
        std::vector<std::byte> longer = *packet;
        longer.push_back({});
        EXPECT_NE(parseMessage(longer).problem, nullptr);
    }
}

TEST(Wire, OtherVersionsAreNamed) {
    std::vector<std::byte> bytes = *encode(Hello{"x", 1});
    bytes[4] ^= std::byte(1);
    EXPECT_EQ(std::string(parseMessage(bytes).problem), "of another version of this library");
}

// What a program of bad will could send: checksums are right, and wrong values inside.
TEST(Wire, PayloadsAreCheckedBehindTheChecksum) {
    const auto problem = [](const Message& message) {
        const char* const text = parseMessage(*encode(message)).problem;
        return std::string(text ? text : "");
    };
    const TileRequest good{9, {1, 7}, {64, 32, 32, 16}, 640, 480, 2048, false, 0};
    EXPECT_EQ(problem(good), "");
    for (const Tile tile : {Tile{0, 0, 0, 1}, Tile{0, 0, 1, 0}, Tile{0, 0, 33, 1},
                            Tile{0, 0, 1, 33}, Tile{640, 0, 1, 1}, Tile{0, 480, 1, 1},
                            Tile{639, 0, 2, 1}, Tile{0, 479, 1, 2}, Tile{~0u, 0, 32, 1}}) {
        TileRequest bad = good;
        bad.tile = tile;
        EXPECT_EQ(problem(bad), "no such tile");
    }
    const std::vector<std::byte> most(kMaxPart), more(kMaxPart + 1);
    EXPECT_EQ(problem(CallBytes{most}), "");
    EXPECT_NE(problem(CallBytes{more}), "");
}

TEST(Wire, AnythingIsTakenWithoutHarm) {
    std::mt19937 random(3);
    const std::vector<std::byte> bytes = randomBytes(random, 100);
    std::vector<std::vector<std::byte>> seeds;
    for (const Message& message : samples(bytes)) seeds.push_back(*encode(message));
    std::size_t accepted = 0;
    for (int i = 0; i < 200000; ++i) {
        std::vector<std::byte> mutant = seeds[random() % seeds.size()];
        for (unsigned changes = random() % 6; changes > 0 && !mutant.empty(); --changes) {
            const std::size_t at = random() % mutant.size();
            switch (random() % 5) {
                case 0: mutant[at] = std::byte(random()); break;
                case 1: mutant.resize(at); break;
                case 2: mutant.insert(mutant.begin() + std::ptrdiff_t(at), std::byte(at)); break;
                case 3: mutant[at] ^= std::byte(1u << random() % 8); break;
                case 4: mutant.erase(mutant.begin() + std::ptrdiff_t(at)); break;
            }
        }
        const Parsed parsed = parseMessage(mutant);
        if (parsed.problem) continue;
        ++accepted;
        EXPECT_NE(std::find(seeds.begin(), seeds.end(), mutant), seeds.end());
    }
    EXPECT_GT(accepted, 0u);
}

} // namespace
} // namespace smart

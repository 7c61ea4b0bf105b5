// SPDX-License-Identifier: MIT
// Pixels of tiles on their way from a worker to the master: as they are, or packed.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <span>
#include <vector>

#include "libsmart/remote/byte_codec.h"
#include "libsmart/remote/packing_choice.h"
#include "libsmart/render/stored_tile.h"

namespace smart {

enum class Packing { WhenItPays, Never, Always };

/// Memory of a thread, for one tile after the other.
struct PackMemory {
    std::vector<std::byte> planes, packed;
};

/// A worker's side. Packs where that makes more tiles a second, as far as its own figures tell. To
/// keep them right it packs a tile now and then while it does not, and leaves some as they are
/// while it does. Thread-safe.
class AnswerPacker {
public:
    /// Without a codec nothing is packed.
    AnswerPacker(const ByteCodec* codec, Packing packing, unsigned threads);

    /// A stored tile that took a thread this time, as it shall travel: its bytes, or fewer in
    /// `memory`.
    std::span<const std::byte> pack(const StoredLayout& layout, const Tile& tile,
                                    std::span<const std::byte> bytes, double seconds, bool mayPack,
                                    PackMemory& memory);
    /// So many of the bytes that pack() gave have arrived.
    void arrived(uint64_t bytes, PackingChoice::Clock::time_point now);
    /// No tiles are wanted for now.
    void paused();

private:
    bool shallPack(double seconds, bool mayPack);

    const ByteCodec* const codec_;
    const Packing packing_;
    const uint64_t trial_; ///< tiles that are left as they are, to see what the line carries
    std::mutex mutex_;     // guards what follows
    PackingChoice choice_;
    uint64_t tiles_ = 0; ///< since the last trial began, or since packing was found not to pay
    bool pays_ = false;
};

/// The master's side, of the thread that serves all workers: makes tiles whole, and sees whether
/// it has the time to. Others may ask that.
class AnswerUnpacker {
public:
    explicit AnswerUnpacker(const ByteCodec* codec)
        : codec_(codec), choice_(1), mayPack_(codec != nullptr) {}

    /// The stored tile, of so many bytes, valid until the next call. Any bytes are taken. Throws
    /// Error where they are no such tile.
    std::span<const std::byte> unpack(const StoredLayout& layout, const Tile& tile,
                                      std::size_t size, std::span<const std::byte> packed);
    /// An answer of so many bytes was dealt with, since that time.
    void served(PackingChoice::Clock::time_point since, std::size_t bytes);
    /// False: this side would be the slower for it.
    bool mayPack() const { return mayPack_; }

private:
    const ByteCodec* const codec_;
    PackingChoice choice_;
    uint64_t arrived_ = 0;
    double unpackSeconds_ = 0; ///< of this answer
    std::atomic<bool> mayPack_;
    std::vector<std::byte> planes_, whole_;
};

} // namespace smart

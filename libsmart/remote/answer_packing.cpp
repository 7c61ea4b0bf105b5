// SPDX-License-Identifier: MIT
#include "libsmart/remote/answer_packing.h"

#include <algorithm>
#include <utility>

#include "libsmart/base/error.h"
#include "libsmart/remote/tile_planes.h"

namespace smart {
namespace {

using Clock = PackingChoice::Clock;

constexpr double kWorthwhile = 1.1; ///< figures are not that exact
constexpr uint64_t kSample = 64;    ///< one tile of so many is packed to see what that gives
constexpr uint64_t kTrialsApart = 32;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

} // namespace

AnswerPacker::AnswerPacker(const ByteCodec* codec, Packing packing, unsigned threads)
    : codec_(codec), packing_(packing), trial_(64 + 8 * threads), choice_(threads) {}

bool AnswerPacker::shallPack(double seconds, bool mayPack) {
    const std::lock_guard lock(mutex_);
    choice_.worked(seconds);
    if (!codec_ || packing_ == Packing::Never) return false;
    if (packing_ == Packing::Always) return true;
    ++tiles_;
    const bool before = pays_;
    if (!pays_ || tiles_ == trial_) pays_ = choice_.gain() > kWorthwhile;
    if (pays_ && !before) tiles_ = trial_;
    if (!mayPack) return false;
    if (!pays_) return tiles_ % kSample == 0;
    if (tiles_ == kTrialsApart * trial_) tiles_ = 0;
    return tiles_ >= trial_;
}

std::span<const std::byte> AnswerPacker::pack(const StoredLayout& layout, const Tile& tile,
                                              std::span<const std::byte> bytes, double seconds,
                                              bool mayPack, PackMemory& memory) {
    if (!shallPack(seconds, mayPack)) return bytes;
    const Clock::time_point start = Clock::now();
    memory.planes.resize(bytes.size());
    memory.packed.resize(bytes.size() - std::min<std::size_t>(bytes.size(), 1)); // or it is none
    splitTile(layout, tile, bytes.data(), memory.planes.data());
    const std::size_t size = codec_->pack(memory.planes, memory.packed);
    const std::lock_guard lock(mutex_);
    choice_.packed(secondsSince(start), bytes.size(), size == 0 ? bytes.size() : size);
    return size == 0 ? bytes : std::span<const std::byte>(memory.packed).first(size);
}

void AnswerPacker::arrived(uint64_t bytes, Clock::time_point now) {
    const std::lock_guard lock(mutex_);
    choice_.arrived(bytes, now);
}

void AnswerPacker::paused() {
    const std::lock_guard lock(mutex_);
    choice_.paused();
}

std::span<const std::byte> AnswerUnpacker::unpack(const StoredLayout& layout, const Tile& tile,
                                                  std::size_t size,
                                                  std::span<const std::byte> packed) {
    const Clock::time_point start = Clock::now();
    planes_.resize(size);
    whole_.resize(size);
    if (!codec_ || packed.empty() || packed.size() >= size || !codec_->unpack(packed, planes_))
        throw Error(ErrorCode::InvalidOperation, "its packed tile is none");
    joinTile(layout, tile, planes_.data(), whole_.data());
    unpackSeconds_ = secondsSince(start);
    choice_.packed(unpackSeconds_, size, packed.size());
    return whole_;
}

void AnswerUnpacker::served(Clock::time_point since, std::size_t bytes) {
    choice_.worked(secondsSince(since) - std::exchange(unpackSeconds_, 0.0));
    choice_.arrived(arrived_ += bytes, Clock::now());
    const double gain = choice_.gain();
    mayPack_ = codec_ && (gain == 0 || gain >= 1);
}

} // namespace smart

// SPDX-License-Identifier: MIT
#include "compat/recorder/frame_table.h"

#include "libsmart/base/immortal.h"

namespace smart::compat {

FrameTable& frameTable() {
    static Immortal<FrameTable> frames;
    return frames.get();
}

uint32_t FrameTable::add(Frame& frame, const QueuedFramePtr& queued) {
    const std::lock_guard lock(mutex_);
    frame.id = kNoId;
    if (last_ + 1 == kNoId) return kNoId;
    forgetOld();
    frames_.emplace(last_ + 1, queued);
    frame.id = ++last_;
    return last_;
}

// Looks at a few frames with every frame that is added, so that all are looked at in turn and the
// table holds no more than those in flight, the newest, and a share of these.
void FrameTable::forgetOld() {
    constexpr int kLooks = 8;
    auto entry = frames_.lower_bound(sweep_);
    for (int look = 0; look < kLooks; ++look) {
        if (entry == frames_.end() || last_ - entry->first < kRemembered) {
            entry = frames_.begin();
            if (entry == frames_.end() || last_ - entry->first < kRemembered) break;
        }
        const auto& [id, queued] = *entry;
        if (!queued->ended()) {
            ++entry;
            continue;
        }
        const FrameStatus status = queued->status();
        if (status == FrameStatus::Cancelled) outcomes_[id / kChunk].cancelled.set(id % kChunk);
        if (status == FrameStatus::Failed) outcomes_[id / kChunk].failed.set(id % kChunk);
        entry = frames_.erase(entry);
    }
    sweep_ = entry == frames_.end() ? 0 : entry->first;
}

std::optional<KnownFrame> FrameTable::find(uint32_t id) const {
    const std::lock_guard lock(mutex_);
    if (id <= forgotten_ || id > last_) return std::nullopt;
    if (const auto found = frames_.find(id); found != frames_.end())
        return KnownFrame{found->second, found->second->status()};
    const auto chunk = outcomes_.find(id / kChunk);
    if (chunk == outcomes_.end()) return KnownFrame{nullptr, FrameStatus::Done};
    return KnownFrame{nullptr, chunk->second.failed[id % kChunk]      ? FrameStatus::Failed
                               : chunk->second.cancelled[id % kChunk] ? FrameStatus::Cancelled
                                                                      : FrameStatus::Done};
}

void FrameTable::forgetAll() noexcept {
    const std::lock_guard lock(mutex_);
    frames_.clear();
    outcomes_.clear();
    forgotten_ = last_;
}

} // namespace smart::compat

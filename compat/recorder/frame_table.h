// SPDX-License-Identifier: MIT
#pragma once

#include <bitset>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>

#include "libsmart/render/queued_frame.h"

namespace smart::compat {

/// A frame by its id.
struct KnownFrame {
    QueuedFramePtr frame; ///< nullptr: ended long ago, and only how is still known
    FrameStatus status;
};

/// The frames of all contexts by their ids, which count from 1 and are never used again. Only the
/// newest frames are kept once they have ended; of the older ones those that were not done cost
/// two bits. From any thread.
class FrameTable {
public:
    /// So many ids back a frame is still known by more than its outcome.
    static constexpr uint32_t kRemembered = 256;
    /// Of a frame that got none, because all are used up.
    static constexpr uint32_t kNoId = 0xFFFFFFFFu;

    /// Gives a frame, which nobody else knows yet, its id and keeps it; or kNoId.
    uint32_t add(Frame& frame, const QueuedFramePtr& queued);
    std::optional<KnownFrame> find(uint32_t id) const;
    /// Afterwards no id given so far is known.
    void forgetAll() noexcept;

private:
    static constexpr uint32_t kChunk = 1024;
    struct Outcomes {
        std::bitset<kChunk> cancelled, failed;
    };
    void forgetOld();

    mutable std::mutex mutex_; // guards all
    uint32_t last_ = 0;
    uint32_t forgotten_ = 0; ///< ids up to this one mean nothing
    uint32_t sweep_ = 0;     ///< where forgetOld() goes on
    std::map<uint32_t, QueuedFramePtr> frames_;
    std::map<uint32_t, Outcomes> outcomes_; ///< by id / kChunk
};

/// The process's.
FrameTable& frameTable();

} // namespace smart::compat

// SPDX-License-Identifier: MIT
#include "compat/stream/played_frames.h"

#include <algorithm>
#include <utility>

#include "compat/stream/call_player.h"
#include "openrt/rt.h"

namespace smart::compat {

namespace {

bool isInFlight(RTuint frame) {
    const RTenum status = rtFrameStatus(frame);
    return status == RT_QUEUED || status == RT_RENDERING;
}

} // namespace

void PlayedFrames::queued(RTuint frame, const std::vector<uint64_t>& keys) {
    if (frame == RT_INVALID) return;
    for (const uint64_t key : keys) {
        std::deque<RTuint>& frames = queued_[key];
        while (!frames.empty() && !isInFlight(frames.front())) frames.pop_front();
        frames.push_back(frame);
    }
}

void PlayedFrames::started(RTcontext context, std::vector<uint64_t> keys) {
    started_[context] = std::move(keys);
}

void PlayedFrames::await(uint64_t key) {
    for (const auto& [context, keys] : started_)
        if (std::find(keys.begin(), keys.end(), key) != keys.end())
            throw StreamError("a picture before its frame has ended");
    if (const auto found = queued_.find(key); found != queued_.end()) {
        for (const RTuint frame : found->second) rtWaitFrame(frame);
        queued_.erase(found);
    }
}

} // namespace smart::compat

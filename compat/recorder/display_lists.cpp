// SPDX-License-Identifier: MIT
#include "compat/recorder/display_lists.h"

#include <algorithm>
#include <utility>

#include "libsmart/base/error.h"

namespace smart::compat {

void DisplayLists::remove(uint32_t first, uint32_t n) {
    if (n == 0) return;
    const uint32_t last = uint32_t(std::min<uint64_t>(uint64_t(first) + n - 1, 0xFFFFFFFFu));
    names_.remove(first, last);
    lists_.erase(lists_.lower_bound(first), lists_.upper_bound(last));
}

std::shared_ptr<DisplayList> DisplayLists::find(uint32_t name) const {
    const auto found = lists_.find(name);
    return found == lists_.end() ? nullptr : found->second;
}

void DisplayLists::start(uint32_t name, bool executes) {
    if (recording_)
        throw Error(ErrorCode::InvalidOperation, "a display list is under compilation already");
    recording_ = std::make_unique<ListRecording>(name, executes);
}

void DisplayLists::finish() {
    if (!recording_)
        throw Error(ErrorCode::InvalidOperation, "no display list is under compilation");
    const std::unique_ptr<ListRecording> recording = std::exchange(recording_, nullptr);
    auto list = std::make_shared<DisplayList>(recording->finish());
    std::shared_ptr<DisplayList>& place = lists_[recording->name()];
    try {
        names_.add(recording->name());
    } catch (...) {
        if (!place) lists_.erase(recording->name());
        throw;
    }
    place = std::move(list);
}

} // namespace smart::compat

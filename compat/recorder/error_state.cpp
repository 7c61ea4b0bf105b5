// SPDX-License-Identifier: MIT
#include "compat/recorder/error_state.h"

#include <cstring>

#include "compat/recorder/error_log.h"

namespace smart::compat {

namespace {

thread_local RaisedErrors raised;

} // namespace

const RaisedErrors& errorsRaised() noexcept { return raised; }

void ErrorState::raise(ErrorCode code, const char* function, const char* text) noexcept {
    logError(code, function, text);
    raised.recent[raised.count++ % RaisedErrors::kKept] = code;
    if (!first_) {
        first_ = code;
        std::strncpy(text_, text, kTextSize - 1);
        text_[kTextSize - 1] = '\0';
    }
    if (!listener_ || telling_) return;
    // The listener may replace itself, and may throw.
    const std::shared_ptr<ErrorListener> listener = listener_;
    telling_ = true;
    try {
        listener->error(code, function, text);
    } catch (...) {
    }
    telling_ = false;
}

std::optional<ErrorCode> ErrorState::take() noexcept {
    const std::optional<ErrorCode> code = first_;
    first_.reset();
    return code;
}

} // namespace smart::compat

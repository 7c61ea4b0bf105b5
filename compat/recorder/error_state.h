// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include "libsmart/base/error.h"

namespace smart::compat {

/// Is told of every error of a context.
class ErrorListener {
public:
    virtual ~ErrorListener() = default;
    virtual void error(ErrorCode code, const char* function, const char* text) = 0;
};

/// The errors that were raised on a thread, whatever the context.
struct RaisedErrors {
    static constexpr uint64_t kKept = 8;
    uint64_t count = 0;
    ErrorCode recent[kKept] = {};

    /// The first after so many, or the oldest kept. Precondition: count is larger.
    ErrorCode since(uint64_t before) const {
        return recent[(count - before > kKept ? count : before) % kKept];
    }
};
const RaisedErrors& errorsRaised() noexcept;

/// The first error sticks until it is taken; the listener hears of all. Raising never allocates.
class ErrorState {
public:
    void raise(ErrorCode code, const char* function, const char* text) noexcept;
    /// The error that stuck, and forgets it; its text stays readable.
    std::optional<ErrorCode> take() noexcept;
    /// Of the error that sticks, else of the one taken last; never nullptr.
    const char* text() const noexcept { return text_; }
    void setListener(std::shared_ptr<ErrorListener> listener) { listener_ = std::move(listener); }

private:
    static constexpr std::size_t kTextSize = 256;

    std::optional<ErrorCode> first_;
    char text_[kTextSize] = "";
    std::shared_ptr<ErrorListener> listener_;
    bool telling_ = false;
};

} // namespace smart::compat

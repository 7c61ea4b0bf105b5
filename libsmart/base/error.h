// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

namespace smart {

/// The kinds of error a caller can tell apart; OpenGL's.
enum class ErrorCode {
    InvalidEnum,
    InvalidValue,
    InvalidOperation,
    StackOverflow,
    StackUnderflow,
    OutOfMemory
};

/// The only exception type that the library throws on purpose.
class Error : public std::runtime_error {
public:
    Error(ErrorCode code, const std::string& text) : std::runtime_error(text), code_(code) {}
    ErrorCode code() const noexcept { return code_; }

private:
    ErrorCode code_;
};

} // namespace smart

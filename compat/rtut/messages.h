// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace rtut {

/// Tells on stderr and in rtutGetErrorText.
void tell(const char* function, const std::string& text) noexcept;
/// The same, the first time only that this function says so.
void tellOnce(const char* function, const std::string& text) noexcept;
const char* newestMessage() noexcept;

/// Tells and ends the program.
[[noreturn]] void endProgram(int status, const std::string& text);

/// Runs body; an exception becomes a message.
template <class Body>
void guarded(const char* function, Body&& body) noexcept {
    try {
        body();
    } catch (...) {
        tell(function, "out of memory");
    }
}

} // namespace rtut

// SPDX-License-Identifier: MIT
#pragma once

namespace rtut {

/// Tells on stderr and in rtutGetErrorText.
void tell(const char* function, const char* text) noexcept;
/// The same, the first time only that this function says so.
void tellOnce(const char* function, const char* text) noexcept;
const char* newestMessage() noexcept;

/// Tells and ends the program.
[[noreturn]] void endProgram(int status, const char* text, const char* detail = "") noexcept;

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

// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace smart::test {

/// How many rays of a plan to trace: a tenth under a sanitizer, rounded up.
constexpr std::size_t rayCount(std::size_t planned) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    return (planned + 9) / 10;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
    return (planned + 9) / 10;
#else
    return planned;
#endif
#else
    return planned;
#endif
}

} // namespace smart::test

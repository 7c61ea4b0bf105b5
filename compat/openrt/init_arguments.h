// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "libsmart/kernel/kernels.h"

namespace smart::compat {

/// What rtInit's arguments and the environment ask for.
struct InitOptions {
    unsigned threads = 0; ///< 0: all cores
    std::optional<Precision> precision;
    std::optional<unsigned> samples;
};

inline constexpr unsigned kMaxThreads = 1024;
inline constexpr unsigned kMaxSamples = 4096;

/// Threads that OPENRT_THREADS asks for; 0 without it, and in set-uid programs.
unsigned threadsFromEnvironment();

/// Takes the --rt-... arguments out of argv; a bad value prints one line and is ignored.
InitOptions takeInitArguments(int* argcp, char** argv);

} // namespace smart::compat

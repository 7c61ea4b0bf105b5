// SPDX-License-Identifier: MIT
// Arguments for every function of the interface, the same in each process.
#pragma once

#include <cstddef>
#include <cstring>

#include "compat/stream/call_table.h"
#include "openrt/types.h"

namespace smart::compat {

struct EveryCallMemory {
    alignas(16) unsigned char small[4][4096];
    alignas(16) unsigned char zeros[4096];

    /// Small whole numbers, or text.
    void fill() {
        std::memset(zeros, 0, sizeof zeros);
        for (unsigned k = 0; k < 4; ++k)
            for (std::size_t i = 0; i < sizeof small[k]; ++i)
                small[k][i] = i % 4 == 0 && i < 64 ? (unsigned char)(i / 4 % 3 + k + 1) : 0;
    }
};

/// Legal to call, and mostly an error.
void fillArguments(const CallSignature& call, EveryCallMemory& memory, CallValue* arguments);

} // namespace smart::compat

// SPDX-License-Identifier: MIT
// What a test and gate.cpp share.
#pragma once

#include <atomic>

struct GateState {
    std::atomic<int> entered = 0, destroyed = 0;
    std::atomic<bool> open = false;
};
/// The parameter "state": where the GateState is.
struct GateAddress {
    GateState* state;
};

// SPDX-License-Identifier: MIT
// A surface that waits until the test lets it go on.
#include <openrt/plugin.hpp>

#include <atomic>
#include <thread>

#include "tests/plugins/good/gate.h"

namespace {

struct Gate {
    GateState* state = nullptr;
    void registerParams(const openrt::ShaderRegistrator& r) const {
        r.registerParam<GateAddress>("state", openrt::PER_SHADER, offsetof(Gate, state));
    }
    ~Gate() {
        if (state) ++state->destroyed;
    }
    void shade(openrt::TraceContext& c) const {
        ++state->entered;
        while (!state->open) std::this_thread::yield();
        c.setRadiance({0.25f, 0.5f, 0.75f});
    }
};

} // namespace

OPENRT_PLUGIN(Gate, "Gate")

// SPDX-License-Identifier: MIT
#include <openrt/plugin.hpp>

namespace {

struct Blue {
    void shade(openrt::TraceContext& c) const { c.setRadiance({0, 0, 0.5f}); }
};

OPENRT_PLUGIN(Blue, "Blue")

} // namespace

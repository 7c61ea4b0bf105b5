// SPDX-License-Identifier: MIT
// A shader library of an outside project, in C++.
#include <openrt/plugin.hpp>

struct Flat {
    openrt::Color color{0.25f, 0.5f, 1.0f};
    void registerParams(const openrt::ShaderRegistrator& r) const {
        r.registerParam<openrt::Color>("color", openrt::PER_SHADER, offsetof(Flat, color));
    }
    void shade(openrt::TraceContext& c) const { c.setRadiance(color); }
};

OPENRT_PLUGIN(Flat, "Flat")

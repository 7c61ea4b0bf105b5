// SPDX-License-Identifier: MIT
// Classes that throw while they are made known.
#include <openrt/plugin.hpp>

#include <stdexcept>

namespace {

struct OutOfChalk {
    OutOfChalk() { throw std::runtime_error("out of chalk"); }
    void shade(openrt::TraceContext&) const {}
};

struct NoParameters {
    void registerParams(const openrt::ShaderRegistrator&) const {
        throw std::logic_error("no parameters today");
    }
    void shade(openrt::TraceContext&) const {}
};

struct Wordless {
    Wordless() { throw 7; }
    void shade(openrt::TraceContext&) const {}
};

struct TwoOfOneName {
    float a = 0;
    void registerParams(const openrt::ShaderRegistrator& r) const {
        r.registerParam<float>("a", openrt::PER_SHADER, offsetof(TwoOfOneName, a));
        r.registerParam<float>("a", openrt::PER_SHADER, offsetof(TwoOfOneName, a));
    }
    void shade(openrt::TraceContext&) const {}
};

struct Fine {
    void shade(openrt::TraceContext& c) const { c.setRadiance({1, 0, 0}); }
};

OPENRT_PLUGIN(OutOfChalk, "OutOfChalk")
OPENRT_PLUGIN(NoParameters, "NoParameters")
OPENRT_PLUGIN(Wordless, "Wordless")
OPENRT_PLUGIN(TwoOfOneName, "TwoOfOneName")
OPENRT_PLUGIN(Fine, "Fine")

} // namespace

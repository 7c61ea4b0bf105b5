// SPDX-License-Identifier: MIT
// Compiled twice, with another SHADE: two libraries whose classes, inline functions and static
// objects have the same C++ names.
#include <openrt/plugin.hpp>

#include <string>

template <class T>
T& shared() {
    static T value = {};
    return value;
}

struct SameName {
    float level = SHADE;
    static std::string& text() {
        static std::string words = SHADE > 0.5f ? "bright" : "dark, and far longer than inline";
        return words;
    }
    float factor() const { return text() == "bright" ? 1.0f : SHADE; }
    void registerParams(const openrt::ShaderRegistrator& r) const {
        r.registerParam<float>(SHADE > 0.5f ? "bright" : "dark", openrt::PER_SHADER,
                               offsetof(SameName, level));
        shared<float>() += SHADE;
    }
    void shade(openrt::TraceContext& c) const {
        c.setRadiance(openrt::Color(level, factor(), shared<float>()));
    }
};

OPENRT_PLUGIN(SameName, "SameName")

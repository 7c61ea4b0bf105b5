// SPDX-License-Identifier: MIT
// A state with answers given by the test, so that shaders run without scene and renderer.
#pragma once

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <map>
#include <vector>

#include "libsmart/base/error.h"
#include "libsmart/shading/shader_registry.h"

namespace smart::test {

struct FakeTracer {
    // What the shader is told.
    std::vector<RTSlightsample> lights;
    std::array<float, 3> shadowAttenuation{1, 1, 1};
    std::array<float, 3> traced{0, 0, 0};
    int mayTrace = 1;
    std::map<RTuint, std::array<float, 4>> textures;
    std::array<float, 3> environmentAt[2] = {}; ///< of directions with y >= 0, y < 0
    std::function<float()> nextRandom = [] { return 0.5f; };
    // What the shader asked.
    int shadowRays = 0, tracedRays = 0;
    std::array<float, 3> tracedDirection{};
    float tracedWeight = 0;
    std::vector<std::array<float, 3>> directions; ///< of traced and shadow rays

    RTSstate state{};

    FakeTracer() {
        static const RTSfunctions functions = {
            sizeof(RTSfunctions), trace,   traceHit,    shadow, lightCount,
            illuminate,           texture, environment, random};
        state.functions = &functions;
        state.tracer = this;
        setNormal(0, 0, 1);
        setRay(0, 0, -1);
        for (float& c : state.color) c = 1;
        state.weight = 1;
        state.result[3] = 1;
    }
    FakeTracer(const FakeTracer&) = delete;

    void setNormal(float x, float y, float z) {
        const float n[3] = {x, y, z};
        std::copy_n(n, 3, state.shadingNormal);
        std::copy_n(n, 3, state.rawNormal);
        std::copy_n(n, 3, state.geometricNormal);
    }
    void setRay(float x, float y, float z) {
        const float d[3] = {x, y, z};
        std::copy_n(d, 3, state.rayDirection);
        const float* n = state.geometricNormal;
        state.frontFace = d[0] * n[0] + d[1] * n[1] + d[2] * n[2] <= 0;
    }
    /// Runs a shader of a class; the colour that it gave.
    std::array<float, 4> shade(const ShaderObject& shader, int expected = 0) {
        const int result = shader.functions().shade(shader.block(), &state);
        if (result != expected) return {-1, -1, -1, -1};
        return {state.result[0], state.result[1], state.result[2], state.result[3]};
    }

private:
    static FakeTracer& of(const RTSstate* s) { return *static_cast<FakeTracer*>(s->tracer); }
    static int trace(RTSstate* s, const float*, const float d[3], float weight, float radiance[3]) {
        FakeTracer& self = of(s);
        ++self.tracedRays;
        self.tracedWeight = weight;
        std::copy_n(d, 3, self.tracedDirection.begin());
        self.directions.push_back(self.tracedDirection);
        std::copy_n(self.traced.begin(), 3, radiance);
        return self.mayTrace;
    }
    static int traceHit(RTSstate*, const float*, const float*, RTShitinfo* hit) {
        *hit = {};
        return 0;
    }
    static int shadow(RTSstate* s, const float*, const float d[3], float, float attenuation[3]) {
        ++of(s).shadowRays;
        of(s).directions.push_back({d[0], d[1], d[2]});
        std::copy_n(of(s).shadowAttenuation.begin(), 3, attenuation);
        return 1;
    }
    static RTuint lightCount(const RTSstate* s) { return RTuint(of(s).lights.size()); }
    static int illuminate(RTSstate* s, RTuint light, RTSlightsample* sample) {
        *sample = of(s).lights[light];
        return 1;
    }
    static void texture(RTSstate* s, RTuint id, float, float, float rgba[4]) {
        const auto found = of(s).textures.find(id);
        for (std::size_t k = 0; k < 4; ++k)
            rgba[k] = found == of(s).textures.end() ? 1 : found->second[k];
    }
    static void environment(RTSstate* s, const float d[3], float radiance[3]) {
        std::copy_n(of(s).environmentAt[d[1] < 0].begin(), 3, radiance);
    }
    static float random(RTSstate* s) { return of(s).nextRandom(); }
};

template <class T>
std::vector<std::byte> bytesOf(const T& value) {
    std::vector<std::byte> bytes(sizeof(T));
    std::memcpy(bytes.data(), &value, sizeof(T));
    return bytes;
}

/// A shader of a class with some of its parameters set by name.
class MadeShader {
public:
    explicit MadeShader(ShaderClassPtr shaderClass) : class_(std::move(shaderClass)) {}
    explicit MadeShader(const char* builtin) : MadeShader(findBuiltinClass(builtin)) {}

    template <class T>
    MadeShader&& set(const char* name, const T& value) && {
        const int index = class_->findParameter(name);
        if (index < 0) throw Error(ErrorCode::InvalidValue, std::string("no parameter ") + name);
        values_[uint32_t(index)] = bytesOf(value);
        return std::move(*this);
    }
    std::shared_ptr<const ShaderObject> make() && {
        for (const auto& [index, bytes] : values_)
            if (bytes.size() != valueSize(class_->parameter(index)))
                throw Error(ErrorCode::InvalidValue, "size of a parameter");
        return std::make_shared<const ShaderObject>(class_, values_);
    }

private:
    ShaderClassPtr class_;
    ParameterValues values_;
};

} // namespace smart::test

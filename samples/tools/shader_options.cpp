// SPDX-License-Identifier: MIT
#include "samples/tools/shader_options.h"

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace samples {
namespace {

struct Made {
    std::string className;
    RTuint shader;
};

Made makeShader(const std::string& choice) {
    const std::size_t colon = choice.rfind(':');
    const bool builtIn = colon == std::string::npos;
    const std::string name = builtIn ? choice : choice.substr(colon + 1);
    const std::string library = builtIn ? "" : choice.substr(0, colon);
    if (name.empty() || (!builtIn && library.empty()))
        throw CLI::ValidationError("'" + choice + "' is neither LIBRARY:CLASS nor CLASS");
    rtGenNewShaderClass(name.c_str(), builtIn ? nullptr : library.c_str());
    const RTuint shader = rtGenNewShader();
    checkRt();
    return {name, shader};
}

/// Numbers separated by commas; none if it is something else.
std::vector<float> numbersIn(const std::string& text) {
    std::vector<float> numbers;
    const char* at = text.data();
    const char* const end = at + text.size();
    while (at != end) {
        float number = 0.0f;
        const auto [next, error] = std::from_chars(at, end, number);
        if (error != std::errc() || (next != end && *next != ',') || next + 1 == end) return {};
        numbers.push_back(number);
        at = next == end ? end : next + 1;
    }
    return numbers;
}

/// Sets a parameter of the bound shader as float, int or string, whichever it takes.
bool setValue(RTuint handle, const std::string& text) {
    const std::vector<float> n = numbersIn(text);
    const auto accepted = [] { return rtGetError() == RT_NO_ERROR; };
    const auto whole = [&](std::size_t i) { return RTint(std::lround(n[i])); };
    switch (n.size()) {
    case 1: rtParameter1f(handle, n[0]); break;
    case 2: rtParameter2f(handle, n[0], n[1]); break;
    case 3: rtParameter3f(handle, n[0], n[1], n[2]); break;
    case 4: rtParameter4f(handle, n[0], n[1], n[2], n[3]); break;
    case 16: rtParameter16fv(handle, n.data()); break;
    default: rtParameterString(handle, text.c_str()); break;
    }
    if (accepted()) return true;
    for (const float number : n)
        if (number != std::round(number) || std::fabs(number) > 1e9f) return false;
    switch (n.size()) {
    case 1: rtParameter1i(handle, whole(0)); break;
    case 2: rtParameter2i(handle, whole(0), whole(1)); break;
    case 3: rtParameter3i(handle, whole(0), whole(1), whole(2)); break;
    default: return false;
    }
    return accepted();
}

void setVector(const char* name, const glm::vec3& v) {
    rtParameter3fv(rtParameterHandle(name), &v.x);
    rtGetError(); // there may be no such parameter
}

} // namespace

void ShaderOptions::addTo(CLI::App& app) {
    app.add_option("--surface", surface,
                   "LIBRARY:CLASS of a shader library, or CLASS built in: shows everything");
    app.add_option("--camera-shader", camera, "the same: takes the picture");
    app.add_option("--environment", environment, "the same, or a picture by latitude and longitude, .exr .hdr: around the scene");
    app.add_option("--rendering-object", renderingObject, "the same: makes pixels of rays");
    app.add_option("--light-shader", lights, "the same: one more light; repeatable")
        ->allow_extra_args(false);
    app.add_option("--set", values,
                   "CLASS.PARAMETER=VALUE: numbers separated by commas, or a text; repeatable")
        ->allow_extra_args(false);
}

FrameShaders ShaderOptions::make(const View& view, float aspect) const {
    std::vector<Made> made;
    const auto shaderOf = [&](const std::string& choice) -> RTuint {
        return choice.empty() ? 0 : made.emplace_back(makeShader(choice)).shader;
    };
    FrameShaders shaders;
    shaders.surface = shaderOf(surface);
    shaders.environment = shaderOf(environment);
    shaders.renderingObject = shaderOf(renderingObject);
    for (const std::string& light : lights) shaders.lights.push_back(shaderOf(light));
    shaders.camera = shaderOf(camera);
    if (shaders.camera != 0) {
        setVector("origin", view.eye);
        setVector("direction", view.target - view.eye);
        setVector("up", view.up);
        rtParameter1f(rtParameterHandle("aspect"), aspect);
        rtGetError();
    }
    for (const std::string& text : values) {
        const std::size_t dot = text.find('.'), equals = text.find('=');
        if (dot == std::string::npos || equals == std::string::npos || dot > equals)
            throw CLI::ValidationError("--set wants CLASS.PARAMETER=VALUE, not '" + text + "'");
        const std::string className = text.substr(0, dot);
        const std::string parameter = text.substr(dot + 1, equals - dot - 1);
        bool found = false;
        for (const Made& each : made) {
            if (each.className != className) continue;
            found = true;
            rtBindShader(each.shader);
            const RTuint handle = rtParameterHandle(parameter.c_str());
            checkRt();
            if (!setValue(handle, text.substr(equals + 1)))
                throw std::runtime_error("--set " + text + ": not of the parameter's type");
        }
        if (!found) throw std::runtime_error("--set " + text + ": no shader of that class is used");
    }
    rtBindShader(0);
    return shaders;
}

} // namespace samples

// SPDX-License-Identifier: MIT
// Shaders of every built-in class with any values in their parameters, in a small picture.
#include <string>
#include <vector>

#include "openrt/rt.h"
#include "openrt/rts.h"
#include "tests/fuzz/input.h"

namespace openrt::test {
namespace {

constexpr RTuint kSize = 8;
RTubyte pixels[kSize * kSize * 4];

std::vector<std::string> classNames() {
    std::vector<std::string> names(1);
    for (const char* c = rtGetShaderClassNames(nullptr); c && *c; ++c) {
        if (*c == '\n') names.emplace_back();
        else names.back() += *c;
    }
    if (names.back().empty()) names.pop_back();
    return names;
}

/// Interesting values, or the input's own bytes.
float numberOf(Input& input) {
    static const float values[] = {0,     1,     -1,    0.5f,  2,       90,      180,  1e-40f,
                                   1e30f, -1e30f, 3e38f, 1e-7f, INFINITY, -INFINITY, NAN, 1.5f};
    const uint8_t choice = input.byte();
    return choice < 128 ? values[choice % 16] : input.number();
}

void setParameter(const RTSparameter& parameter, Input& input) {
    const RTuint handle = rtParameterHandle(parameter.name);
    float numbers[16];
    switch (parameter.type) {
    case RTS_INT1: return rtParameter1i(handle, RTint(int8_t(input.byte())));
    case RTS_INT2: return rtParameter2i(handle, RTint(int8_t(input.byte())), 1);
    case RTS_INT3: return rtParameter3i(handle, RTint(int8_t(input.byte())), 1, 1);
    case RTS_FLOAT1: return rtParameter1f(handle, numberOf(input));
    case RTS_RAW: {
        const std::vector<unsigned char> bytes(parameter.size, input.byte());
        return rtParameterRaw(handle, bytes.data(), parameter.size);
    }
    case RTS_STRING: {
        const std::string text(input.byte(), char(input.byte() | 1));
        return rtParameterString(handle, text.c_str());
    }
    default: break;
    }
    for (float& number : numbers) number = numberOf(input);
    switch (parameter.type) {
    case RTS_FLOAT2: return rtParameter2fv(handle, numbers);
    case RTS_FLOAT3: return rtParameter3fv(handle, numbers);
    case RTS_FLOAT4: return rtParameter4fv(handle, numbers);
    default: return rtParameter16fv(handle, numbers);
    }
}

void setParameters(const RTshaderclass& shaderClass, Input& input) {
    for (uint8_t n = input.byte() % 8; n > 0 && shaderClass.parameterCount > 0; --n)
        setParameter(shaderClass.parameters[input.byte() % shaderClass.parameterCount], input);
}

/// A shader of a class that the input chooses, in use if it is no surface.
void makeShader(const std::vector<std::string>& names, Input& input) {
    const RTuint id = rtGenNewShaderClass(names[input.byte() % names.size()].c_str(), nullptr);
    const RTshaderclass* const shaderClass = rtGetShaderClassDescriptor(id);
    const RTuint shader = rtGenNewShader();
    if (!shaderClass) return;
    setParameters(*shaderClass, input);
    switch (shaderClass->kind) {
    case RT_LIGHT_SHADER: return rtUseLight(shader);
    case RT_CAMERA_SHADER: return rtUseCamera(shader);
    case RT_ENV_SHADER: return rtUseEnvironmentShader(shader);
    case RT_RENDERING_OBJECT_SHADER: return rtUseRenderingObject(shader);
    default: break;
    }
    rtBegin(RT_TRIANGLES);
    static const float corners[3][3] = {{-1, -1, 0}, {1, -1, 0.25f}, {0, 1, -0.25f}};
    for (const float(&v)[3] : corners) {
        setParameters(*shaderClass, input); // per triangle and per vertex too
        rtTexCoord2f(numberOf(input), v[1]);
        rtVertex3fv(v);
    }
    rtEnd();
}

void run(Input& input) {
    static const RTubyte texels[64] = {255, 0, 0, 255, 0, 255, 0, 255, 9};
    rtInit(nullptr, nullptr);
    static const std::vector<std::string> names = classNames();
    rtThreads(1);
    rtRecursionLimit(3);
    rtSetFrameBuffer(pixels, kSize, kSize, RT_RGBA_8);
    rtBindTexture(RT_TEXTURE_2D, 1);
    rtTexImage2D(RT_TEXTURE_2D, 0, RT_RGBA, 4, 4, 0, RT_RGBA, RT_UNSIGNED_BYTE, texels);
    for (int i = 0; i < 8 && !input.atEnd(); ++i) makeShader(names, input);
    rtRender();
    rtExit();
}

} // namespace
} // namespace openrt::test

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
    openrt::test::Input input(data, size);
    openrt::test::run(input);
    return 0;
}

// SPDX-License-Identifier: MIT
// Descriptors of shader classes, whose every number is the input's; the pointers lead somewhere.
#include <cstring>
#include <memory>

#include "openrt/rt.h"
#include "openrt/rts.h"
#include "tests/fuzz/input.h"

namespace openrt::test {
namespace {

constexpr RTuint kSize = 8, kParameters = 12;
RTubyte pixels[kSize * kSize * 4];

int construct(void*, void*, void*) {
    return 0;
}
int shade(const void*, RTSstate* state) {
    rtsResultColor(state, 1, 0.5f, 0);
    return 0;
}
int illuminate(const void*, const float*, RTSlightsample* sample) {
    *sample = {{0, 0, 1}, 1, {1, 1, 1}};
    return 1;
}
int cameraRay(const void*, float x, float y, RTScameraray* ray) {
    ray->origin[0] = x;
    ray->origin[1] = y;
    ray->direction[2] = -1;
    return 0;
}
int renderPixel(const void*, RTSpixel* pixel, float rgba[4]) {
    pixel->trace(pixel, 0.5f, 0.5f, rgba);
    return 0;
}

RTuint smallNumber(Input& input) {
    const uint8_t choice = input.byte();
    if (choice < 240) return choice;
    return choice == 255 ? 0xFFFFFFFFu : RTuint(1) << (choice - 240 + 16);
}

void run(Input& input) {
    static const char* const names[] = {"",     "a", "b", "color", "a long name of a parameter",
                                        nullptr};
    RTSparameter parameters[kParameters];
    for (RTSparameter& parameter : parameters) {
        parameter.name = names[input.byte() % 6];
        parameter.scope = RTSscope(input.byte() % 4);
        parameter.type = RTStype(input.byte() % 12);
        parameter.offset = smallNumber(input);
        parameter.size = smallNumber(input);
    }
    RTshaderclass descriptor = {};
    descriptor.structSize = input.byte() & 1 ? RTuint(sizeof descriptor) : smallNumber(input);
    // A size beyond the structure promises memory that is not there.
    if (descriptor.structSize > sizeof descriptor) descriptor.structSize = sizeof descriptor;
    descriptor.interfaceVersion = input.byte() & 3 ? RTS_INTERFACE_VERSION : smallNumber(input);
    descriptor.kind = RT_SURFACE_SHADER + input.byte() % 6;
    descriptor.name = names[input.byte() % 6];
    descriptor.shaderSize = smallNumber(input);
    descriptor.triangleSize = smallNumber(input);
    descriptor.vertexSize = smallNumber(input);
    descriptor.alignment = input.byte() & 1 ? 16 : smallNumber(input);
    descriptor.parameters = input.byte() == 1 ? nullptr : parameters;
    descriptor.parameterCount = input.byte() % (kParameters + 1);
    const uint8_t functions = uint8_t(~input.byte());
    if (functions & 1) descriptor.construct = construct;
    if (functions & 2) descriptor.shade = shade;
    if (functions & 4) descriptor.illuminate = illuminate;
    if (functions & 8) descriptor.cameraRay = cameraRay;
    if (functions & 16) descriptor.renderPixel = renderPixel;

    rtInit(nullptr, nullptr);
    rtThreads(1);
    rtSetFrameBuffer(pixels, kSize, kSize, RT_RGBA_8);
    if (rtRegisterShaderClass(&descriptor) != RT_INVALID) {
        const RTuint shader = rtGenNewShader();
        const float numbers[16] = {1, 2, 3, 4};
        for (RTuint i = 0; i < descriptor.parameterCount; ++i) {
            const RTuint handle = rtParameterHandle(parameters[i].name);
            rtParameter1i(handle, 1);
            rtParameter3fv(handle, numbers);
            rtParameter16fv(handle, numbers);
            rtParameterString(handle, "text");
        }
        rtUseLight(shader);
        rtUseCamera(shader);
        rtUseEnvironmentShader(shader);
        rtUseRenderingObject(shader);
        rtBegin(RT_TRIANGLE_FAN);
        for (int i = 0; i < 4; ++i) rtVertex3f(float(i % 2) - 0.5f, float(i / 2) - 0.5f, 0);
        rtEnd();
        rtRender();
    }
    rtExit();
}

} // namespace
} // namespace openrt::test

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
    openrt::test::Input input(data, size);
    openrt::test::run(input);
    return 0;
}

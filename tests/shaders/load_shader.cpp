// SPDX-License-Identifier: MIT
// load_shader LIBRARY CLASS...: loads each class and renders a frame that uses it; says what is
// wrong, and fails then.
#include <array>
#include <cmath>
#include <cstdio>

#include "openrt/rt.h"

namespace {

bool failed(const char* what) {
    const RTenum error = rtGetError();
    if (error == RT_NO_ERROR) return false;
    std::fprintf(stderr, "%s: %s\n", what, rtGetErrorText());
    return true;
}

RTuint builtin(const char* name) {
    rtGenNewShaderClass(name, nullptr);
    return rtGenNewShader();
}

/// True if the frame takes the shader in one of its roles, each a call of the interface.
bool use(RTuint shader) {
    for (const auto call : {rtUseLight, rtUseEnvironmentShader, rtUseCamera,
                            rtUseRenderingObject}) {
        call(shader);
        if (rtGetError() == RT_NO_ERROR) return true;
    }
    return false;
}

bool render(const char* library, const char* name) {
    static std::array<float, 32 * 32 * 4> pixels;
    rtInit(nullptr, nullptr);
    rtSetFrameBuffer(reinterpret_cast<RTubyte*>(pixels.data()), 32, 32, RT_RGBA_32F);
    rtUseLight(builtin("DirectionalLight"));
    const RTuint plain = builtin("Phong");
    rtGenNewShaderClass(name, library);
    const RTuint shader = rtGenNewShader();
    if (failed(name)) return false;
    const bool isSurface = !use(shader);
    rtBindShader(isSurface ? shader : plain);
    rtBegin(RT_QUADS);
    rtVertex3f(-1, -0.5f, -0.5f);
    rtVertex3f(0.5f, -1, 0.2f);
    rtVertex3f(1, 0.5f, 0.5f);
    rtVertex3f(-0.5f, 1, -0.2f);
    rtEnd();
    rtRender();
    if (failed(name)) return false;
    for (const float value : pixels)
        if (!std::isfinite(value)) return false;
    rtExit();
    return true;
}

} // namespace

int main(int argc, char** argv) {
    int failures = argc < 3;
    for (int i = 2; i < argc; ++i) failures += !render(argv[1], argv[i]);
    return failures;
}

// SPDX-License-Identifier: MIT
// openrt-texture-floor FILE: the picture of docs/textures.md. A floor of tiles to the horizon with
// one sample a pixel; left half RT_LINEAR, right half RT_LINEAR_MIPMAP_LINEAR.
#include <cstdio>
#include <cstring>
#include <vector>

#include "openrt/rt.h"
#include "samples/common/refuse_options.h"
#include "samples/common/write_png.h"

namespace {

constexpr RTuint kHalf = 200, kHeight = 150, kTexels = 64;

RTuint makeTiles(RTint minFilter) {
    std::vector<RTubyte> texels;
    for (RTuint y = 0; y < kTexels; ++y)
        for (RTuint x = 0; x < kTexels; ++x) {
            const bool joint = x % 32 < 2 || y % 32 < 2, light = (x / 32 + y / 32) % 2 != 0;
            const RTubyte color[3] = {RTubyte(light ? 236 : 70), RTubyte(light ? 226 : 92),
                                      RTubyte(light ? 205 : 112)};
            for (const RTubyte c : color) texels.push_back(joint ? 40 : c);
        }
    RTuint texture = 0;
    rtGenTextures(1, &texture);
    rtBindTexture(RT_TEXTURE_2D, texture);
    rtTexParameteri(RT_TEXTURE_2D, RT_TEXTURE_MIN_FILTER, minFilter);
    rtTexParameteri(RT_TEXTURE_2D, RT_GENERATE_MIPMAP, RT_TRUE);
    rtTexImage2D(RT_TEXTURE_2D, 0, RT_SRGB8, kTexels, kTexels, 0, RT_RGB, RT_UNSIGNED_BYTE,
                 texels.data());
    return texture;
}

/// Half of the picture, RGBA.
std::vector<RTubyte> render(RTint minFilter) {
    std::vector<RTubyte> pixels(std::size_t(4) * kHalf * kHeight);
    rtInit(nullptr, nullptr);
    rtSetFrameBuffer(pixels.data(), kHalf, kHeight, RT_RGBA_8);
    rtEnable(RT_FRAMEBUFFER_SRGB);
    rtClearColor(0.45f, 0.62f, 0.85f, 1.0f);
    rtGenNewShaderClass("TextureShader", nullptr);
    rtGenNewShader();
    rtParameter1i(rtParameterHandle("texture"), RTint(makeTiles(minFilter)));

    rtMatrixMode(RT_PROJECTION);
    rtPerspective(50.0, double(kHalf) / kHeight, 0.1, 10000.0);
    rtMatrixMode(RT_MODELVIEW);
    rtLookAt(0, 1, 0, 0.25, 0.8, -1, 0, 1, 0);
    constexpr float kFar = 3000;
    rtBegin(RT_QUADS);
    for (int i = 0; i < 4; ++i) {
        const float x = i == 1 || i == 2 ? kFar : -kFar, z = i < 2 ? kFar : -kFar;
        rtTexCoord2f(x * 0.5f, z * 0.5f);
        rtVertex3f(x, 0, z);
    }
    rtEnd();
    rtRender();
    rtExit();
    return pixels;
}

} // namespace

int main(int count, char* arguments[]) {
    constexpr const char* kUsage = "openrt-texture-floor FILE";
    refuseOptions(count, arguments, kUsage);
    if (count != 2) {
        std::fprintf(stderr, "usage: %s\n", kUsage);
        return 2;
    }
    const std::vector<RTubyte> left = render(RT_LINEAR), right = render(RT_LINEAR_MIPMAP_LINEAR);
    std::vector<RTubyte> both(2 * left.size());
    constexpr std::size_t kRow = 4 * kHalf;
    for (std::size_t y = 0; y < kHeight; ++y) {
        std::memcpy(&both[2 * y * kRow], &left[y * kRow], kRow);
        std::memcpy(&both[(2 * y + 1) * kRow], &right[y * kRow], kRow);
    }
    return writePng(arguments[1], both.data(), 2 * kHalf, kHeight) ? 0 : 1;
}

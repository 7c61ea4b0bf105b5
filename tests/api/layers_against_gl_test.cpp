// SPDX-License-Identifier: MIT
// Layers, order and fragment operations against pictures of OpenGL's.
#include <GL/osmesa.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "openrt/rt.h"
#include "tests/api/layer_scenes.h"

namespace {

constexpr int kSize = 64;

struct Picture {
    std::vector<unsigned char> colors = std::vector<unsigned char>(kSize * kSize * 4);
    std::vector<float> depths = std::vector<float>(kSize * kSize);

    const unsigned char* at(int x, int y) const { return &colors[std::size_t(y * kSize + x) * 4]; }
};

Picture drawnByGl(const LayerScene& scene) {
    Picture picture;
    std::vector<unsigned char> memory(kSize * kSize * 4);
    const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, nullptr);
    EXPECT_TRUE(
        OSMesaMakeCurrent(context, memory.data(), 0x1401 /* bytes */, kSize, kSize));
    scene.draw();
    glReadPicture(picture.colors.data(), picture.depths.data());
    OSMesaDestroyContext(context);
    return picture;
}

Picture drawnByRt(const LayerScene& scene) {
    Picture picture;
    std::vector<unsigned char> memory(kSize * kSize * 4);
    rtInit(nullptr, nullptr);
    rtThreads(1);
    rtSetFrameBuffer(memory.data(), kSize, kSize, RT_RGBA_8);
    scene.draw();
    rtReadPicture(picture.colors.data(), picture.depths.data());
    EXPECT_EQ(rtGetError(), unsigned(RT_NO_ERROR)) << scene.name << ": " << rtGetErrorText();
    rtExit();
    return picture;
}

bool sameColor(const unsigned char* a, const unsigned char* b) {
    for (int k = 0; k < 4; ++k)
        if (std::abs(int(a[k]) - int(b[k])) > 1) return false;
    return true;
}

/// Whether the pixel, or one beside it, is of another colour or depth than its neighbours: at
/// edges that pass near a centre rounding decides.
bool isAtEdge(const Picture& picture, int x, int y) {
    const unsigned char* const centre = picture.at(x, y);
    for (int j = std::max(y - 1, 0); j <= std::min(y + 1, kSize - 1); ++j)
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, kSize - 1); ++i)
            if (!sameColor(picture.at(i, j), centre) ||
                std::fabs(picture.depths[std::size_t(j * kSize + i)] -
                          picture.depths[std::size_t(y * kSize + x)]) > 0.01f)
                return true;
    return false;
}

struct Differences {
    int inside = 0, atEdges = 0;
};

Differences compare(const Picture& gl, const Picture& rt) {
    Differences found;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            const auto i = std::size_t(y * kSize + x);
            if (sameColor(gl.at(x, y), rt.at(x, y)) &&
                std::fabs(gl.depths[i] - rt.depths[i]) <= 2e-6f)
                continue;
            ++(isAtEdge(gl, x, y) ? found.atEdges : found.inside);
        }
    return found;
}

TEST(LayersAgainstGl, Pictures) {
    int scenes = 0;
    for (int i = 0; glLayerScenes[i].name; ++i, ++scenes) {
        const Picture gl = drawnByGl(glLayerScenes[i]), rt = drawnByRt(rtLayerScenes[i]);
        const Differences found = compare(gl, rt);
        EXPECT_EQ(found.inside, 0) << glLayerScenes[i].name;
        // Edges lie at whole pixels or through centres, but for those in space.
        EXPECT_LE(found.atEdges, 4) << glLayerScenes[i].name;
    }
    EXPECT_EQ(scenes, 16);
}

TEST(LayersAgainstGl, EachPictureDiffersFromTheNext) {
    for (int i = 0; glLayerScenes[i + 1].name; ++i) {
        const Differences found =
            compare(drawnByGl(glLayerScenes[i]), drawnByRt(rtLayerScenes[i + 1]));
        EXPECT_GT(found.inside, 50) << glLayerScenes[i].name;
    }
}

} // namespace

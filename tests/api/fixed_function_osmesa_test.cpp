// SPDX-License-Identifier: MIT
// Pictures of fixed function by Mesa and by the library, from the same source.
#include <GL/osmesa.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "openrt/rt.h"
#include "tests/api/fixed_function_scenes.h"

namespace {

constexpr std::size_t kBytes = std::size_t(SCENE_SIDE) * SCENE_SIDE * 4;
using Pixels = std::vector<uint8_t>;

Pixels drawnByMesa(unsigned features, unsigned seed) {
    Pixels pixels(kBytes);
    const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, nullptr);
    EXPECT_TRUE(OSMesaMakeCurrent(context, pixels.data(), GL_UNSIGNED_BYTE, SCENE_SIDE,
                                  SCENE_SIDE));
    drawWithMesa(features, seed);
    glFinish();
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    OSMesaDestroyContext(context);
    return pixels;
}

Pixels drawnByLibrary(unsigned features, unsigned seed) {
    Pixels pixels(kBytes);
    rtInit(nullptr, nullptr);
    rtThreads(1);
    rtSetFrameBuffer(pixels.data(), SCENE_SIDE, SCENE_SIDE, RT_RGBA_8);
    drawWithLibrary(features, seed);
    rtRender();
    EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR));
    rtExit();
    return pixels;
}

struct Difference {
    double mean = 0; ///< in steps of 8 bits
    int most = 0;    ///< of all but a hundredth of the values
    double shown = 0; ///< share of the first one's pixels that are not the background
};

Difference between(const Pixels& a, const Pixels& b) {
    Difference result;
    std::vector<int> steps;
    for (std::size_t i = 0; i < kBytes; ++i) {
        steps.push_back(std::abs(int(a[i]) - int(b[i])));
        result.mean += steps.back() / double(kBytes);
        if (i % 4 == 0 && (a[i] | a[i + 1] | a[i + 2] | a[i + 3]) != 0)
            result.shown += 4.0 / kBytes;
    }
    std::sort(steps.begin(), steps.end());
    result.most = steps[std::size_t(0.99 * double(steps.size()))];
    return result;
}

Difference compare(unsigned features, unsigned seed) {
    return between(drawnByMesa(features, seed), drawnByLibrary(features, seed));
}

class FixedFunctionAndMesa : public testing::Test {
protected:
    void expectSame(unsigned features, unsigned seed);
    void TearDown() override {
        if (scenes > 0) { EXPECT_GT(shown / scenes, 0.2); } // some environments make all black
    }
    double shown = 0;
    int scenes = 0;
};

void FixedFunctionAndMesa::expectSame(unsigned features, unsigned seed) {
    const Difference found = compare(features, seed);
    EXPECT_LE(found.mean, 0.5) << "features 0x" << std::hex << features << " seed " << seed;
    EXPECT_LE(found.most, 2) << "features 0x" << std::hex << features << " seed " << seed;
    shown += found.shown;
    ++scenes;
}

constexpr unsigned kMipmapped = SCENE_MIPMAPS;

TEST_F(FixedFunctionAndMesa, OneFeatureAtATime) {
    expectSame(0, 1);
    for (int bit = 0; bit < SCENE_FEATURES; ++bit) {
        unsigned features = 1u << bit;
        if (features == kMipmapped) continue;
        if (bit > 0 && bit < 7) features |= SCENE_LIGHTS;
        if (features & (SCENE_TEXGEN | SCENE_TEXTURE_MATRIX | SCENE_NAMED_TEXTURE))
            features |= SCENE_TEXTURE;
        if (features & (SCENE_RESCALE | SCENE_FLAT | SCENE_LIST)) features |= SCENE_LIGHTS;
        for (unsigned seed = 1; seed <= 2; ++seed) expectSame(features, seed);
    }
}

TEST_F(FixedFunctionAndMesa, TexturesAndTheirEnvironment) {
    for (unsigned seed = 1; seed <= 24; ++seed)
        expectSame(SCENE_TEXTURE | (seed % 2 ? SCENE_LIGHTS | SCENE_SEPARATE_SPECULAR : 0), seed);
    for (unsigned seed = 1; seed <= 8; ++seed)
        expectSame(SCENE_TEXTURE | SCENE_TEXGEN | (seed % 2 ? SCENE_LIST : 0), seed);
}

TEST_F(FixedFunctionAndMesa, ManyFeaturesAtOnce) {
    std::mt19937 engine(3);
    for (unsigned seed = 1; seed <= 30; ++seed)
        expectSame(unsigned(engine()) % (1u << SCENE_FEATURES) & ~kMipmapped, seed);
}

TEST_F(FixedFunctionAndMesa, ComparisonSeesADifference) {
    const unsigned scene = SCENE_LIGHTS;
    const Pixels mesa = drawnByMesa(scene, 1);
    for (const unsigned other :
         {SCENE_LOCAL_VIEWER, SCENE_ATTENUATION, SCENE_FLAT, SCENE_FOG, SCENE_TEXTURE,
          SCENE_TURNED, SCENE_ORTHO}) {
        const Difference found = between(mesa, drawnByLibrary(scene | other, 1));
        EXPECT_TRUE(found.mean > 0.5 || found.most > 2) << other;
    }
    EXPECT_GT(between(mesa, drawnByLibrary(scene, 2)).mean, 0.5);
}

// The choice of levels is Mesa's own to some degree: the specification lets it take the larger of
// the distances of s and t instead of their root of squares.
TEST_F(FixedFunctionAndMesa, Mipmaps) {
    for (unsigned seed = 1; seed <= 6; ++seed) {
        const Difference found =
            compare(SCENE_TEXTURE | SCENE_MIPMAPS | SCENE_TEXTURE_MATRIX, seed);
        EXPECT_LE(found.mean, 1.0) << seed; // a level is 30
        RecordProperty("mean" + std::to_string(seed), std::to_string(found.mean));
        EXPECT_GT(found.shown, 0.2);
    }
}

} // namespace

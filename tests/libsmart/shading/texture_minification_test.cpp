// SPDX-License-Identifier: MIT
// Which level a footprint leads to, and how levels are mixed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "libsmart/shading/texture.h"

namespace smart {
namespace {

constexpr TextureFilter kNearest = TextureFilter::Nearest, kLinear = TextureFilter::Linear;

/// Each texel of a level has the level's number as its value.
std::shared_ptr<const TextureLevels> numberedLevels(uint32_t width, uint32_t height) {
    std::vector<TextureImagePtr> images;
    const uint32_t count = levelCount(width, height);
    for (uint32_t n = 0; n < count; ++n) {
        const std::vector<float> values(std::size_t(width) * height, float(n));
        std::vector<std::byte> texels(values.size() * sizeof(float));
        std::memcpy(texels.data(), values.data(), texels.size());
        images.push_back(std::make_shared<const TextureImage>(width, height, 1, TexelType::Float,
                                                              false, std::move(texels)));
        width = nextLevelSide(width);
        height = nextLevelSide(height);
    }
    return std::make_shared<const TextureLevels>(std::move(images), count);
}

// OpenGL 1.5, sections 3.8.8 and 3.8.9: the level, or mixture of levels, of a level of detail;
// magnification is level 0.
double levelByOpenGL(double lambda, TextureFilter magnification, MinificationFilter min,
                     double last) {
    const double c = magnification == kLinear && min.filter == kNearest &&
                             min.levels != LevelChoice::First
                         ? 0.5
                         : 0.0;
    if (lambda <= c || min.levels == LevelChoice::First) return 0;
    if (min.levels == LevelChoice::Nearest) {
        if (lambda <= 0.5) return 0;
        return std::min(std::ceil(lambda + 0.5) - 1, last);
    }
    return std::clamp(lambda, 0.0, last);
}

TEST(TextureMinificationTest, SixFiltersTakeTheLevelsThatOpenGLSays) {
    const auto levels = numberedLevels(64, 16); // 7 levels; sqrt(64 * 16) = 32 texels a side
    for (const TextureFilter magnification : {kNearest, kLinear})
        for (const TextureFilter filter : {kNearest, kLinear})
            for (const LevelChoice choice :
                 {LevelChoice::First, LevelChoice::Nearest, LevelChoice::Linear}) {
                const MinificationFilter min{filter, choice};
                const Texture t(levels, {.magnification = magnification, .minification = min});
                for (double lambda = -3.05; lambda < 9; lambda += 0.1) {
                    const auto footprint = float(std::exp2(lambda) / 32);
                    EXPECT_NEAR(double(t.sample(0.3f, 0.6f, footprint).r),
                                levelByOpenGL(lambda, magnification, min, 6), 1e-5)
                        << lambda << " " << int(filter) << int(choice);
                }
            }
}

TEST(TextureMinificationTest, BiasAndLimits) {
    const auto levels = numberedLevels(64, 64);
    const auto at = [&](double lambda, const TextureOptions& o) {
        return double(Texture(levels, o).sample(0.5f, 0.5f, float(std::exp2(lambda) / 64)).r);
    };
    EXPECT_NEAR(at(2.25, {.levelBias = 1.5f}), 3.75, 1e-5);
    EXPECT_NEAR(at(2.25, {.levelBias = -3.0f}), 0, 1e-5);
    EXPECT_NEAR(at(-2, {.levelBias = 1e30f}), 6, 1e-5);
    EXPECT_NEAR(at(2.25, {.minLevel = 3.5f}), 3.5, 1e-5);
    EXPECT_NEAR(at(-9, {.minLevel = 3.5f}), 3.5, 1e-5);
    EXPECT_NEAR(at(5, {.maxLevel = 1.25f}), 1.25, 1e-5);
    EXPECT_NEAR(at(5, {.maxLevel = -1.0f}), 0, 1e-5);
    // The level of detail counts from the base level, which has a quarter of the texels a side.
    EXPECT_NEAR(at(3.5, {.firstLevel = 2}), 3.5, 1e-5);
    EXPECT_NEAR(at(-3, {.firstLevel = 2}), 2, 1e-5);
    EXPECT_NEAR(at(9, {.lastLevel = 4}), 4, 1e-5);
    EXPECT_NEAR(at(9, {.firstLevel = 3, .lastLevel = 1}), 3, 1e-5);
    EXPECT_NEAR(at(9, {.firstLevel = 99}), 6, 1e-5);
    const float nan = std::nanf("");
    EXPECT_NEAR(at(2.25, {.levelBias = nan, .minLevel = nan, .maxLevel = nan}), 2.25, 1e-5);
}

TEST(TextureMinificationTest, FootprintsThatAreNone) {
    const Texture t(numberedLevels(16, 16), {});
    constexpr float kInf = std::numeric_limits<float>::infinity();
    EXPECT_EQ(t.sample(0.5f, 0.5f, 0.0f).r, 0);
    EXPECT_EQ(t.sample(0.5f, 0.5f, -1.0f).r, 0);
    EXPECT_EQ(t.sample(0.5f, 0.5f, std::nanf("")).r, 0);
    EXPECT_EQ(t.sample(0.5f, 0.5f, 1e-45f).r, 0);
    EXPECT_EQ(t.sample(0.5f, 0.5f, kInf).r, 4);
    EXPECT_EQ(t.sample(0.5f, 0.5f, 3e38f).r, 4);
    EXPECT_EQ(t.sample(std::nanf(""), 0.5f, 1.0f), glm::vec4(0, 0, 0, 1));
    const Texture low(numberedLevels(16, 16), {.minLevel = -1e30f});
    EXPECT_EQ(low.sample(0.5f, 0.5f, 1e-45f).r, 0);
}

std::shared_ptr<const TextureLevels> randomLevels(uint32_t width, uint32_t height) {
    std::mt19937 random(23);
    std::vector<std::byte> texels(std::size_t(width) * height * 3);
    for (std::byte& b : texels) b = std::byte(random() % 256);
    const auto image = std::make_shared<const TextureImage>(width, height, 3, TexelType::Byte,
                                                            true, std::move(texels));
    return std::make_shared<const TextureLevels>(std::vector<TextureImagePtr>{image},
                                                 levelCount(width, height));
}

float distance(const glm::vec4& a, const glm::vec4& b) {
    float largest = 0;
    for (int k = 0; k < 4; ++k) largest = std::max(largest, std::fabs(a[k] - b[k]));
    return largest;
}

TEST(TextureMinificationTest, TrilinearLookUpsChangeLittleWithLevelAndPlace) {
    for (const auto& [width, height] : {std::pair{32u, 32u}, {37u, 21u}}) {
        const Texture t(randomLevels(width, height), {});
        const auto side = float(std::sqrt(double(width) * height));
        glm::vec4 before = t.sample(0.4f, 0.7f, std::exp2(-1.0f) / side);
        for (float lambda = -1; lambda < 7; lambda += 1.0f / 256) {
            const glm::vec4 now = t.sample(0.4f, 0.7f, std::exp2(lambda) / side);
            EXPECT_LE(distance(now, before), 1.01f / 256) << lambda; // texels lie in 0..1
            before = now;
        }
        // Along a line through several copies, at every level: the borders are no exception.
        for (float lambda = 0.3f; lambda < 6; lambda += 0.7f) {
            const float footprint = std::exp2(lambda) / side;
            const float texels = 2.0f * float(width) / 1024; // of the two levels, per step
            before = t.sample(-1.5f, 0.3f, footprint);
            for (float s = -1.5f; s < 1.5f; s += 1.0f / 1024) {
                const glm::vec4 now = t.sample(s, 0.3f, footprint);
                EXPECT_LE(distance(now, before), texels + 1e-5f) << s;
                before = now;
                EXPECT_EQ(now, t.sample(s + 2, 0.3f, footprint)) << s;
            }
            const glm::vec4 left = t.sample(1e-7f, 0.3f, footprint);
            const glm::vec4 right = t.sample(std::nextafter(1.0f, 0.0f), 0.3f, footprint);
            EXPECT_LE(distance(left, right), 1e-4f) << lambda;
            EXPECT_EQ(t.sample(0.0f, 0.3f, footprint), t.sample(1.0f, 0.3f, footprint));
            EXPECT_EQ(t.sample(0.3f, 0.0f, footprint), t.sample(0.3f, 1.0f, footprint));
        }
    }
}

TEST(TextureMinificationTest, TheSeamCheckerSeesASeam) {
    const Texture t(randomLevels(32, 32), {.wrapS = TextureWrap::ClampToEdge});
    const float footprint = 3.0f / 32;
    EXPECT_GT(distance(t.sample(1e-7f, 0.3f, footprint),
                       t.sample(std::nextafter(1.0f, 0.0f), 0.3f, footprint)),
              0.02f);
}

TEST(TextureMinificationTest, TheCoarsestLevelIsTheMean) {
    const auto levels = randomLevels(64, 64);
    const Texture t(levels, {});
    double mean = 0;
    std::vector<float> row(64 * 3);
    for (uint32_t y = 0; y < 64; ++y) {
        levels->first().readRow(y, row.data());
        for (std::size_t i = 0; i < row.size(); i += 3) mean += double(row[i]) / 4096;
    }
    EXPECT_NEAR(double(t.sample(0.1f, 0.9f, 5.0f).r), mean, 0.01);
}

TEST(TextureMinificationTest, FiltersThatNeedNoLevelsMakeNone) {
    const auto levels = randomLevels(64, 64);
    for (const MinificationFilter min : {MinificationFilter{kNearest, LevelChoice::First},
                                         MinificationFilter{kLinear, LevelChoice::First}}) {
        const Texture t(levels, {.minification = min});
        for (const float footprint : {0.0f, 0.1f, 3.0f}) t.sample(0.2f, 0.3f, footprint);
        EXPECT_EQ(t.bytes(), 64u * 64 * 3);
    }
    const Texture t(levels, {});
    t.sample(0.2f, 0.3f, 0.01f);
    EXPECT_EQ(t.bytes(), 64u * 64 * 3) << "magnification";
    t.sample(0.2f, 0.3f, 0.1f);
    EXPECT_EQ(t.bytes(), 3u * (4096 + 1024 + 256 + 64 + 16 + 4 + 1));
    EXPECT_EQ(t.withOptions({.wrapS = TextureWrap::Mirror}).bytes(), t.bytes()) << "shared";
}

} // namespace
} // namespace smart

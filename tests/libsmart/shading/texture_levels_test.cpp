// SPDX-License-Identifier: MIT
#include "libsmart/shading/texture_levels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <random>
#include <thread>

#include "libsmart/base/error.h"

namespace smart {
namespace {

constexpr TexelType kTypes[] = {TexelType::Byte, TexelType::Short, TexelType::Half,
                                TexelType::Float};

TextureImage made(uint32_t width, uint32_t height, uint32_t channels, TexelType type, bool srgb,
                  const std::vector<double>& linear) {
    std::vector<std::byte> texels(linear.size() * bytesPerChannel(type));
    encodeTexels(linear.data(), linear.size(), channels, type, srgb, texels.data());
    // encodeTexels gives linear numbers for Half and Float: those are not to be decoded again.
    const bool encoded = srgb && (type == TexelType::Byte || type == TexelType::Short);
    return TextureImage(width, height, channels, type, encoded, std::move(texels));
}

std::vector<double> randomValues(std::size_t count, uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> value(0, 1);
    std::vector<double> values(count);
    for (double& v : values) v = value(random);
    return values;
}

std::vector<float> valuesOf(const TextureImage& image) {
    const std::size_t row = std::size_t(image.width()) * image.channels();
    std::vector<float> values(row * image.height());
    for (uint32_t y = 0; y < image.height(); ++y) image.readRow(y, &values[y * row]);
    return values;
}

// Length of what the i-th of m parts of [0, 1] and the j-th of n have in common.
double shared(uint32_t i, uint32_t m, uint32_t j, uint32_t n) {
    const double low = std::max(double(i) / m, double(j) / n);
    const double high = std::min(double(i + 1) / m, double(j + 1) / n);
    return std::max(0.0, high - low);
}

// The mean over a texel of the next level, by its definition as an integral over the image.
double coveredMean(const TextureImage& image, const std::vector<float>& values, uint32_t x,
                   uint32_t y, uint32_t channel) {
    const uint32_t width = nextLevelSide(image.width()), height = nextLevelSide(image.height());
    double sum = 0;
    for (uint32_t j = 0; j < image.height(); ++j)
        for (uint32_t i = 0; i < image.width(); ++i)
            sum += shared(x, width, i, image.width()) * shared(y, height, j, image.height()) *
                   double(values[(std::size_t(j) * image.width() + i) * image.channels() +
                                 channel]);
    return sum * width * height;
}

// Largest step between neighbouring numbers of a type, in linear light.
double stepOf(TexelType type, bool srgb) {
    switch (type) {
    case TexelType::Byte: return (srgb ? 2.3 : 1) / 255.0;
    case TexelType::Short: return (srgb ? 2.3 : 1) / 65535.0;
    case TexelType::Half: return 0x1p-11;
    case TexelType::Float: break;
    }
    return 0x1p-24;
}

TEST(TextureLevelsTest, EachTexelIsTheMeanOfWhatItCovers) {
    for (const auto& [width, height] :
         {std::pair{2u, 2u}, {4u, 6u}, {3u, 3u}, {5u, 4u}, {1u, 7u}, {9u, 1u}, {7u, 5u}})
        for (const TexelType type : kTypes)
            for (const bool srgb : {false, true})
                for (uint32_t channels = 1; channels <= 4; ++channels) {
                    const TextureImage image =
                        made(width, height, channels, type, srgb,
                             randomValues(std::size_t(width) * height * channels,
                                          width + channels));
                    const std::vector<float> values = valuesOf(image);
                    const TextureImage next = reducedImage(image);
                    ASSERT_EQ(next.width(), nextLevelSide(width));
                    ASSERT_EQ(next.height(), nextLevelSide(height));
                    const std::vector<float> found = valuesOf(next);
                    for (uint32_t y = 0; y < next.height(); ++y)
                        for (uint32_t x = 0; x < next.width(); ++x)
                            for (uint32_t c = 0; c < channels; ++c)
                                ASSERT_NEAR(
                                    double(found[(y * next.width() + x) * channels + c]),
                                    coveredMean(image, values, x, y, c), stepOf(type, srgb) * 0.51)
                                    << width << " x " << height << " type " << int(type);
                }
}

TEST(TextureLevelsTest, TheMeanCheckerSeesADroppedColumn) {
    // What halving an odd side without weights would give.
    const TextureImage image = made(3, 1, 1, TexelType::Float, false, {0, 0, 1});
    EXPECT_GT(coveredMean(image, valuesOf(image), 0, 0, 0) - (0 + 0) / 2.0, 0.3);
    EXPECT_EQ(valuesOf(reducedImage(image))[0], float(1.0 / 3.0));
}

TEST(TextureLevelsTest, MeansAreTakenInLinearLight) {
    // Black and white, encoded: the mean has code 188, not 128.
    std::vector<std::byte> texels = {std::byte(0), std::byte(255)};
    const TextureImage next = reducedImage(TextureImage(2, 1, 1, TexelType::Byte, true, texels));
    std::vector<std::byte> code(1);
    const double value = double(valuesOf(next)[0]);
    encodeTexels(&value, 1, 1, TexelType::Byte, true, code.data());
    EXPECT_EQ(int(code[0]), 188);
}

TEST(TextureLevelsTest, ConstantImagesStayWhatTheyAre) {
    for (const TexelType type : kTypes)
        for (const bool srgb : {false, true})
            for (const auto& [width, height] : {std::pair{17u, 13u}, {64u, 1u}, {255u, 3u}}) {
                const std::size_t count = std::size_t(width) * height * 2;
                std::vector<double> values(count);
                for (std::size_t i = 0; i < count; ++i) values[i] = i % 2 ? 0.7 : 0.3;
                const auto image = std::make_shared<const TextureImage>(
                    made(width, height, 2, type, srgb, values));
                const float color = valuesOf(*image)[0], alpha = valuesOf(*image)[1];
                const TextureLevels levels({image}, levelCount(width, height));
                for (uint32_t n = 0; n < levels.count(); ++n)
                    for (std::size_t i = 0; const float v : valuesOf(levels[n]))
                        ASSERT_EQ(v, i++ % 2 ? alpha : color) << "level " << n;
            }
}

TEST(TextureLevelsTest, MeansOfTheWholeArePreserved) {
    for (const auto& [width, height] : {std::pair{64u, 64u}, {37u, 53u}, {1u, 100u}, {127u, 64u}})
        for (const TexelType type : {TexelType::Byte, TexelType::Short, TexelType::Float}) {
            const auto image = std::make_shared<const TextureImage>(
                made(width, height, 1, type, false, randomValues(width * height, 5)));
            const TextureLevels levels({image}, levelCount(width, height));
            const auto mean = [](const TextureImage& level) {
                double sum = 0;
                const std::vector<float> values = valuesOf(level);
                for (const float v : values) sum += double(v);
                return sum / double(values.size());
            };
            const double whole = mean(*image);
            // Each level rounds once: errors of many texels cancel, the last levels' do not.
            const double step = type == TexelType::Float ? 1e-6 : stepOf(type, false);
            for (uint32_t n = 1; n < levels.count(); ++n)
                EXPECT_NEAR(mean(levels[n]), whole, step * 1.5) << "level " << n;
        }
}

TEST(TextureLevelsTest, CountsAndSides) {
    EXPECT_EQ(levelCount(1, 1), 1u);
    EXPECT_EQ(levelCount(2, 1), 2u);
    EXPECT_EQ(levelCount(3, 5), 3u);
    EXPECT_EQ(levelCount(256, 16), 9u);
    EXPECT_EQ(levelCount(16384, 16384), 15u);
    const auto image =
        std::make_shared<const TextureImage>(13, 6, 1, TexelType::Byte, false,
                                             std::vector<std::byte>(78));
    const TextureLevels levels({image}, 4);
    const uint32_t sides[][2] = {{13, 6}, {6, 3}, {3, 1}, {1, 1}};
    for (uint32_t n = 0; n < 4; ++n) {
        EXPECT_EQ(levels[n].width(), sides[n][0]);
        EXPECT_EQ(levels[n].height(), sides[n][1]);
    }
}

TEST(TextureLevelsTest, LevelsAreMadeWhenAskedForAndCounted) {
    const auto image = std::make_shared<const TextureImage>(
        16, 16, 4, TexelType::Byte, false, std::vector<std::byte>(1024));
    const TextureLevels levels({image}, 5);
    EXPECT_EQ(levels.bytes(), 1024u);
    EXPECT_EQ(&levels[0], image.get());
    EXPECT_EQ(levels.bytes(), 1024u) << "the first level needs no other";
    levels[3];
    EXPECT_EQ(levels.bytes(), 4u * (256 + 64 + 16 + 4 + 1));
}

TEST(TextureLevelsTest, GivenLevelsAreKeptAndTheOthersMadeFromTheFirst) {
    const auto full = [](uint32_t side, uint8_t value) {
        return std::make_shared<const TextureImage>(
            side, side, 1, TexelType::Byte, false,
            std::vector<std::byte>(side * side, std::byte(value)));
    };
    const auto second = full(2, 51);
    const TextureLevels levels({full(8, 255), nullptr, second, nullptr}, 4);
    EXPECT_EQ(valuesOf(levels[1])[0], 1.0f);
    EXPECT_EQ(&levels[2], second.get());
    EXPECT_EQ(valuesOf(levels[3])[0], 1.0f);
    EXPECT_THROW(TextureLevels({full(8, 0), full(3, 0)}, 2), Error);
    EXPECT_THROW(TextureLevels({full(8, 0)}, 5), Error);
    EXPECT_THROW(TextureLevels({full(8, 0)}, 0), Error);
    EXPECT_THROW(TextureLevels({nullptr, full(4, 0)}, 2), Error);
    EXPECT_THROW(TextureLevels({}, 1), Error);
}

TEST(TextureLevelsTest, ManyThreadsMakeOneSetOfLevels) {
    const auto image = std::make_shared<const TextureImage>(
        made(64, 64, 3, TexelType::Byte, true, randomValues(64 * 64 * 3, 9)));
    const TextureLevels levels({image}, 7);
    std::atomic<int> ready{0};
    const TextureImage* found[4] = {};
    std::vector<std::thread> threads;
    for (int n = 0; n < 4; ++n)
        threads.emplace_back([&, n] {
            ++ready;
            while (ready < 4) std::this_thread::yield();
            found[n] = &levels[uint32_t(3)];
            EXPECT_EQ(levels[6].width(), 1u);
        });
    for (std::thread& t : threads) t.join();
    for (const TextureImage* level : found) EXPECT_EQ(level, found[0]);
}

} // namespace
} // namespace smart

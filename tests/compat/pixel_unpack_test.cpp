// SPDX-License-Identifier: MIT
#include "compat/recorder/pixel_unpack.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <random>

namespace smart::compat {
namespace {

constexpr int kComponents[] = {1, 2, 3, 4, 3, 4, 1, 1, 1, 1}; // of each PixelOrder

/// Red, green, blue and alpha of a pixel by the meaning of its order; bytes of one component.
template <class T>
std::array<T, 4> rgbaOf(const T* p, PixelOrder order, T one) {
    switch (order) {
    case PixelOrder::Luminance: return {p[0], p[0], p[0], one};
    case PixelOrder::LuminanceAlpha: return {p[0], p[0], p[0], p[1]};
    case PixelOrder::Rgb: return {p[0], p[1], p[2], one};
    case PixelOrder::Rgba: return {p[0], p[1], p[2], p[3]};
    case PixelOrder::Bgr: return {p[2], p[1], p[0], one};
    case PixelOrder::Bgra: return {p[2], p[1], p[0], p[3]};
    case PixelOrder::Red: return {p[0], 0, 0, one};
    case PixelOrder::Green: return {0, p[0], 0, one};
    case PixelOrder::Blue: return {0, 0, p[0], one};
    case PixelOrder::Alpha: return {0, 0, 0, p[0]};
    }
    return {};
}

template <class T>
void checkAll(TexelType type, T one) {
    std::mt19937 random(4);
    for (int order = 0; order < 10; ++order) {
        for (uint32_t channels = 1; channels <= 4; ++channels) {
            for (uint32_t alignment : {1u, 2u, 4u, 8u}) {
                for (uint32_t rowLength : {0u, 7u}) {
                    const uint32_t width = 5, height = 3, skipX = rowLength ? 2 : 0, skipY = 1;
                    const uint32_t rowPixels = rowLength ? rowLength : width;
                    std::size_t rowBytes = rowPixels * uint32_t(kComponents[order]) * sizeof(T);
                    if (sizeof(T) < alignment)
                        while (rowBytes % alignment) ++rowBytes;
                    std::vector<std::byte> memory(rowBytes * (height + skipY));
                    for (std::size_t i = 0; i + sizeof(T) <= memory.size(); i += sizeof(T)) {
                        const T value = T(random() % 250);
                        std::memcpy(&memory[i], &value, sizeof value);
                    }
                    PixelStore store;
                    store.alignment = alignment;
                    store.rowLength = rowLength;
                    store.skipPixels = skipX;
                    store.skipRows = skipY;
                    const auto texels = unpackImage(
                        {memory.data(), width, height, PixelOrder(order), type}, store, channels);
                    ASSERT_EQ(texels.size(), width * height * channels * sizeof(T));
                    for (uint32_t y = 0; y < height; ++y) {
                        for (uint32_t x = 0; x < width; ++x) {
                            T pixel[4], found[4];
                            std::memcpy(pixel,
                                        &memory[(y + skipY) * rowBytes +
                                                (x + skipX) * uint32_t(kComponents[order]) *
                                                    sizeof(T)],
                                        uint32_t(kComponents[order]) * sizeof(T));
                            std::memcpy(found, &texels[(y * width + x) * channels * sizeof(T)],
                                        channels * sizeof(T));
                            auto expected = rgbaOf(pixel, PixelOrder(order), one);
                            if (channels == 2) expected[1] = expected[3];
                            for (uint32_t c = 0; c < channels; ++c)
                                ASSERT_EQ(found[c], expected[c]) << order << " to " << channels;
                        }
                    }
                }
            }
        }
    }
}

TEST(PixelUnpack, EveryOrderTypeAndLayout) {
    checkAll<uint8_t>(TexelType::Byte, 255);
    checkAll<uint16_t>(TexelType::Short, 65535);
    checkAll<uint16_t>(TexelType::Half, 0x3C00);
    checkAll<float>(TexelType::Float, 1.0f);
}

TEST(PixelUnpack, SwapsBytesOfEachComponent) {
    const uint16_t source[] = {0x1234, 0xABCD};
    PixelStore store;
    store.swapBytes = true;
    const auto texels = unpackImage({source, 1, 1, PixelOrder::LuminanceAlpha, TexelType::Short},
                                    store, 2);
    uint16_t found[2];
    std::memcpy(found, texels.data(), sizeof found);
    EXPECT_EQ(found[0], 0x3412);
    EXPECT_EQ(found[1], 0xCDAB);
}

/// A pixel of bytes 10, 20, 30, 40 as four channels of a format.
std::vector<int> unpackedAs(TexelFormat format, PixelOrder order) {
    const uint8_t source[] = {10, 20, 30, 40};
    PixelStore store;
    store.alignment = 1;
    const auto texels = unpackImage({source, 1, 1, order, TexelType::Byte}, store, 4, format);
    std::vector<int> values;
    for (const std::byte b : texels) values.push_back(int(b));
    return values;
}

// OpenGL 1.5, table 3.15, and section 3.6.4, "Conversion to RGB".
TEST(PixelUnpack, FormatsTakeTheirComponents) {
    using Values = std::vector<int>;
    EXPECT_EQ(unpackedAs(TexelFormat::ByChannels, PixelOrder::Bgra), (Values{30, 20, 10, 40}));
    EXPECT_EQ(unpackedAs(TexelFormat::Alpha, PixelOrder::Rgba), (Values{0, 0, 0, 40}));
    EXPECT_EQ(unpackedAs(TexelFormat::Alpha, PixelOrder::Alpha), (Values{0, 0, 0, 10}));
    EXPECT_EQ(unpackedAs(TexelFormat::Alpha, PixelOrder::Luminance), (Values{0, 0, 0, 255}));
    EXPECT_EQ(unpackedAs(TexelFormat::Intensity, PixelOrder::Bgr), (Values{30, 30, 30, 30}));
    EXPECT_EQ(unpackedAs(TexelFormat::Intensity, PixelOrder::Alpha), (Values{0, 0, 0, 0}));
    EXPECT_EQ(unpackedAs(TexelFormat::ByChannels, PixelOrder::Red), (Values{10, 0, 0, 255}));
    EXPECT_EQ(unpackedAs(TexelFormat::ByChannels, PixelOrder::Green), (Values{0, 10, 0, 255}));
    EXPECT_EQ(unpackedAs(TexelFormat::ByChannels, PixelOrder::Blue), (Values{0, 0, 10, 255}));
    EXPECT_EQ(unpackedAs(TexelFormat::ByChannels, PixelOrder::Alpha), (Values{0, 0, 0, 10}));
}

TEST(PixelUnpack, NothingIsAnImageOfZeros) {
    const auto texels = unpackImage({nullptr, 3, 2, PixelOrder::Rgb, TexelType::Float}, {}, 3);
    ASSERT_EQ(texels.size(), 72u);
    for (const std::byte b : texels) EXPECT_EQ(b, std::byte(0));
}

} // namespace
} // namespace smart::compat

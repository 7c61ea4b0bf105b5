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
    case PixelOrder::Depth: break;
    }
    return {};
}

template <class T>
void checkAll(PixelType memory, TexelType type, T one) {
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
                    std::vector<std::byte> bytes(rowBytes * (height + skipY));
                    for (std::size_t i = 0; i + sizeof(T) <= bytes.size(); i += sizeof(T)) {
                        const T value = T(random() % 250);
                        std::memcpy(&bytes[i], &value, sizeof value);
                    }
                    PixelStore store;
                    store.alignment = alignment;
                    store.rowLength = rowLength;
                    store.skipPixels = skipX;
                    store.skipRows = skipY;
                    const auto texels = unpackImage(
                        {bytes.data(), width, height, {PixelOrder(order), memory}}, store, channels,
                        type);
                    ASSERT_EQ(texels.size(), width * height * channels * sizeof(T));
                    for (uint32_t y = 0; y < height; ++y) {
                        for (uint32_t x = 0; x < width; ++x) {
                            T pixel[4], found[4];
                            std::memcpy(pixel,
                                        &bytes[(y + skipY) * rowBytes +
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
    checkAll<uint8_t>(PixelType::UnsignedByte, TexelType::Byte, 255);
    checkAll<uint16_t>(PixelType::UnsignedShort, TexelType::Short, 65535);
    checkAll<uint16_t>(PixelType::Half, TexelType::Half, 0x3C00);
    checkAll<float>(PixelType::Float, TexelType::Float, 1.0f);
}

TEST(PixelUnpack, SwapsBytesOfEachComponent) {
    const uint16_t source[] = {0x1234, 0xABCD};
    PixelStore store;
    store.swapBytes = true;
    const auto texels =
        unpackImage({source, 1, 1, {PixelOrder::LuminanceAlpha, PixelType::UnsignedShort}}, store,
                    2, TexelType::Short);
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
    const auto texels = unpackImage({source, 1, 1, {order}}, store, 4, TexelType::Byte, format);
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
    const auto texels = unpackImage({nullptr, 3, 2, {PixelOrder::Rgb, PixelType::Float}}, {}, 3,
                                    TexelType::Float);
    ASSERT_EQ(texels.size(), 72u);
    for (const std::byte b : texels) EXPECT_EQ(b, std::byte(0));
}

/// The luminance that a number stands for, exactly.
template <class Number>
double luminanceOf(PixelType type, Number number, const PixelTransfer& transfer = {}) {
    PixelStore store;
    store.alignment = 1;
    const auto texels = unpackImage({&number, 1, 1, {PixelOrder::Luminance, type}}, store, 1,
                                    TexelType::Float, TexelFormat::ByChannels, transfer);
    float value;
    std::memcpy(&value, texels.data(), sizeof value);
    return double(value);
}

// OpenGL 1.5, table 2.9.
TEST(PixelUnpack, WholeNumbersStandForTheirRange) {
    for (int n = -128; n < 128; ++n)
        EXPECT_FLOAT_EQ(luminanceOf(PixelType::Byte, int8_t(n)), (2.0 * n + 1.0) / 255.0);
    for (const int n : {-32768, -32767, -1, 0, 1, 20000, 32767})
        EXPECT_FLOAT_EQ(luminanceOf(PixelType::Short, int16_t(n)), (2.0 * n + 1.0) / 65535.0);
    for (const int64_t n : {-2147483648ll, -1ll, 0ll, 1ll << 20, 2147483647ll})
        EXPECT_FLOAT_EQ(luminanceOf(PixelType::Int, int32_t(n)),
                        (2.0 * double(n) + 1.0) / 4294967295.0);
    for (const uint32_t n : {0u, 1u, 1u << 30, 4294967295u})
        EXPECT_FLOAT_EQ(luminanceOf(PixelType::UnsignedInt, n), double(n) / 4294967295.0);
}

TEST(PixelUnpack, TransferComesBeforeTheLimits) {
    const PixelTransfer transfer{glm::vec4(-2.0f), glm::vec4(1.5f)};
    EXPECT_FLOAT_EQ(luminanceOf(PixelType::UnsignedByte, uint8_t(255), transfer), -0.5);
    EXPECT_FLOAT_EQ(luminanceOf(PixelType::Byte, int8_t(-128), transfer), 3.5);
    EXPECT_FLOAT_EQ(luminanceOf(PixelType::Float, 0.25f, transfer), 1.0);
}

struct Field {
    PixelFields fields;
    uint32_t lowest[4]; ///< bit of each component
};

// OpenGL 1.5, table 3.8: where the components lie.
TEST(PixelUnpack, FieldsLieWhereTheirTypeSays) {
    const Field all[] = {{{1, 3, {3, 3, 2}, false}, {5, 2, 0}},
                         {{1, 3, {2, 3, 3}, true}, {0, 3, 6}},
                         {{2, 3, {5, 6, 5}, false}, {11, 5, 0}},
                         {{2, 3, {5, 6, 5}, true}, {0, 5, 11}},
                         {{2, 4, {4, 4, 4, 4}, false}, {12, 8, 4, 0}},
                         {{2, 4, {5, 5, 5, 1}, false}, {11, 6, 1, 0}},
                         {{2, 4, {1, 5, 5, 5}, true}, {0, 5, 10, 15}},
                         {{4, 4, {8, 8, 8, 8}, true}, {0, 8, 16, 24}},
                         {{4, 4, {10, 10, 10, 2}, false}, {22, 12, 2, 0}},
                         {{4, 4, {2, 10, 10, 10}, true}, {0, 10, 20, 30}}};
    std::mt19937 random(9);
    for (const Field& field : all)
        for (int trial = 0; trial < 20; ++trial) {
            const uint32_t bits = field.fields.bytes * 8u;
            const uint32_t number = random() & (bits == 32 ? ~0u : (1u << bits) - 1u);
            const PixelOrder order = field.fields.count == 3 ? PixelOrder::Rgb : PixelOrder::Rgba;
            const auto texels = unpackImage(
                {&number, 1, 1, {order, PixelType::Fields, field.fields}}, {}, 4, TexelType::Float);
            float rgba[4];
            std::memcpy(rgba, texels.data(), sizeof rgba);
            for (uint32_t k = 0; k < field.fields.count; ++k) {
                const bool last = k + 1u == field.fields.count;
                const uint32_t next = field.fields.reversed
                                          ? (last ? bits : field.lowest[k + 1])
                                          : (k == 0 ? bits : field.lowest[k - 1]);
                const uint32_t most = uint32_t((uint64_t(1) << (next - field.lowest[k])) - 1);
                EXPECT_FLOAT_EQ(rgba[k], double(number >> field.lowest[k] & most) / most)
                    << bits << " bits, component " << k;
            }
            if (field.fields.count == 3) {
                EXPECT_EQ(rgba[3], 1.0f);
            }
        }
}

} // namespace
} // namespace smart::compat

// SPDX-License-Identifier: MIT
#include "samples/common/image_file.h"

#include <gtest/gtest.h>

#include "samples/common/output_file.h"
#include "tests/samples/temporary_folder.h"

#ifdef SAMPLES_HAVE_EXR
#    include <OpenEXR/ImfArray.h>
#    include <OpenEXR/ImfRgbaFile.h>
#endif

namespace samples {
namespace {

TEST(ImageFile, PngComesBackTurnedOver) {
    std::vector<uint8_t> pixels;
    for (int i = 0; i < 5 * 3 * 3; ++i) pixels.push_back(uint8_t(i * 5));
    PixelBudget budget;
    const Image image = decodeImage(encodePng(5, 3, 3, pixels), budget);
    ASSERT_EQ(image.width, 5u);
    ASSERT_EQ(image.height, 3u);
    for (std::size_t y = 0; y < 3; ++y) {
        for (std::size_t x = 0; x < 5; ++x) {
            for (std::size_t c = 0; c < 3; ++c) {
                EXPECT_EQ(image.rgba[(y * 5 + x) * 4 + c], pixels[((2 - y) * 5 + x) * 3 + c]);
            }
            EXPECT_EQ(image.rgba[(y * 5 + x) * 4 + 3], 255);
        }
    }
}

TEST(ImageFile, BrokenImagesAreRefused) {
    const std::vector<uint8_t> pixels(64 * 64 * 4, 77);
    const std::vector<uint8_t> png = encodePng(64, 64, 4, pixels);
    for (std::size_t size = 0; size + 12 < png.size(); size += 7) {
        PixelBudget budget;
        EXPECT_THROW(decodeImage(std::span(png).first(size), budget), LoadError) << size;
    }
    PixelBudget budget;
    const std::vector<uint8_t> text = {'G', 'I', 'F', '8', '9', 'a', 0, 0, 0, 0};
    EXPECT_THROW(decodeImage(text, budget), LoadError);
    const std::vector<uint8_t> jpeg = {0xFF, 0xD8, 0xFF, 0xE0, 0, 16, 'J', 'F', 'I', 'F'};
    EXPECT_THROW(decodeImage(jpeg, budget), LoadError);
    // A Huffman table of 16 times 255 codes, more than there are symbols.
    std::vector<uint8_t> table = {0xFF, 0xD8, 0xFF, 0xC4, 0x10, 0x03, 0};
    table.resize(table.size() + 16, 255);
    table.resize(table.size() + 16 * 255, 0);
    EXPECT_THROW(decodeImage(table, budget), LoadError);
}

TEST(ImageFile, ABudgetBoundsWhatIsDecoded) {
    const std::vector<uint8_t> png = encodePng(8, 8, 3, std::vector<uint8_t>(8 * 8 * 3));
    PixelBudget budget{100};
    EXPECT_NO_THROW(decodeImage(png, budget));
    EXPECT_THROW(decodeImage(png, budget), LoadError);
    // A header that asks for 2^31 - 1 pixels a side.
    std::vector<uint8_t> huge = png;
    for (std::size_t i : {16u, 20u}) {
        huge[i] = 0x7F;
        huge[i + 1] = huge[i + 2] = huge[i + 3] = 0xFF;
    }
    PixelBudget fresh;
    EXPECT_THROW(decodeImage(huge, fresh), LoadError);
}

#ifdef SAMPLES_HAVE_EXR
TEST(ImageFile, ExrHoldsTheSameNumbers) {
    const test::TemporaryFolder temporary;
    std::vector<float> pixels;
    for (int i = 0; i < 3 * 2 * 4; ++i) pixels.push_back(float(i) * 0.25f - 1.0f);
    const auto path = temporary.write("picture.exr", encodeExr(3, 2, pixels));
    Imf::RgbaInputFile file(path.c_str());
    ASSERT_EQ(file.dataWindow().max.x, 2);
    ASSERT_EQ(file.dataWindow().max.y, 1);
    Imf::Array2D<Imf::Rgba> rows(2, 3);
    file.setFrameBuffer(&rows[0][0], 1, 3);
    file.readPixels(0, 1);
    for (long y = 0; y < 2; ++y) {
        for (long x = 0; x < 3; ++x) {
            const float* expected = &pixels[std::size_t(((1 - y) * 3 + x) * 4)];
            EXPECT_EQ(float(rows[y][x].r), expected[0]);
            EXPECT_EQ(float(rows[y][x].g), expected[1]);
            EXPECT_EQ(float(rows[y][x].b), expected[2]);
            EXPECT_EQ(float(rows[y][x].a), expected[3]);
        }
    }
}
#endif

TEST(OutputFile, LeavesNothingBehindUnlessItIsWritten) {
    const test::TemporaryFolder temporary;
    const auto fresh = temporary.path() / "fresh.png";
    {
        const OutputFile unused(fresh);
        EXPECT_FALSE(std::filesystem::exists(fresh)) << "nor if the program is interrupted";
    }
    EXPECT_FALSE(std::filesystem::exists(fresh));
    const auto old = temporary.write("old.png", std::string("a longer text"));
    { const OutputFile unused(old); }
    EXPECT_EQ(std::filesystem::file_size(old), 13u);
    const std::vector<uint8_t> bytes = {1, 2, 3};
    OutputFile(fresh).write(bytes);
    OutputFile(old).write(bytes);
    EXPECT_EQ(std::filesystem::file_size(fresh), 3u);
    EXPECT_EQ(std::filesystem::file_size(old), 3u);
}

TEST(OutputFile, SaysEarlyWhatCanNotBeWritten) {
    const test::TemporaryFolder temporary;
    EXPECT_THROW(OutputFile(temporary.path()), std::runtime_error);
    EXPECT_THROW(OutputFile(temporary.path() / "no folder" / "a.png"), std::runtime_error);
}

TEST(OutputFile, AFullDiskIsAnError) {
    OutputFile full("/dev/full");
    EXPECT_THROW(full.write(std::vector<uint8_t>{1, 2, 3}), std::runtime_error);
}

} // namespace
} // namespace samples

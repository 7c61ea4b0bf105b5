// SPDX-License-Identifier: MIT
#include "samples/common/image_file.h"

#include <png.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <string_view>

#include "samples/common/jpeg_tables.h"

#ifdef SAMPLES_HAVE_EXR
#    include <OpenEXR/ImfChannelList.h>
#    include <OpenEXR/ImfFrameBuffer.h>
#    include <OpenEXR/ImfHeader.h>
#    include <OpenEXR/ImfIO.h>
#    include <OpenEXR/ImfOutputFile.h>
#    include <Imath/half.h>
#endif

#ifdef SAMPLES_HAVE_JPEG
#    define STB_IMAGE_STATIC
#    define STB_IMAGE_IMPLEMENTATION
#    define STBI_ONLY_JPEG
#    define STBI_NO_STDIO
#    define STBI_ASSERT(condition) // on what files hold, which must not end a program
#    pragma GCC diagnostic push
#    pragma GCC diagnostic ignored "-Wunused-function"
#    include <stb/stb_image.h>
#    pragma GCC diagnostic pop
#endif

namespace samples {
namespace {

constexpr uint32_t kMaxSide = 16384; // the library's largest texture

/// A PNG file without what it says of its colours' encoding, by which libpng would convert them. A
/// texture's numbers are used as they are (glTF 2.0, 3.8.3): its place in the material says whether
/// they are sRGB.
std::vector<uint8_t> withoutColorSpace(std::span<const uint8_t> bytes) {
    constexpr std::string_view kDropped[] = {"cHRM", "gAMA", "iCCP", "sRGB"};
    constexpr uint64_t kSignature = 8, kAroundData = 12; // length, name, checksum
    std::vector<uint8_t> kept;
    kept.reserve(bytes.size());
    const auto move = [&](uint64_t wanted, bool keep) {
        const auto part = bytes.first(std::size_t(std::min<uint64_t>(wanted, bytes.size())));
        if (keep) kept.insert(kept.end(), part.begin(), part.end());
        bytes = bytes.subspan(part.size());
    };
    move(kSignature, true);
    while (bytes.size() >= kAroundData) {
        const std::string_view name(reinterpret_cast<const char*>(bytes.data()) + 4, 4);
        const bool drop = std::count(std::begin(kDropped), std::end(kDropped), name) != 0;
        move(kAroundData + png_get_uint_32(bytes.data()), !drop);
    }
    move(bytes.size(), true);
    return kept;
}

Image decodePng(std::span<const uint8_t> bytes, PixelBudget& budget) {
    const std::vector<uint8_t> file = withoutColorSpace(bytes);
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    const std::unique_ptr<png_image, decltype(&png_image_free)> cleanUp(&png, &png_image_free);
    if (!png_image_begin_read_from_memory(&png, file.data(), file.size())) {
        throw LoadError(std::string("a broken PNG image: ") + png.message);
    }
    takePixels(budget, png.width, png.height);
    png.flags |= PNG_IMAGE_FLAG_16BIT_sRGB; // or 16 bits would count as linear
    png.format = PNG_FORMAT_RGBA;
    Image image{png.width, png.height, std::vector<uint8_t>(PNG_IMAGE_SIZE(png))};
    if (!png_image_finish_read(&png, nullptr, image.rgba.data(), 0, nullptr)) {
        throw LoadError(std::string("a broken PNG image: ") + png.message);
    }
    return image;
}

#ifdef SAMPLES_HAVE_JPEG
LoadError brokenJpeg() {
    const char* const reason = stbi_failure_reason(); // some failures have none
    return LoadError(std::string("a broken JPEG image") + (reason ? ": " : "") +
                     (reason ? reason : ""));
}
#endif

Image decodeJpeg([[maybe_unused]] std::span<const uint8_t> bytes,
                 [[maybe_unused]] PixelBudget& budget) {
#ifdef SAMPLES_HAVE_JPEG
    checkJpegTables(bytes);
    int width = 0, height = 0, channels = 0;
    const int size = int(std::min<std::size_t>(bytes.size(), std::size_t(1) << 30));
    if (!stbi_info_from_memory(bytes.data(), size, &width, &height, &channels)) {
        throw brokenJpeg();
    }
    takePixels(budget, uint64_t(std::max(width, 0)), uint64_t(std::max(height, 0)));
    const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
        stbi_load_from_memory(bytes.data(), size, &width, &height, &channels, 4),
        &stbi_image_free);
    if (!pixels) throw brokenJpeg();
    const std::size_t count = std::size_t(width) * std::size_t(height) * 4;
    return {uint32_t(width), uint32_t(height), {pixels.get(), pixels.get() + count}};
#else
    throw LoadError("a JPEG image, and this program was built without stb");
#endif
}

} // namespace

void takePixels(PixelBudget& budget, uint64_t width, uint64_t height) {
    if (width == 0 || height == 0 || width > kMaxSide || height > kMaxSide) {
        throw LoadError("an image of " + std::to_string(width) + " x " + std::to_string(height) +
                        " pixels; 1 to " + std::to_string(kMaxSide) + " a side are accepted");
    }
    if (width * height > budget.pixelsLeft) throw LoadError("its images are too large in all");
    budget.pixelsLeft -= width * height;
}

Image decodeImage(std::span<const uint8_t> bytes, PixelBudget& budget) {
    constexpr uint8_t kPng[] = {0x89, 'P', 'N', 'G'};
    constexpr uint8_t kJpeg[] = {0xFF, 0xD8, 0xFF};
    const auto beginsWith = [&](std::span<const uint8_t> magic) {
        return bytes.size() >= magic.size() &&
               std::equal(magic.begin(), magic.end(), bytes.begin());
    };
    if (beginsWith(kPng)) return decodePng(bytes, budget);
    if (beginsWith(kJpeg)) return decodeJpeg(bytes, budget);
    throw LoadError("an image that is neither PNG nor JPEG");
}

std::vector<uint8_t> encodePng(uint32_t width, uint32_t height, uint32_t channels,
                               std::span<const uint8_t> pixels) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    const std::unique_ptr<png_image, decltype(&png_image_free)> cleanUp(&png, &png_image_free);
    png.width = width;
    png.height = height;
    png.format = channels == 4 ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
    // A negative stride turns the rows over.
    const png_int_32 stride = -png_int_32(width * channels);
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
    std::vector<uint8_t> file(size);
    if (!png_image_write_to_memory(&png, file.data(), &size, 0, pixels.data(), stride, nullptr)) {
        throw std::runtime_error(std::string("the PNG can not be made: ") + png.message);
    }
    file.resize(size);
    return file;
}

#ifdef SAMPLES_HAVE_EXR
namespace {

class MemoryStream final : public Imf::OStream {
public:
    MemoryStream() : OStream("picture") {}
    void write(const char bytes[], int count) override {
        if (position_ + std::size_t(count) > bytes_.size()) {
            bytes_.resize(position_ + std::size_t(count));
        }
        std::memcpy(bytes_.data() + position_, bytes, std::size_t(count));
        position_ += std::size_t(count);
    }
    uint64_t tellp() override { return position_; }
    void seekp(uint64_t position) override { position_ = position; }
    std::vector<uint8_t> take() { return std::move(bytes_); }

private:
    std::vector<uint8_t> bytes_;
    std::size_t position_ = 0;
};

} // namespace

std::vector<uint8_t> encodeExr(uint32_t width, uint32_t height, std::span<const float> rgba) {
    std::vector<half> pixels(rgba.size());
    for (uint32_t y = 0; y < height; ++y) {
        const auto row = rgba.subspan(std::size_t(height - 1 - y) * width * 4, width * 4);
        std::transform(row.begin(), row.end(), pixels.begin() + std::ptrdiff_t(y) * width * 4,
                       [](float v) { return half(v); });
    }
    MemoryStream stream;
    {
        Imf::Header header{int(width), int(height)};
        Imf::FrameBuffer frame;
        const std::size_t pixelBytes = 4 * sizeof(half);
        const char* names[] = {"R", "G", "B", "A"};
        for (std::size_t c = 0; c < 4; ++c) {
            header.channels().insert(names[c], Imf::Channel(Imf::HALF));
            frame.insert(names[c], Imf::Slice(Imf::HALF, reinterpret_cast<char*>(&pixels[c]),
                                              pixelBytes, pixelBytes * width));
        }
        Imf::OutputFile file(stream, header);
        file.setFrameBuffer(frame);
        file.writePixels(int(height));
    }
    return stream.take();
}
#else
std::vector<uint8_t> encodeExr(uint32_t, uint32_t, std::span<const float>) {
    throw std::runtime_error("this program was built without OpenEXR, so it writes no .exr");
}
#endif

} // namespace samples

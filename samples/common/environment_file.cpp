// SPDX-License-Identifier: MIT
#include "samples/common/environment_file.h"

#include <algorithm>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>

#include "samples/common/confined_folder.h"
#include "samples/common/exr_header.h"
#include "samples/common/radiance_picture.h"
#include "samples/common/scene_loader.h"

#ifdef SAMPLES_HAVE_EXR
#    include <OpenEXR/ImfChannelList.h>
#    include <OpenEXR/ImfFrameBuffer.h>
#    include <OpenEXR/ImfHeader.h>
#    include <OpenEXR/ImfIO.h>
#    include <OpenEXR/ImfInputFile.h>
#endif

namespace samples {
namespace {

constexpr uint64_t kMaxFileBytes = uint64_t(2) << 30;

#ifdef SAMPLES_HAVE_EXR
class MemoryStream final : public Imf::IStream {
public:
    explicit MemoryStream(std::span<const uint8_t> bytes) : IStream("picture"), bytes_(bytes) {}
    bool read(char to[], int count) override {
        if (count < 0 || position_ > bytes_.size() ||
            std::size_t(count) > bytes_.size() - position_) {
            throw LoadError("it is cut off");
        }
        std::memcpy(to, bytes_.data() + position_, std::size_t(count));
        position_ += std::size_t(count);
        return position_ < bytes_.size();
    }
    uint64_t tellg() override { return position_; }
    void seekg(uint64_t position) override { position_ = position; }

private:
    std::span<const uint8_t> bytes_;
    uint64_t position_ = 0;
};

Environment readExr(std::span<const uint8_t> bytes) {
    MemoryStream stream(bytes);
    Imf::InputFile file(stream, 0);
    const auto window = file.header().dataWindow();
    const Imf::ChannelList& channels = file.header().channels();
    const bool grey = channels.findChannel("Y") && !channels.findChannel("RY");
    const char* const colours[] = {"R", "G", "B"};
    for (const char* name : colours) {
        if (!grey && !channels.findChannel(name)) {
            throw LoadError("it has neither channels R, G and B nor Y alone");
        }
    }
    const std::size_t width = std::size_t(window.max.x - window.min.x + 1);
    const std::size_t height = std::size_t(window.max.y - window.min.y + 1);
    // All rows come into one, so that no memory is touched for those that are not in the file.
    std::vector<float> row(width * 3);
    constexpr std::ptrdiff_t kPixel = 3 * sizeof(float);
    Imf::FrameBuffer frame;
    for (std::size_t c = 0; c < (grey ? 1 : 3); ++c) {
        char* const begin = reinterpret_cast<char*>(&row[c]) - window.min.x * kPixel;
        frame.insert(grey ? "Y" : colours[c], Imf::Slice(Imf::FLOAT, begin, kPixel, 0));
    }
    file.setFrameBuffer(frame);
    Environment picture{uint32_t(width), uint32_t(height), {}};
    picture.rgb.reserve(width * height * 3);
    for (int y = window.min.y; y <= window.max.y; ++y) {
        file.readPixels(y);
        for (std::size_t x = 0; x < row.size() && grey; x += 3) row[x + 1] = row[x + 2] = row[x];
        picture.rgb.insert(picture.rgb.end(), row.begin(), row.end());
    }
    return picture;
}

Environment decodeExr(std::span<const uint8_t> bytes, PixelBudget& budget) {
    checkExrHeader(bytes, budget);
    try {
        return readExr(bytes);
    } catch (const LoadError&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        throw LoadError(std::string("it can not be read: ") + error.what());
    }
}
#else
Environment decodeExr(std::span<const uint8_t>, PixelBudget&) {
    throw LoadError("this program was built without OpenEXR, so it reads no .exr");
}
#endif

void turnOver(Environment& picture) {
    const std::size_t row = std::size_t(picture.width) * 3;
    for (std::size_t y = 0; y < picture.height / 2; ++y) {
        const auto upper = picture.rgb.begin() + std::ptrdiff_t(y * row);
        const auto lower = picture.rgb.end() - std::ptrdiff_t((y + 1) * row);
        std::swap_ranges(upper, upper + std::ptrdiff_t(row), lower);
    }
}

} // namespace

bool isEnvironmentFile(const std::filesystem::path& path) {
    const std::string ending = endingOf(path);
    return ending == ".exr" || ending == ".hdr";
}

Environment decodeEnvironment(std::span<const uint8_t> bytes, PixelBudget& budget) {
    constexpr float kBrightest = 1e9f; // light adds up, and must stay finite
    const bool radiance = bytes.size() >= 2 && bytes[0] == '#' && bytes[1] == '?';
    Environment picture = radiance ? decodeRadiance(bytes, budget) : decodeExr(bytes, budget);
    turnOver(picture);
    for (float& number : picture.rgb) number = number > 0 ? std::min(number, kBrightest) : 0;
    return picture;
}

Environment loadEnvironment(const std::filesystem::path& path) {
    try {
        PixelBudget budget{uint64_t(128) << 20};
        return decodeEnvironment(readWholeFile(path, kMaxFileBytes), budget);
    } catch (const LoadError& error) {
        throw std::runtime_error(oneLine(path.string()) + ": " + oneLine(error.what()));
    }
}

} // namespace samples

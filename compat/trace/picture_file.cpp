// SPDX-License-Identifier: MIT
#include "compat/trace/picture_file.h"

#include <png.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <regex>
#include <vector>

#include "openrt/enums.h"

namespace smart::compat {

namespace {

uint8_t byteOf(const std::byte* pixel, bool isFloat, unsigned component) {
    if (!isFloat) return uint8_t(pixel[component]);
    float value;
    std::memcpy(&value, pixel + component * sizeof value, sizeof value);
    return uint8_t(std::clamp(value >= 0 ? value : 0.0f, 0.0f, 1.0f) * 255.0f + 0.5f);
}

} // namespace

std::string nameOfPicture(const std::string& pattern, uint64_t number) {
    static const std::regex parts("([^%]*)%(0?)([0-9]?)d([^%]*\\.png)");
    std::smatch match;
    if (!std::regex_match(pattern, match, parts))
        throw StreamError("'" + pattern + "' is no pattern such as frame%03d.png");
    std::string digits = std::to_string(number);
    const std::size_t width = match[3].length() ? std::size_t(match[3].str()[0] - '0') : 0;
    if (digits.size() < width)
        digits.insert(0, width - digits.size(), match[2].length() ? '0' : ' ');
    return match[1].str() + digits + match[4].str();
}

void writePicture(const std::string& path, const PlayedFrame& frame) {
    const bool isReversed = frame.format == RT_BGR_32 || frame.format == RT_BGRA_8;
    const bool isFloat = frame.format == RT_BGR_32 || frame.format == RT_RGB_32F ||
                         frame.format == RT_RGBA_32F;
    const bool hasAlpha = frame.format == RT_RGBA_8 || frame.format == RT_BGRA_8 ||
                          frame.format == RT_RGBA_32F;
    const std::size_t pixelBytes = (hasAlpha ? 4u : 3u) * (isFloat ? sizeof(float) : 1u);
    std::vector<uint8_t> rgb;
    rgb.reserve(std::size_t(frame.width) * frame.height * 3);
    for (uint32_t y = frame.height; y-- > 0;)
        for (uint32_t x = 0; x < frame.width; ++x)
            for (unsigned c = 0; c < 3; ++c)
                rgb.push_back(byteOf(frame.pixels + y * frame.stride + x * pixelBytes, isFloat,
                                     isReversed ? 2 - c : c));
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = frame.width;
    image.height = frame.height;
    image.format = PNG_FORMAT_RGB;
    if (!png_image_write_to_file(&image, path.c_str(), 0, rgb.data(), 0, nullptr))
        throw StreamError(path + ": " + image.message);
}

} // namespace smart::compat

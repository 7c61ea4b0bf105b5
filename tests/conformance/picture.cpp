// SPDX-License-Identifier: MIT
#include "tests/conformance/picture.h"

#include <png.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

namespace conformance {

Picture readPng(const std::string& path) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_file(&image, path.c_str()))
        throw std::runtime_error(path + ": " + image.message);
    image.format = PNG_FORMAT_RGBA; // as RGB, libpng would put it on a background
    std::vector<std::uint8_t> rgba(PNG_IMAGE_SIZE(image));
    if (!png_image_finish_read(&image, nullptr, rgba.data(), 0, nullptr))
        throw std::runtime_error(path + ": " + image.message);
    Picture picture{int(image.width), int(image.height), {}};
    picture.pixels.resize(rgba.size() / 4);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        std::copy_n(&rgba[4 * i], 3, picture.pixels[i].begin());
    return picture;
}

void writePng(const std::string& path, const Picture& picture) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = png_uint_32(picture.width);
    image.height = png_uint_32(picture.height);
    image.format = PNG_FORMAT_RGB;
    if (!png_image_write_to_file(&image, path.c_str(), 0, picture.pixels.data(), 0, nullptr))
        throw std::runtime_error(path + ": " + image.message);
}

DepthPicture readPfm(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string kind;
    DepthPicture picture;
    float scale = 0;
    file >> kind >> picture.width >> picture.height >> scale;
    file.get();
    if (!file || kind != "Pf" || scale >= 0 || picture.width < 1 || picture.height < 1 ||
        picture.width > 16384 || picture.height > 16384)
        throw std::runtime_error(path + ": no little-endian PFM of one channel");
    const std::size_t width = std::size_t(picture.width), height = std::size_t(picture.height);
    picture.depth.resize(width * height);
    for (std::size_t row = height; row-- > 0;)
        file.read(reinterpret_cast<char*>(&picture.depth[row * width]),
                  std::streamsize(width * sizeof(float)));
    if (!file) throw std::runtime_error(path + ": too short");
    return picture;
}

} // namespace conformance

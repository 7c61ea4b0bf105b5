// SPDX-License-Identifier: MIT
#include "compat/rtut/picture.h"

#include <png.h>

#include <cstring>
#include <fstream>

namespace rtut {

std::string writePng(const std::string& path, const Picture& picture) {
    const std::size_t pixels = picture.rgba.size() / 4;
    std::vector<uint8_t> rgb(pixels * 3);
    for (std::size_t i = 0; i < pixels; ++i)
        std::memcpy(rgb.data() + 3 * i, picture.rgba.data() + 4 * i, 3);
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = png_uint_32(picture.size.width);
    image.height = png_uint_32(picture.size.height);
    image.format = PNG_FORMAT_RGB;
    // A negative stride: the first row in memory is the lowest of the picture.
    if (png_image_write_to_file(&image, path.c_str(), 0, rgb.data(), -3 * picture.size.width,
                                nullptr))
        return {};
    return image.message;
}

std::string writePfm(const std::string& path, const Picture& picture) {
    std::ofstream file(path, std::ios::binary);
    file << "Pf\n" << picture.size.width << ' ' << picture.size.height << "\n-1.0\n";
    file.write(reinterpret_cast<const char*>(picture.depth.data()),
               std::streamsize(picture.depth.size() * sizeof(float)));
    file.close();
    return file ? "" : "could not be written";
}

} // namespace rtut

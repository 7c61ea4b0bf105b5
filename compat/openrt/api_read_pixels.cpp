// SPDX-License-Identifier: MIT
// What is read back: the picture so far, into memory, textures, and the picture itself; and images
// of textures.
#include <memory>
#include <new>
#include <optional>
#include <vector>

#include "compat/openrt/guard.h"
#include "compat/openrt/image_formats.h"
#include "compat/openrt/texture_images.h"
#include "compat/recorder/pixel_pack.h"
#include "openrt/rt_textures.h"
#include "openrt/rt_window.h"

using namespace smart;
using namespace smart::compat;

namespace {

PackOrder packOrderOf(RTenum format) {
    switch (format) {
    case RT_RED: return PackOrder::Red;
    case RT_GREEN: return PackOrder::Green;
    case RT_BLUE: return PackOrder::Blue;
    case RT_ALPHA: return PackOrder::Alpha;
    case RT_RGB: return PackOrder::Rgb;
    case RT_RGBA: return PackOrder::Rgba;
    case RT_BGR: return PackOrder::Bgr;
    case RT_BGRA: return PackOrder::Bgra;
    case RT_LUMINANCE: return PackOrder::Luminance;
    case RT_LUMINANCE_ALPHA: return PackOrder::LuminanceAlpha;
    case RT_DEPTH_COMPONENT: return PackOrder::Depth;
    case RT_COLOR_INDEX:
    case RT_STENCIL_INDEX:
        throwError(ErrorCode::InvalidOperation, "there is no such buffer to be read");
    default: throwError(ErrorCode::InvalidEnum, "unknown pixel format");
    }
}

std::optional<PackFields> packFieldsOf(RTenum type) {
    switch (type) {
    case RT_UNSIGNED_BYTE_3_3_2: return PackFields{1, 3, {3, 3, 2}, false};
    case RT_UNSIGNED_BYTE_2_3_3_REV: return PackFields{1, 3, {2, 3, 3}, true};
    case RT_UNSIGNED_SHORT_5_6_5: return PackFields{2, 3, {5, 6, 5}, false};
    case RT_UNSIGNED_SHORT_5_6_5_REV: return PackFields{2, 3, {5, 6, 5}, true};
    case RT_UNSIGNED_SHORT_4_4_4_4: return PackFields{2, 4, {4, 4, 4, 4}, false};
    case RT_UNSIGNED_SHORT_4_4_4_4_REV: return PackFields{2, 4, {4, 4, 4, 4}, true};
    case RT_UNSIGNED_SHORT_5_5_5_1: return PackFields{2, 4, {5, 5, 5, 1}, false};
    case RT_UNSIGNED_SHORT_1_5_5_5_REV: return PackFields{2, 4, {1, 5, 5, 5}, true};
    case RT_UNSIGNED_INT_8_8_8_8: return PackFields{4, 4, {8, 8, 8, 8}, false};
    case RT_UNSIGNED_INT_8_8_8_8_REV: return PackFields{4, 4, {8, 8, 8, 8}, true};
    case RT_UNSIGNED_INT_10_10_10_2: return PackFields{4, 4, {10, 10, 10, 2}, false};
    case RT_UNSIGNED_INT_2_10_10_10_REV: return PackFields{4, 4, {2, 10, 10, 10}, true};
    default: return std::nullopt;
    }
}

PackType packTypeOf(RTenum type) {
    switch (type) {
    case RT_BYTE: return PackType::Byte;
    case RT_UNSIGNED_BYTE: return PackType::UnsignedByte;
    case RT_SHORT: return PackType::Short;
    case RT_UNSIGNED_SHORT: return PackType::UnsignedShort;
    case RT_INT: return PackType::Int;
    case RT_UNSIGNED_INT: return PackType::UnsignedInt;
    case RT_FLOAT: return PackType::Float;
    default: throwError(ErrorCode::InvalidEnum, "unknown pixel type");
    }
}

PackFormat packFormatOf(RTenum format, RTenum type) {
    PackFormat result;
    const std::optional<PackFields> fields = packFieldsOf(type);
    result.type = fields ? PackType::Fields : packTypeOf(type);
    result.order = packOrderOf(format);
    if (!fields) return result;
    result.fields = *fields;
    const bool fits = fields->count == 3 ? result.order == PackOrder::Rgb
                                         : result.order == PackOrder::Rgba ||
                                               result.order == PackOrder::Bgra;
    if (!fits) throwError(ErrorCode::InvalidOperation, "the type does not fit the format");
    return result;
}

void checkArea(RTsizei width, RTsizei height) {
    if (width < 0 || height < 0) throwError(ErrorCode::InvalidValue, "a size is negative");
}

/// A side of more pixels than any picture has; more would overflow.
constexpr RTsizei kMaxSide = 1 << 24;

constexpr PixelStore kPacked{.alignment = 1};

/// An area in bytes red, green, blue, alpha; 0 outside of the picture.
std::vector<std::byte> readBytes(const Picture& picture, const ReadArea& area) {
    std::vector<std::byte> bytes(std::size_t(area.width) * area.height * 4);
    packPixels(picture, area, {}, kPacked, glm::vec4(1.0f), glm::vec4(0.0f), bytes.data());
    return bytes;
}

void copyTexImage(const char* function, RTenum target, RTenum internalFormat, RTint x, RTint y,
                  const TextureImageCall& call) noexcept {
    recorded(function, [=](Context& c) {
        c.recorder().requireOutsideObject();
        checkTextureTarget(target, call.target);
        if (internalFormat < 5) throwError(ErrorCode::InvalidEnum, "not an internal format");
        checkTextureImage(call);
        const std::vector<std::byte> bytes =
            readBytes(c.frames().finishedPicture(false, PictureUse::Scene),
                      {x, y, uint32_t(call.width), uint32_t(call.height)});
        defineTextureImage(c, call, {bytes.data(), PixelOrder::Rgba, TexelType::Byte}, &kPacked);
    });
}

void copyTexSubImage(const char* function, RTenum target, RTint x, RTint y,
                     const TexturePartCall& call) noexcept {
    recorded(function, [=](Context& c) {
        c.recorder().requireOutsideObject();
        checkTextureTarget(target, call.target);
        checkTexturePart(c, call);
        const std::vector<std::byte> bytes =
            readBytes(c.frames().finishedPicture(false, PictureUse::Scene),
                      {x, y, uint32_t(call.width), uint32_t(call.height)});
        replaceTexturePart(c, call, {bytes.data(), PixelOrder::Rgba, TexelType::Byte}, &kPacked);
    });
}

/// A texel as OpenGL 1.5, table 6.1, has it.
glm::vec4 texelBack(const float* channels, const TextureLevelInfo& level) {
    switch (level.format) {
    case TexelFormat::Alpha: return {0.0f, 0.0f, 0.0f, channels[level.channels - 1]};
    case TexelFormat::Intensity: return {channels[0], 0.0f, 0.0f, 1.0f};
    default: break;
    }
    switch (level.channels) {
    case 1: return {channels[0], 0.0f, 0.0f, 1.0f};
    case 2: return {channels[0], 0.0f, 0.0f, channels[1]};
    case 3: return {channels[0], channels[1], channels[2], 1.0f};
    default: return {channels[0], channels[1], channels[2], channels[3]};
    }
}

std::vector<glm::vec4> texelsBack(const TextureImage& image, const TextureLevelInfo& level) {
    std::vector<glm::vec4> texels;
    texels.reserve(std::size_t(image.width()) * image.height());
    std::vector<float> row(std::size_t(image.width()) * image.channels());
    for (uint32_t y = 0; y < image.height(); ++y) {
        image.readRow(y, row.data());
        for (uint32_t x = 0; x < image.width(); ++x)
            texels.push_back(texelBack(&row[std::size_t(x) * image.channels()], level));
    }
    return texels;
}

} // namespace

RTAPI void RTAPIENTRY rtGetTexImage(RTenum target, RTint level, RTenum format, RTenum type,
                                    void* pixels) {
    guarded(__func__, [&](Context& c) {
        const TextureStore& textures = c.recorder().textures();
        const TextureTarget bound = textureTargetOf(target);
        const PackFormat packed = packFormatOf(format, type);
        if (level < 0 || uint32_t(level) > TextureStore::kMaxLevel)
            throwError(ErrorCode::InvalidValue, "levels go from 0 to 14");
        if (packed.order == PackOrder::Depth)
            throwError(ErrorCode::InvalidOperation, "textures hold colours");
        const TextureImagePtr image = textures.image(uint32_t(level), bound);
        if (!image) return;
        requirePointer(pixels, "pixels");
        std::vector<glm::vec4> texels =
            texelsBack(*image, textures.info(uint32_t(level), bound));
        Picture picture;
        picture.target.memory = texels.data();
        picture.target.width = image->width();
        picture.target.height = image->height();
        picture.target.format = PixelFormat::Rgba32f;
        packPixels(picture, {0, 0, image->width(), image->height()}, packed,
                   c.recorder().packStore(), glm::vec4(1.0f), glm::vec4(0.0f), pixels);
    });
}

RTAPI void RTAPIENTRY rtReadPixels(RTint x, RTint y, RTsizei width, RTsizei height, RTenum format,
                                   RTenum type, void* pixels) {
    guarded(__func__, [&](Context& c) {
        c.recorder().requireOutsideObject();
        const PackFormat packed = packFormatOf(format, type);
        checkArea(width, height);
        if (width == 0 || height == 0) return;
        requirePointer(pixels, "pixels");
        const Picture picture = c.frames().finishedPicture(packed.order == PackOrder::Depth,
                                                           PictureUse::Application);
        const PixelDrawing& transfer = c.recorder().pixelDrawingNow();
        packPixels(picture, {x, y, uint32_t(width), uint32_t(height)}, packed,
                   c.recorder().packStore(), transfer.scale, transfer.bias, pixels);
    });
}

RTAPI void RTAPIENTRY rtCopyTexImage1D(RTenum target, RTint level, RTenum internalformat, RTint x,
                                       RTint y, RTsizei width, RTint border) {
    copyTexImage(__func__, target, internalformat, x, y,
                 {level, RTint(internalformat), width, 1, border, TextureTarget::OneDimensional});
}
RTAPI void RTAPIENTRY rtCopyTexImage2D(RTenum target, RTint level, RTenum internalformat, RTint x,
                                       RTint y, RTsizei width, RTsizei height, RTint border) {
    copyTexImage(__func__, target, internalformat, x, y,
                 {level, RTint(internalformat), width, height, border});
}

RTAPI void RTAPIENTRY rtCopyTexSubImage1D(RTenum target, RTint level, RTint xoffset, RTint x,
                                          RTint y, RTsizei width) {
    copyTexSubImage(__func__, target, x, y,
                    {level, xoffset, 0, width, 1, TextureTarget::OneDimensional});
}
RTAPI void RTAPIENTRY rtCopyTexSubImage2D(RTenum target, RTint level, RTint xoffset,
                                          RTint yoffset, RTint x, RTint y, RTsizei width,
                                          RTsizei height) {
    copyTexSubImage(__func__, target, x, y, {level, xoffset, yoffset, width, height});
}

RTAPI void RTAPIENTRY rtCopyPixels(RTint x, RTint y, RTsizei width, RTsizei height, RTenum type) {
    recorded(__func__, [=](Context& c) {
        c.recorder().requireOutsideObject();
        if (type == RT_DEPTH || type == RT_STENCIL)
            throwError(ErrorCode::InvalidOperation, "only colours can be copied in the picture");
        if (type != RT_COLOR) throwError(ErrorCode::InvalidEnum, "unknown kind of pixels");
        checkArea(width, height);
        if (width == 0 || height == 0) return;
        if (width > kMaxSide || height > kMaxSide) throw std::bad_alloc();
        const Picture picture = c.frames().finishedPicture(false, PictureUse::Scene);
        const auto image = std::make_shared<ImagePixels>();
        image->width = uint32_t(width);
        image->height = uint32_t(height);
        image->type = TexelType::Byte;
        image->data = readBytes(picture, {x, y, image->width, image->height});
        c.recorder().drawPixels(image);
    });
}

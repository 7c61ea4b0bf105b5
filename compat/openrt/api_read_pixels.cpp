// SPDX-License-Identifier: MIT
// What is read back: the picture so far, into memory, textures, and the picture itself; and images
// of textures.
#include <memory>
#include <new>
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

void checkArea(RTsizei width, RTsizei height) {
    if (width < 0 || height < 0) throwError(ErrorCode::InvalidValue, "a size is negative");
}

/// A side of more pixels than any picture has; more would overflow.
constexpr RTsizei kMaxSide = 1 << 24;

constexpr PixelStore kPacked{.alignment = 1};

/// An area in bytes red, green, blue, alpha; 0 outside of the picture.
std::vector<std::byte> readBytes(const Picture& picture, const ReadArea& area,
                                 const PixelTransfer& transfer = {}) {
    std::vector<std::byte> bytes(std::size_t(area.width) * area.height * 4);
    packPixels(picture, area, {}, kPacked, transfer, bytes.data());
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
                      {x, y, uint32_t(call.width), uint32_t(call.height)},
                      c.recorder().pixelDrawing().transfer);
        setTextureImage(c, call, makeTextureImage(call, {bytes.data(), {}, kPacked}));
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
                      {x, y, uint32_t(call.width), uint32_t(call.height)},
                      c.recorder().pixelDrawing().transfer);
        replaceTexturePart(c, call, {bytes.data(), {}, kPacked});
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
        const PixelLayout layout = pixelLayoutOf(format, type);
        if (level < 0 || uint32_t(level) > TextureStore::kMaxLevel)
            throwError(ErrorCode::InvalidValue, "levels go from 0 to 14");
        if (layout.order == PixelOrder::Depth)
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
        packPixels(picture, {0, 0, image->width(), image->height()}, layout,
                   c.recorder().packStore(), {}, pixels);
    });
}

RTAPI void RTAPIENTRY rtReadPixels(RTint x, RTint y, RTsizei width, RTsizei height, RTenum format,
                                   RTenum type, void* pixels) {
    guarded(__func__, [&](Context& c) {
        c.recorder().requireOutsideObject();
        const PixelLayout layout = pixelLayoutOf(format, type);
        checkArea(width, height);
        if (width == 0 || height == 0) return;
        requirePointer(pixels, "pixels");
        const Picture picture = c.frames().finishedPicture(layout.order == PixelOrder::Depth,
                                                           PictureUse::Application);
        packPixels(picture, {x, y, uint32_t(width), uint32_t(height)}, layout,
                   c.recorder().packStore(), c.recorder().pixelDrawingNow().transfer, pixels);
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

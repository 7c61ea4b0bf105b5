// SPDX-License-Identifier: MIT
#include "compat/openrt/texture_images.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "compat/openrt/guard.h"
#include "compat/openrt/image_formats.h"

namespace smart::compat {

namespace {

void checkLevel(RTint level) {
    if (level < 0 || uint32_t(level) > TextureStore::kMaxLevel)
        throwError(ErrorCode::InvalidValue, "levels go from 0 to 14");
}

void checkSize(RTsizei width, RTsizei height) {
    if (width < 0 || height < 0) throwError(ErrorCode::InvalidValue, "an image's size is negative");
}

uint32_t largestSide(RTint level) {
    return TextureStore::kMaxSize >> level;
}
bool fitsLevel(RTint level, RTsizei width, RTsizei height) {
    return uint32_t(width) <= largestSide(level) && uint32_t(height) <= largestSide(level);
}

void checkSizeOfLevel(RTint level, RTsizei width, RTsizei height) {
    checkSize(width, height);
    if (!fitsLevel(level, width, height))
        throwError(ErrorCode::InvalidValue,
                   "images of level " + std::to_string(level) + " have " +
                       std::to_string(largestSide(level)) + " texels a side at most");
}

void checkBorder(RTint border) {
    if (border < 0 || border > 1) throwError(ErrorCode::InvalidValue, "a border is 0 or 1");
}
void refuseBorder(RTint border) {
    if (border > 0)
        throwError(ErrorCode::InvalidOperation, "texture borders are not part of this release");
}

/// The layout of pixels that go into an image of colours (or, empty `internal`, of depths); empty:
/// OpenGL has such images, this library has not.
std::optional<PixelLayout> layoutFor(const std::optional<InternalFormat>& internal, RTenum format,
                                     RTenum type) {
    const bool areIndices = format == RT_COLOR_INDEX;
    if (areIndices && type == RT_BITMAP && internal) return std::nullopt;
    const PixelLayout layout = pixelLayoutOf(areIndices ? RT_RED : format, type);
    if ((layout.order == PixelOrder::Depth) == internal.has_value())
        throwError(ErrorCode::InvalidOperation,
                   "an image holds depths, its pixels colours, or the other way round");
    if (areIndices || !internal) return std::nullopt;
    return layout;
}

TextureImage imageOf(const TexturePixels& pixels, RTsizei width, RTsizei height,
                     const InternalFormat& internal) {
    const ImageSource source{pixels.pixels, uint32_t(width), uint32_t(height), pixels.layout};
    const TexelType type = texelTypeFor(pixels.layout);
    return {source.width, source.height, internal.channels, type, internal.srgb,
            unpackImage(source, pixels.store, internal.channels, type, internal.format,
                        pixels.transfer)};
}

} // namespace

void checkTextureImage(const TextureImageCall& call) {
    internalFormatOf(call.internalFormat);
    checkLevel(call.level);
    checkSizeOfLevel(call.level, call.width, call.height);
    checkBorder(call.border);
    refuseBorder(call.border);
}

void checkTexturePart(Context& context, const TexturePartCall& call) {
    checkLevel(call.level);
    checkSize(call.width, call.height);
    const TextureLevelInfo info = context.recorder().textures().info(uint32_t(call.level), call.target);
    if (info.channels == 0) throwError(ErrorCode::InvalidOperation, "the level has no image");
    if (call.xoffset < 0 || call.yoffset < 0 || int64_t(call.xoffset) + call.width > info.width ||
        int64_t(call.yoffset) + call.height > info.height)
        throwError(ErrorCode::InvalidValue, "the part does not lie inside the image");
}

TextureImagePtr makeTextureImage(const TextureImageCall& call, const TexturePixels& pixels) {
    checkTextureImage(call);
    if (call.width == 0 || call.height == 0) return nullptr;
    const InternalFormat internal = internalFormatOf(call.internalFormat);
    return std::make_shared<TextureImage>(imageOf(pixels, call.width, call.height, internal));
}

void setTextureImage(Context& context, const TextureImageCall& call, TextureImagePtr image) {
    context.recorder().textures().setImage(uint32_t(call.level), std::move(image),
                                           call.internalFormat,
                                           internalFormatOf(call.internalFormat).format,
                                           call.target);
}

void setProxyImage(Context& context, const TextureImageCall& call, RTenum format, RTenum type) {
    TextureStore& textures = context.recorder().textures();
    const std::optional<InternalFormat> internal = findInternalFormat(call.internalFormat);
    const std::optional<PixelLayout> layout = layoutFor(internal, format, type);
    checkLevel(call.level);
    checkSize(call.width, call.height);
    checkBorder(call.border);
    TextureLevelInfo info;
    if (layout && call.border == 0 && call.width > 0 && call.height > 0 &&
        fitsLevel(call.level, call.width, call.height))
        info = {uint32_t(call.width), uint32_t(call.height), internal->channels,
                texelTypeFor(*layout), call.internalFormat,  internal->format};
    textures.setProxy(uint32_t(call.level), info, call.target);
}

void replaceTexturePart(Context& context, const TexturePartCall& call,
                        const TexturePixels& pixels) {
    TextureStore& textures = context.recorder().textures();
    checkTexturePart(context, call);
    if (call.width == 0 || call.height == 0) return;
    requirePointer(pixels.pixels, "pixels");
    const auto level = uint32_t(call.level);
    const TextureLevelInfo info = textures.info(level, call.target);
    const InternalFormat internal = internalFormatOf(info.internalFormat);
    const TextureImage part = imageOf(pixels, call.width, call.height, internal);
    textures.setPart(level, uint32_t(call.xoffset), uint32_t(call.yoffset), part, call.target);
}

} // namespace smart::compat

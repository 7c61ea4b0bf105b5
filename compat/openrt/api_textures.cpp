// SPDX-License-Identifier: MIT
// Textures and their images; how they are looked up stands in api_texture_parameters.cpp.
#include <cmath>
#include <memory>
#include <utility>

#include "compat/openrt/guard.h"
#include "compat/openrt/image_formats.h"
#include "openrt/rt_textures.h"

using namespace smart;
using namespace smart::compat;

namespace {

void requireNames(RTsizei n, const RTuint* textures) {
    if (n < 0) throwError(ErrorCode::InvalidValue, "n is negative");
    if (n > 0) requirePointer(textures, "textures");
}

void checkLevel(RTint level) {
    if (level < 0 || uint32_t(level) > TextureStore::kMaxLevel)
        throwError(ErrorCode::InvalidValue, "levels go from 0 to 14");
}

void checkSize(RTsizei width, RTsizei height) {
    if (width < 0 || height < 0) throwError(ErrorCode::InvalidValue, "an image's size is negative");
}

void checkSizeOfLevel(RTint level, RTsizei width, RTsizei height) {
    checkSize(width, height);
    const uint32_t largest = TextureStore::kMaxSize >> level;
    if (uint32_t(width) > largest || uint32_t(height) > largest)
        throwError(ErrorCode::InvalidValue,
                   "images of level " + std::to_string(level) + " have " +
                       std::to_string(largest) + " texels a side at most");
}

void checkBorder(RTint border) {
    if (border < 0 || border > 1) throwError(ErrorCode::InvalidValue, "a border is 0 or 1");
    if (border > 0)
        throwError(ErrorCode::InvalidOperation, "texture borders are not part of this release");
}

void setPixelStore(const char* function, RTenum pname, RTint param) noexcept {
    guarded(function, [&](Context& c) {
        PixelStore& store = c.recorder().pixelStore();
        const auto count = [param] {
            if (param < 0) throwError(ErrorCode::InvalidValue, "a length is negative");
            return uint32_t(param);
        };
        switch (pname) {
        case RT_UNPACK_ALIGNMENT:
            if (param != 1 && param != 2 && param != 4 && param != 8)
                throwError(ErrorCode::InvalidValue, "an alignment is 1, 2, 4 or 8");
            store.alignment = uint32_t(param);
            break;
        case RT_UNPACK_ROW_LENGTH: store.rowLength = count(); break;
        case RT_UNPACK_SKIP_PIXELS: store.skipPixels = count(); break;
        case RT_UNPACK_SKIP_ROWS: store.skipRows = count(); break;
        case RT_UNPACK_SWAP_BYTES: store.swapBytes = param != 0; break;
        case RT_UNPACK_LSB_FIRST: store.lsbFirst = param != 0; break;
        case RT_UNPACK_IMAGE_HEIGHT:
        case RT_UNPACK_SKIP_IMAGES:
        case RT_PACK_ALIGNMENT:
        case RT_PACK_ROW_LENGTH:
        case RT_PACK_SKIP_PIXELS:
        case RT_PACK_SKIP_ROWS:
        case RT_PACK_SWAP_BYTES:
        case RT_PACK_LSB_FIRST:
        case RT_PACK_IMAGE_HEIGHT:
        case RT_PACK_SKIP_IMAGES:
            throwError(ErrorCode::InvalidOperation,
                       "this way of storing pixels is not part of this release");
        default: throwError(ErrorCode::InvalidEnum, "unknown way of storing pixels");
        }
    });
}

/// To the nearest whole number, as OpenGL converts parameters; what is out of range names nothing.
RTint rounded(RTfloat param) {
    return std::fabs(param) < 0x1p30f ? RTint(std::floor(param + 0.5f)) : -1;
}

} // namespace

RTAPI void RTAPIENTRY rtGenTextures(RTsizei n, RTuint* textures) {
    guarded(__func__, [&](Context& c) {
        TextureStore& store = c.recorder().textures();
        requireNames(n, textures);
        RTsizei made = 0;
        try {
            for (; made < n; ++made) textures[made] = store.generate();
        } catch (...) {
            while (made > 0) store.remove(textures[--made]);
            throw;
        }
    });
}

RTAPI void RTAPIENTRY rtDeleteTextures(RTsizei n, const RTuint* textures) {
    guarded(__func__, [&](Context& c) {
        TextureStore& store = c.recorder().textures();
        requireNames(n, textures);
        for (RTsizei i = 0; i < n; ++i) store.remove(textures[i]);
    });
}

RTAPI void RTAPIENTRY rtBindTexture(RTenum target, RTuint texture) {
    recorded(__func__, [=](Context& c) {
        TextureStore& textures = c.recorder().textures();
        checkTextureTarget(target);
        textures.bind(texture);
    });
}

RTAPI RTboolean RTAPIENTRY rtIsTexture(RTuint texture) {
    return guardedOr<RTboolean>(RT_FALSE, __func__, [&](Context& c) -> RTboolean {
        return c.recorder().textures().exists(texture) ? RT_TRUE : RT_FALSE;
    });
}

RTAPI void RTAPIENTRY rtTexImage2D(RTenum target, RTint level, RTint internalFormat, RTsizei width,
                                   RTsizei height, RTint border, RTenum format, RTenum type,
                                   const void* pixels) {
    guarded(__func__, [&](Context& c) {
        TextureStore& textures = c.recorder().textures();
        checkTextureTarget(target);
        const PixelOrder order = pixelOrderOf(format);
        const TexelType texelType = texelTypeOf(type);
        const InternalFormat internal = internalFormatOf(internalFormat);
        checkLevel(level);
        checkSizeOfLevel(level, width, height);
        checkBorder(border);
        if (width == 0 || height == 0) {
            textures.setImage(uint32_t(level), nullptr, internalFormat);
            return;
        }
        const ImageSource source{pixels, uint32_t(width), uint32_t(height), order, texelType};
        textures.setImage(
            uint32_t(level),
            std::make_shared<const TextureImage>(
                source.width, source.height, internal.channels, texelType, internal.srgb,
                unpackImage(source, c.recorder().pixelStore(), internal.channels,
                            internal.format)),
            internalFormat, internal.format);
    });
}

RTAPI void RTAPIENTRY rtTexSubImage2D(RTenum target, RTint level, RTint xoffset, RTint yoffset,
                                      RTsizei width, RTsizei height, RTenum format, RTenum type,
                                      const void* pixels) {
    guarded(__func__, [&](Context& c) {
        TextureStore& textures = c.recorder().textures();
        checkTextureTarget(target);
        const PixelOrder order = pixelOrderOf(format);
        const TexelType texelType = texelTypeOf(type);
        checkLevel(level);
        checkSize(width, height);
        const TextureLevelInfo info = textures.info(uint32_t(level));
        if (info.channels == 0)
            throwError(ErrorCode::InvalidOperation, "the level has no image");
        if (xoffset < 0 || yoffset < 0 || int64_t(xoffset) + width > info.width ||
            int64_t(yoffset) + height > info.height)
            throwError(ErrorCode::InvalidValue, "the part does not lie inside the image");
        if (width == 0 || height == 0) return;
        requirePointer(pixels, "pixels");
        const ImageSource source{pixels, uint32_t(width), uint32_t(height), order, texelType};
        const InternalFormat internal = internalFormatOf(info.internalFormat);
        const TextureImage part(source.width, source.height, info.channels, texelType,
                                internal.srgb,
                                unpackImage(source, c.recorder().pixelStore(), info.channels,
                                            internal.format));
        textures.setImage(uint32_t(level),
                          std::make_shared<const TextureImage>(
                              textures.image(uint32_t(level))
                                  ->withPart(uint32_t(xoffset), uint32_t(yoffset), part)),
                          info.internalFormat, internal.format);
    });
}

RTAPI void RTAPIENTRY rtPixelStorei(RTenum pname, RTint param) {
    setPixelStore(__func__, pname, param);
}
RTAPI void RTAPIENTRY rtPixelStoref(RTenum pname, RTfloat param) {
    setPixelStore(__func__, pname, rounded(param));
}

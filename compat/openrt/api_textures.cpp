// SPDX-License-Identifier: MIT
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

void checkSize(RTsizei width, RTsizei height) {
    if (width < 0 || height < 0) throwError(ErrorCode::InvalidValue, "an image's size is negative");
    if (uint32_t(width) > TextureStore::kMaxSize || uint32_t(height) > TextureStore::kMaxSize)
        throwError(ErrorCode::InvalidValue, "images have 16384 texels a side at most");
}

void checkLevelAndBorder(RTint level, RTint border) {
    if (level < 0) throwError(ErrorCode::InvalidValue, "a level is negative");
    if (border < 0 || border > 1) throwError(ErrorCode::InvalidValue, "a border is 0 or 1");
    if (level > 0) throwError(ErrorCode::InvalidOperation, "mipmaps are not part of this release");
    if (border > 0)
        throwError(ErrorCode::InvalidOperation, "texture borders are not part of this release");
}

void setTexParameter(const char* function, RTenum target, RTenum pname, RTint param) noexcept {
    guarded(function, [&](Context& c) {
        TextureStore& textures = c.recorder().textures();
        checkTextureTarget(target);
        TextureOptions options = textures.options();
        switch (pname) {
        case RT_TEXTURE_WRAP_S: options.wrapS = textureWrapOf(param); break;
        case RT_TEXTURE_WRAP_T: options.wrapT = textureWrapOf(param); break;
        case RT_TEXTURE_MAG_FILTER: options.filter = magFilterOf(param); break;
        case RT_TEXTURE_MIN_FILTER: checkMinFilter(param); return;
        case RT_TEXTURE_WRAP_R:
        case RT_TEXTURE_BORDER_COLOR:
        case RT_TEXTURE_PRIORITY:
        case RT_TEXTURE_MIN_LOD:
        case RT_TEXTURE_MAX_LOD:
        case RT_TEXTURE_BASE_LEVEL:
        case RT_TEXTURE_MAX_LEVEL:
        case RT_TEXTURE_LOD_BIAS:
        case RT_DEPTH_TEXTURE_MODE:
        case RT_TEXTURE_COMPARE_MODE:
        case RT_TEXTURE_COMPARE_FUNC:
        case RT_GENERATE_MIPMAP:
            throwError(ErrorCode::InvalidOperation,
                       "this texture parameter is not part of this release");
        default: throwError(ErrorCode::InvalidEnum, "unknown texture parameter");
        }
        textures.setOptions(options);
    });
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
        case RT_UNPACK_LSB_FIRST:
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
    guarded(__func__, [&](Context& c) {
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
        checkSize(width, height);
        checkLevelAndBorder(level, border);
        if (internal.srgb && texelType != TexelType::Byte)
            throwError(ErrorCode::InvalidOperation, "sRGB images consist of bytes");
        if (width == 0 || height == 0) {
            textures.setImage(nullptr);
            return;
        }
        TextureOptions options = textures.options();
        options.srgb = internal.srgb;
        const ImageSource source{pixels, uint32_t(width), uint32_t(height), order, texelType};
        textures.setImage(std::make_shared<const Texture>(
            source.width, source.height, internal.channels, texelType,
            unpackImage(source, c.recorder().pixelStore(), internal.channels), options));
    });
}

RTAPI void RTAPIENTRY rtTexParameteri(RTenum target, RTenum pname, RTint param) {
    setTexParameter(__func__, target, pname, param);
}
RTAPI void RTAPIENTRY rtTexParameterf(RTenum target, RTenum pname, RTfloat param) {
    setTexParameter(__func__, target, pname, rounded(param));
}
RTAPI void RTAPIENTRY rtPixelStorei(RTenum pname, RTint param) {
    setPixelStore(__func__, pname, param);
}
RTAPI void RTAPIENTRY rtPixelStoref(RTenum pname, RTfloat param) {
    setPixelStore(__func__, pname, rounded(param));
}

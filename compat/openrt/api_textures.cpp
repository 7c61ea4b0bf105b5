// SPDX-License-Identifier: MIT
// Textures and their images; how they are looked up stands in api_texture_parameters.cpp.
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "compat/openrt/guard.h"
#include "compat/openrt/image_formats.h"
#include "compat/openrt/texture_images.h"
#include "compat/recorder/pixel_unpack.h"
#include "openrt/rt_textures.h"

using namespace smart;
using namespace smart::compat;

namespace {

void requireNames(RTsizei n, const RTuint* textures) {
    if (n < 0) throwError(ErrorCode::InvalidValue, "n is negative");
    if (n > 0) requirePointer(textures, "textures");
}

bool isOfPacking(RTenum pname) {
    return pname >= RT_PACK_SWAP_BYTES && pname <= RT_PACK_ALIGNMENT;
}

void setPixelStore(const char* function, RTenum pname, RTint param) noexcept {
    guarded(function, [&](Context& c) {
        PixelStore& store = isOfPacking(pname) ? c.recorder().packStore()
                                               : c.recorder().pixelStore();
        const auto count = [param] {
            if (param < 0) throwError(ErrorCode::InvalidValue, "a length is negative");
            return uint32_t(param);
        };
        switch (pname) {
        case RT_UNPACK_ALIGNMENT:
        case RT_PACK_ALIGNMENT:
            if (param != 1 && param != 2 && param != 4 && param != 8)
                throwError(ErrorCode::InvalidValue, "an alignment is 1, 2, 4 or 8");
            store.alignment = uint32_t(param);
            break;
        case RT_UNPACK_ROW_LENGTH:
        case RT_PACK_ROW_LENGTH: store.rowLength = count(); break;
        case RT_UNPACK_SKIP_PIXELS:
        case RT_PACK_SKIP_PIXELS: store.skipPixels = count(); break;
        case RT_UNPACK_SKIP_ROWS:
        case RT_PACK_SKIP_ROWS: store.skipRows = count(); break;
        case RT_UNPACK_SWAP_BYTES:
        case RT_PACK_SWAP_BYTES: store.swapBytes = param != 0; break;
        case RT_UNPACK_LSB_FIRST:
        case RT_PACK_LSB_FIRST: store.lsbFirst = param != 0; break;
        case RT_UNPACK_IMAGE_HEIGHT:
        case RT_UNPACK_SKIP_IMAGES:
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

TexturePixels pixelsOf(Context& c, RTenum format, RTenum type, const void* pixels) {
    return {pixels, colorLayoutOf(format, type), c.recorder().pixelStore(),
            c.recorder().pixelDrawingNow().transfer};
}

/// The application's memory is read when the call is made, also for display lists. Of proxies
/// nothing is read, and they are no part of lists (OpenGL 1.5, section 5.4).
void texImage(const char* function, RTenum target, const TextureImageCall& call, RTenum format,
              RTenum type, const void* pixels) noexcept {
    TextureImagePtr image;
    bool made = false;
    guarded(function, [&](Context& c) {
        if (proxiedTargetOf(target) == call.target) return setProxyImage(c, call, format, type);
        checkTextureTarget(target, call.target);
        image = makeTextureImage(call, pixelsOf(c, format, type, pixels));
        made = true;
    });
    if (made) recorded(function, [=](Context& c) { setTextureImage(c, call, image); });
}

/// A part for a display list, which does not know yet what kind of image it will go into.
struct KeptPart {
    std::vector<std::byte> texels; ///< red, green, blue, alpha; empty: there is nothing to replace
    TexelType type;

    KeptPart(const TexturePartCall& call, const TexturePixels& pixels)
        : type(texelTypeFor(pixels.layout)) {
        const auto fits = [](RTsizei side) {
            return side > 0 && uint32_t(side) <= TextureStore::kMaxSize;
        };
        if (!fits(call.width) || !fits(call.height)) return;
        requirePointer(pixels.pixels, "pixels");
        texels = unpackImage(
            {pixels.pixels, uint32_t(call.width), uint32_t(call.height), pixels.layout},
            pixels.store, 4, type, TexelFormat::ByChannels, pixels.transfer);
    }
    TexturePixels pixels() const {
        return {texels.empty() ? nullptr : texels.data(), rgbaLayoutOf(type), {.alignment = 1}};
    }
};

void texSubImage(const char* function, RTenum target, const TexturePartCall& call, RTenum format,
                 RTenum type, const void* pixels) noexcept {
    std::shared_ptr<const KeptPart> kept;
    guarded(function, [&](Context& c) {
        checkTextureTarget(target, call.target);
        const TexturePixels given = pixelsOf(c, format, type, pixels);
        if (c.lists().recording())
            kept = std::make_shared<const KeptPart>(call, given);
        else
            replaceTexturePart(c, call, given);
    });
    if (kept)
        recorded(function, [=](Context& c) { replaceTexturePart(c, call, kept->pixels()); });
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
        textures.bind(texture, textureTargetOf(target));
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
    texImage(__func__, target, {level, internalFormat, width, height, border}, format, type,
             pixels);
}
RTAPI void RTAPIENTRY rtTexImage1D(RTenum target, RTint level, RTint internalFormat, RTsizei width,
                                   RTint border, RTenum format, RTenum type, const void* pixels) {
    texImage(__func__, target,
             {level, internalFormat, width, 1, border, TextureTarget::OneDimensional}, format,
             type, pixels);
}

RTAPI void RTAPIENTRY rtTexSubImage2D(RTenum target, RTint level, RTint xoffset, RTint yoffset,
                                      RTsizei width, RTsizei height, RTenum format, RTenum type,
                                      const void* pixels) {
    texSubImage(__func__, target, {level, xoffset, yoffset, width, height}, format, type, pixels);
}
RTAPI void RTAPIENTRY rtTexSubImage1D(RTenum target, RTint level, RTint xoffset, RTsizei width,
                                      RTenum format, RTenum type, const void* pixels) {
    texSubImage(__func__, target, {level, xoffset, 0, width, 1, TextureTarget::OneDimensional},
                format, type, pixels);
}

RTAPI void RTAPIENTRY rtPrioritizeTextures(RTsizei n, const RTuint* textures,
                                           const RTclampf* priorities) {
    guarded(__func__, [&](Context& c) {
        c.recorder().requireOutsidePrimitive();
        requireNames(n, textures);
        if (n > 0) requirePointer(priorities, "priorities");
    });
}
RTAPI RTboolean RTAPIENTRY rtAreTexturesResident(RTsizei n, const RTuint* textures,
                                                 RTboolean* residences) {
    return guardedOr<RTboolean>(RT_FALSE, __func__, [&](Context& c) -> RTboolean {
        const TextureStore& store = c.recorder().textures();
        requireNames(n, textures);
        if (n > 0) requirePointer(residences, "residences");
        for (RTsizei i = 0; i < n; ++i)
            if (!store.exists(textures[i]))
                throwError(ErrorCode::InvalidValue, "no texture has this name");
        return RT_TRUE;
    });
}

RTAPI void RTAPIENTRY rtPixelStorei(RTenum pname, RTint param) {
    setPixelStore(__func__, pname, param);
}
RTAPI void RTAPIENTRY rtPixelStoref(RTenum pname, RTfloat param) {
    setPixelStore(__func__, pname, rounded(param));
}

// SPDX-License-Identifier: MIT
// Images of textures, wherever their pixels come from.
#pragma once

#include "compat/recorder/context.h"
#include "compat/recorder/pixel_unpack.h"
#include "openrt/types.h"

namespace smart::compat {

/// The pixels of a call, as many as it names.
struct TexturePixels {
    const void* pixels; ///< nullptr: zeros, or nothing to replace
    PixelLayout layout;
    PixelStore store;
    PixelTransfer transfer = {};
};

struct TextureImageCall {
    RTint level, internalFormat;
    RTsizei width, height;
    RTint border;
    TextureTarget target = TextureTarget::TwoDimensional;
};
struct TexturePartCall {
    RTint level, xoffset, yoffset;
    RTsizei width, height;
    TextureTarget target = TextureTarget::TwoDimensional;
};

/// What is asked for, as OpenGL checks it: throws Error where it can not be.
void checkTextureImage(const TextureImageCall& call);
void checkTexturePart(Context& context, const TexturePartCall& call);

/// The image that the call defines, after the check; nullptr: none, as a side is 0.
TextureImagePtr makeTextureImage(const TextureImageCall& call, const TexturePixels& pixels);
/// A level of the bound texture anew.
void setTextureImage(Context& context, const TextureImageCall& call, TextureImagePtr image);
/// What OpenGL keeps of a proxy's level, OpenGL 1.5, section 3.8.11: how the image would be, without
/// one; 0 where the library can not have it. Throws Error only for what is wrong in itself.
void setProxyImage(Context& context, const TextureImageCall& call, RTenum format, RTenum type);
/// A part of a level anew, after the check.
void replaceTexturePart(Context& context, const TexturePartCall& call,
                        const TexturePixels& pixels);

} // namespace smart::compat

// SPDX-License-Identifier: MIT
// OpenGL's names of image formats, and what they name inside. Functions throw Error for others.
#pragma once

#include "compat/recorder/pixel_layout.h"
#include "compat/recorder/texture_store.h"
#include "libsmart/shading/texture.h"
#include "openrt/types.h"

namespace smart::compat {

struct InternalFormat {
    uint32_t channels;
    bool srgb;
    TexelFormat format = TexelFormat::ByChannels;
};
InternalFormat internalFormatOf(RTint format);
/// Colours, or depths.
PixelLayout pixelLayoutOf(RTenum format, RTenum type);
/// Colours.
PixelLayout colorLayoutOf(RTenum format, RTenum type);
TextureWrap textureWrapOf(RTint wrap);
RTenum tokenOf(TextureWrap wrap);
/// A value of RT_TEXTURE_MAG_FILTER, of RT_TEXTURE_MIN_FILTER.
TextureFilter magFilterOf(RTint filter);
MinificationFilter minFilterOf(RTint filter);
RTenum tokenOf(const MinificationFilter& filter);
/// Of RT_TEXTURE_1D and RT_TEXTURE_2D.
TextureTarget textureTargetOf(RTenum target);
/// Throws unless it is the target with so many dimensions.
void checkTextureTarget(RTenum target, TextureTarget wanted = TextureTarget::TwoDimensional);

} // namespace smart::compat

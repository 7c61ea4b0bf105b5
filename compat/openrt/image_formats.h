// SPDX-License-Identifier: MIT
// OpenGL's names of image formats, and what they name inside. Functions throw Error for others.
#pragma once

#include <optional>

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
/// Empty: one of OpenGL's formats of depths, which this library has not.
std::optional<InternalFormat> findInternalFormat(RTint format);
/// Of colours.
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
/// The target that RT_PROXY_TEXTURE_1D or _2D stands for; empty: the target is none of them.
std::optional<TextureTarget> proxiedTargetOf(RTenum target);
/// Throws unless it is the target with so many dimensions.
void checkTextureTarget(RTenum target, TextureTarget wanted = TextureTarget::TwoDimensional);

} // namespace smart::compat

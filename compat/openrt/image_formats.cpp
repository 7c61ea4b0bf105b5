// SPDX-License-Identifier: MIT
#include "compat/openrt/image_formats.h"

#include <string>

#include "compat/openrt/guard.h"

namespace smart::compat {

namespace {

[[noreturn]] void notInRelease(const char* what) {
    throwError(ErrorCode::InvalidOperation, std::string(what) + " is not part of this release");
}

} // namespace

std::optional<InternalFormat> findInternalFormat(RTint format) {
    switch (format) {
    case 1:
    case RT_LUMINANCE:
    case RT_LUMINANCE4:
    case RT_LUMINANCE8:
    case RT_LUMINANCE12:
    case RT_LUMINANCE16:
    case RT_COMPRESSED_LUMINANCE: return InternalFormat{1, false};
    case 2:
    case RT_LUMINANCE_ALPHA:
    case RT_LUMINANCE4_ALPHA4:
    case RT_LUMINANCE6_ALPHA2:
    case RT_LUMINANCE8_ALPHA8:
    case RT_LUMINANCE12_ALPHA4:
    case RT_LUMINANCE12_ALPHA12:
    case RT_LUMINANCE16_ALPHA16:
    case RT_COMPRESSED_LUMINANCE_ALPHA: return InternalFormat{2, false};
    case 3:
    case RT_RGB:
    case RT_R3_G3_B2:
    case RT_RGB4:
    case RT_RGB5:
    case RT_RGB8:
    case RT_RGB10:
    case RT_RGB12:
    case RT_RGB16:
    case RT_COMPRESSED_RGB: return InternalFormat{3, false};
    case 4:
    case RT_RGBA:
    case RT_RGBA2:
    case RT_RGBA4:
    case RT_RGB5_A1:
    case RT_RGBA8:
    case RT_RGB10_A2:
    case RT_RGBA12:
    case RT_RGBA16:
    case RT_COMPRESSED_RGBA: return InternalFormat{4, false};
    case RT_SRGB:
    case RT_SRGB8: return InternalFormat{3, true};
    case RT_SRGB_ALPHA:
    case RT_SRGB8_ALPHA8: return InternalFormat{4, true};
    case RT_ALPHA:
    case RT_ALPHA4:
    case RT_ALPHA8:
    case RT_ALPHA12:
    case RT_ALPHA16:
    case RT_COMPRESSED_ALPHA: return InternalFormat{4, false, TexelFormat::Alpha};
    case RT_INTENSITY:
    case RT_INTENSITY4:
    case RT_INTENSITY8:
    case RT_INTENSITY12:
    case RT_INTENSITY16:
    case RT_COMPRESSED_INTENSITY: return InternalFormat{4, false, TexelFormat::Intensity};
    case RT_DEPTH_COMPONENT:
    case RT_DEPTH_COMPONENT16:
    case RT_DEPTH_COMPONENT24:
    case RT_DEPTH_COMPONENT32: return std::nullopt;
    default: throwError(ErrorCode::InvalidValue, "unknown internal format");
    }
}

InternalFormat internalFormatOf(RTint format) {
    if (const std::optional<InternalFormat> found = findInternalFormat(format)) return *found;
    notInRelease("this internal format");
}

namespace {

PixelOrder pixelOrderOf(RTenum format) {
    switch (format) {
    case RT_LUMINANCE: return PixelOrder::Luminance;
    case RT_LUMINANCE_ALPHA: return PixelOrder::LuminanceAlpha;
    case RT_RGB: return PixelOrder::Rgb;
    case RT_RGBA: return PixelOrder::Rgba;
    case RT_BGR: return PixelOrder::Bgr;
    case RT_BGRA: return PixelOrder::Bgra;
    case RT_RED: return PixelOrder::Red;
    case RT_GREEN: return PixelOrder::Green;
    case RT_BLUE: return PixelOrder::Blue;
    case RT_ALPHA: return PixelOrder::Alpha;
    case RT_DEPTH_COMPONENT: return PixelOrder::Depth;
    case RT_COLOR_INDEX:
    case RT_STENCIL_INDEX: notInRelease("this pixel format");
    default: throwError(ErrorCode::InvalidEnum, "unknown pixel format");
    }
}

std::optional<PixelFields> pixelFieldsOf(RTenum type) {
    switch (type) {
    case RT_UNSIGNED_BYTE_3_3_2: return PixelFields{1, 3, {3, 3, 2}, false};
    case RT_UNSIGNED_BYTE_2_3_3_REV: return PixelFields{1, 3, {2, 3, 3}, true};
    case RT_UNSIGNED_SHORT_5_6_5: return PixelFields{2, 3, {5, 6, 5}, false};
    case RT_UNSIGNED_SHORT_5_6_5_REV: return PixelFields{2, 3, {5, 6, 5}, true};
    case RT_UNSIGNED_SHORT_4_4_4_4: return PixelFields{2, 4, {4, 4, 4, 4}, false};
    case RT_UNSIGNED_SHORT_4_4_4_4_REV: return PixelFields{2, 4, {4, 4, 4, 4}, true};
    case RT_UNSIGNED_SHORT_5_5_5_1: return PixelFields{2, 4, {5, 5, 5, 1}, false};
    case RT_UNSIGNED_SHORT_1_5_5_5_REV: return PixelFields{2, 4, {1, 5, 5, 5}, true};
    case RT_UNSIGNED_INT_8_8_8_8: return PixelFields{4, 4, {8, 8, 8, 8}, false};
    case RT_UNSIGNED_INT_8_8_8_8_REV: return PixelFields{4, 4, {8, 8, 8, 8}, true};
    case RT_UNSIGNED_INT_10_10_10_2: return PixelFields{4, 4, {10, 10, 10, 2}, false};
    case RT_UNSIGNED_INT_2_10_10_10_REV: return PixelFields{4, 4, {2, 10, 10, 10}, true};
    default: return std::nullopt;
    }
}

PixelType pixelTypeOf(RTenum type) {
    switch (type) {
    case RT_BYTE: return PixelType::Byte;
    case RT_UNSIGNED_BYTE: return PixelType::UnsignedByte;
    case RT_SHORT: return PixelType::Short;
    case RT_UNSIGNED_SHORT: return PixelType::UnsignedShort;
    case RT_INT: return PixelType::Int;
    case RT_UNSIGNED_INT: return PixelType::UnsignedInt;
    case RT_HALF_FLOAT: return PixelType::Half;
    case RT_FLOAT: return PixelType::Float;
    case RT_BITMAP: throwError(ErrorCode::InvalidEnum, "bitmaps hold indices, not colours");
    default: throwError(ErrorCode::InvalidEnum, "unknown pixel type");
    }
}

} // namespace

PixelLayout pixelLayoutOf(RTenum format, RTenum type) {
    PixelLayout layout;
    layout.order = pixelOrderOf(format);
    const std::optional<PixelFields> fields = pixelFieldsOf(type);
    layout.type = fields ? PixelType::Fields : pixelTypeOf(type);
    if (!fields) return layout;
    layout.fields = *fields;
    const bool fits = fields->count == 3 ? layout.order == PixelOrder::Rgb
                                         : layout.order == PixelOrder::Rgba ||
                                               layout.order == PixelOrder::Bgra;
    if (!fits) throwError(ErrorCode::InvalidOperation, "the type does not fit the format");
    return layout;
}

PixelLayout colorLayoutOf(RTenum format, RTenum type) {
    const PixelLayout layout = pixelLayoutOf(format, type);
    if (layout.order == PixelOrder::Depth) notInRelease("this pixel format");
    return layout;
}

TextureWrap textureWrapOf(RTint wrap) {
    switch (wrap) {
    case RT_REPEAT: return TextureWrap::Repeat;
    case RT_CLAMP: return TextureWrap::Clamp;
    case RT_CLAMP_TO_EDGE: return TextureWrap::ClampToEdge;
    case RT_CLAMP_TO_BORDER: return TextureWrap::ClampToBorder;
    case RT_MIRRORED_REPEAT: return TextureWrap::Mirror;
    default: throwError(ErrorCode::InvalidEnum, "unknown wrap mode");
    }
}

RTenum tokenOf(TextureWrap wrap) {
    switch (wrap) {
    case TextureWrap::Repeat: return RT_REPEAT;
    case TextureWrap::Clamp: return RT_CLAMP;
    case TextureWrap::ClampToEdge: return RT_CLAMP_TO_EDGE;
    case TextureWrap::ClampToBorder: return RT_CLAMP_TO_BORDER;
    case TextureWrap::Mirror: break;
    }
    return RT_MIRRORED_REPEAT;
}

TextureFilter magFilterOf(RTint filter) {
    switch (filter) {
    case RT_NEAREST: return TextureFilter::Nearest;
    case RT_LINEAR: return TextureFilter::Linear;
    default: throwError(ErrorCode::InvalidEnum, "unknown filter");
    }
}

MinificationFilter minFilterOf(RTint filter) {
    constexpr TextureFilter kNearest = TextureFilter::Nearest, kLinear = TextureFilter::Linear;
    switch (filter) {
    case RT_NEAREST: return {kNearest, LevelChoice::First};
    case RT_LINEAR: return {kLinear, LevelChoice::First};
    case RT_NEAREST_MIPMAP_NEAREST: return {kNearest, LevelChoice::Nearest};
    case RT_LINEAR_MIPMAP_NEAREST: return {kLinear, LevelChoice::Nearest};
    case RT_NEAREST_MIPMAP_LINEAR: return {kNearest, LevelChoice::Linear};
    case RT_LINEAR_MIPMAP_LINEAR: return {kLinear, LevelChoice::Linear};
    default: throwError(ErrorCode::InvalidEnum, "unknown filter");
    }
}

RTenum tokenOf(const MinificationFilter& filter) {
    const bool linear = filter.filter == TextureFilter::Linear;
    switch (filter.levels) {
    case LevelChoice::First: return linear ? RT_LINEAR : RT_NEAREST;
    case LevelChoice::Nearest:
        return linear ? RT_LINEAR_MIPMAP_NEAREST : RT_NEAREST_MIPMAP_NEAREST;
    case LevelChoice::Linear: break;
    }
    return linear ? RT_LINEAR_MIPMAP_LINEAR : RT_NEAREST_MIPMAP_LINEAR;
}

TextureTarget textureTargetOf(RTenum target) {
    switch (target) {
    case RT_TEXTURE_1D: return TextureTarget::OneDimensional;
    case RT_TEXTURE_2D: return TextureTarget::TwoDimensional;
    case RT_PROXY_TEXTURE_1D:
    case RT_PROXY_TEXTURE_2D:
        throwError(ErrorCode::InvalidEnum, "a proxy has no image and no parameters");
    case RT_TEXTURE_3D:
    case RT_PROXY_TEXTURE_3D:
    case RT_TEXTURE_CUBE_MAP:
    case RT_TEXTURE_CUBE_MAP_POSITIVE_X:
    case RT_TEXTURE_CUBE_MAP_NEGATIVE_X:
    case RT_TEXTURE_CUBE_MAP_POSITIVE_Y:
    case RT_TEXTURE_CUBE_MAP_NEGATIVE_Y:
    case RT_TEXTURE_CUBE_MAP_POSITIVE_Z:
    case RT_TEXTURE_CUBE_MAP_NEGATIVE_Z:
    case RT_PROXY_TEXTURE_CUBE_MAP: notInRelease("this texture target");
    default: throwError(ErrorCode::InvalidEnum, "unknown texture target");
    }
}

std::optional<TextureTarget> proxiedTargetOf(RTenum target) {
    switch (target) {
    case RT_PROXY_TEXTURE_1D: return TextureTarget::OneDimensional;
    case RT_PROXY_TEXTURE_2D: return TextureTarget::TwoDimensional;
    default: return std::nullopt;
    }
}

void checkTextureTarget(RTenum target, TextureTarget wanted) {
    if (textureTargetOf(target) != wanted)
        throwError(ErrorCode::InvalidEnum, "a target of another number of dimensions");
}

} // namespace smart::compat

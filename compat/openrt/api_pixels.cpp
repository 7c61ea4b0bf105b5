// SPDX-License-Identifier: MIT
// Bitmaps and rectangles of pixels.
#include <cmath>
#include <exception>
#include <memory>
#include <new>
#include <utility>

#include "compat/openrt/guard.h"
#include "compat/openrt/image_formats.h"
#include "compat/recorder/pixel_unpack.h"
#include "openrt/rt_pixels.h"

using namespace smart;
using namespace smart::compat;

namespace {

/// A side of more pixels than any picture has; more would overflow.
constexpr RTsizei kMaxSide = 1 << 24;

void checkSize(RTsizei width, RTsizei height) {
    if (width < 0 || height < 0) throwError(ErrorCode::InvalidValue, "a size is negative");
    if (width > kMaxSide || height > kMaxSide) throw std::bad_alloc();
}

/// What a list keeps of an image: read when the call is made, as pixel storage was then. Errors
/// show when the call is carried out.
struct ImageGiven {
    std::shared_ptr<const ImagePixels> pixels;
    std::exception_ptr error;

    template <class Read>
    explicit ImageGiven(Read&& read) noexcept {
        try {
            pixels = read();
        } catch (...) {
            error = std::current_exception();
        }
    }
    const std::shared_ptr<const ImagePixels>& get() const {
        if (error) std::rethrow_exception(error);
        return pixels;
    }
};

std::shared_ptr<const ImagePixels> readBitmap(Context& c, RTsizei width, RTsizei height,
                                              const RTubyte* bits) {
    checkSize(width, height);
    if (!bits || width == 0 || height == 0) return nullptr;
    const auto image = std::make_shared<ImagePixels>();
    image->width = uint32_t(width);
    image->height = uint32_t(height);
    image->bitmap = true;
    image->data = unpackBitmap(bits, image->width, image->height, c.recorder().pixelStore());
    return image;
}

std::shared_ptr<const ImagePixels> readPixels(Context& c, RTsizei width, RTsizei height,
                                              RTenum format, RTenum type, const void* pixels) {
    const PixelLayout layout = colorLayoutOf(format, type);
    checkSize(width, height);
    if (width == 0 || height == 0) return nullptr;
    requirePointer(pixels, "pixels");
    const auto image = std::make_shared<ImagePixels>();
    image->width = uint32_t(width);
    image->height = uint32_t(height);
    // The transfer may make colours of negative numbers.
    image->type = layout.isSigned() ? TexelType::Float : texelTypeFor(layout);
    image->data = unpackImage({pixels, image->width, image->height, layout},
                              c.recorder().pixelStore(), 4, image->type);
    return image;
}

/// Of a call with an image; not between begin and end, where nothing is to be read.
template <class Read, class Draw>
void drawn(const char* function, Read&& read, Draw draw) noexcept {
    Context* const context = currentContext();
    if (!context) return withoutContext(function);
    const ImageGiven image([&]() -> std::shared_ptr<const ImagePixels> {
        context->recorder().requireOutsidePrimitive();
        return read(*context);
    });
    recorded(function, [image, draw](Context& c) {
        c.recorder().requireOutsideObject();
        draw(c, image.get());
    });
}

void setTransfer(const char* function, RTenum pname, double param) noexcept {
    recorded(function, [=](Context& c) {
        PixelDrawing& drawing = c.recorder().pixelDrawing();
        const auto only = [&](double value) {
            if (param != value)
                throwError(ErrorCode::InvalidOperation,
                           "this pixel transfer is not part of this release");
        };
        switch (pname) {
        case RT_RED_SCALE: drawing.transfer.scale.r = float(param); break;
        case RT_GREEN_SCALE: drawing.transfer.scale.g = float(param); break;
        case RT_BLUE_SCALE: drawing.transfer.scale.b = float(param); break;
        case RT_ALPHA_SCALE: drawing.transfer.scale.a = float(param); break;
        case RT_RED_BIAS: drawing.transfer.bias.r = float(param); break;
        case RT_GREEN_BIAS: drawing.transfer.bias.g = float(param); break;
        case RT_BLUE_BIAS: drawing.transfer.bias.b = float(param); break;
        case RT_ALPHA_BIAS: drawing.transfer.bias.a = float(param); break;
        case RT_DEPTH_SCALE: only(1.0); break;
        case RT_MAP_COLOR:
        case RT_MAP_STENCIL:
        case RT_INDEX_SHIFT:
        case RT_INDEX_OFFSET:
        case RT_DEPTH_BIAS: only(0.0); break;
        default: throwError(ErrorCode::InvalidEnum, "unknown pixel transfer");
        }
    });
}

} // namespace

RTAPI void RTAPIENTRY rtBitmap(RTsizei width, RTsizei height, RTfloat xorig, RTfloat yorig,
                               RTfloat xmove, RTfloat ymove, const RTubyte* bitmap) {
    drawn(
        __func__, [&](Context& c) { return readBitmap(c, width, height, bitmap); },
        [=](Context& c, const std::shared_ptr<const ImagePixels>& image) {
            c.recorder().drawBitmap(image, {xorig, yorig}, {xmove, ymove});
        });
}

RTAPI void RTAPIENTRY rtDrawPixels(RTsizei width, RTsizei height, RTenum format, RTenum type,
                                   const void* pixels) {
    drawn(
        __func__, [&](Context& c) { return readPixels(c, width, height, format, type, pixels); },
        [](Context& c, const std::shared_ptr<const ImagePixels>& image) {
            if (image) c.recorder().drawPixels(image);
        });
}

RTAPI void RTAPIENTRY rtPixelZoom(RTfloat xfactor, RTfloat yfactor) {
    recorded(__func__, [=](Context& c) {
        PixelDrawing& drawing = c.recorder().pixelDrawing();
        if (!std::isfinite(xfactor) || !std::isfinite(yfactor))
            throwError(ErrorCode::InvalidValue, "a zoom factor is not finite");
        drawing.zoom = {xfactor, yfactor};
    });
}

RTAPI void RTAPIENTRY rtPixelTransferf(RTenum pname, RTfloat param) {
    setTransfer(__func__, pname, param);
}
RTAPI void RTAPIENTRY rtPixelTransferi(RTenum pname, RTint param) {
    setTransfer(__func__, pname, param);
}

// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <memory>

#include "compat/openrt/guard.h"
#include "compat/rtu/image.h"
#include "openrt/rt.h"
#include "openrt/rtu.h"

using namespace smart;
using namespace smart::compat;

namespace {

/// What these calls return and record: GLU's number of an error, and a text.
struct ImageError {
    RTenum number;
    const char* text;
};

void check(bool holds, RTenum number, const char* text) {
    if (!holds) throw ImageError{number, text};
}

void checkFormat(RTenum format, RTenum type) {
    check(componentsOf(format) != 0, RTU_INVALID_ENUM, "not a format of images");
    check(bytesOf(type) != 0, RTU_INVALID_ENUM, "not a type that images can have");
}

/// body's errors as GLU's numbers, and recorded in the context if there is one.
template <class Body>
RTint withErrors(const char* function, Body&& body) noexcept {
    RTint result = 0;
    const auto run = [&] {
        try {
            body();
        } catch (const ImageError& error) {
            result = RTint(error.number);
            throwError(error.number == RTU_INVALID_ENUM ? ErrorCode::InvalidEnum
                                                        : ErrorCode::InvalidValue,
                       error.text);
        } catch (...) { // of these only the memory can run out
            result = RTU_OUT_OF_MEMORY;
            throw;
        }
    };
    try {
        run();
    } catch (...) {
        report(function);
    }
    return result;
}

/// As at the start where the context does not tell.
PixelStore unpackState() {
    Context* const context = currentContext();
    return context && !context->recorder().insidePrimitive() ? context->recorder().pixelStore()
                                                              : PixelStore();
}
PixelStore packState() {
    Context* const context = currentContext();
    return context && !context->recorder().insidePrimitive() ? context->recorder().packStore()
                                                              : PixelStore();
}

constexpr PixelStore kTight{.alignment = 1};

/// Gives levels to a texture call with rows that follow each other. The call may report an error,
/// and who listens may end the context.
class PackedRows {
public:
    PackedRows() : context_(currentContextShared()), saved_(unpackState()) { set(kTight); }
    ~PackedRows() { set(saved_); }
    PackedRows(const PackedRows&) = delete;
    PackedRows& operator=(const PackedRows&) = delete;

private:
    void set(const PixelStore& store) {
        if (context_ && !context_->recorder().insidePrimitive())
            context_->recorder().pixelStore() = store;
    }
    std::shared_ptr<Context> context_;
    PixelStore saved_;
};

/// The power of two that GLU takes for a size.
int64_t nearestPower(int size) {
    int64_t power = 1;
    while (size != 1) {
        if (size == 3) return power * 4;
        size >>= 1;
        power *= 2;
    }
    return power;
}

int fittingPower(int size) {
    RTint largest = 0;
    rtGetIntegerv(RT_MAX_TEXTURE_SIZE, &largest);
    int64_t power = nearestPower(size);
    while (largest > 0 && power > largest) power /= 2;
    return int(std::min<int64_t>(power, 1 << 30));
}

int levelsBelow(int size) {
    int levels = 0;
    while (size > 1) {
        size /= 2;
        ++levels;
    }
    return levels;
}

struct Mipmaps {
    int dimensions;
    RTenum target;
    RTint internalFormat;
    RTsizei width, height, depth;
    RTenum format, type;
    const void* data;

    /// max < 0: all levels.
    void build(RTint level, RTint base, RTint max) const {
        checkFormat(format, type);
        check(width >= 1 && height >= 1 && depth >= 1, RTU_INVALID_VALUE, "a size below 1");
        check(data != nullptr, RTU_INVALID_VALUE, "data is NULL");
        const int w = fittingPower(width), h = dimensions > 1 ? fittingPower(height) : 1;
        const int d = dimensions > 2 ? fittingPower(depth) : 1;
        const int64_t last = int64_t(level) + levelsBelow(std::max({w, h, d}));
        if (max < 0) max = RTint(last);
        check(level >= 0 && base >= level && max >= base && max <= last, RTU_INVALID_VALUE,
              "not a range of levels");
        const Enlarging enlarging =
            dimensions == 2 ? Enlarging::Exact : Enlarging::WholePixels;
        Image image = scaleImage(
            readImage(data, type, componentsOf(format), width, height, depth, unpackState()), w, h,
            d, enlarging);
        const PackedRows packed;
        std::vector<std::byte> bytes;
        for (int64_t current = level; current <= max; ++current) {
            if (current > level)
                image = scaleImage(image, std::max(image.width / 2, 1),
                                   std::max(image.height / 2, 1), std::max(image.depth / 2, 1),
                                   enlarging);
            if (current < base) continue;
            bytes.resize(tightBytes(image));
            writeImage(image, kTight, bytes.data());
            give(RTint(current), image, bytes.data());
        }
    }

private:
    void give(RTint level, const Image& image, const std::byte* pixels) const {
        if (dimensions == 1)
            rtTexImage1D(target, level, internalFormat, image.width, 0, format, type, pixels);
        else if (dimensions == 2)
            rtTexImage2D(target, level, internalFormat, image.width, image.height, 0, format, type,
                         pixels);
        else
            rtTexImage3D(target, level, internalFormat, image.width, image.height,
                         image.depth, 0, format, type, pixels);
    }
};

} // namespace

RTAPI RTint RTAPIENTRY rtuScaleImage(RTenum format, RTsizei wIn, RTsizei hIn, RTenum typeIn,
                                     const void* dataIn, RTsizei wOut, RTsizei hOut,
                                     RTenum typeOut, void* dataOut) {
    return withErrors(__func__, [&] {
        check(wIn >= 0 && hIn >= 0 && wOut >= 0 && hOut >= 0, RTU_INVALID_VALUE, "negative size");
        if (wIn == 0 || hIn == 0 || wOut == 0 || hOut == 0) return;
        checkFormat(format, typeIn);
        checkFormat(format, typeOut);
        check(dataIn && dataOut, RTU_INVALID_VALUE, "a pointer is NULL");
        const bool scaled = format != RT_COLOR_INDEX && format != RT_STENCIL_INDEX;
        const Image in = toShorts(
            readImage(dataIn, typeIn, componentsOf(format), wIn, hIn, 1, unpackState()), scaled);
        const Image out = scaleImage(in, wOut, hOut, 1, Enlarging::WholePixels);
        writeImage(fromShorts(out, typeOut, scaled), packState(), dataOut);
    });
}

RTAPI RTint RTAPIENTRY rtuBuild1DMipmaps(RTenum target, RTint internalFormat, RTsizei width,
                                         RTenum format, RTenum type, const void* data) {
    return withErrors(__func__, [&] {
        Mipmaps{1, target, internalFormat, width, 1, 1, format, type, data}.build(0, 0, -1);
    });
}
RTAPI RTint RTAPIENTRY rtuBuild2DMipmaps(RTenum target, RTint internalFormat, RTsizei width,
                                         RTsizei height, RTenum format, RTenum type,
                                         const void* data) {
    return withErrors(__func__, [&] {
        Mipmaps{2, target, internalFormat, width, height, 1, format, type, data}.build(0, 0, -1);
    });
}
RTAPI RTint RTAPIENTRY rtuBuild3DMipmaps(RTenum target, RTint internalFormat, RTsizei width,
                                         RTsizei height, RTsizei depth, RTenum format, RTenum type,
                                         const void* data) {
    return withErrors(__func__, [&] {
        Mipmaps{3, target, internalFormat, width, height, depth, format, type, data}.build(0, 0,
                                                                                           -1);
    });
}
RTAPI RTint RTAPIENTRY rtuBuild1DMipmapLevels(RTenum target, RTint internalFormat, RTsizei width,
                                              RTenum format, RTenum type, RTint level, RTint base,
                                              RTint max, const void* data) {
    return withErrors(__func__, [&] {
        check(max >= 0, RTU_INVALID_VALUE, "not a range of levels");
        Mipmaps{1, target, internalFormat, width, 1, 1, format, type, data}.build(level, base,
                                                                                  max);
    });
}
RTAPI RTint RTAPIENTRY rtuBuild2DMipmapLevels(RTenum target, RTint internalFormat, RTsizei width,
                                              RTsizei height, RTenum format, RTenum type,
                                              RTint level, RTint base, RTint max,
                                              const void* data) {
    return withErrors(__func__, [&] {
        check(max >= 0, RTU_INVALID_VALUE, "not a range of levels");
        Mipmaps{2, target, internalFormat, width, height, 1, format, type, data}.build(level, base,
                                                                                       max);
    });
}
RTAPI RTint RTAPIENTRY rtuBuild3DMipmapLevels(RTenum target, RTint internalFormat, RTsizei width,
                                              RTsizei height, RTsizei depth, RTenum format,
                                              RTenum type, RTint level, RTint base, RTint max,
                                              const void* data) {
    return withErrors(__func__, [&] {
        check(max >= 0, RTU_INVALID_VALUE, "not a range of levels");
        Mipmaps{3, target, internalFormat, width, height, depth, format, type, data}.build(
            level, base, max);
    });
}

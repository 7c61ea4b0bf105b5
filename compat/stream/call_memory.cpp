// SPDX-License-Identifier: MIT
#include "compat/stream/call_memory.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <string>

#include "openrt/enums.h"

namespace smart::compat {

namespace {

uint64_t product(uint64_t a, uint64_t b) {
    uint64_t result = 0;
    return __builtin_mul_overflow(a, b, &result) ? kTooMuch : result;
}
uint64_t sum(uint64_t a, uint64_t b) {
    uint64_t result = 0;
    return __builtin_add_overflow(a, b, &result) ? kTooMuch : result;
}

/// How many values calls such as rtLightfv and rtTexEnviv read for a token; -1: unknown.
int valuesOfToken(RTenum token) {
    switch (token) {
    case RT_AMBIENT:
    case RT_DIFFUSE:
    case RT_AMBIENT_AND_DIFFUSE:
    case RT_SPECULAR:
    case RT_EMISSION:
    case RT_POSITION:
    case RT_LIGHT_MODEL_AMBIENT:
    case RT_FOG_COLOR:
    case RT_TEXTURE_ENV_COLOR:
    case RT_TEXTURE_BORDER_COLOR:
    case RT_OBJECT_PLANE:
    case RT_EYE_PLANE: return 4;
    case RT_SPOT_DIRECTION:
    case RT_COLOR_INDEXES: return 3;
    case RT_SPOT_EXPONENT:
    case RT_SPOT_CUTOFF:
    case RT_CONSTANT_ATTENUATION:
    case RT_LINEAR_ATTENUATION:
    case RT_QUADRATIC_ATTENUATION:
    case RT_LIGHT_MODEL_LOCAL_VIEWER:
    case RT_LIGHT_MODEL_TWO_SIDE:
    case RT_LIGHT_MODEL_COLOR_CONTROL:
    case RT_SHININESS:
    case RT_REFLECTION:
    case RT_FOG_MODE:
    case RT_FOG_DENSITY:
    case RT_FOG_START:
    case RT_FOG_END:
    case RT_FOG_INDEX:
    case RT_FOG_COORDINATE_SOURCE: return 1;
    default: return -1;
    }
}

std::size_t componentsOfFormat(RTenum format) {
    switch (format) {
    case RT_COLOR_INDEX:
    case RT_STENCIL_INDEX:
    case RT_DEPTH_COMPONENT:
    case RT_RED:
    case RT_GREEN:
    case RT_BLUE:
    case RT_ALPHA:
    case RT_LUMINANCE: return 1;
    case RT_LUMINANCE_ALPHA: return 2;
    case RT_RGB:
    case RT_BGR: return 3;
    case RT_RGBA:
    case RT_BGRA: return 4;
    default: return 0;
    }
}

/// Of a number that holds a whole pixel; 0: the type has a number for each component.
std::size_t bytesOfFields(RTenum type) {
    switch (type) {
    case RT_UNSIGNED_BYTE_3_3_2:
    case RT_UNSIGNED_BYTE_2_3_3_REV: return 1;
    case RT_UNSIGNED_SHORT_5_6_5:
    case RT_UNSIGNED_SHORT_5_6_5_REV:
    case RT_UNSIGNED_SHORT_4_4_4_4:
    case RT_UNSIGNED_SHORT_4_4_4_4_REV:
    case RT_UNSIGNED_SHORT_5_5_5_1:
    case RT_UNSIGNED_SHORT_1_5_5_5_REV: return 2;
    case RT_UNSIGNED_INT_8_8_8_8:
    case RT_UNSIGNED_INT_8_8_8_8_REV:
    case RT_UNSIGNED_INT_10_10_10_2:
    case RT_UNSIGNED_INT_2_10_10_10_REV: return 4;
    default: return 0;
    }
}

std::size_t bytesOfPixelComponent(RTenum type) {
    return type == RT_HALF_FLOAT ? 2 : type == RT_DOUBLE ? 0 : bytesOfComponent(type);
}

struct Extent {
    uint64_t width = 0, rows = 0;
    bool isTooLarge = false; ///< for any image
};

/// From one row to the next. `unit`: the bytes whose order a machine has; rows of shorter ones
/// are aligned.
uint64_t rowBytes(uint64_t width, std::size_t pixelBytes, std::size_t unit,
                  const ImageStore& store) {
    const uint64_t bytes = (store.rowLength ? store.rowLength : width) * pixelBytes;
    if (unit >= store.alignment || store.alignment > 8) return bytes;
    return (bytes + store.alignment - 1) / store.alignment * store.alignment;
}

uint64_t imageBytes(const Extent& image, std::size_t pixelBytes, std::size_t unit,
                    const ImageStore& store) {
    if (image.isTooLarge) return kTooMuch;
    if (image.width == 0 || image.rows == 0 || pixelBytes == 0) return 0;
    return sum(product(store.skipRows + image.rows - 1,
                       rowBytes(image.width, pixelBytes, unit, store)),
               (store.skipPixels + image.width) * pixelBytes);
}

uint64_t bitmapBytes(const Extent& image, const ImageStore& store) {
    if (image.isTooLarge) return kTooMuch;
    if (image.width == 0 || image.rows == 0 || store.alignment == 0) return 0;
    const uint64_t rowBits = store.rowLength ? store.rowLength : image.width;
    const uint64_t groups = (rowBits + 8 * store.alignment - 1) / (8 * store.alignment);
    return sum(product(store.skipRows + image.rows - 1, groups * store.alignment),
               (store.skipPixels + image.width + 7) / 8);
}

class Sizes {
public:
    Sizes(const CallSignature& call, const CallValue* arguments)
        : call_(call), arguments_(arguments) {}

    int64_t named(const char* name, int64_t otherwise) const {
        return argumentNamed(call_, name, arguments_).value_or(otherwise);
    }
    /// Empty where a side is negative.
    Extent extent(const char* width, const char* height) const {
        constexpr int64_t kMaxSide = 1 << 24;
        const int64_t w = named(width, 0), h = named(height, 1), d = named("depth", 1);
        if (w < 0 || h < 0 || d < 0) return {};
        if (std::max({w, h, d}) > kMaxSide) return {0, 0, true};
        return {uint64_t(w), uint64_t(h) * uint64_t(d)};
    }
    uint64_t image(const Extent& area, const char* typeName, const ImageStore& store) const {
        const auto format = RTenum(named("format", 0)), type = RTenum(named(typeName, 0));
        if (type == RT_BITMAP) return bitmapBytes(area, store);
        const std::size_t fields = bytesOfFields(type);
        return imageBytes(area, bytesOfPixel(format, type),
                          fields ? fields : bytesOfPixelComponent(type), store);
    }

    /// Images of proxies have no pixels, whatever the pointer is.
    bool ofProxy() const {
        if (std::strncmp(call_.name, "rtTexImage", 10) != 0) return false;
        const auto target = RTenum(named("target", 0));
        return target == RT_PROXY_TEXTURE_1D || target == RT_PROXY_TEXTURE_2D;
    }

private:
    const CallSignature& call_;
    const CallValue* arguments_;
};

} // namespace

std::size_t bytesOf(ValueKind kind) {
    constexpr uint8_t kBytes[] = {0, 1, 1, 2, 2, 4, 4, 8, 8, 4, 8, sizeof(void*)};
    return kBytes[std::size_t(kind)];
}

int64_t integerOf(ValueKind kind, CallValue value) {
    switch (kind) {
    case ValueKind::Int8: return value.as<int8_t>();
    case ValueKind::UInt8: return value.as<uint8_t>();
    case ValueKind::Int16: return value.as<int16_t>();
    case ValueKind::UInt16: return value.as<uint16_t>();
    case ValueKind::Int32: return value.as<int32_t>();
    case ValueKind::UInt32: return value.as<uint32_t>();
    default: return value.as<int64_t>();
    }
}

std::optional<int64_t> argumentNamed(const CallSignature& call, const char* name,
                                     const CallValue* arguments) {
    const std::span<const CallParameter> parameters = parametersOf(call);
    for (std::size_t i = 0; i < parameters.size(); ++i)
        if (std::strcmp(parameters[i].name, name) == 0)
            return integerOf(parameters[i].kind, arguments[i]);
    return std::nullopt;
}

const CallSignature* findCall(const char* name) {
    const std::span<const CallSignature> table = callTable(); // in the order of the names
    const auto found = std::lower_bound(
        table.begin(), table.end(), name,
        [](const CallSignature& call, const char* n) { return std::strcmp(call.name, n) < 0; });
    return found != table.end() && std::strcmp(found->name, name) == 0 ? &*found : nullptr;
}

std::size_t bytesOfComponent(RTenum type) {
    switch (type) {
    case RT_BYTE:
    case RT_UNSIGNED_BYTE: return 1;
    case RT_SHORT:
    case RT_UNSIGNED_SHORT: return 2;
    case RT_INT:
    case RT_UNSIGNED_INT:
    case RT_FLOAT: return 4;
    case RT_DOUBLE: return 8;
    default: return 0;
    }
}

std::size_t bytesOfIndex(RTenum type) {
    const bool known =
        type == RT_UNSIGNED_BYTE || type == RT_UNSIGNED_SHORT || type == RT_UNSIGNED_INT;
    return known ? bytesOfComponent(type) : 0;
}

std::size_t bytesOfListName(RTenum type) {
    switch (type) {
    case RT_2_BYTES: return 2;
    case RT_3_BYTES: return 3;
    case RT_4_BYTES: return 4;
    case RT_DOUBLE: return 0;
    default: return bytesOfComponent(type);
    }
}

std::size_t bytesOfPixel(RTenum format, RTenum type) {
    if (const std::size_t fields = bytesOfFields(type)) return fields;
    return componentsOfFormat(format) * bytesOfPixelComponent(type);
}

std::size_t bytesOfFrameBufferPixel(RTenum format) {
    switch (format) {
    case RT_BGR_32:
    case RT_RGB_32F: return 12;
    case RT_RGB_8: return 3;
    case RT_RGBA_8:
    case RT_BGRA_8: return 4;
    case RT_RGBA_32F: return 16;
    default: return 0;
    }
}

std::size_t bytesOfAuxBufferPixel(RTenum what) {
    return what == RT_NORMAL ? 12 : 4;
}

ImageRows rowsOfReadPixels(const CallSignature& call, const CallValue* arguments,
                           const ImageStores& stores) {
    const Sizes sizes(call, arguments);
    const auto format = RTenum(sizes.named("format", 0)), type = RTenum(sizes.named("type", 0));
    const Extent area = sizes.extent("width", "height");
    const std::size_t pixel = bytesOfPixel(format, type), fields = bytesOfFields(type);
    if (pixel == 0 || type == RT_BITMAP || area.width == 0 || area.rows == 0) return {};
    const uint64_t stride = rowBytes(area.width, pixel,
                                     fields ? fields : bytesOfPixelComponent(type), stores.pack);
    return {stores.pack.skipRows * stride + stores.pack.skipPixels * pixel, area.width * pixel,
            stride, area.rows};
}

uint64_t memoryBytes(const CallSignature& call, const CallParameter& parameter,
                     const CallValue* arguments, const ImageStores& stores) {
    const Sizes sizes(call, arguments);
    const auto counter = [&] {
        return integerOf(parametersOf(call)[std::size_t(parameter.counter)].kind,
                         arguments[parameter.counter]);
    };
    const auto counted = [&](uint64_t bytes) {
        return counter() > 0 ? product(uint64_t(counter()), bytes) : 0;
    };
    switch (parameter.memory) {
    case Memory::Constant: return uint64_t(parameter.amount) * parameter.elementBytes;
    case Memory::Counted: return counted(uint64_t(parameter.amount) * parameter.elementBytes);
    case Memory::Token:
        return uint64_t(std::max(valuesOfToken(RTenum(counter())), 0)) * parameter.elementBytes;
    case Memory::TokenOrOne:
        return uint64_t(std::max(valuesOfToken(RTenum(counter())), 1)) * parameter.elementBytes;
    case Memory::Lists: return counted(bytesOfListName(RTenum(sizes.named("type", 0))));
    case Memory::Indices: return counted(bytesOfIndex(RTenum(sizes.named("type", 0))));
    case Memory::Bitmap:
        if (parameter.amount) return bitmapBytes({32, 32}, stores.unpack);
        return bitmapBytes(sizes.extent("width", "height"), stores.unpack);
    case Memory::Image:
        if (sizes.ofProxy()) return 0;
        if (argumentNamed(call, "wIn", arguments))
            return sizes.image(sizes.extent("wIn", "hIn"), "typeIn", stores.unpack);
        return sizes.image(sizes.extent("width", "height"), "type", stores.unpack);
    case Memory::PackedImage:
        if (parameter.amount) return bitmapBytes({32, 32}, stores.pack);
        return sizes.image(sizes.extent("width", "height"), "type", stores.pack);
    case Memory::ScaledImage: return sizes.image(sizes.extent("wOut", "hOut"), "typeOut", stores.pack);
    case Memory::Scratch: return 64 * sizeof(double);
    default: return 0;
    }
}

} // namespace smart::compat

// SPDX-License-Identifier: MIT
#include "compat/openrt/array_elements.h"

#include <cstring>

#include "compat/openrt/component_values.h"
#include "compat/openrt/guard.h"

namespace smart::compat {

namespace {

// Keys of attribute calls in lists; those of colour, normal and texture coordinate have ops.
constexpr uint64_t kEdgeFlagKey = 0x0B43, kSecondaryColorKey = 0x8459, kFogCoordinateKey = 0x8453;

template <class T, bool isNormalised>
void fetchComponents(const std::byte* from, int n, double* to) {
    for (int k = 0; k < n; ++k) {
        T value;
        std::memcpy(&value, from + std::size_t(k) * sizeof value, sizeof value);
        to[k] = isNormalised ? double(normalised(value)) : double(value);
    }
}

template <bool isNormalised>
auto fetcher(ComponentType type) {
    switch (type) {
    case ComponentType::Byte: return &fetchComponents<int8_t, isNormalised>;
    case ComponentType::UnsignedByte: return &fetchComponents<uint8_t, isNormalised>;
    case ComponentType::Short: return &fetchComponents<int16_t, isNormalised>;
    case ComponentType::UnsignedShort: return &fetchComponents<uint16_t, isNormalised>;
    case ComponentType::Int: return &fetchComponents<int32_t, isNormalised>;
    case ComponentType::UnsignedInt: return &fetchComponents<uint32_t, isNormalised>;
    case ComponentType::Float: return &fetchComponents<float, isNormalised>;
    case ComponentType::Double: return &fetchComponents<double, isNormalised>;
    }
    return &fetchComponents<float, isNormalised>;
}

bool isNormalisedKind(ArrayKind kind) {
    return kind == ArrayKind::Color || kind == ArrayKind::SecondaryColor ||
           kind == ArrayKind::Normal;
}

template <class Body>
void attribute(Context& c, const char* function, uint64_t key, const Body& body) {
    ListRecording* const list = c.lists().recording();
    if (!list || keepIn(*list, ListOp::Attribute, function, key, body)) body(c);
}

} // namespace

ComponentType componentTypeOf(RTenum type) {
    switch (type) {
    case RT_BYTE: return ComponentType::Byte;
    case RT_UNSIGNED_BYTE: return ComponentType::UnsignedByte;
    case RT_SHORT: return ComponentType::Short;
    case RT_UNSIGNED_SHORT: return ComponentType::UnsignedShort;
    case RT_INT: return ComponentType::Int;
    case RT_UNSIGNED_INT: return ComponentType::UnsignedInt;
    case RT_FLOAT: return ComponentType::Float;
    case RT_DOUBLE: return ComponentType::Double;
    default: throwError(ErrorCode::InvalidEnum, "not a type of components");
    }
}

RTenum tokenOf(ComponentType type) {
    constexpr RTenum kTokens[] = {RT_BYTE, RT_UNSIGNED_BYTE, RT_SHORT, RT_UNSIGNED_SHORT,
                                  RT_INT,  RT_UNSIGNED_INT,  RT_FLOAT, RT_DOUBLE};
    return kTokens[std::size_t(type)];
}

std::size_t sizeOf(ComponentType type) {
    constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
    return kSizes[std::size_t(type)];
}

ReadableMemory readable(const void* pointer, const BufferBinding& binding) {
    if (!binding.buffer) {
        if (!pointer) throwError(ErrorCode::InvalidOperation, "an array has no memory");
        return {static_cast<const std::byte*>(pointer), UINT64_MAX};
    }
    const BufferObject& buffer = *binding.buffer;
    if (buffer.mapped)
        throwError(ErrorCode::InvalidOperation, "a buffer that is to be read is mapped");
    const auto offset = reinterpret_cast<uintptr_t>(pointer);
    if (offset >= buffer.bytes.size())
        throwError(ErrorCode::InvalidOperation, "an array begins behind the end of its buffer");
    return {buffer.bytes.data() + offset, buffer.bytes.size() - offset};
}

ArrayElements::ArrayElements(Context& context)
    : context_(context), before_(context.recorder().attributes()) {
    for (std::size_t i = 0; i < kArrayKinds; ++i) {
        const auto kind = ArrayKind(i);
        const VertexArray& array = context.arrays()[kind];
        if (array.enabled && kind != ArrayKind::Index) resolve(kind, array);
    }
}

void ArrayElements::resolve(ArrayKind kind, const VertexArray& array) {
    Source& source = sources_[std::size_t(kind)];
    const ReadableMemory memory = readable(array.pointer, array.buffer);
    source.data = memory.data;
    source.bytes = memory.bytes;
    source.size = array.size;
    source.elementBytes = std::size_t(array.size) * sizeOf(array.type);
    source.stride = array.stride ? array.stride : source.elementBytes;
    source.fetch = isNormalisedKind(kind) ? fetcher<true>(array.type) : fetcher<false>(array.type);
    enabled_[std::size_t(kind)] = true;
}

void ArrayElements::requireElement(uint64_t index) const {
    for (std::size_t i = 0; i < kArrayKinds; ++i) {
        const Source& source = sources_[i];
        if (enabled_[i] && source.bytes != UINT64_MAX &&
            index * source.stride + source.elementBytes > source.bytes)
            throwError(ErrorCode::InvalidOperation, "an array's buffer ends before element " +
                                                        std::to_string(index));
    }
}

void ArrayElements::make(uint64_t index) const {
    Recorder& recorder = context_.recorder();
    ListRecording* const list = context_.lists().recording();
    if (double flag = 1; fetch(ArrayKind::EdgeFlag, index, &flag))
        attribute(context_, "rtEdgeFlag", kEdgeFlagKey,
                  [on = flag != 0](Context& c) { c.recorder().setEdgeFlag(on); });
    for (std::size_t unit = 0; unit < kTextureUnits; ++unit)
        if (double v[4] = {0, 0, 0, 1}; fetch(texCoordArray(unit), index, v)) {
            const glm::vec4 texCoord(v[0], v[1], v[2], v[3]);
            if (!list || list->texCoord(texCoord, unit)) recorder.texCoord(texCoord, unit);
        }
    if (double v[4] = {0, 0, 0, 1}; fetch(ArrayKind::Color, index, v)) {
        const glm::vec4 color(v[0], v[1], v[2], v[3]);
        if (!list || list->color(color)) recorder.color(color);
    }
    if (double v[3] = {}; fetch(ArrayKind::SecondaryColor, index, v))
        attribute(context_, "rtSecondaryColor", kSecondaryColorKey,
                  [color = glm::vec4(v[0], v[1], v[2], 1)](Context& c) {
                      c.recorder().secondaryColor(color);
                  });
    if (double v[3] = {}; fetch(ArrayKind::Normal, index, v)) {
        const glm::vec3 normal(v[0], v[1], v[2]);
        if (!list || list->normal(normal)) recorder.normal(normal);
    }
    if (double coordinate = 0; fetch(ArrayKind::FogCoordinate, index, &coordinate))
        attribute(context_, "rtFogCoord", kFogCoordinateKey,
                  [value = float(coordinate)](Context& c) { c.recorder().fogCoordinate(value); });
    if (double v[4] = {0, 0, 0, 1}; fetch(ArrayKind::Vertex, index, v)) {
        const glm::dvec4 position(v[0], v[1], v[2], v[3]);
        if (!list || list->vertex(position)) recorder.vertex(position);
    }
}

void ArrayElements::restoreAttributes() const {
    Recorder& recorder = context_.recorder();
    const auto enabled = [&](ArrayKind kind) { return enabled_[std::size_t(kind)]; };
    for (std::size_t unit = 0; unit < kTextureUnits; ++unit)
        if (enabled(texCoordArray(unit))) recorder.texCoord(before_.texCoordOf(unit), unit);
    if (enabled(ArrayKind::Color)) recorder.color(before_.color);
    if (enabled(ArrayKind::Normal)) recorder.normal(before_.normal);
    if (enabled(ArrayKind::EdgeFlag)) recorder.setEdgeFlag(before_.edgeFlag);
    if (enabled(ArrayKind::SecondaryColor)) recorder.secondaryColor(before_.secondaryColor);
    if (enabled(ArrayKind::FogCoordinate)) recorder.fogCoordinate(before_.fogCoordinate);
}

} // namespace smart::compat

// SPDX-License-Identifier: MIT
// Where vertex arrays lie; what draws them stands in api_array_drawing.cpp.
#include <initializer_list>
#include <optional>

#include "compat/openrt/array_elements.h"
#include "compat/openrt/array_names.h"
#include "compat/openrt/fixed_tokens.h"
#include "compat/openrt/guard.h"
#include "openrt/rt_arrays.h"

using namespace smart;
using namespace smart::compat;

namespace {

VertexArrays& arraysOutside(Context& c) {
    c.recorder().requireOutsidePrimitive();
    return c.arrays();
}

void setPointer(const char* function, ArrayKind kind, RTint size, int smallest, int largest,
                RTenum type, std::initializer_list<ComponentType> types, RTsizei stride,
                const void* pointer) noexcept {
    guarded(function, [&](Context& c) {
        VertexArrays& arrays = arraysOutside(c);
        if (size < smallest || size > largest)
            throwError(ErrorCode::InvalidValue, "not a number of components of this array");
        if (stride < 0) throwError(ErrorCode::InvalidValue, "the stride is negative");
        const ComponentType component = componentTypeOf(type);
        bool known = false;
        for (const ComponentType t : types) known |= t == component;
        if (!known) throwError(ErrorCode::InvalidEnum, "not a type of components of this array");
        VertexArray& array = arrays[arrays.selected(kind)];
        array.size = size;
        array.type = component;
        array.stride = uint32_t(stride);
        array.pointer = pointer;
        array.buffer = arrays.arrayBuffer;
    });
}

void setEnabled(const char* function, RTenum cap, bool on) noexcept {
    guarded(function, [&](Context& c) {
        VertexArrays& arrays = arraysOutside(c);
        const std::optional<ArrayKind> kind = arrayKindOf(cap);
        if (!kind) throwError(ErrorCode::InvalidEnum, "no such array");
        arrays[arrays.selected(*kind)].enabled = on;
    });
}

/// OpenGL 1.5, table 2.5: components, and where in an element of so many bytes they start.
struct InterleavedFormat {
    RTenum format;
    int texCoords, colors;
    ComponentType colorType;
    bool normals;
    int vertices;
    uint32_t colorAt, normalAt, vertexAt, bytes;
};
constexpr auto kF = ComponentType::Float;
constexpr auto kUb = ComponentType::UnsignedByte;
constexpr InterleavedFormat kFormats[] = {
    {RT_V2F, 0, 0, kF, false, 2, 0, 0, 0, 8},
    {RT_V3F, 0, 0, kF, false, 3, 0, 0, 0, 12},
    {RT_C4UB_V2F, 0, 4, kUb, false, 2, 0, 0, 4, 12},
    {RT_C4UB_V3F, 0, 4, kUb, false, 3, 0, 0, 4, 16},
    {RT_C3F_V3F, 0, 3, kF, false, 3, 0, 0, 12, 24},
    {RT_N3F_V3F, 0, 0, kF, true, 3, 0, 0, 12, 24},
    {RT_C4F_N3F_V3F, 0, 4, kF, true, 3, 0, 16, 28, 40},
    {RT_T2F_V3F, 2, 0, kF, false, 3, 0, 0, 8, 20},
    {RT_T4F_V4F, 4, 0, kF, false, 4, 0, 0, 16, 32},
    {RT_T2F_C4UB_V3F, 2, 4, kUb, false, 3, 8, 0, 12, 24},
    {RT_T2F_C3F_V3F, 2, 3, kF, false, 3, 8, 0, 20, 32},
    {RT_T2F_N3F_V3F, 2, 0, kF, true, 3, 0, 8, 20, 32},
    {RT_T2F_C4F_N3F_V3F, 2, 4, kF, true, 3, 8, 24, 36, 48},
    {RT_T4F_C4F_N3F_V4F, 4, 4, kF, true, 4, 16, 32, 44, 60},
};

const InterleavedFormat& interleavedFormatOf(RTenum format) {
    for (const InterleavedFormat& known : kFormats)
        if (known.format == format) return known;
    throwError(ErrorCode::InvalidEnum, "no such format of interleaved arrays");
}

void interleave(VertexArrays& arrays, const InterleavedFormat& format, RTsizei stride,
                const void* pointer) {
    const uint32_t step = stride ? uint32_t(stride) : format.bytes;
    const auto set = [&](ArrayKind kind, int size, ComponentType type, uint32_t offset) {
        VertexArray& array = arrays[arrays.selected(kind)];
        array.enabled = size > 0;
        if (size == 0) return;
        array.size = size;
        array.type = type;
        array.stride = step;
        array.pointer =
            reinterpret_cast<const void*>(reinterpret_cast<uintptr_t>(pointer) + offset);
        array.buffer = arrays.arrayBuffer;
    };
    for (const ArrayKind kind : {ArrayKind::EdgeFlag, ArrayKind::Index, ArrayKind::SecondaryColor,
                                 ArrayKind::FogCoordinate})
        arrays[kind].enabled = false;
    set(ArrayKind::TexCoord, format.texCoords, kF, 0);
    set(ArrayKind::Color, format.colors, format.colorType, format.colorAt);
    set(ArrayKind::Normal, format.normals ? 3 : 0, kF, format.normalAt);
    set(ArrayKind::Vertex, format.vertices, kF, format.vertexAt);
}

} // namespace

RTAPI void RTAPIENTRY rtEnableClientState(RTenum cap) {
    setEnabled(__func__, cap, true);
}
RTAPI void RTAPIENTRY rtDisableClientState(RTenum cap) {
    setEnabled(__func__, cap, false);
}

RTAPI void RTAPIENTRY rtVertexPointer(RTint size, RTenum type, RTsizei stride, const void* ptr) {
    using enum ComponentType;
    setPointer(__func__, ArrayKind::Vertex, size, 2, 4, type, {Short, Int, Float, Double}, stride,
               ptr);
}
RTAPI void RTAPIENTRY rtTexCoordPointer(RTint size, RTenum type, RTsizei stride, const void* ptr) {
    using enum ComponentType;
    setPointer(__func__, ArrayKind::TexCoord, size, 1, 4, type, {Short, Int, Float, Double}, stride,
               ptr);
}
RTAPI void RTAPIENTRY rtNormalPointer(RTenum type, RTsizei stride, const void* ptr) {
    using enum ComponentType;
    setPointer(__func__, ArrayKind::Normal, 3, 3, 3, type, {Byte, Short, Int, Float, Double},
               stride, ptr);
}
RTAPI void RTAPIENTRY rtColorPointer(RTint size, RTenum type, RTsizei stride, const void* ptr) {
    using enum ComponentType;
    setPointer(__func__, ArrayKind::Color, size, 3, 4, type,
               {Byte, UnsignedByte, Short, UnsignedShort, Int, UnsignedInt, Float, Double}, stride,
               ptr);
}
RTAPI void RTAPIENTRY rtSecondaryColorPointer(RTint size, RTenum type, RTsizei stride,
                                              const void* pointer) {
    using enum ComponentType;
    setPointer(__func__, ArrayKind::SecondaryColor, size, 3, 3, type,
               {Byte, UnsignedByte, Short, UnsignedShort, Int, UnsignedInt, Float, Double}, stride,
               pointer);
}
RTAPI void RTAPIENTRY rtFogCoordPointer(RTenum type, RTsizei stride, const void* pointer) {
    using enum ComponentType;
    setPointer(__func__, ArrayKind::FogCoordinate, 1, 1, 1, type, {Float, Double}, stride, pointer);
}
RTAPI void RTAPIENTRY rtIndexPointer(RTenum type, RTsizei stride, const void* ptr) {
    using enum ComponentType;
    setPointer(__func__, ArrayKind::Index, 1, 1, 1, type,
               {UnsignedByte, Short, Int, Float, Double}, stride, ptr);
}
RTAPI void RTAPIENTRY rtEdgeFlagPointer(RTsizei stride, const void* ptr) {
    setPointer(__func__, ArrayKind::EdgeFlag, 1, 1, 1, RT_UNSIGNED_BYTE,
               {ComponentType::UnsignedByte}, stride, ptr);
}

RTAPI void RTAPIENTRY rtInterleavedArrays(RTenum format, RTsizei stride, const void* pointer) {
    guarded(__func__, [&](Context& c) {
        VertexArrays& arrays = arraysOutside(c);
        const InterleavedFormat& layout = interleavedFormatOf(format);
        if (stride < 0) throwError(ErrorCode::InvalidValue, "the stride is negative");
        interleave(arrays, layout, stride, pointer);
    });
}

RTAPI void RTAPIENTRY rtClientActiveTexture(RTenum texture) {
    guarded(__func__, [&](Context& c) {
        VertexArrays& arrays = arraysOutside(c);
        arrays.unit = textureUnitOf(texture);
    });
}

RTAPI void RTAPIENTRY rtGetPointerv(RTenum pname, void** params) {
    guarded(__func__, [&](Context& c) {
        const VertexArrays& arrays = arraysOutside(c);
        const std::optional<ArrayKind> kind = arrayPointerOf(pname);
        const bool never =
            pname == RT_FEEDBACK_BUFFER_POINTER || pname == RT_SELECTION_BUFFER_POINTER;
        if (!kind && !never) throwError(ErrorCode::InvalidEnum, "no such pointer");
        requirePointer(params, "params");
        *params = kind ? const_cast<void*>(arrays[arrays.selected(*kind)].pointer) : nullptr;
    });
}

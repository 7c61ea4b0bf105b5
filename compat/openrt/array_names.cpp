// SPDX-License-Identifier: MIT
#include "compat/openrt/array_names.h"

#include "compat/openrt/array_elements.h"

namespace smart::compat {

namespace {

/// Tokens of one array; 0: OpenGL has none.
struct ArrayNames {
    ArrayKind kind;
    RTenum cap, size, type, stride, pointer, buffer;
};
constexpr ArrayNames kNames[] = {
    {ArrayKind::Vertex, RT_VERTEX_ARRAY, RT_VERTEX_ARRAY_SIZE, RT_VERTEX_ARRAY_TYPE,
     RT_VERTEX_ARRAY_STRIDE, RT_VERTEX_ARRAY_POINTER, RT_VERTEX_ARRAY_BUFFER_BINDING},
    {ArrayKind::Normal, RT_NORMAL_ARRAY, 0, RT_NORMAL_ARRAY_TYPE, RT_NORMAL_ARRAY_STRIDE,
     RT_NORMAL_ARRAY_POINTER, RT_NORMAL_ARRAY_BUFFER_BINDING},
    {ArrayKind::Color, RT_COLOR_ARRAY, RT_COLOR_ARRAY_SIZE, RT_COLOR_ARRAY_TYPE,
     RT_COLOR_ARRAY_STRIDE, RT_COLOR_ARRAY_POINTER, RT_COLOR_ARRAY_BUFFER_BINDING},
    {ArrayKind::SecondaryColor, RT_SECONDARY_COLOR_ARRAY, RT_SECONDARY_COLOR_ARRAY_SIZE,
     RT_SECONDARY_COLOR_ARRAY_TYPE, RT_SECONDARY_COLOR_ARRAY_STRIDE,
     RT_SECONDARY_COLOR_ARRAY_POINTER, RT_SECONDARY_COLOR_ARRAY_BUFFER_BINDING},
    {ArrayKind::FogCoordinate, RT_FOG_COORD_ARRAY, 0, RT_FOG_COORD_ARRAY_TYPE,
     RT_FOG_COORD_ARRAY_STRIDE, RT_FOG_COORD_ARRAY_POINTER, RT_FOG_COORD_ARRAY_BUFFER_BINDING},
    {ArrayKind::Index, RT_INDEX_ARRAY, 0, RT_INDEX_ARRAY_TYPE, RT_INDEX_ARRAY_STRIDE,
     RT_INDEX_ARRAY_POINTER, RT_INDEX_ARRAY_BUFFER_BINDING},
    {ArrayKind::TexCoord, RT_TEXTURE_COORD_ARRAY, RT_TEXTURE_COORD_ARRAY_SIZE,
     RT_TEXTURE_COORD_ARRAY_TYPE, RT_TEXTURE_COORD_ARRAY_STRIDE, RT_TEXTURE_COORD_ARRAY_POINTER,
     RT_TEXTURE_COORD_ARRAY_BUFFER_BINDING},
    {ArrayKind::EdgeFlag, RT_EDGE_FLAG_ARRAY, 0, 0, RT_EDGE_FLAG_ARRAY_STRIDE,
     RT_EDGE_FLAG_ARRAY_POINTER, RT_EDGE_FLAG_ARRAY_BUFFER_BINDING},
};

StateValue number(double value) {
    StateValue state;
    state.values[0] = value;
    return state;
}

} // namespace

std::optional<ArrayKind> arrayKindOf(RTenum cap) {
    for (const ArrayNames& names : kNames)
        if (names.cap == cap) return names.kind;
    return std::nullopt;
}

std::optional<ArrayKind> arrayPointerOf(RTenum pname) {
    for (const ArrayNames& names : kNames)
        if (names.pointer == pname) return names.kind;
    return std::nullopt;
}

std::optional<StateValue> arrayStateValue(const VertexArrays& arrays, RTenum name) {
    if (name == 0) return std::nullopt;
    if (name == RT_ARRAY_BUFFER_BINDING) return number(arrays.arrayBuffer.name);
    if (name == RT_ELEMENT_ARRAY_BUFFER_BINDING) return number(arrays.elementBuffer.name);
    if (name == RT_CLIENT_ACTIVE_TEXTURE) return number(double(RT_TEXTURE0 + arrays.unit));
    for (const ArrayNames& names : kNames) {
        const VertexArray& array = arrays[arrays.selected(names.kind)];
        if (name == names.cap) return number(array.enabled);
        if (name == names.size) return number(array.size);
        if (name == names.type) return number(tokenOf(array.type));
        if (name == names.stride) return number(array.stride);
        if (name == names.buffer) return number(array.buffer.name);
    }
    return std::nullopt;
}

} // namespace smart::compat

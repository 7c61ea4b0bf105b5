// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "libsmart/geometry/texture_units.h"

namespace smart::compat {

/// Memory that vertex arrays and indices may lie in instead of the application's.
struct BufferObject {
    std::vector<std::byte> bytes;
    uint32_t usage = 0, access = 0; ///< tokens, only to be asked for; 0: OpenGL's initial ones
    bool mapped = false;
};
using BufferPtr = std::shared_ptr<BufferObject>;

/// A buffer as it is bound; name 0: none.
struct BufferBinding {
    uint32_t name = 0;
    BufferPtr buffer;
};

enum class ComponentType : uint8_t {
    Byte, UnsignedByte, Short, UnsignedShort, Int, UnsignedInt, Float, Double
};

enum class ArrayKind : uint8_t {
    EdgeFlag, TexCoord, Color, SecondaryColor, Normal, FogCoordinate, Index, Vertex,
    MoreTexCoords ///< of the second texture unit; those of the others follow
};
inline constexpr std::size_t kArrayKinds = std::size_t(ArrayKind::MoreTexCoords) + kMoreUnits;

inline ArrayKind texCoordArray(std::size_t unit) {
    return unit == 0 ? ArrayKind::TexCoord
                     : ArrayKind(std::size_t(ArrayKind::MoreTexCoords) + unit - 1);
}

struct VertexArray {
    bool enabled = false;
    int size = 4;
    ComponentType type = ComponentType::Float;
    uint32_t stride = 0;           ///< as given; 0: elements follow each other
    const void* pointer = nullptr; ///< or an offset into the buffer
    BufferBinding buffer;
};

/// OpenGL's client state of vertex arrays (table 6.6 to 6.9), a plain value to be pushed and popped.
struct VertexArrays {
    std::array<VertexArray, kArrayKinds> arrays;
    BufferBinding arrayBuffer, elementBuffer;
    std::size_t unit = 0; ///< the texture unit that calls about texture coordinates mean

    VertexArrays() {
        (*this)[ArrayKind::Normal].size = 3;
        (*this)[ArrayKind::SecondaryColor].size = 3;
        (*this)[ArrayKind::FogCoordinate].size = 1;
        (*this)[ArrayKind::Index].size = 1;
        (*this)[ArrayKind::EdgeFlag].size = 1;
        (*this)[ArrayKind::EdgeFlag].type = ComponentType::UnsignedByte;
    }
    /// What a kind of array means for the unit that is selected.
    ArrayKind selected(ArrayKind kind) const {
        return kind == ArrayKind::TexCoord ? texCoordArray(unit) : kind;
    }
    VertexArray& operator[](ArrayKind kind) { return arrays[std::size_t(kind)]; }
    const VertexArray& operator[](ArrayKind kind) const { return arrays[std::size_t(kind)]; }
};

} // namespace smart::compat

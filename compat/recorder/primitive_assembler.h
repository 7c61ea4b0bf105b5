// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace smart::compat {

enum class Primitive : uint8_t {
    Triangles, TriangleStrip, TriangleFan, Quads, QuadStrip, Polygon,
    Points, Lines, LineStrip, LineLoop
};
/// Whether it is made of triangles, not drawn in pixels.
constexpr bool isFilled(Primitive primitive) {
    return primitive < Primitive::Points;
}

struct AssembledTriangle {
    uint32_t corners[3]; ///< vertex numbers
    uint32_t provoking;  ///< vertex number of the primitive that the triangle is a part of
    uint8_t boundary;    ///< see ShadingData::boundary
    bool extendsPolygon; ///< the last edge of the triangle before is inside the polygon after all
};

/// Turns the vertices between begin and end into triangles, as they complete them. Every other
/// triangle of a strip is turned, so that all keep the winding of the first; quads are split
/// along their first and third vertex, those of strips too.
class PrimitiveAssembler {
public:
    static constexpr int kMaxTriangles = 2; ///< that one vertex can complete

    void begin(Primitive primitive) noexcept;
    /// Takes a vertex and writes the triangles that it completes; returns how many. edgeFlag: of
    /// the edge that starts there.
    int add(uint32_t vertex, AssembledTriangle out[kMaxTriangles], bool edgeFlag = true) noexcept;
    Primitive primitive() const { return primitive_; }
    /// Whether the provoking vertex of every triangle is its last corner.
    bool lastCornerProvokes() const {
        return primitive_ == Primitive::Triangles || primitive_ == Primitive::TriangleStrip ||
               primitive_ == Primitive::TriangleFan;
    }

private:
    Primitive primitive_ = Primitive::Triangles;
    uint32_t held_[3] = {}; ///< earlier vertices that may still be needed
    uint8_t flags_[3] = {}; ///< 1: the edge that starts at the earlier vertex is a boundary
    uint32_t count_ = 0;    ///< vertices since begin, or since the last whole primitive
    bool odd_ = false;      ///< the strip's next triangle is to be turned
    bool extends_ = false;  ///< the polygon has a triangle already
};

} // namespace smart::compat

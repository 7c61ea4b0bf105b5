// SPDX-License-Identifier: MIT
#include "compat/recorder/primitive_assembler.h"

#include <utility>

namespace smart::compat {

void PrimitiveAssembler::begin(Primitive primitive) noexcept {
    primitive_ = primitive;
    count_ = 0;
    odd_ = false;
    extends_ = false;
}

// Edge flags count for separate triangles, quads and polygons; strips and fans draw all edges of
// their triangles and quads.
int PrimitiveAssembler::add(uint32_t vertex, AssembledTriangle out[kMaxTriangles],
                            bool edgeFlag) noexcept {
    const uint32_t a = held_[0], b = held_[1], c = held_[2];
    const auto edges = [](int first, int second, int third) {
        return uint8_t(first | second << 1 | third << 2);
    };
    switch (primitive_) {
    case Primitive::Triangles:
        if (count_ < 2) break;
        out[0] = {{a, b, vertex}, vertex, edges(flags_[0], flags_[1], edgeFlag), false};
        count_ = 0;
        return 1;
    case Primitive::TriangleStrip:
        if (count_ < 2) break;
        out[0] = {{a, b, vertex}, vertex, edges(1, 1, 1), false};
        if (odd_) std::swap(out[0].corners[0], out[0].corners[1]);
        odd_ = !odd_;
        held_[0] = b;
        held_[1] = vertex;
        return 1;
    case Primitive::TriangleFan:
        if (count_ < 2) break;
        out[0] = {{a, b, vertex}, vertex, edges(1, 1, 1), false};
        held_[1] = vertex;
        return 1;
    case Primitive::Polygon:
        if (count_ < 2) break;
        out[0] = {{a, b, vertex}, a, edges(flags_[0], flags_[1], edgeFlag), extends_};
        held_[1] = vertex;
        flags_[0] = 0; // the next triangle's first edge is a diagonal
        flags_[1] = edgeFlag;
        extends_ = true;
        return 1;
    case Primitive::Quads:
        if (count_ < 3) break;
        out[0] = {{a, b, c}, vertex, edges(flags_[0], flags_[1], 0), false};
        out[1] = {{a, c, vertex}, vertex, edges(0, flags_[2], edgeFlag), false};
        count_ = 0;
        return 2;
    case Primitive::QuadStrip:
        if (count_ < 3) break;
        out[0] = {{a, b, vertex}, vertex, edges(1, 1, 0), false};
        out[1] = {{a, vertex, c}, vertex, edges(0, 1, 1), false};
        held_[0] = c;
        held_[1] = vertex;
        count_ = 2;
        return 2;
    case Primitive::Points:
    case Primitive::Lines:
    case Primitive::LineStrip:
    case Primitive::LineLoop: return 0;
    }
    held_[count_] = vertex;
    flags_[count_] = edgeFlag;
    ++count_;
    return 0;
}

} // namespace smart::compat

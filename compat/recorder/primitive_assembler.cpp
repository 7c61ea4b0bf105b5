// SPDX-License-Identifier: MIT
#include "compat/recorder/primitive_assembler.h"

namespace smart::compat {

void PrimitiveAssembler::begin(Primitive primitive) noexcept {
    primitive_ = primitive;
    count_ = 0;
    odd_ = false;
}

int PrimitiveAssembler::add(uint32_t vertex, AssembledTriangle out[kMaxTriangles]) noexcept {
    const uint32_t a = held_[0], b = held_[1], c = held_[2];
    switch (primitive_) {
    case Primitive::Triangles:
        if (count_ < 2) break;
        out[0] = {{a, b, vertex}, vertex};
        count_ = 0;
        return 1;
    case Primitive::TriangleStrip:
        if (count_ < 2) break;
        out[0] = odd_ ? AssembledTriangle{{b, a, vertex}, vertex}
                      : AssembledTriangle{{a, b, vertex}, vertex};
        odd_ = !odd_;
        held_[0] = b;
        held_[1] = vertex;
        return 1;
    case Primitive::TriangleFan:
    case Primitive::Polygon:
        if (count_ < 2) break;
        out[0] = {{a, b, vertex}, primitive_ == Primitive::Polygon ? a : vertex};
        held_[1] = vertex;
        return 1;
    case Primitive::Quads:
        if (count_ < 3) break;
        out[0] = {{a, b, c}, vertex};
        out[1] = {{a, c, vertex}, vertex};
        count_ = 0;
        return 2;
    case Primitive::QuadStrip:
        if (count_ < 3) break;
        out[0] = {{a, b, vertex}, vertex};
        out[1] = {{a, vertex, c}, vertex};
        held_[0] = c;
        held_[1] = vertex;
        count_ = 2;
        return 2;
    }
    held_[count_++] = vertex;
    return 0;
}

} // namespace smart::compat

// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <random>

#include "openrt/rts_packet.h"

namespace samples {

using Random = std::mt19937;

struct AlignedDelete {
    void operator()(std::byte* p) const;
};

/// A shader of a class and the blocks of its points, to be shaded without the library.
class TestedShader {
public:
    /// With the class's defaults. Throws std::runtime_error if its constructor fails.
    explicit TestedShader(const RTshaderclass& shaderClass);
    ~TestedShader();
    TestedShader(const TestedShader&) = delete;
    TestedShader& operator=(const TestedShader&) = delete;

    /// Floats become others near them; switches that are off, and textures, go on.
    void vary(Random& random);

    const void* bytes() const { return shader_.get(); }
    void* triangleBlock() const { return class_.triangleSize ? triangle_.get() : nullptr; }
    const void* vertexBlock(int lane) const {
        return class_.vertexSize ? vertices_[lane].get() : nullptr;
    }

private:
    std::byte* scratch();

    const RTshaderclass& class_;
    std::unique_ptr<std::byte, AlignedDelete> shader_, triangle_, scratch_;
    std::unique_ptr<std::byte, AlignedDelete> vertices_[RTS_PACKET_SIZE];
};

/// A point as the library could hand it out, of a surface or of what is behind all surfaces.
RTSstate randomPoint(Random& random, bool environment);

/// The same bits; NaN is NaN, whichever.
bool sameNumber(float a, float b);

} // namespace samples

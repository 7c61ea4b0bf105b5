// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

namespace smart {

struct WindowImage;

/// Points, lines or an image, given between two triangles.
struct PixelRun {
    enum class Kind : uint8_t { Points, Lines, LineStrip, LineLoop, Image };

    Kind kind = Kind::Points;
    uint32_t beforeTriangle = 0; ///< number of the triangle that is given next
    uint32_t first = 0;          ///< of the positions, or of the images
    uint32_t count = 0;          ///< an image: 1
    uint32_t firstVertex = 0;    ///< the first position's number, for its attributes
};

/// What of an object is drawn in pixels and met by no ray. Attributes of the vertices are in the
/// model's ShadingData, by vertex number.
struct PixelGeometry {
    std::vector<PixelRun> runs;
    std::vector<glm::vec3> positions;
    std::vector<std::shared_ptr<const WindowImage>> images; ///< of loose geometry only

    bool empty() const { return runs.empty(); }
    std::size_t bytes() const {
        return runs.capacity() * sizeof(PixelRun) + positions.capacity() * sizeof(glm::vec3) +
               images.capacity() * sizeof(images[0]);
    }
};

} // namespace smart

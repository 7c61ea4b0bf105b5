// SPDX-License-Identifier: MIT
// What OpenGL does with the fragments of a pixel (OpenGL 1.5, chapter 4), in order of submission.
#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "libsmart/render/framebuffer.h"
#include "libsmart/shading/fixed_state.h"

namespace smart {

/// A hit, or a pixel primitive, as one pixel sees it.
struct Fragment {
    uint64_t order = 0;                ///< of submission in its layer, see below
    const FixedState* state = nullptr; ///< nullptr: depth test RT_LESS, nothing else, not clamped
    float depth = 1.0f;                ///< window depth, offset included, 0 to 1
    glm::vec4 color{0.0f};             ///< textured and fogged, not clamped
    uint32_t source = 0xFFFFFFFFu;     ///< which hit of a ray it was; all ones: none
};

/// The order of what is submitted between the instances of a layer: hits of instance i come after
/// fragments of place i, which were submitted before the instance, and before those of place i + 1.
/// `number` counts inside the place.
constexpr uint64_t orderBeforeInstance(uint32_t place, uint32_t number) {
    return uint64_t(place) << 33 | number;
}
constexpr uint64_t orderOfInstance(uint32_t instance, uint32_t number) {
    return uint64_t(instance) << 33 | uint64_t(1) << 32 | number;
}

/// Numbers of an instance's own triangles are theirs; what nests in it comes after them, hits from
/// this number on, what is drawn in pixels last.
inline constexpr uint32_t kFirstNested = 0x80000000u, kLastNested = 0xFFFFFFFFu;

/// The smallest step of window depth, which polygon offset counts in.
inline constexpr float kDepthUnit = 0x1p-24f;

/// A fragment of a pixel of a tile: entry j * kTileSize + i, as in TilePixels.
struct PixelFragment {
    uint16_t entry = 0;
    uint64_t samples = ~uint64_t(0); ///< bit i: it covers samples i, i + 64, ... of the pixel
    Fragment fragment;
};

/// What covers pixels without rays: points, lines, bitmaps and drawn pixels of one layer.
/// Immutable; any threads may ask at once.
class FragmentSource {
public:
    virtual ~FragmentSource() = default;
    /// Appends what covers pixels of the tile, of a pixel in order of submission: what has the
    /// order of a hit comes after it. Fragments may lie outside of the viewport; the layer's
    /// scissor is the caller's business.
    virtual void cover(const Tile& tile, std::vector<PixelFragment>& fragments) const = 0;
};

/// A pixel's place in the buffers.
struct PixelValue {
    glm::vec4 color{0.0f};
    float depth = 1.0f;
    /// Fragment::source of the one that is seen here: that wrote the depth last, or, without a
    /// depth test, was drawn last.
    uint32_t source = kNoSource;

    static constexpr uint32_t kNoSource = 0xFFFFFFFFu;
};

/// Takes fragments, in their order, through alpha test, depth test, blending, logical operation
/// and masks.
void replay(std::span<const Fragment> fragments, PixelValue& pixel);

/// Before the colours of the fragments are known: needed[i] = whether that of the i-th may matter
/// to the pixel, whose depth is given.
void findNeeded(std::span<const Fragment> fragments, float depth, uint8_t* needed);

} // namespace smart

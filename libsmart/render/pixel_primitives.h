// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "libsmart/render/fragments.h"
#include "libsmart/render/frame.h"
#include "libsmart/render/pixel_assembly.h"
#include "libsmart/render/tile_bins.h"

namespace smart {

/// Points, lines, edges of polygons and images of one layer: covered by OpenGL's rules, in the
/// window, and seen by camera rays alone. What is needed of the vertices is computed when the
/// first tile asks.
class PixelPrimitives final : public FragmentSource {
public:
    /// What the layer's scene has of them; nullptr: nothing. Copies from the layer what it needs.
    static std::shared_ptr<const PixelPrimitives> make(const Frame& layer);

    void cover(const Tile& tile, std::vector<PixelFragment>& fragments) const override;

private:
    struct Prepared {
        PixelItems items;
        TileBins bins;
    };
    explicit PixelPrimitives(const Frame& layer);
    const Prepared& prepared() const;

    Frame layer_; ///< the parts that assembling reads
    mutable std::once_flag once_;
    mutable std::optional<Prepared> prepared_;
};

} // namespace smart

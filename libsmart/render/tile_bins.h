// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "libsmart/render/framebuffer.h"

namespace smart {

/// Numbers of things by the tiles of a picture that they may touch, ascending in each.
class TileBins {
public:
    /// forEachTile(add): calls add(thing, column, row) for all things in ascending order; the same
    /// calls each time. It is called twice.
    template <class ForEachTile>
    TileBins(uint32_t width, uint32_t height, ForEachTile&& forEachTile)
        : columns_((width + kTileSize - 1) / kTileSize),
          rows_((height + kTileSize - 1) / kTileSize),
          starts_(std::size_t(columns_) * rows_ + 1) {
        forEachTile([this](uint32_t, uint32_t column, uint32_t row) {
            ++starts_[binOf(column, row) + 1];
        });
        for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
        things_.resize(starts_.back());
        std::vector<std::size_t> next(starts_.begin(), starts_.end() - 1);
        forEachTile([&](uint32_t thing, uint32_t column, uint32_t row) {
            things_[next[binOf(column, row)]++] = thing;
        });
    }

    uint32_t columns() const { return columns_; }
    uint32_t rows() const { return rows_; }
    std::span<const uint32_t> of(uint32_t column, uint32_t row) const {
        const std::size_t bin = binOf(column, row);
        return {things_.data() + starts_[bin], starts_[bin + 1] - starts_[bin]};
    }

private:
    std::size_t binOf(uint32_t column, uint32_t row) const {
        return std::size_t(row) * columns_ + column;
    }

    uint32_t columns_, rows_;
    std::vector<std::size_t> starts_;
    std::vector<uint32_t> things_;
};

} // namespace smart

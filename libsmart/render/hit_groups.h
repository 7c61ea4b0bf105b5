// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "libsmart/render/framebuffer.h"
#include "libsmart/shading/shader_object.h"

namespace smart {

/// The rays of a tile by the surface shader of what they hit: groups in the order in which their
/// shader was first met, rays of a group in the order in which they were added.
class HitGroups {
public:
    using RayNumber = uint16_t;

    void clear() { rays_ = groups_ = 0; }

    /// At most TilePixels::kCount rays. nullptr, where there is no shader, is a group as well.
    void add(RayNumber ray, const ShaderObject* surface) {
        if (groups_ == 0 || surfaces_[last_] != surface) last_ = find(surface);
        ++size_[last_];
        ray_[rays_] = ray;
        groupOf_[rays_++] = uint16_t(last_);
    }

    /// function(surface, rays of the group) for each group.
    template <class Function>
    void forEachGroup(Function&& function) {
        RayNumber* next[TilePixels::kCount];
        RayNumber* begin = sorted_;
        for (std::size_t group = 0; group < groups_; ++group) {
            next[group] = begin;
            begin += size_[group];
        }
        for (std::size_t i = 0; i < rays_; ++i) *next[groupOf_[i]]++ = ray_[i];
        for (std::size_t group = 0; group < groups_; ++group)
            function(surfaces_[group], std::span<const RayNumber>(next[group] - size_[group],
                                                                  next[group]));
    }

private:
    std::size_t find(const ShaderObject* surface) {
        for (std::size_t group = 0; group < groups_; ++group)
            if (surfaces_[group] == surface) return group;
        surfaces_[groups_] = surface;
        size_[groups_] = 0;
        return groups_++;
    }

    std::size_t rays_ = 0, groups_ = 0, last_ = 0;
    RayNumber ray_[TilePixels::kCount], sorted_[TilePixels::kCount];
    uint16_t groupOf_[TilePixels::kCount];
    const ShaderObject* surfaces_[TilePixels::kCount];
    uint16_t size_[TilePixels::kCount];
};

} // namespace smart

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "libsmart/render/framebuffer.h"

namespace smart {

/// The tiles of a picture in Morton order: neighbours in time are neighbours in the picture, so
/// that workers meet the same parts of the scene. Empty for an empty picture.
std::vector<Tile> mortonTiles(uint32_t width, uint32_t height);

} // namespace smart

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "libsmart/geometry/model.h"

namespace smart {

/// Collects the triangles and attributes of one object and compiles them into a Model.
/// Throws std::bad_alloc; a builder that threw holds what it held before.
class ModelBuilder {
public:
    /// `shading` is filled by the caller: its vectors must agree with each other and with the
    /// triangles (see ShadingData); that is checked by assertion only.
    std::vector<Triangle> triangles;
    ShadingData shading;
    PixelGeometry pixels;
    InstanceList children;

    /// Compiles. A triangle that is not finite, or whose cross product is exactly zero (in exact
    /// arithmetic), is left out of the tree, counted, and keeps its number.
    ModelPtr build(const ModelBuildOptions& options = {}) &&;
};

} // namespace smart

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "libsmart/geometry/model.h"

namespace smart {

/// The model with other positions, x, y, z each, of the vertices first.. in the order given; they
/// must exist, and the model must know its corners. Everything but triangles and tree is shared
/// with `old`, which does not change. Triangles that were dropped come back where they are finite
/// and have an area now, and the other way round. Throws std::bad_alloc.
ModelPtr updateModel(const Model& old, uint32_t first, uint32_t count, const float* positions,
                     const ModelBuildOptions& options = {});

} // namespace smart

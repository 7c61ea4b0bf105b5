// SPDX-License-Identifier: MIT
// Embree 3 as a yardstick: the same triangles, the same rays, in the same process.
#pragma once

#include "tests/bench/engine.h"

namespace smart::bench {

enum class EmbreeQuality { Medium, High };

/// Builds only; the scene is gone afterwards.
BuildReport buildEmbree(const std::vector<Triangle>& triangles, EmbreeQuality quality,
                        unsigned threads);

/// Packets of 16 (coherent flag) and single rays, for both qualities of its tree.
std::vector<EnginePtr> embreeEngines(const std::vector<Triangle>& triangles, bool robust,
                                     unsigned threads);

} // namespace smart::bench

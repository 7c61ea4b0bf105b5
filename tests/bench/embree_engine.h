// SPDX-License-Identifier: MIT
// Embree 3 as a yardstick: the same triangles, the same rays, in the same process.
#pragma once

#include "tests/bench/engine.h"

namespace smart::bench {

enum class EmbreeQuality { Medium, High };

/// Builds only; the scene is gone afterwards.
BuildReport buildEmbree(const std::vector<Triangle>& triangles, EmbreeQuality quality,
                        unsigned threads);

/// Every way that Embree has to trace rays, for both qualities of its tree, plain and ROBUST,
/// each with the coherent and the incoherent flag: single rays and packets of 4, 8 and 16, packed
/// by us from arrays ("arrays", in the time) and ready in its own form ("packed"), and streams
/// "1M", "NM" (of packets of 16) and "Np". Named such as "embree 16 coherent packed high robust".
/// isa: ours whose counterpart Embree is limited to; "" for all that it has.
std::vector<EnginePtr> embreeEngines(const std::vector<Triangle>& triangles, unsigned threads,
                                     const std::string& isa);

/// The same for one tree.
std::vector<EnginePtr> embreeEngines(const std::vector<Triangle>& triangles, EmbreeQuality quality,
                                     bool robust, unsigned threads, const std::string& isa);

} // namespace smart::bench

// SPDX-License-Identifier: MIT
#pragma once

#include "libsmart/scene/query.h"
#include "libsmart/scene/scene.h"
#include "tests/bench/engine.h"

namespace smart::bench {

/// A scene of one instance, built by `threads`.
ScenePtr buildOpenrt(const std::vector<Triangle>& triangles, Precision precision, unsigned threads,
                     BuildReport& report, BuildQuality quality = BuildQuality::Nicest);

/// Packets, single rays and the public query for rays of that coherence, and tiles where they are
/// coherent, with the kernels that are selected now.
/// plantError: every 1000th packet names a wrong triangle, so that the comparison can be proved.
std::vector<EnginePtr> openrtEngines(const ScenePtr& scene, Precision precision,
                                     Coherence coherence, bool plantError);

/// Packets in precise mode, over a scene made for any mode.
EnginePtr preciseEngine(const ScenePtr& scene);

} // namespace smart::bench

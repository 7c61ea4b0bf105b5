// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "libsmart/render/frame.h"
#include "tests/bench/workload.h"

namespace smart::bench {

/// A square picture of a scene with the class Phong and a point light with shadows, written to
/// `pixels`, four floats each, which it makes as large as needed.
std::unique_ptr<Frame> phongFrame(const ScenePtr& scene, const View& view, uint32_t size,
                                  std::vector<float>& pixels);

} // namespace smart::bench

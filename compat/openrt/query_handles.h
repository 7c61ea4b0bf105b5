// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "libsmart/scene/scene.h"

namespace smart::compat {

// Scenes compiled for ray queries: process-wide, from any thread. Handles count from 1 and are
// never used again.

uint32_t addQueryScene(ScenePtr scene);
/// nullptr: unknown handle.
ScenePtr findQueryScene(uint32_t handle);
/// False for an unknown handle.
bool releaseQueryScene(uint32_t handle);
void releaseAllQueryScenes();

} // namespace smart::compat

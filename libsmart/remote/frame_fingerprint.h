// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "libsmart/render/frame.h"

namespace smart {

/// Of what a frame is made of, without its pixels and addresses: processes that mean the same frame
/// have the same. It covers sizes, settings, camera and places of instances, and of models and
/// shaders their numbers; enough to find out two frames that were mistaken for each other.
uint64_t frameFingerprint(const Frame& frame);

} // namespace smart

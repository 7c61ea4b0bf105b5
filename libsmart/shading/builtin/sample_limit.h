// SPDX-License-Identifier: MIT
#pragma once

namespace smart::builtin {

/// Samples that a point or a pixel may ask for, as many as rtSamples takes: a tile that is under way
/// can not be cancelled.
inline constexpr int kMaxSamples = 4096;

} // namespace smart::builtin

// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "libsmart/render/frame.h"

namespace smart::bench {

/// Means of the tiles of a rendered picture, on this machine.
struct PackingCosts {
    double packSeconds = 0, unpackSeconds = 0;
    double plainBytes = 0, packedBytes = 0;
};
PackingCosts packingCosts(const Frame& frame, unsigned repeat);

/// The rendered picture again and again, by tiles that take a millisecond of no processor, over
/// lines of several rates: what packing all tiles, none, and those for which it pays makes of it.
/// Prints a table.
void printSimulatedPacking(const std::shared_ptr<Frame>& frame, unsigned frames);

} // namespace smart::bench

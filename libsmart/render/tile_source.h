// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <exception>
#include <memory>
#include <optional>

#include "libsmart/render/frame.h"

namespace smart {

struct TileJob {
    std::shared_ptr<const Frame> frame;
    Tile tile;
    uint64_t ticket = 0; ///< the source's own; workers hand it back as it came
};

/// The whole contract between those who have work and those who do it: threads, other machines
/// and tests are callers alike. Thread-safe.
class TileSource {
public:
    virtual ~TileSource() = default;
    /// Blocks until there is work; nullopt: go home.
    virtual std::optional<TileJob> next() = 0;
    virtual void done(const TileJob&, const TilePixels&) = 0;
    virtual void failed(const TileJob&, std::exception_ptr) noexcept = 0;
};

} // namespace smart

// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <chrono>

namespace smart {

/// How long a tile that another process was asked for may take until others get it too: a few times
/// as long as answers take, as tiles that are slow are not late. Not thread-safe.
class TilePatience {
public:
    using Duration = std::chrono::steady_clock::duration;

    explicit TilePatience(Duration least) : least_(least) {}
    /// An answer came so long after its tile was asked for. One that took far longer than others
    /// changes little, so that a process that was stopped for a while makes nobody wait.
    void answered(Duration time) { mean_ += (std::min(time, 2 * limit()) - mean_) / kMemory; }
    Duration limit() const { return std::max(least_, 4 * mean_); }

private:
    static constexpr int kMemory = 16; ///< answers
    const Duration least_;
    Duration mean_{};
};

} // namespace smart

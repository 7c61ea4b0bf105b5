// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace smart {

/// Whether packing tiles makes more of them a second. Tiles pass two stages, threads and a line,
/// and the slower one sets the pace: packing takes time of the threads and spares the line. All of
/// this is measured, the line by the fastest that bytes lately came through, which is less than it
/// could carry while it is not the limit. Not thread-safe.
class PackingChoice {
public:
    using Clock = std::chrono::steady_clock;

    explicit PackingChoice(unsigned threads) : threads_(threads) {}

    /// A thread's time for a tile, without what packed() has.
    void worked(double seconds);
    void packed(double seconds, std::size_t before, std::size_t after);
    /// So many bytes, all in all, have come through the line.
    void arrived(uint64_t bytes, Clock::time_point now);
    /// There is nothing to send for now.
    void paused() { spanTiles_ = 0; }

    /// Tiles a second with packing to those without; 0: not known yet.
    double gain() const;
    double bytesPerSecond() const; ///< of the line; 0: not known yet

private:
    const unsigned threads_;
    double workSeconds_ = 0, packSeconds_ = 0; // of a tile; 0: not measured
    double before_ = 0, after_ = 0;            // bytes of a tile

    uint64_t arrived_ = 0, spanBegin_ = 0;
    Clock::time_point spanStart_;
    unsigned spanTiles_ = 0, spans_ = 0;
    double fastest_ = 0, fastestBefore_ = 0; // of these spans and of those before
};

} // namespace smart

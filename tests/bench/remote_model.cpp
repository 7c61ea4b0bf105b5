// SPDX-License-Identifier: MIT
#include "tests/bench/remote_model.h"

#include <algorithm>

namespace smart::bench {

RemotePrediction predict(const RemoteCosts& c, uint64_t tiles, unsigned ranks, unsigned threads) {
    const double roundTrip = 2 * c.latencySeconds + c.tileSeconds;
    // Tiles a second: of a thread beside the application, of one behind the network, and what the
    // line and the serving thread let through of the latter.
    const double own = threads / c.tileSeconds;
    const double traced = (ranks - 1.0) * threads / c.tileSeconds;
    const double awaited = (ranks - 1.0) * threads * c.tilesAhead / roundTrip;
    const double carried =
        c.lineBytesPerSecond > 0 ? c.lineBytesPerSecond / c.answerBytes : 1e300;
    const double served = c.masterSeconds > 0 ? 1 / c.masterSeconds : 1e300;
    const double others = std::min({traced, awaited, carried, served});

    RemotePrediction p;
    p.limit = others == traced    ? "tracing"
              : others == awaited ? "latency"
              : others == carried ? "the line of rank 0"
                                  : "the serving thread of rank 0";
    p.framesPerSecond = (own + others) / double(tiles);
    // No more threads than tiles; the first request and the last answer travel by themselves.
    const double rounds = double(tiles) / (own + others);
    const double remote = ranks > 1 ? 2 * c.latencySeconds : 0.0;
    p.frameSeconds = std::max(rounds, c.tileSeconds) + remote;
    p.efficiency = p.framesPerSecond * double(tiles) * c.tileSeconds / (double(ranks) * threads);
    return p;
}

} // namespace smart::bench

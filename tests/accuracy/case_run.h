// SPDX-License-Identifier: MIT
// One hard case through many engines, all judged by the same truth.
#pragma once

#include "tests/accuracy/engine.h"
#include "tests/accuracy/tally.h"

namespace smart::test {

struct RunSize {
    std::size_t rays = 10000;          ///< before a case's own share
    std::size_t identityRays = 2000;   ///< through every variant of a mode
    std::size_t bruteTests = 20000000; ///< triangle tests for a brute force engine
    unsigned threads = 1;
    uint64_t seed = 1;
};

struct EngineTally {
    std::string engine;
    int mode = -1;
    Tally tally;
};

/// Rays whose answers were not the same bits in all variants of a mode.
struct Identity {
    std::string mode;
    std::size_t variants = 0, rays = 0, differing = 0;
};

struct CaseResult {
    std::string name;
    std::size_t triangles = 0;
    Promise promise = Promise::None;
    std::vector<EngineTally> engines;
    std::vector<Identity> identities;
    double seconds = 0;
};

CaseResult runCase(const NamedCase& named, const std::vector<EngineKind>& kinds,
                   const RunSize& size);

/// What a mode of the library did against its promise; empty if it kept it.
std::string broken(const CaseResult& result);

} // namespace smart::test

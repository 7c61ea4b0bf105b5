// SPDX-License-Identifier: MIT
// Ways to build a tree, and the trees that they leave to be traced.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tests/bench/engine.h"

namespace smart::bench {

/// A tree over the triangles of a bench scene, while they live.
class TracedTree {
public:
    virtual ~TracedTree() = default;
    virtual std::size_t bytes() const = 0;          ///< nodes, and triangles where it has its own
    virtual float cost() const { return 0; }        ///< by the surface area heuristic; 0: unknown
    /// Nearest hits, packet by packet; coherent: neighbours go the same way.
    virtual void closest(const RaySet& rays, bool coherent, Found* found) const = 0;
};

struct TreeBuilder {
    std::string name;
    bool peer;
    /// `seconds`: what the build took, from triangles to a tree that can be traced. Processor time
    /// of the process for one thread, by the clock for several.
    std::function<std::unique_ptr<TracedTree>(const std::vector<Triangle>& triangles,
                                              unsigned threads, double& seconds)>
        build;
};

/// Seconds by the clock that builds with so many threads are measured by.
class BuildClock {
public:
    explicit BuildClock(unsigned threads);
    double seconds() const;

private:
    int clock_;
    double start_;
};

/// The same triangles, bent a little: what a refit is measured with.
std::vector<Triangle> bent(const std::vector<Triangle>& triangles);

std::vector<TreeBuilder> openrtBuilders();
std::vector<TreeBuilder> embreeBuilders();

} // namespace smart::bench

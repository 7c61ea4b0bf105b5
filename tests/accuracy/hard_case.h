// SPDX-License-Identifier: MIT
// Scenes and rays at which ray tracers fail, made by rule with fixed seeds.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/support/exact_reference.h"
#include "tests/support/ray_sets.h"

namespace smart::test {

struct Placement {
    uint32_t mesh;
    Matrix34 toWorld;
    bool identity = false;
    bool dropped = false; ///< no engine can take it: nothing of it is there
};

/// Meshes and where they stand, for every engine to build from.
struct Geometry {
    std::vector<std::vector<Triangle>> meshes;
    std::vector<Placement> placements;

    Geometry() = default;
    /// One mesh as it is.
    explicit Geometry(std::vector<Triangle> mesh);

    void addTo(ExactReference& reference) const;
    std::size_t triangles() const; ///< counted once a placement
    bool plain() const { return placements.size() == 1 && placements[0].identity; }
};

/// What the watertight mode promises; the precise mode promises that everything is right.
enum class Promise {
    Right,       ///< nothing wrong at all
    NothingLost, ///< no miss, no leak; distances along slivers may slide
    None         ///< beyond the mode's limits: measured only
};

struct HardCase {
    Geometry geometry;
    /// Any number of rays; equal seeds give equal rays.
    std::function<std::vector<Ray>(std::size_t count, uint64_t seed)> rays;
    Promise promise = Promise::NothingLost;
    double share = 0.1; ///< of the number of rays asked for
    std::size_t most = std::size_t(-1);
    bool abortsPeers = false; ///< Embree as Debian builds it stops the process
};

struct NamedCase {
    std::string name;
    std::function<HardCase()> make;
};

/// All cases, H1 to H12 without H9, which is about rays that engines make themselves. `crowd`:
/// triangles of each case of H6.
std::vector<NamedCase> hardCases(uint32_t crowd = 100000);

// The parts of hardCases().
std::vector<NamedCase> aimedCases();   ///< H1, H2, H11-dir: at vertices and edges of closed meshes
std::vector<NamedCase> alignedCases(); ///< H3, H4, H5: planes, zero components, bad triangles
std::vector<NamedCase> crowdedCases(uint32_t crowd); ///< H6, H7: many triangles in one place
std::vector<NamedCase> placedCases();                ///< H10: instances
std::vector<NamedCase> limitCases(); ///< H8, H11-range, H12: distances, ranges, grazing rays

} // namespace smart::test

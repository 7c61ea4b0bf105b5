// SPDX-License-Identifier: MIT
// What the hard cases ask: one small adapter an engine.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "tests/accuracy/hard_case.h"
#include "tests/support/verdict.h"

namespace smart::test {

/// A scene as one engine holds it. Several threads may trace at once.
class Engine {
public:
    virtual ~Engine() = default;
    /// claims[i] answers rays[i], in the numbers of Geometry::addTo.
    virtual void trace(std::span<const Ray> rays, Claim* claims) const = 0;
    /// Sets the origin of a ray that leaves what `incoming` hit; its direction is given. `point`
    /// is made of the hit's barycentrics, `normal` is the triangle's unit normal, both in double.
    /// For engines that offer no help: four units in the last place of the largest coordinate.
    virtual void leaveSurface(const Ray& incoming, const Claim& hit, const double point[3],
                              const double normal[3], Ray& ray) const;
};

using EnginePtr = std::unique_ptr<const Engine>;

/// Ways to trace the same scene with the same results to the bit.
struct Variant {
    std::string name;
    EnginePtr engine;
};

/// An engine's name and how to make it for a scene; makes nullptr for what it can not take.
struct EngineKind {
    std::string name;
    std::function<EnginePtr(const Geometry&)> make;
    /// The mode that the engine is; Embree and yardsticks: -1.
    int mode = -1;
    bool bruteForce = false; ///< asks every triangle: few rays must do
    bool aborts = false;     ///< stops the process on bad numbers
};

/// All there are: our modes, Embree where it was built in, yardsticks, planted defects.
std::vector<EngineKind> engineKinds();

/// The library's modes: packets with the best instruction set.
std::vector<EngineKind> openrtKinds();
/// Packets, full and sparse, and single rays, of every instruction set of this machine.
std::vector<Variant> openrtVariants(const Geometry& geometry, int mode);
/// The watertight mode over a tree that holds straddling triangles on one side only.
EngineKind oneSidedKind();
/// Float tests of every triangle: Moeller-Trumbore, Wald, Woop, Woop contracted.
std::vector<EngineKind> yardstickKinds();
/// Embree's default and robust modes, single rays and packets.
std::vector<EngineKind> embreeKinds();
std::string embreeVersion(); ///< empty: not built in

const char* modeName(int mode); ///< fast, watertight, precise

} // namespace smart::test

// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>

#include "tests/bench/agreement.h"

namespace smart::bench {

/// Workloads. Camera rays; shadow rays to a point light; ambient occlusion, four rays a hit within
/// a tenth of the diagonal; the nearest hits of rays that leave diffusely.
enum class Kind { Primary, Shadow, Ao, Bounce };
inline constexpr Kind kKinds[] = {Kind::Primary, Kind::Shadow, Kind::Ao, Kind::Bounce};

const char* nameOf(Kind kind);
Query queryOf(Kind kind);
bool coherent(Kind kind);

/// One engine at one kind of rays and one number of threads.
struct Result {
    std::string engine;
    bool peer = false, robust = false;
    std::vector<double> mraysPerSecond; ///< one for each repeat; empty: sorted out as too slow
    /// The same for each second that a processor worked, times the number of threads: what it
    /// would be if the machine did nothing else and the threads ended together.
    std::vector<double> undisturbed;
    double firstLook = 0;               ///< Mrays/s of a part of the rays
    Mistakes mistakes;                  ///< in all repeats
    /// Too many wrong answers: the speeds mean nothing. A peer stays the yardstick that it is, its
    /// wrong answers printed beside.
    bool refused = false;

    double median() const;
};

struct Series {
    Kind kind;
    unsigned threads;
    std::size_t rays = 0; ///< of all repeats
    std::vector<Result> results;

    /// The fastest peer, nullptr if there is none.
    const Result* bestPeer(bool robustOnly) const;
};

/// How many times as fast as the other, the median over the repeats, in which both met the same
/// rays and nearly the same moment.
double ratio(const Result& result, const Result& other);
/// The same of one engine with several threads and with one, by `undisturbed`.
double gain(const Result& several, const Result& one);
double medianOf(std::vector<double> values);

using Progress = std::function<void(const std::string&)>;

struct Plan {
    Kind kind;
    std::function<RaySet(uint64_t seed)> rays; ///< new ones for each repeat
    std::vector<unsigned> threads;
    unsigned repeats;
    /// Not measured; rays about which it differs from the others are judged too. May be nullptr.
    Engine* referee = nullptr;
};

/// All engines in turn, on the same rays, `repeats` times over, so that a disturbance meets all
/// alike; their answers are compared each time. Peers that are clearly not among their fastest in
/// a first look at a part of the rays are left out.
/// One thread is measured in its own processor time, several by the clock, each on a core of its
/// own.
std::vector<Series> measure(const Truth& truth, const Plan& plan,
                            std::span<const EnginePtr> engines, const Progress& progress);

} // namespace smart::bench

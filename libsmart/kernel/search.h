// SPDX-License-Identifier: MIT
// What a traversal carries along: the rays in the space at hand, and the best hit of each lane.
#pragma once

#include "libsmart/kernel/packet.h"
#include "libsmart/kernel/simd.h"
#include "libsmart/kernel/view.h"

namespace smart::SMART_ISA {

enum class HitMode { Closest, Any, All };

/// Rays in one model's space. Plain arrays: lanes are regrouped and transformed in memory.
template <int N>
struct alignas(64) LocalRays {
    float org[3][N];
    float dir[3][N];
};

/// The application's rays without any rounding, for the precise mode: see WorldRay.
template <int N>
struct alignas(64) WorldRays {
    double org[3][N], dir[3][N];
    double tNear[N], tFar[N];
    double scale[N];
    const ModelView* scene;
};

/// Counts nothing and costs nothing.
struct NoCounts {
    void node() {}
    void leaf() {}
    void triangle(uint32_t = 1) {}
    void instance() {}
    void arbitration(bool) {}
};

struct Counts {
    TraversalCounts* total = nullptr;
    void node() { ++total->nodes; }
    void leaf() { ++total->leaves; }
    void triangle(uint32_t count = 1) { total->triangles += count; }
    void instance() { ++total->instances; }
    void arbitration(bool exact) {
        ++total->doubles;
        total->exacts += exact;
    }
};

/// The state of one query. t is in units of the ray direction as scaled at the start, which no
/// instance changes. `best` is the far limit until something is hit. In the precise mode distances
/// are known as intervals: the best one lies in [low, best].
template <int N, HitMode M, class Counter>
struct alignas(64) Search {
    alignas(4 * N) float tNear[N];
    alignas(4 * N) float best[N];
    alignas(4 * N) float low[N];
    alignas(4 * N) uint32_t triangle[N];
    alignas(4 * N) uint32_t levels[N];
    alignas(4 * N) uint32_t path[kMaxLevels][N];
    uint32_t blocked = 0; ///< HitMode::Any: lanes that met something

    const WorldRays<N>* world = nullptr; ///< precise mode only
    HitList* all = nullptr;              ///< HitMode::All: where the hits go
    uint32_t firstLane = 0;              ///< ... as the first lane's of these
    bool lastOfEqual = false;            ///< as ModelView has it

    uint32_t currentPath[kMaxLevels];
    uint32_t currentLevels = 0;
    uint32_t deepest = 0; ///< no hit has more levels
    Counter counter{};

    /// Whether the triangle at hand is preferred to the one stored for a lane at equal distance:
    /// the lowest path, a model's own triangles before its children, the lowest triangle; with
    /// lastOfEqual the opposite.
    bool precedes(uint32_t candidate, int lane) const {
        if (triangle[lane] == kNoHit) return true;
        for (uint32_t l = 0; l < currentLevels && l < levels[lane]; ++l)
            if (currentPath[l] != path[l][lane])
                return (currentPath[l] < path[l][lane]) != lastOfEqual;
        if (currentLevels != levels[lane])
            return (currentLevels < levels[lane]) != lastOfEqual;
        return lastOfEqual ? candidate > triangle[lane] : candidate < triangle[lane];
    }

    /// Whether the triangle stored for a lane belongs to the model at hand, in the same place.
    bool sharesModel(int lane) const {
        if (levels[lane] != currentLevels) return false;
        for (uint32_t l = 0; l < currentLevels; ++l)
            if (currentPath[l] != path[l][lane]) return false;
        return true;
    }
    /// Whether the triangle at hand is the one stored for a lane.
    bool holds(uint32_t candidate, int lane) const {
        return triangle[lane] == candidate && sharesModel(lane);
    }

    /// Lanes, of those given, whose stored triangle stays at equal distance.
    uint32_t outranked(uint32_t candidate, uint32_t lanes) const {
        uint32_t stay = 0;
        for (; lanes; lanes &= lanes - 1)
            if (!precedes(candidate, lowestBit(lanes))) stay |= lanes & (0u - lanes);
        return stay;
    }

    static void keep(const Mask<N>& lanes, uint32_t value, uint32_t* kept) {
        select(lanes, Word<N>(value), Word<N>::load(kept)).store(kept);
    }

    /// Stores the triangle at hand for the lanes given.
    void keepTriangle(const Mask<N>& lanes, uint32_t candidate) {
        keepTriangle(lanes, Word<N>(candidate));
    }
    void keepTriangle(const Mask<N>& lanes, const Word<N>& candidates) {
        select(lanes, candidates, Word<N>::load(triangle)).store(triangle);
        keep(lanes, currentLevels, levels);
        for (uint32_t l = 0; l < currentLevels; ++l) keep(lanes, currentPath[l], path[l]);
        deepest = deepest > currentLevels ? deepest : currentLevels;
    }

    /// The same for one lane.
    void keepTriangleOf(int lane, uint32_t candidate) {
        triangle[lane] = candidate;
        levels[lane] = currentLevels;
        for (uint32_t l = 0; l < currentLevels; ++l) path[l][lane] = currentPath[l];
        deepest = deepest > currentLevels ? deepest : currentLevels;
    }

    /// HitMode::All: adds the triangle at hand for the lanes given.
    void append(uint32_t lanes, uint32_t candidate) {
        for (; lanes; lanes &= lanes - 1) {
            const uint32_t at = all->count++;
            if (at >= all->capacity) continue;
            Hit& hit = all->hits[at];
            hit.triangle = candidate;
            hit.levels = currentLevels;
            for (uint32_t l = 0; l < currentLevels; ++l) hit.path[l] = currentPath[l];
            all->lanes[at] = firstLane + uint32_t(lowestBit(lanes));
        }
    }

    /// Takes a triangle met at t by the lanes `hit`; returns the lanes' new far limits.
    Real<N> accept(const Mask<N>& hit, const Real<N>& t, const Real<N>& far, uint32_t candidate) {
        if constexpr (M == HitMode::Any) {
            blocked |= hit.bits();
            return far;
        } else if constexpr (M == HitMode::All) {
            append(hit.bits(), candidate);
            return far;
        } else {
            Mask<N> taken = hit;
            const Mask<N> ties = hit & (t == far);
            if (any(ties)) taken = andNot(hit, Mask<N>::fromBits(outranked(candidate, ties.bits())));
            keepTriangle(taken, candidate);
            return select(taken, t, far);
        }
    }
};

} // namespace smart::SMART_ISA

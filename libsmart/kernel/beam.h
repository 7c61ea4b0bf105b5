// SPDX-License-Identifier: MIT
// A tile of rays that come from one point, or go to one, as a whole: a beam. Its rays are told
// apart by their slopes alone, so that boxes can be tested against all of them at once.
//
// Reshetov, Soupikov, Hurley, "Multi-level ray tracing algorithm", SIGGRAPH 2005, for testing
// boxes against all rays at once; Wald, Benthin, Boulos, "Getting rid of packets", RT 2008, for
// one beam against sixteen boxes.
#pragma once

#include "libsmart/kernel/kd_traversal.h"

namespace smart::SMART_ISA {

inline constexpr int kTileVectors = 4; ///< packets of a tile

inline float lesserOf(float a, float b) { return a < b ? a : b; }

/// The packets of a tile in one model's space.
struct RayTile {
    LocalRays<kPacketSize> rays[kTileVectors];
    float apex[3]; ///< the point that all rays start at, or head for
    bool startsThere;
    alignas(64) float last[kTileVectors][kPacketSize]; ///< of rays that head for it: the far limits
};

/// Which rays of a tile: bits of each packet.
struct TileLanes {
    uint32_t of[kTileVectors];

    uint32_t count() const {
        uint32_t n = 0;
        for (const uint32_t lanes : of) n += uint32_t(__builtin_popcount(lanes));
        return n;
    }
};

/// Splits the rays of a tile as RayGroups does those of a packet.
class TileGroups {
public:
    TileGroups(const RayTile& tile, const TileLanes& lanes) : rest_(lanes) {
        const Real<kPacketSize> zero(0.0f);
        for (int v = 0; v < kTileVectors; ++v) {
            if (!lanes.of[v]) continue;
            Real<kPacketSize> size[3];
            for (int k = 0; k < 3; ++k) {
                const auto d = Real<kPacketSize>::load(tile.rays[v].dir[k]);
                negative_[k].of[v] = (d < zero).bits();
                size[k] = magnitude(d);
            }
            dominant_[0].of[v] = ((size[0] >= size[1]) & (size[0] >= size[2])).bits();
            dominant_[1].of[v] = (size[1] >= size[2]).bits() & ~dominant_[0].of[v];
            dominant_[2].of[v] = ~(dominant_[0].of[v] | dominant_[1].of[v]);
        }
    }

    /// `group.lanes` stays unset: a tile has more than a packet.
    bool next(RayGroup& group, TileLanes& lanes) {
        int from = 0;
        while (from < kTileVectors && !rest_.of[from]) ++from;
        if (from == kTileVectors) return false;
        const uint32_t first = rest_.of[from] & (0u - rest_.of[from]);
        for (int k = 0; k < 3; ++k) {
            group.negative[k] = (negative_[k].of[from] & first) != 0;
            if (dominant_[k].of[from] & first) group.dominantAxis = k;
        }
        for (int v = 0; v < kTileVectors; ++v) {
            uint32_t same = rest_.of[v];
            if (same) {
                same &= dominant_[group.dominantAxis].of[v];
                for (int k = 0; k < 3; ++k)
                    same &= group.negative[k] ? negative_[k].of[v] : ~negative_[k].of[v];
            }
            lanes.of[v] = same;
            rest_.of[v] &= ~same;
        }
        return true;
    }

private:
    TileLanes rest_;
    TileLanes negative_[3], dominant_[3];
};

/// The planes of sixteen boxes as a beam sees them: from its apex, along its rays, padded.
struct alignas(64) SeenBoxes {
    float enter[3][kPacketSize], leave[3][kPacketSize];
};

/// The rays of a tile as bits: lane i of packet v is bit 16 v + i.
inline uint32_t raysOf(uint64_t rays, int v) { return uint32_t(rays >> 16 * v) & 0xffffu; }
inline uint32_t packetsOf(uint64_t rays) {
    return uint32_t((rays & 0xffffu) != 0) | uint32_t((rays & 0xffff0000u) != 0) << 1 |
           uint32_t((rays & 0xffffull << 32) != 0) << 2 | uint32_t(rays >> 48 != 0) << 3;
}

/// Rays of one group of a tile. A ray is the line that is at apex + z * (x and y slope) for each z,
/// the coordinate along the dominant axis; depth w is |z|, and counts from the apex on.
///
/// The lines of rays that head for the apex pass it by as much as origin and direction round;
/// `stray` says how far, across the dominant axis. Boxes are padded by that, and by 16 u S for the
/// rounding here and in the triangle test, where u = 2^-24 and S is the largest coordinate: the
/// planes are off by 2 u S here, the slopes by 2 u, their inverses by 2.1 u and the product by u,
/// of a distance of up to 2 S; the triangle test is off by 3 u S.
class Beam {
public:
    static constexpr int N = kPacketSize;

    /// maxAbs: the largest coordinate of what the beam may meet.
    Beam(float maxAbs, const RayTile& tile, const TileLanes& lanes, const RayGroup& group)
        : axis_{(group.dominantAxis + 1) % 3, (group.dominantAxis + 2) % 3, group.dominantAxis} {
        for (int k = 0; k < 3; ++k) {
            apex_[k] = tile.apex[axis_[k]];
            sign_[k] = group.negative[axis_[k]] == tile.startsThere ? -1.0f : 1.0f;
        }
        int some = 0;
        for (int v = 0; v < kTileVectors; ++v) {
            if (!lanes.of[v]) continue;
            addPacket(tile.rays[v], lanes.of[v], v);
            some = v;
        }
        for (int v = 0; v < kTileVectors; ++v) {
            if (lanes.of[v]) continue;
            for (int k = 0; k < 2; ++k) {
                slope_[k][v] = slope_[k][some];
                inverse_[k][v] = inverse_[k][some];
            }
        }
        span();
        stray(tile, lanes);
        widest_ = maxAbs * 0x1p-8f;
        scale_ = largerOf(maxAbs, reach_);
        for (int k = 0; k < 3; ++k) scale_ = largerOf(scale_, __builtin_fabsf(apex_[k]));
        pad_ = scale_ * 0x1p-20f + stray_;
        for (int k = 0; k < 3; ++k) {
            enterApex_[k] = apex_[k] + sign_[k] * pad_;
            leaveApex_[k] = apex_[k] - sign_[k] * pad_;
        }
    }

    /// Whether the rays are near enough together, and to their apex, to gain by being one beam, the
    /// apex is so near to what they meet that padding leaves boxes apart, all numbers are so far
    /// from over- and underflow that its bounds hold, and no ray goes beyond its apex.
    bool isNarrow() const {
        return half_[0] <= 0.15f && half_[1] <= 0.15f && scale_ <= 0x1p38f &&
               scale_ >= 0x1p-40f &&
               stray_ <= scale_ * 0x1p-14f && pad_ <= widest_ && overshoot_ <= pad_;
    }

    int axis(int k) const { return axis_[k]; }    ///< of the model: x, y, z
    float apex(int k) const { return apex_[k]; }
    float depthSign() const { return sign_[2]; }  ///< of z
    float centre(int k) const { return centre_[k]; }
    float half(int k) const { return half_[k]; }  ///< of all slopes about the centre
    /// Slopes less the centre's; of lanes and packets that are off, those of some other.
    const Real<N>& slope(int k, int v) const { return slope_[k][v]; }
    /// Slopes of packet v less the centre's: their middle, and the largest half width of all.
    float packetCentre(int k, int v) const { return packetCentre_[k][v]; }
    float packetHalf(int k) const { return packetHalf_[k]; }
    const Real<N>& depthScale(int v) const { return depthScale_[v]; } ///< |z| a unit of t
    const Real<N>& originDepth(int v) const { return originDepth_[v]; }
    float stray() const { return stray_; }
    float reach() const { return reach_; } ///< largest coordinate of an origin as the apex sees it
    float scale() const { return scale_; }
    float pad() const { return pad_; } ///< by which boxes are widened

    HWY_INLINE void see(const WideNode& node, SeenBoxes& seen) const {
        for (int k = 0; k < 3; ++k) {
            const int axis = axis_[k];
            const float* const first = sign_[k] < 0 ? node.hi[axis] : node.lo[axis];
            const float* const last = sign_[k] < 0 ? node.lo[axis] : node.hi[axis];
            const Real<N> sign(sign_[k]);
            ((Real<N>::load(first) - Real<N>(enterApex_[k])) * sign).store(seen.enter[k]);
            ((Real<N>::load(last) - Real<N>(leaveApex_[k])) * sign).store(seen.leave[k]);
        }
    }

    /// Which of sixteen boxes rays between depth `near` and `far` may meet, and from what depth on.
    HWY_INLINE Mask<N> meet(const SeenBoxes& seen, float near, float far, Real<N>& from) const {
        from = max(Real<N>(near), Real<N>::load(seen.enter[2]));
        Real<N> to = min(Real<N>(far), Real<N>::load(seen.leave[2]));
        for (int k = 0; k < 2; ++k) {
            from = max(from, Real<N>::load(seen.enter[k]) * Real<N>(steepest_[k]));
            to = min(to, Real<N>::load(seen.leave[k]) * Real<N>(flattest_[k]));
        }
        return from <= to;
    }

    /// Whether rays may meet any of a node's boxes, however far away.
    bool mayMeet(const WideNode& node) const {
        SeenBoxes seen;
        see(node, seen);
        Real<N> from;
        return any(meet(seen, 0.0f, __builtin_inff(), from));
    }

    /// Which rays of packet v meet one of the boxes between their depths `near` and `far`.
    HWY_INLINE Mask<N> meet(const SeenBoxes& seen, int box, int v, const Real<N>& near,
                            const Real<N>& far) const {
        Real<N> from = max(near, Real<N>(seen.enter[2][box]));
        Real<N> to = min(far, Real<N>(seen.leave[2][box]));
        for (int k = 0; k < 2; ++k) {
            from = max(from, Real<N>(seen.enter[k][box]) * inverse_[k][v]);
            to = min(to, Real<N>(seen.leave[k][box]) * inverse_[k][v]);
        }
        return from <= to;
    }

private:
    void addPacket(const LocalRays<N>& rays, uint32_t lanes, int v) {
        const Mask<N> on = Mask<N>::fromBits(lanes);
        const int some = lowestBit(lanes);
        const Real<N> z = Real<N>::load(rays.dir[axis_[2]]);
        const Real<N> inverse = Real<N>(1.0f) / z;
        depthScale_[v] = magnitude(z);
        for (int k = 0; k < 2; ++k) {
            const Real<N> slope = Real<N>::load(rays.dir[axis_[k]]) * inverse;
            slope_[k][v] = slope;
            if (lanes != (1u << N) - 1u)
                slope_[k][v] = select(
                    on, slope, Real<N>(rays.dir[axis_[k]][some] / rays.dir[axis_[2]][some]));
            inverse_[k][v] = reciprocal(max(magnitude(slope), Real<N>(0x1p-100f)));
        }
    }

    /// What the packets' slopes span together.
    void span() {
        for (int k = 0; k < 2; ++k) {
            Real<N> negative[kTileVectors];
            for (int v = 0; v < kTileVectors; ++v) negative[v] = Real<N>(0.0f) - slope_[k][v];
            float least[kTileVectors], most[kTileVectors]; // the latter times -1
            smallestLanes(slope_[k], least);
            smallestLanes(negative, most);
            const float low = lesserOf(lesserOf(least[0], least[1]), lesserOf(least[2], least[3]));
            const float high = -lesserOf(lesserOf(most[0], most[1]), lesserOf(most[2], most[3]));
            centre_[k] = 0.5f * (low + high);
            half_[k] = largerOf(high - centre_[k], centre_[k] - low) * (1 + 0x1p-20f) + 0x1p-40f;
            float widest[kTileVectors];
            for (int v = 0; v < kTileVectors; ++v) {
                const float middle = 0.5f * (least[v] - most[v]);
                widest[v] = largerOf(-most[v] - middle, middle - least[v]);
                packetCentre_[k][v] = middle - centre_[k];
                slope_[k][v] = slope_[k][v] - Real<N>(centre_[k]);
            }
            packetHalf_[k] =
                largerOf(largerOf(widest[0], widest[1]), largerOf(widest[2], widest[3])) *
                    (1 + 0x1p-20f) +
                0x1p-22f * half_[k];
            // The slopes of a group have one sign.
            const float a = __builtin_fabsf(low), b = __builtin_fabsf(high);
            steepest_[k] = (1 - 0x1p-20f) / largerOf(largerOf(a, b), 0x1p-100f);
            flattest_[k] = (1 + 0x1p-20f) / largerOf(lesserOf(a, b), 0x1p-100f);
        }
    }

    void stray(const RayTile& tile, const TileLanes& lanes) {
        Real<N> stray(0.0f), reach(0.0f), overshoot(0.0f);
        for (int v = 0; v < kTileVectors; ++v) {
            originDepth_[v] = Real<N>(0.0f);
            if (tile.startsThere || !lanes.of[v]) continue;
            const Mask<N> on = Mask<N>::fromBits(lanes.of[v]);
            const Real<N> z =
                Real<N>::load(tile.rays[v].org[axis_[2]]) - Real<N>(apex_[2]);
            originDepth_[v] = z * Real<N>(sign_[2]);
            const Real<N> length = Real<N>::load(tile.last[v]) * depthScale_[v];
            overshoot = select(on, max(overshoot, length - originDepth_[v]), overshoot);
            reach = select(on, max(reach, magnitude(z)), reach);
            for (int k = 0; k < 2; ++k) {
                const Real<N> x =
                    Real<N>::load(tile.rays[v].org[axis_[k]]) - Real<N>(apex_[k]);
                const Real<N> missed =
                    magnitude(x - (slope_[k][v] + Real<N>(centre_[k])) * z);
                stray = select(on, max(stray, missed), stray);
                reach = select(on, max(reach, magnitude(x)), reach);
            }
        }
        if (tile.startsThere) return;
        reach_ = largestLane(reach);
        stray_ = largestLane(stray) + 0x1p-21f * reach_;
        overshoot_ = largestLane(overshoot);
    }

    int axis_[3];
    float apex_[3], sign_[3], enterApex_[3], leaveApex_[3];
    float centre_[2], half_[2], packetHalf_[2], steepest_[2], flattest_[2];
    float packetCentre_[2][kTileVectors];
    float stray_ = 0, reach_ = 0, overshoot_ = 0, scale_, pad_, widest_;
    Real<N> slope_[2][kTileVectors], inverse_[2][kTileVectors];
    Real<N> depthScale_[kTileVectors], originDepth_[kTileVectors];
};

} // namespace smart::SMART_ISA

// SPDX-License-Identifier: MIT
// Traversal of a tree of wide nodes by a tile of 64 rays: sixteen child boxes at once against the
// beam, the boxes that are left against the rays, sixteen at once; in leaves sixteen triangles at
// once against the packets, and what is left against the rays.
//
// Nothing is decided here that the single ray would decide otherwise: boxes and triangles are only
// dropped where bounds of all roundings allow it, a hit is only taken over where they prove that
// the exact test takes it and float distances order it; the exact test does the rest.
#pragma once

#include "libsmart/kernel/edge_functions.h"
#include "libsmart/kernel/intersect.h"
#include "libsmart/kernel/wide_traversal.h"

namespace smart::SMART_ISA {

/// Built in place when it is first needed.
template <class T>
class Lazy {
public:
    template <class Make>
    HWY_INLINE T& get(const Make& make) {
        if (!made_) {
            new (memory_) T(make());
            made_ = true;
        }
        return *reinterpret_cast<T*>(memory_);
    }

private:
    bool made_ = false;
    alignas(T) unsigned char memory_[sizeof(T)];
};

/// One model's own triangles, one beam.
template <template <int> class Precision, HitMode M>
class TileTraversal {
public:
    static constexpr int N = kPacketSize;
    using Query = Search<N, M, NoCounts>;
    /// Whether linear functions may decide: they know what the watertight test would say.
    static constexpr bool kDecides = std::is_same_v<Precision<N>, Watertight<N>>;

    TileTraversal(const ModelView& model, const RayTile& tile, const Beam& beam,
                  const RayGroup& group, const TileLanes& lanes, Query* query)
        : model_(model), tile_(tile), beam_(beam), group_(group), lanes_(lanes), query_(query) {
        slack_ = 0;
        if (!tile.startsThere) slack_ = 16 * 0x1p-24f * beam.reach() + 5 * beam.stray();
        // Records of the fast mode are off by some units in the last place of the coordinates.
        if (!kDecides) slack_ = slack_ + 160 * 0x1p-24f * beam.scale();
        for (int v = 0; v < kTileVectors; ++v)
            if (lanes.of[v]) {
                start(v);
            } else {
                near_[v] = farDepth_[v] = Real<N>(-__builtin_inff());
                low_[v] = Real<N>(__builtin_inff());
            }
        updateLimits();
    }

    void run() {
        if constexpr (M == HitMode::Any)
            traverseWideUnordered(model_.wide.nodes, beam_, *this);
        else
            traverseWide(model_.wide.nodes, beam_, *this);
    }

    /// Brings the queries up to date. exactly: also the distances of the hits, for models to come.
    void finish(bool exactly) {
        if constexpr (M == HitMode::Closest) {
            for (int v = 0; v < kTileVectors; ++v) {
                if (!unsettled_[v]) continue;
                if (exactly)
                    settle(v, unsettled_[v]);
                else
                    name(v, unsettled_[v]);
            }
        }
    }

    // What traverseWide asks.
    uint32_t packets() const { return packets_; }
    HWY_INLINE uint64_t looking(float near) const {
        uint64_t rays = 0;
        for (int v = 0; v < kTileVectors; ++v) {
            const uint32_t lanes = M == HitMode::Any ? lanes_.of[v] & ~query_[v].blocked
                                                     : (farDepth_[v] >= Real<N>(near)).bits();
            rays |= uint64_t(lanes) << 16 * v;
        }
        return rays;
    }
    float farthestDepth() const { return far_; }
    const Real<N>& nearDepth(int v) const { return near_[v]; }
    const Real<N>& farDepth(int v) const { return farDepth_[v]; }
    HWY_INLINE void prefetch(uint32_t child) const {
        // By address, as no predictor learns which children are leaves.
        const char* const starts[2] = {reinterpret_cast<const char*>(model_.wide.nodes),
                                       reinterpret_cast<const char*>(model_.wide.blocks)};
        constexpr std::size_t kStride[2] = {sizeof(WideNode), sizeof(float) * kWordsOfTriangle};
        const uint32_t leaf = child >> 31;
        const char* const next =
            starts[leaf] + kStride[leaf] * ((child & ~kWideLeaf) >> 4 * leaf);
        for (int line = 0; line < 7; ++line) __builtin_prefetch(next + 64 * line);
    }

    bool waits() const { return leaves_.count() > 0; }
    bool joins(uint32_t child) const { return child & kWideLeaf && leaves_.hasRoomFor(child); }
    HWY_INLINE void leaf(uint32_t child, uint64_t rays) {
        Mask<N> of[kTileVectors];
        for (int v = 0; v < kTileVectors; ++v) of[v] = Mask<N>::fromBits(raysOf(rays, v));
        leaves_.add(model_.wide.blocks, child, packetsOf(rays), of);
    }
    HWY_INLINE void goThrough() {
        testLeaves();
        leaves_.clear();
    }

private:
    /// The triangles of the leaves that wait, against their rays.
    HWY_INLINE void testLeaves() {
        EdgeFunctions edges;
        uint64_t pairs = edges.setUp(beam_, leaves_, farthest_, slack_);
        if (!pairs) return;
        bool changed = false;
        Undecided later;
        for (; pairs; pairs &= pairs - 1) {
            const int pair = __builtin_ctzll(pairs);
            const int v = pair >> 4, i = pair & 15;
            const Real<N> x = beam_.slope(0, v), y = beam_.slope(1, v);
            const auto edge = [&](int e) {
                return Real<N>(edges.z[e][i]) + Real<N>(edges.x[e][i]) * x +
                       Real<N>(edges.y[e][i]) * y;
            };
            const Real<N> lowest = min(min(edge(0), edge(1)), edge(2));
            const Real<N> inverse = edges.inverseDepth(i, x, y);
            const Real<N> upper = inverse * Real<N>(edges.nearer[i]);
            const Mask<N> possible =
                leaves_.rays(v) & (lowest >= Real<N>(-edges.bound[i])) & (upper >= low_[v]);
            if constexpr (kDecides) {
                const Real<N> lower = inverse * Real<N>(edges.farther[i]);
                const Mask<N> sure = possible & (lowest >= Real<N>(edges.sure[i])) &
                                     (lower >= high_[v]) & (upper <= inverseLimit_[v]);
                const uint32_t taken = sure.bits(), open = possible.bits() & ~taken;
                changed |= taken != 0;
                if constexpr (M == HitMode::Any)
                    query_[v].blocked |= taken;
                else
                    take(v, taken, sure, lower, upper, leaves_.number(i));
                later.add(pair, open);
            } else {
                const uint32_t open = possible.bits();
                if (open) changed |= decide(i, v, open);
            }
        }
        for (uint32_t n = 0; n < later.count; ++n) {
            const int v = later.pair[n] >> 4, i = later.pair[n] & 15;
            uint32_t open = later.lanes[n];
            if constexpr (M == HitMode::Any) {
                open &= ~query_[v].blocked;
                if (open && edges.sure[i] < __builtin_inff()) open = ahead(i, v, open);
            } else {
                const Real<N> upper =
                    edges.inverseDepth(i, beam_.slope(0, v), beam_.slope(1, v)) *
                    Real<N>(edges.nearer[i]);
                open &= (upper >= low_[v]).bits();
            }
            if (open) changed |= decide(i, v, open);
        }
        if (changed) updateLimits();
    }

    /// What linear functions leave open, pairs of a packet and a triangle as EdgeFunctions has
    /// them. What is sure comes first: it settles some of the rest, and no pair waits for a branch
    /// on the one before.
    struct Undecided {
        uint32_t count = 0;
        int pair[kTileVectors * N];
        uint32_t lanes[kTileVectors * N];

        void add(int which, uint32_t open) {
            pair[count] = which;
            lanes[count] = open;
            count += open != 0;
        }
    };

    /// Near and far depth of the rays of a packet.
    HWY_INLINE void start(int v) {
        const Mask<N> on = Mask<N>::fromBits(lanes_.of[v]);
        const DepthRange range(tile_, beam_, v, Real<N>::load(query_[v].tNear),
                               Real<N>::load(query_[v].best));
        // Where doubt about distances begins: see Watertight.
        const Real<N> doubtful(beam_.scale() * 0x1p-9f);
        const Real<N> surelyFrom =
            tile_.startsThere ? max(range.from, doubtful) : range.from + Real<N>(4 * beam_.pad());
        near_[v] = range.from;
        const Real<N> slip(tile_.startsThere ? 0.0f : 4 * beam_.pad());
        low_[v] = select(on, inverse(range.limit + slip) * Real<N>(1 - 0x1p-18f),
                         Real<N>(__builtin_inff()));
        high_[v] = inverse(range.limit - slip) * Real<N>(1 + 0x1p-18f);
        inverseLimit_[v] = roughInverse(surelyFrom * Real<N>(1 + 0x1p-8f));
        farDepth_[v] = select(on, range.to, Real<N>(-__builtin_inff()));
        if (any(on & (range.from <= range.to))) packets_ |= 1u << v;
    }
    static Real<N> bounded(const Real<N>& a) {
        return min(max(a, Real<N>(0x1p-100f)), Real<N>(0x1p100f));
    }
    /// 1/a for a from 0 to infinity, off by less than 2^-13 of it, and by less than 2^-22.
    static Real<N> roughInverse(const Real<N>& a) { return roughReciprocal(bounded(a)); }
    static Real<N> inverse(const Real<N>& a) { return reciprocal(bounded(a)); }

    /// After hits: how far the rays still have to look. All packets alike: to ask which have
    /// changed costs more.
    HWY_INLINE void updateLimits() {
        Real<N> far(-__builtin_inff());
        for (int v = 0; v < kTileVectors; ++v) {
            if constexpr (M == HitMode::Closest)
                farDepth_[v] =
                    min(farDepth_[v], roughInverse(low_[v]) * Real<N>(1 + 0x1p-12f));
            else
                dropBlocked(v);
            far = max(far, farDepth_[v]);
        }
        smallestLanes(low_, farthest_);
        far_ = largestLane(far);
    }

    /// Rays of packet v hit a triangle, nearer than all else so far.
    HWY_INLINE void take(int v, uint32_t lanes, const Mask<N>& mask, const Real<N>& lower,
                         const Real<N>& upper, uint32_t triangle) {
        low_[v] = select(mask, lower, low_[v]);
        high_[v] = select(mask, upper, high_[v]);
        found_[v] = select(mask, Word<N>(triangle), found_[v]);
        unsettled_[v] |= lanes;
        // For the refinement; if nothing is taken, something that is near anyway. By arithmetic,
        // as no predictor learns the branch.
        const uint32_t fetched = triangle & (0u - uint32_t(lanes != 0));
        const char* const hit = reinterpret_cast<const char*>(model_.triangles + fetched);
        __builtin_prefetch(hit);
        __builtin_prefetch(hit + sizeof(Triangle) - 1);
    }
    /// HitMode::Any: rays that met something look for nothing more.
    HWY_INLINE void dropBlocked(int v) {
        const uint32_t blocked = query_[v].blocked;
        const Mask<N> done = Mask<N>::fromBits(blocked);
        low_[v] = select(done, Real<N>(__builtin_inff()), low_[v]);
        farDepth_[v] = select(done, Real<N>(-__builtin_inff()), farDepth_[v]);
        packets_ &= ~(uint32_t(!(lanes_.of[v] & ~blocked)) << v);
    }

    /// Of the given rays of packet v, those that do not start behind the plane of triangle i: the
    /// exact test would find the same in double. Most of what a shadow ray has left is the surface
    /// that it starts on.
    [[gnu::noinline]] uint32_t ahead(int i, int v, uint32_t lanes) const {
        Triangle triangle;
        leaves_.load(i, triangle);
        double e1[3], e2[3], n[3];
        for (int k = 0; k < 3; ++k) {
            e1[k] = double(triangle.v1[k]) - triangle.v0[k];
            e2[k] = double(triangle.v2[k]) - triangle.v0[k];
        }
        for (int k = 0; k < 3; ++k) {
            const int a = (k + 1) % 3, b = (k + 2) % 3;
            n[k] = e1[a] * e2[b] - e1[b] * e2[a];
        }
        const hn::CappedTag<double, 8> real;
        const hn::Rebind<float, decltype(real)> narrow;
        const LocalRays<N>& rays = tile_.rays[v];
        uint32_t behind = 0;
        for (int first = 0; first < N; first += int(hn::Lanes(real))) {
            auto depth = hn::Zero(real), slope = hn::Zero(real);
            for (int k = 0; k < 3; ++k) {
                const auto normal = hn::Set(real, n[k]);
                const auto org = hn::PromoteTo(real, hn::Load(narrow, rays.org[k] + first));
                const auto dir = hn::PromoteTo(real, hn::Load(narrow, rays.dir[k] + first));
                const auto towards = hn::Sub(hn::Set(real, triangle.v0[k]), org);
                depth = hn::Add(depth, hn::Mul(towards, normal));
                slope = hn::Add(slope, hn::Mul(dir, normal));
            }
            // A distance that float could round to zero stays.
            const auto least = hn::Mul(hn::Mul(slope, slope), hn::Set(real, -0x1p-100));
            uint64_t bits = 0;
            hn::StoreMaskBits(real, hn::Lt(hn::Mul(depth, slope), least),
                              reinterpret_cast<uint8_t*>(&bits));
            behind |= uint32_t(bits) << first;
        }
        return lanes & ~behind;
    }

    /// The exact test of triangle i of the leaves by the given rays of packet v; whether it changed
    /// anything.
    [[gnu::noinline]] bool decide(int i, int v, uint32_t lanes) {
        Query& query = query_[v];
        if (M == HitMode::Closest && (unsettled_[v] & lanes)) settle(v, unsettled_[v] & lanes);
        const Precision<N>& precision = exact(v);
        const uint32_t prim = leaves_.number(i);
        Real<N> t, best = Real<N>::load(query.best);
        Mask<N> hit;
        if constexpr (kDecides) {
            Triangle triangle;
            leaves_.load(i, triangle);
            hit = precision.meet(triangle, Mask<N>::fromBits(lanes), t);
            if (!any(hit)) return false;
            hit = precision.comparable(prim, hit, t, best, query);
        } else {
            hit = precision.meet(prim, Mask<N>::fromBits(lanes), t);
        }
        hit = hit & (t >= Real<N>::load(query.tNear)) & (t <= best);
        if constexpr (M == HitMode::Any) {
            if (!any(hit)) return false;
            query.blocked |= hit.bits();
        } else {
            best = query.accept(hit, t, best, prim);
            best.store(query.best);
            // In double, `comparable` may have found a nearer one by itself.
            const Mask<N> tested = Mask<N>::fromBits(lanes);
            const Real<N> found = roughInverse(best * beam_.depthScale(v));
            low_[v] = select(tested, found * Real<N>(1 - 0x1p-9f), low_[v]);
            high_[v] = select(tested, found * Real<N>(1 + 0x1p-9f), high_[v]);
        }
        return true;
    }

    HWY_INLINE const Precision<N>& exact(int v) {
        return exact_[v].get([&] {
            RayGroup group = group_;
            group.lanes = lanes_.of[v];
            return Precision<N>(model_, tile_.rays[v], group);
        });
    }

    /// Writes the names of hits that linear functions found.
    void name(int v, uint32_t lanes) {
        Query& query = query_[v];
        unsettled_[v] &= ~lanes;
        query.keepTriangle(Mask<N>::fromBits(lanes), found_[v]);
    }

    /// Also finds the distances that the exact test gives them.
    [[gnu::noinline]] void settle(int v, uint32_t lanes) {
        name(v, lanes);
        Query& query = query_[v];
        const Precision<N>& precision = exact(v);
        for (; lanes; lanes &= lanes - 1) {
            const int i = lowestBit(lanes);
            Real<N> t;
            precision.meet(query.triangle[i], Mask<N>::fromBits(1u << i), t);
            alignas(64) float distances[N];
            t.store(distances);
            query.best[i] = distances[i];
        }
    }

    const ModelView& model_;
    const RayTile& tile_;
    const Beam& beam_;
    const RayGroup& group_;
    const TileLanes& lanes_;
    Query* const query_;
    LeafGroup leaves_; ///< that wait
    float slack_, far_;
    uint32_t packets_ = 0; ///< with rays that still look for something
    Real<N> near_[kTileVectors], farDepth_[kTileVectors]; ///< depths; none for lanes that are off
    Real<N> low_[kTileVectors], high_[kTileVectors]; ///< bounds of 1/depth of the best hit
    Real<N> inverseLimit_[kTileVectors]; ///< 1/depth from where on float knows a hit to be in range
    Word<N> found_[kTileVectors];        ///< triangles, for unsettled lanes
    uint32_t unsettled_[kTileVectors] = {};
    float farthest_[kTileVectors];
    Lazy<Precision<N>> exact_[kTileVectors];
};

} // namespace smart::SMART_ISA

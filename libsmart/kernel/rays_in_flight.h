// SPDX-License-Identifier: MIT
// Rays that have nothing in common, many at a time: each goes down the wide tree alone, with a
// stack of its own, but they take turns, a node or a leaf each, so that one ray's wait for memory
// and for its own results is filled by the others. Which kind of turn comes next can not be
// predicted, hence rays wait in lists of those before a node and those before a leaf, and joining a
// list takes no branch.
//
// Fuetterling, Lojewski, Pfreundt, Hamann, Ebert, "Accelerated single ray tracing for wide vector
// units", HPG 2017, for compressing the boxes that were met onto the stack.
#pragma once

#include "libsmart/kernel/scene_traversal.h"

namespace smart::SMART_ISA {

/// The rays of a packet, whatever their directions, against one box after the other.
class MixedPacket {
public:
    static constexpr int N = kPacketSize;

    MixedPacket(const BoxView& box, const LocalRays<N>& rays, float padding) {
        const Real<N> zero(0.0f);
        Real<N> scale(box.maxAbs), size[3];
        for (int k = 0; k < 3; ++k) scale = max(scale, magnitude(Real<N>::load(rays.org[k])));
        const Real<N> pad = scale * Real<N>(padding);
        pad_ = pad;
        for (int k = 0; k < 3; ++k) {
            const Real<N> dir = Real<N>::load(rays.dir[k]), org = Real<N>::load(rays.org[k]);
            size[k] = magnitude(dir);
            negative_[k] = dir < zero;
            reciprocal_[k] = boundedReciprocal(dir);
            enterOrg_[k] = select(negative_[k], org - pad, org + pad);
            leaveOrg_[k] = select(negative_[k], org + pad, org - pad);
        }
        const Mask<N> x = (size[0] >= size[1]) & (size[0] >= size[2]);
        axis1_ = andNot(size[1] >= size[2], x).bits();
        axis2_ = ~(x.bits() | axis1_);
        slack_ = (Real<N>(box.maxAbs) + scale) * Real<N>(0x1p-15f) /
                 max(max(size[0], size[1]), size[2]);
        slack_ = min(slack_, Real<N>(0x1p126f));
        const Mask<N> first = x, second = Mask<N>::fromBits(axis1_);
        Real<N> d[3];
        for (int k = 0; k < 3; ++k) d[k] = Real<N>::load(rays.dir[k]);
        const Real<N> z = select(first, d[0], select(second, d[1], d[2]));
        (Real<N>(1.0f) / z).store(lanes_.slopes[2]);
        (select(first, d[1], select(second, d[2], d[0])) / z).store(lanes_.slopes[0]);
        (select(first, d[2], select(second, d[0], d[1])) / z).store(lanes_.slopes[1]);
        for (int k = 0; k < 3; ++k) {
            negativeBits_[k] = negative_[k].bits();
            reciprocal_[k].store(lanes_.reciprocal[k]);
            enterOrg_[k].store(lanes_.enterOrg[k]);
            leaveOrg_[k].store(lanes_.leaveOrg[k]);
        }
    }

    HWY_INLINE Mask<N> meet(const WideNode& node, uint32_t slot, const Real<N>& near,
                            const Real<N>& far, Real<N>& from) const {
        Real<N> to = far;
        from = near;
        for (int k = 0; k < 3; ++k) {
            const Real<N> lo(node.lo[k][slot]), hi(node.hi[k][slot]);
            const Real<N> first = select(negative_[k], hi, lo);
            const Real<N> last = select(negative_[k], lo, hi);
            from = max(from, (first - enterOrg_[k]) * reciprocal_[k]);
            to = min(to, (last - leaveOrg_[k]) * reciprocal_[k]);
        }
        return from <= to;
    }

    /// One lane of it.
    void take(int lane, RayGroup& group, TreeRays<1>& ray, RaySlopes& slopes) const {
        slopes = {lanes_.slopes[0][lane], lanes_.slopes[1][lane], lanes_.slopes[2][lane]};
        group.lanes = 1;
        group.dominantAxis = int((axis1_ >> lane & 1) + 2 * (axis2_ >> lane & 1));
        for (int k = 0; k < 3; ++k) {
            group.negative[k] = (negativeBits_[k] >> lane & 1) != 0;
            ray.reciprocal[k].v = lanes_.reciprocal[k][lane];
            ray.enterOrg[k].v = lanes_.enterOrg[k][lane];
            ray.leaveOrg[k].v = lanes_.leaveOrg[k][lane];
        }
    }

    /// See Horizon.
    const Real<N>& slack() const { return slack_; }

    /// Bounds of what the rays given can meet between 0 and `far`.
    void bound(const LocalRays<N>& rays, const Real<N>& far, uint32_t lanes, float* lo,
               float* hi) const {
        const Mask<N> on = Mask<N>::fromBits(lanes);
        const Real<N> zero(0.0f), inf(__builtin_inff()), none(-__builtin_inff());
        for (int k = 0; k < 3; ++k) {
            const Real<N> org = Real<N>::load(rays.org[k]), dir = Real<N>::load(rays.dir[k]);
            const Real<N> end = org + dir * far;
            const Real<N> slip = magnitude(end) * Real<N>(0x1p-20f);
            const Real<N> first = select(negative_[k], end - slip, org);
            const Real<N> last = select(dir > zero, end + slip, org);
            lo[k] = smallestLane(select(on, first - pad_, inf));
            hi[k] = largestLane(select(on, last + pad_, none));
        }
    }

private:
    Real<N> slack_, pad_;
    Real<N> reciprocal_[3], enterOrg_[3], leaveOrg_[3];
    Mask<N> negative_[3];
    uint32_t negativeBits_[3], axis1_, axis2_;
    struct alignas(64) {
        float reciprocal[3][N], enterOrg[3][N], leaveOrg[3][N], slopes[3][N];
    } lanes_;
};

/// Rays of one packet in a model's space, with their queries' limits.
struct alignas(64) FlightPacket {
    LocalRays<kPacketSize> rays;
    alignas(64) float near[kPacketSize], far[kPacketSize];
    uint32_t lanes; ///< those that carry a ray
};

/// Source: bool next(FlightPacket&, uint32_t& name), which gives a packet and its name, or none
/// any more; void open(name, lane, Search<1>&), which fills in what a query knows besides its
/// limits; void done(name, lane, const Search<1>&).
template <template <int> class Precision, HitMode M, class Source>
class RaysInFlight {
public:
    static constexpr int N = kPacketSize;
    using Query = Search<1, M, NoCounts>;

    RaysInFlight(const ModelView& model, Source& source) : model_(model), source_(source) {}

    void run() {
        for (uint32_t i = 0; i < kRays; ++i) idle_[i] = i;
        idleCount_ = kRays;
        bool more = true;
        while (true) {
            while (more && idleCount_ >= uint32_t(N)) more = launch();
            if (nodeCount_ + leafCount_ == 0) return;
            const uint32_t idle = idleCount_;
            // Nodes first: what comes out of them are mostly leaves, which fill the other list.
            turns(before_[0], nodeCount_, [&](Flight& flight) HWY_ATTR { node(flight); });
            turns(before_[1], leafCount_, [&](Flight& flight) HWY_ATTR { leaf(flight); });
            finish(idle);
        }
    }

private:
    static constexpr uint32_t kRays = 48;
    /// So many rays of a packet go on together; so many nodes they open, at most.
    static constexpr int kTogether = 8, kTogetherNodes = 24;
    static constexpr uint32_t kNothing = 0xFFFFFFFFu; ///< at the bottom of each stack
    /// What a packet leaves behind, what a ray alone pushes, and a whole group written from there
    /// on. The odd size keeps stacks out of each other's sets in the cache.
    static constexpr int kStack = kTogetherNodes * kWideChildren + kWideMaxDepth * kWideChildren +
                                  kPacketSize + 48;
    using Traversal = SceneTraversal<Precision, 1, M, NoCounts>;

    struct Flight {
        LocalRays<1> ray;
        Query query;
        RayGroup group;
        TreeRays<1> tree{group};
        alignas(64) unsigned char precision[sizeof(Precision<1>)];
        Real<1> slack;
        Real<1> best;
        float far;
        uint32_t packet;
        int lane;
        int top; ///< the place of the next to visit
        float from[kStack];
        uint32_t child[kStack];

        Flight() {}
        const Precision<1>& test() const {
            return *reinterpret_cast<const Precision<1>*>(precision);
        }
    };

    /// Gives the rays of a packet to idle flights.
    [[gnu::noinline]] bool launch() {
        FlightPacket packet;
        uint32_t name;
        if (!source_.next(packet, name)) return false;
        if (!packet.lanes) return true;
        const WideView& tree = model_.wide;
        const MixedPacket mixed(tree, packet.rays, Traversal::kPadding);
        alignas(64) float slack[N];
        mixed.slack().store(slack);
        Flight* flights[N];
        for (uint32_t rest = packet.lanes; rest; rest &= rest - 1) {
            const int lane = lowestBit(rest);
            Flight& flight = flights_[idle_[--idleCount_]];
            flights[lane] = &flight;
            takeLane(packet.rays, lane, flight.ray);
            RaySlopes slopes;
            mixed.take(lane, flight.group, flight.tree, slopes);
            new (flight.precision) Precision<1>(model_, flight.ray, flight.group,
                                                Shear<1>(flight.ray, flight.group, slopes));
            flight.query.tNear[0] = packet.near[lane];
            flight.query.best[0] = packet.far[lane];
            flight.best = Real<1>(packet.far[lane]);
            flight.packet = name;
            flight.lane = lane;
            source_.open(name, lane, flight.query);
            flight.slack = Real<1>(slack[lane]);
            flight.far = (flight.best + flight.slack).v;
            packet.far[lane] = flight.far;
            flight.from[0] = -__builtin_inff();
            flight.child[0] = kNothing;
            flight.top = 0;
        }
        const uint32_t idle = idleCount_;
        together(packet, mixed, flights);
        for (uint32_t rest = packet.lanes; rest; rest &= rest - 1) {
            Flight& flight = *flights[lowestBit(rest)];
            if (M == HitMode::Closest) raiseNearest(flight);
            join(uint32_t(&flight - flights_));
        }
        finish(idle);
        return true;
    }

    /// The rays that have joined the idle ones since there were so many.
    void finish(uint32_t before) {
        for (; before < idleCount_; ++before) {
            Flight& flight = flights_[idle_[before]];
            flight.query.best[0] = flight.best.v;
            source_.done(flight.packet, flight.lane, flight.query);
        }
    }

    /// Opens nodes for all rays of a packet while enough of them meet each; what is left goes onto
    /// the rays' own stacks.
    void together(const FlightPacket& packet, const MixedPacket& mixed, Flight* const* flights) {
        struct Entry {
            uint32_t child, lanes;
        };
        Entry stack[kTogetherNodes * kWideChildren];
        int top = 0, opened = 0;
        const auto give = [&](uint32_t child, uint32_t lanes, const float* from) {
            for (; lanes; lanes &= lanes - 1) {
                const int lane = lowestBit(lanes);
                Flight& flight = *flights[lane];
                ++flight.top;
                flight.from[flight.top] = from[lane];
                flight.child[flight.top] = child;
            }
        };
        stack[top++] = {0, packet.lanes};
        const Real<N> near = Real<N>::load(packet.near), far = Real<N>::load(packet.far);
        alignas(64) float from[N];
        float lo[3], hi[3];
        mixed.bound(packet.rays, far, packet.lanes, lo, hi);
        while (top > 0) {
            const Entry entry = stack[--top];
            if (opened == kTogetherNodes || __builtin_popcount(entry.lanes) < kTogether) {
                give(entry.child, entry.lanes, packet.near);
                continue;
            }
            ++opened;
            const WideNode& node = model_.wide.nodes[entry.child];
            Mask<N> inReach = Real<N>::load(node.lo[0]) <= Real<N>::load(node.hi[0]);
            for (int k = 0; k < 3; ++k)
                inReach = inReach & (Real<N>::load(node.lo[k]) <= Real<N>(hi[k])) &
                          (Real<N>::load(node.hi[k]) >= Real<N>(lo[k]));
            for (uint32_t rest = inReach.bits(); rest; rest &= rest - 1) {
                const uint32_t slot = uint32_t(lowestBit(rest)), child = node.child[slot];
                Real<N> entered;
                const uint32_t lanes =
                    entry.lanes & mixed.meet(node, slot, near, far, entered).bits();
                if (!(child & kWideLeaf) && __builtin_popcount(lanes) >= kTogether) {
                    stack[top++] = {child, lanes};
                } else if (lanes) {
                    entered.store(from);
                    give(child, lanes, from);
                }
            }
        }
    }

    static void raiseNearest(Flight& flight) {
        int nearest = flight.top;
        for (int i = 1; i < flight.top; ++i)
            nearest = flight.from[i] < flight.from[nearest] ? i : nearest;
        const float from = flight.from[nearest];
        const uint32_t child = flight.child[nearest];
        flight.from[nearest] = flight.from[flight.top];
        flight.child[nearest] = flight.child[flight.top];
        flight.from[flight.top] = from;
        flight.child[flight.top] = child;
    }

    template <class Turn>
    HWY_INLINE void turns(const uint32_t* list, uint32_t& listed, const Turn& turn) {
        uint32_t now[kRays];
        __builtin_memcpy(now, list, sizeof now);
        const uint32_t count = listed;
        listed = 0;
        for (uint32_t i = 0; i < count; ++i) {
            turn(flights_[now[i]]);
            join(now[i]);
        }
    }

    /// Puts a ray into the list of its next turn.
    HWY_INLINE void join(uint32_t i) {
        const Flight& flight = flights_[i];
        const uint32_t child = flight.child[flight.top];
        const bool done = child == kNothing, isLeaf = !done & ((child & kWideLeaf) != 0);
        before_[0][nodeCount_] = i;
        nodeCount_ += !isLeaf & !done;
        before_[1][leafCount_] = i;
        leafCount_ += isLeaf;
        idle_[idleCount_] = i;
        idleCount_ += done;
        prefetch(done ? kWideLeaf : child);
    }

    HWY_INLINE void prefetch(uint32_t child) const {
        const char* const leaf = reinterpret_cast<const char*>(
            model_.wide.blocks + kWordsOfTriangle * std::size_t((child & ~kWideLeaf) >> 4));
        const char* const node = reinterpret_cast<const char*>(model_.wide.nodes + child);
        const char* const next = child & kWideLeaf ? leaf : node;
        for (int line = 0; line < 7; ++line) __builtin_prefetch(next + 64 * line);
    }

    HWY_INLINE void node(Flight& flight) {
        const WideNode& node = model_.wide.nodes[flight.child[flight.top]];
        Real<kPacketSize> entered;
        const Mask<kPacketSize> hits =
            meetBoxes(node, flight.tree, flight.query.tNear[0], flight.far, entered);
        flight.top += push(hits, entered, node, flight.from + flight.top,
                           flight.child + flight.top) - 1;
    }

    /// Replaces the top of the stack by the boxes met; the nearest comes to lie on top.
    static HWY_INLINE int push(const Mask<kPacketSize>& hits, const Real<kPacketSize>& entered,
                               const WideNode& node, float* from, uint32_t* child) {
        if constexpr (M != HitMode::Closest) {
            compressStore(hits, Word<kPacketSize>::load(node.child), child);
            return compressStore(hits, entered, from);
        } else {
            const Real<kPacketSize> far(__builtin_inff());
            const Real<kPacketSize> distance = select(hits, entered, far);
            const float least = smallestLane(distance);
            const uint32_t bits = hits.bits();
            const int nearest =
                lowestBit((distance == Real<kPacketSize>(least)).bits() | 0x8000u);
            const Mask<kPacketSize> rest = Mask<kPacketSize>::fromBits(bits & ~(1u << nearest));
            const int count = compressStore(rest, entered, from);
            compressStore(rest, Word<kPacketSize>::load(node.child), child);
            from[count] = least;
            child[count] = node.child[nearest];
            return __builtin_popcount(bits);
        }
    }

    HWY_INLINE void leaf(Flight& flight) {
        const TriangleBlock block(model_.wide.blocks, flight.child[flight.top]);
        --flight.top;
        BlockHits hits;
        flight.test().meet(block, Real<1>(flight.query.tNear[0]), flight.best, hits);
        if (hits.any()) decide(flight, block, hits);
    }

    [[gnu::noinline]] void decide(Flight& flight, const TriangleBlock& block,
                                  const BlockHits& hits) {
        const Real<1> before = flight.best;
        Traversal::decide(flight.test(), block, hits, flight.best, flight.query);
        if (M == HitMode::Any) {
            flight.top = flight.query.blocked ? 0 : flight.top;
        } else if (flight.best.v < before.v) {
            flight.far = (flight.best + flight.slack).v;
            int kept = 1;
            for (int i = 1; i <= flight.top; ++i) {
                const float from = flight.from[i];
                const uint32_t child = flight.child[i];
                flight.from[kept] = from;
                flight.child[kept] = child;
                kept += from <= flight.far;
            }
            flight.top = kept - 1;
        }
    }

    const ModelView& model_;
    Source& source_;
    uint32_t before_[2][kRays + 1]; ///< a node, a leaf
    uint32_t idle_[kRays + 1];
    uint32_t nodeCount_ = 0, leafCount_ = 0, idleCount_ = 0;
    Flight flights_[kRays];
};

} // namespace smart::SMART_ISA

// SPDX-License-Identifier: MIT
// Rays that have nothing in common, many at a time. A packet of rays that start close to each other
// goes down the wide tree as one (PacketOcclusion, PacketSearch). Rays of others go alone, each with
// a stack of its own, but they take turns, a node or a leaf each, so that one ray's wait for memory
// and for its own results is filled by the others. Which kind of turn comes next can not be
// predicted, hence rays wait in lists of those before a node and those before a leaf, and joining a
// list takes no branch.
//
// Fuetterling, Lojewski, Pfreundt, Hamann, Ebert, "Accelerated single ray tracing for wide vector
// units", HPG 2017, for compressing the boxes that were met onto the stack.
#pragma once

#include "libsmart/kernel/compress_store.h"
#include "libsmart/kernel/packet_occlusion.h"
#include "libsmart/kernel/packet_search.h"
#include "libsmart/kernel/scene_traversal.h"

namespace smart::SMART_ISA {

/// Source: bool next(PacketRays&, uint32_t& name), which gives a packet and its name, or none
/// any more; void open(Search<N>&), which fills in what a query knows besides its limits; void
/// done(name, const Search<16>&) of a packet that was traced as one, or done(name, lane, const
/// Search<1>&) of each of its rays.
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
    static constexpr uint32_t kRays = 32;
    static constexpr uint32_t kNothing = 0xFFFFFFFFu; ///< at the bottom of each stack
    /// What a ray pushes, and a whole group written behind it.
    static constexpr int kStack = 1 + kWideMaxDepth * kWideChildren + kPacketSize;
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

    /// Traces a packet whose rays start together, or gives its rays to idle flights.
    [[gnu::noinline]] bool launch() {
        PacketRays packet;
        uint32_t name;
        if (!source_.next(packet, name)) return false;
        if (!packet.lanes) return true;
        if (startTogether(packet.rays, packet.lanes, model_.wide)) {
            trace(packet, name);
            return true;
        }
        const MixedRays rays(model_.wide, packet.rays, Traversal::kPadding);
        const MixedShear shear(packet.rays);
        alignas(64) float slopes[3][N], far[N];
        for (int k = 0; k < 3; ++k) shear.slope(k).store(slopes[k]);
        (Real<N>::load(packet.far) + Real<N>::load(rays.slack)).store(far);
        for (uint32_t lanes = packet.lanes; lanes; lanes &= lanes - 1) {
            const int lane = lowestBit(lanes);
            Flight& flight = flights_[idle_[--idleCount_]];
            takeLane(packet.rays, lane, flight.ray);
            flight.group.lanes = 1;
            flight.group.dominantAxis = shear.dominantAxis(lane);
            rays.take(lane, flight.group, flight.tree);
            new (flight.precision) Precision<1>(
                model_, flight.ray, flight.group,
                Shear<1>(flight.ray, flight.group,
                         {slopes[0][lane], slopes[1][lane], slopes[2][lane]}));
            flight.slack = Real<1>(rays.slack[lane]);
            flight.best = Real<1>(packet.far[lane]);
            flight.far = far[lane];
            flight.packet = name;
            flight.lane = lane;
            Query& query = flight.query;
            source_.open(query);
            query.blocked = 0;
            query.deepest = 0;
            query.tNear[0] = packet.near[lane];
            query.best[0] = packet.far[lane];
            query.triangle[0] = kNoHit;
            query.levels[0] = query.currentLevels;
            for (uint32_t l = 0; l < query.currentLevels; ++l)
                query.path[l][0] = query.currentPath[l];
            flight.child[0] = kNothing;
            flight.from[0] = -__builtin_inff();
            flight.child[1] = 0;
            flight.from[1] = packet.near[lane];
            flight.top = 1;
            join(uint32_t(&flight - flights_));
        }
        return true;
    }

    void open(const PacketRays& packet, Search<N, M, NoCounts>& query) const {
        __builtin_memcpy(query.tNear, packet.near, sizeof query.tNear);
        Word<N>(kNoHit).store(query.triangle);
        source_.open(query);
        Word<N>(query.currentLevels).store(query.levels);
        for (uint32_t l = 0; l < query.currentLevels; ++l)
            Word<N>(query.currentPath[l]).store(query.path[l]);
    }

    /// Traces a packet whose rays start together to the end.
    [[gnu::noinline]] void trace(const PacketRays& packet, uint32_t name) {
        using Walk = std::conditional_t<M == HitMode::Any, PacketOcclusion<Precision>,
                                        PacketSearch<Precision>>;
        Search<N, M, NoCounts> query;
        open(packet, query);
        Walk(model_, packet, query).run();
        source_.done(name, query);
    }

    /// The rays that have joined the idle ones since there were so many.
    void finish(uint32_t before) {
        for (; before < idleCount_; ++before) {
            Flight& flight = flights_[idle_[before]];
            flight.query.best[0] = flight.best.v;
            source_.done(flight.packet, flight.lane, flight.query);
        }
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
            dropFarther(flight);
        }
    }

    /// Takes from the stack what begins too far away.
    static HWY_INLINE void dropFarther(Flight& flight) {
        using R = Real<kPacketSize>;
        const R far(flight.far);
        int kept = 1;
        for (int i = 1; i <= flight.top; i += kPacketSize) {
            const R from = R::loadUnaligned(flight.from + i);
            const int left = flight.top + 1 - i;
            const uint32_t stay = (from <= far).bits() &
                                  ((left < kPacketSize ? 1u << left : 0u) - 1u);
            const Mask<kPacketSize> mask = Mask<kPacketSize>::fromBits(stay & 0xFFFFu);
            compressStore(mask, Word<kPacketSize>::loadUnaligned(flight.child + i),
                          flight.child + kept);
            kept += compressStore(mask, from, flight.from + kept);
        }
        flight.top = kept - 1;
    }

    const ModelView& model_;
    Source& source_;
    uint32_t before_[2][kRays + 1]; ///< a node, a leaf
    uint32_t idle_[kRays + 1];
    uint32_t nodeCount_ = 0, leafCount_ = 0, idleCount_ = 0;
    Flight flights_[kRays];
};

} // namespace smart::SMART_ISA

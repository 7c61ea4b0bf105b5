// SPDX-License-Identifier: MIT
// Traversal of wide nodes by a tile of 64 rays: sixteen child boxes at once against all that the
// rays could meet, then the rays themselves, sixteen at once, against the boxes that are left.
#pragma once

#include "libsmart/kernel/scene_traversal.h"

namespace smart::SMART_ISA {

inline float largest(const Real<kPacketSize>& a) {
    hn::Vec<Tag> m = a.v[0];
    for (int i = 1; i < kRegisters; ++i) m = hn::Max(m, a.v[i]);
    return hn::GetLane(hn::MaxOfLanes(Tag(), m));
}
inline float smallest(const Real<kPacketSize>& a) {
    hn::Vec<Tag> m = a.v[0];
    for (int i = 1; i < kRegisters; ++i) m = hn::Min(m, a.v[i]);
    return hn::GetLane(hn::MinOfLanes(Tag(), m));
}

inline constexpr int kTileVectors = 4;

template <template <int> class Precision, HitMode M>
class TileTraversal {
public:
#ifdef TILE_STATS
    static inline long opens = 0, pops = 0, slabs = 0, leaves = 0, tests = 0, tiles = 0, split = 0, woops = 0;
#define COUNT(x, n) x += (n)
#else
#define COUNT(x, n)
#endif
    static constexpr int N = kPacketSize;
    using Query = Search<N, M, NoCounts>;
    using Packets = SceneTraversal<Precision, N, M, NoCounts>;

    static void model(const ModelView& model, const LocalRays<N>* rays, const uint32_t* lanes,
                      Query* query) {
        RayGroup group{};
        const bool coherent = model.wide.nodes && sameGroup(rays, lanes, group);
        COUNT(tiles,1);
        if (!coherent || model.childTree.nodes) { COUNT(split,1);
            for (int v = 0; v < kTileVectors; ++v)
                if (lanes[v]) Packets::model(model, rays[v], lanes[v], query[v]);
            return;
        }
        if (model.wide.nodes) {
            TileTraversal tile(model, rays, lanes, group, query);
            tile.traverse();
            tile.finish();
        }
        for (uint32_t i = 0; i < model.childCount; ++i) child(model, i, rays, lanes, query);
    }
    static void scene(const ModelView& model, const LocalRays<N>* rays, const uint32_t* lanes,
                      Query* query) {
        if (model.wide.nodes || model.childTree.nodes) return TileTraversal::model(model, rays, lanes, query);
        for (uint32_t i = 0; i < model.childCount; ++i) child(model, i, rays, lanes, query);
    }

private:
    struct Entry {
        float near;
        uint32_t node;
        uint8_t slot, vectors;
    };

    static void child(const ModelView& parent, uint32_t number, const LocalRays<N>* rays,
                      const uint32_t* lanes, Query* query) {
        const InstanceView& instance = parent.children[number];
        for (int v = 0; v < kTileVectors; ++v)
            query[v].currentPath[query[v].currentLevels++] = number;
        uint32_t live[kTileVectors];
        for (int v = 0; v < kTileVectors; ++v)
            live[v] = M == HitMode::Any ? lanes[v] & ~query[v].blocked : lanes[v];
        if (instance.identity) {
            scene(*instance.model, rays, live, query);
        } else {
            LocalRays<N> local[kTileVectors];
            for (int v = 0; v < kTileVectors; ++v) transformRays(instance, rays[v], local[v]);
            scene(*instance.model, local, live, query);
        }
        for (int v = 0; v < kTileVectors; ++v) --query[v].currentLevels;
    }

    /// Whether all rays share direction signs and dominant axis.
    static bool sameGroup(const LocalRays<N>* rays, const uint32_t* lanes, RayGroup& group) {
        bool first = true;
        for (int v = 0; v < kTileVectors; ++v) {
            if (!lanes[v]) continue;
            RayGroups<N> groups(rays[v], lanes[v]);
            RayGroup g{};
            groups.next(g);
            if (g.lanes != lanes[v]) return false;
            if (first) {
                group = g;
                first = false;
                continue;
            }
            if (g.dominantAxis != group.dominantAxis) return false;
            for (int k = 0; k < 3; ++k)
                if (g.negative[k] != group.negative[k]) return false;
        }
        return !first;
    }

    struct Vector {
        TreeRays<N> tree;
        Precision<N> precision;
        Real<N> rangeNear, best;
        static ModelView ordered(const ModelView& m) {
            ModelView o = m;
            o.triangles = m.wide.triangles;
            return o;
        }
        Vector(const ModelView& m, const LocalRays<N>& rays, const RayGroup& g, const Query& q,
               uint32_t lanes)
            : tree(m.tree, rays, g), precision(ordered(m), rays, g), rangeNear(Real<N>::load(q.tNear)),
              best(select(Mask<N>::fromBits(lanes), Real<N>::load(q.best),
                          Real<N>(-__builtin_inff()))) {}
    };

    TileTraversal(const ModelView& model, const LocalRays<N>* rays, const uint32_t* lanes,
                  const RayGroup& group, Query* query)
        : model_(model), group_(group), query_(query), lanes_(lanes),
          vectors_{Vector(model, rays[0], group, query[0], lanes[0]),
                   Vector(model, rays[1], group, query[1], lanes[1]),
                   Vector(model, rays[2], group, query[2], lanes[2]),
                   Vector(model, rays[3], group, query[3], lanes[3])} {
        const float inf = __builtin_inff();
        const int kz = group.dominantAxis;
        for (int v = 0; v < kTileVectors; ++v) {
            if (!lanes[v]) continue;
            vectorsOn_ |= 1u << v;
            depth_[v] = magnitude(Real<N>::load(rays[v].dir[kz]));
        }
        float scale = model.tree.maxAbs;
        for (int k = 0; k < 3; ++k) {
            Real<N> orgLo(inf), orgHi(-inf), slopeLo(inf), slopeHi(0.0f);
            for (int v = 0; v < kTileVectors; ++v) {
                if (!lanes[v]) continue;
                const Mask<N> on = Mask<N>::fromBits(lanes[v]);
                const Real<N> org = Real<N>::load(rays[v].org[k]);
                const Real<N> slope = depth_[v] * magnitude(vectors_[v].tree.reciprocal[k]);
                orgLo = select(on, min(orgLo, org), orgLo);
                orgHi = select(on, max(orgHi, org), orgHi);
                slopeLo = select(on, min(slopeLo, slope), slopeLo);
                slopeHi = select(on, max(slopeHi, slope), slopeHi);
            }
            const float olo = smallest(orgLo), ohi = largest(orgHi);
            orgRange_[k][0] = olo;
            orgRange_[k][1] = ohi;
            slopeLo_[k] = smallest(slopeLo) * (1.0f - 0x1p-22f);
            slopeHi_[k] = largest(slopeHi) * (1.0f + 0x1p-22f);
            const float a = olo < 0 ? -olo : olo, b = ohi < 0 ? -ohi : ohi;
            scale = a > scale ? a : scale;
            scale = b > scale ? b : scale;
            sign_[k] = group.negative[k] ? -1.0f : 1.0f;
            enterOrg_[k] = group.negative[k] ? -olo : ohi;
            leaveOrg_[k] = group.negative[k] ? -ohi : olo;
        }
        const float pad = scale * 0x1p-20f;
        for (int k = 0; k < 3; ++k) {
            enterOrg_[k] += pad;
            leaveOrg_[k] -= pad;
        }
        Real<N> near(inf);
        for (int v = 0; v < kTileVectors; ++v)
            if (lanes[v])
                near = select(Mask<N>::fromBits(lanes[v]),
                              min(near, vectors_[v].rangeNear * depth_[v]), near);
        near_ = smallest(near);
        common_ = true;
        for (int k = 0; k < 3; ++k)
            common_ = common_ && orgRange_[k][0] == orgRange_[k][1];
        if (common_) prepareCommon(rays, lanes);
        updateFar();
    }

    void prepareCommon(const LocalRays<N>* rays, const uint32_t* lanes) {
        const int axes[2] = {(group_.dominantAxis + 1) % 3, (group_.dominantAxis + 2) % 3};
        for (int a = 0; a < 2; ++a) {
            Real<N> lo(__builtin_inff()), hi(-__builtin_inff());
            for (int v = 0; v < kTileVectors; ++v) {
                if (!lanes[v]) continue;
                const Mask<N> on = Mask<N>::fromBits(lanes[v]);
                slope_[a][v] = Real<N>::load(rays[v].dir[axes[a]]) /
                               Real<N>::load(rays[v].dir[group_.dominantAxis]);
                lo = select(on, min(lo, slope_[a][v]), lo);
                hi = select(on, max(hi, slope_[a][v]), hi);
            }
            const float l = smallest(lo), h = largest(hi);
            centre_[a] = 0.5f * (l + h);
            half_[a] = (h - centre_[a] > centre_[a] - l ? h - centre_[a] : centre_[a] - l) * (1 + 0x1p-20f);
            for (int v = 0; v < kTileVectors; ++v)
                if (lanes[v]) slope_[a][v] = slope_[a][v] - Real<N>(centre_[a]);
        }
    }

    struct alignas(64) EdgeFunctions {
        float x[3][N], y[3][N], z[3][N], bound[N];
    };

    /// Which of a leaf's triangles some ray may meet; and the edge functions of all.
    uint32_t meetTriangles(uint32_t first, uint32_t count, EdgeFunctions& edges) const {
        using Signed = hn::RebindToSigned<Tag>;
        const float* const base = &model_.wide.triangles[0].v0[0];
        alignas(64) int32_t offset[N];
        for (uint32_t i = 0; i < uint32_t(N); ++i) offset[i] = int32_t((first + (i < count ? i : 0)) * 9);
        const int kz = group_.dominantAxis, kx = (kz + 1) % 3, ky = (kz + 2) % 3;
        uint32_t candidates = 0;
        for (int r = 0; r < kRegisters; ++r) {
            using V = hn::Vec<Tag>;
            const Tag d;
            const auto at = hn::Load(Signed(), offset + r * kRegisterLanes);
            const auto set = [&](float f) { return hn::Set(d, f); };
            V x[3], y[3], z[3];
            V flat = hn::Zero(d), deep = hn::Zero(d), m = hn::Zero(d), nearest = set(__builtin_inff());
            for (int c = 0; c < 3; ++c) {
                x[c] = hn::Sub(hn::GatherIndex(d, base + 3 * c + kx, at), set(orgRange_[kx][0]));
                y[c] = hn::Sub(hn::GatherIndex(d, base + 3 * c + ky, at), set(orgRange_[ky][0]));
                z[c] = hn::Sub(hn::GatherIndex(d, base + 3 * c + kz, at), set(orgRange_[kz][0]));
                flat = hn::Max(flat, hn::Max(hn::Abs(x[c]), hn::Abs(y[c])));
                deep = hn::Max(deep, hn::Abs(z[c]));
                nearest = hn::Min(nearest, hn::Mul(z[c], set(sign_[kz])));
                x[c] = hn::NegMulAdd(set(centre_[0]), z[c], x[c]);
                y[c] = hn::NegMulAdd(set(centre_[1]), z[c], y[c]);
                m = hn::Max(m, hn::Max(hn::Abs(x[c]), hn::Abs(y[c])));
            }
            const V h = set(half_[0] > half_[1] ? half_[0] : half_[1]);
            m = hn::MulAdd(h, deep, m);
            const V delta = hn::Mul(set(0x1p-22f), hn::Add(flat, deep));
            const V bound = hn::Mul(m, hn::MulAdd(set(8.0f), delta, hn::Mul(set(0x1p-19f), m)));
            V lowest = set(__builtin_inff()), highest = set(-__builtin_inff());
            for (int e = 0; e < 3; ++e) {
                const int b = (e + 1) % 3, c = (e + 2) % 3;
                const V nx = hn::Sub(hn::Mul(y[c], z[b]), hn::Mul(z[c], y[b]));
                const V ny = hn::Sub(hn::Mul(z[c], x[b]), hn::Mul(x[c], z[b]));
                const V nz = hn::Sub(hn::Mul(x[c], y[b]), hn::Mul(y[c], x[b]));
                const V reach = hn::MulAdd(hn::Abs(nx), set(half_[0]), hn::Mul(hn::Abs(ny), set(half_[1])));
                lowest = hn::Min(lowest, hn::Add(nz, reach));
                highest = hn::Max(highest, hn::Sub(nz, reach));
                hn::Store(nx, d, edges.x[e] + r * kRegisterLanes);
                hn::Store(ny, d, edges.y[e] + r * kRegisterLanes);
                hn::Store(nz, d, edges.z[e] + r * kRegisterLanes);
            }
            hn::Store(bound, d, edges.bound + r * kRegisterLanes);
            const auto outside = hn::And(hn::Lt(lowest, hn::Neg(bound)), hn::Gt(highest, bound));
            const auto beyond = hn::Gt(hn::Sub(nearest, hn::Mul(set(0x1p-20f), hn::Add(flat, deep))), set(far_));
            uint64_t bits = 0;
            hn::StoreMaskBits(d, hn::Or(outside, beyond), reinterpret_cast<uint8_t*>(&bits));
            candidates |= uint32_t(bits) << (r * kRegisterLanes);
        }
        return ~candidates & ((1u << count) - 1u);
    }

    /// Whether some ray of a vector may meet triangle i.
    bool mayMeet(const EdgeFunctions& edges, int i, int v, const Mask<N>& active) const {
        Real<N> e[3];
        for (int k = 0; k < 3; ++k)
            e[k] = Real<N>(edges.z[k][i]) + Real<N>(edges.x[k][i]) * slope_[0][v] +
                   Real<N>(edges.y[k][i]) * slope_[1][v];
        const Real<N> bound(edges.bound[i]);
        const Mask<N> outside = (min(min(e[0], e[1]), e[2]) < Real<N>(-edges.bound[i])) &
                                (max(max(e[0], e[1]), e[2]) > bound);
        return any(andNot(active, outside));
    }

    void updateFar() {
        Real<N> far(-__builtin_inff());
        for (int v = 0; v < kTileVectors; ++v)
            if (vectorsOn_ >> v & 1) far = max(far, vectors_[v].best * depth_[v]);
        far_ = largest(far);
        far_ = far_ * (1.0f + 0x1p-22f);
    }

    /// Which of sixteen boxes the tile could meet, and from what depth on.
    template <class Box>
    HWY_INLINE Mask<N> meetBoxes(const Box& box, Real<N>& tNear) const {
        tNear = Real<N>(near_);
        Real<N> tFar(far_);
        for (int k = 0; k < 3; ++k) {
            const Real<N> sign(sign_[k]);
            Real<N> lo, hi;
            box(k, lo, hi);
            const Real<N> enter = (group_.negative[k] ? hi : lo) * sign - Real<N>(enterOrg_[k]);
            const Real<N> leave = (group_.negative[k] ? lo : hi) * sign - Real<N>(leaveOrg_[k]);
            const Real<N> slopeLo(slopeLo_[k]), slopeHi(slopeHi_[k]);
            tNear = max(tNear, min(enter * slopeLo, enter * slopeHi));
            tFar = min(tFar, max(leave * slopeLo, leave * slopeHi));
        }
        return tNear <= tFar;
    }

    /// Which of a leaf's triangles the tile could meet.
    uint32_t meetTriangles(uint32_t first, uint32_t count) const {
        using Signed = hn::RebindToSigned<Tag>;
        const float* const base = &model_.wide.triangles[0].v0[0];
        hn::Vec<Signed> at[kRegisters];
        alignas(64) int32_t offset[N];
        for (uint32_t i = 0; i < uint32_t(N); ++i) offset[i] = int32_t((first + (i < count ? i : 0)) * 9);
        for (int r = 0; r < kRegisters; ++r) at[r] = hn::Load(Signed(), offset + r * kRegisterLanes);
        const auto box = [&](int k, Real<N>& lo, Real<N>& hi) {
            for (int r = 0; r < kRegisters; ++r) {
                const auto a = hn::GatherIndex(Tag(), base + k, at[r]);
                const auto b = hn::GatherIndex(Tag(), base + 3 + k, at[r]);
                const auto c = hn::GatherIndex(Tag(), base + 6 + k, at[r]);
                lo.v[r] = hn::Min(hn::Min(a, b), c);
                hi.v[r] = hn::Max(hn::Max(a, b), c);
            }
        };
        Real<N> tNear;
        return meetBoxes(box, tNear).bits() & ((1u << count) - 1u);
    }

    /// Pushes the children of a node that the tile could meet, the nearest last.
    void open(uint32_t index, uint32_t vectors) {
        COUNT(opens,1);
        const WideNode& node = model_.wide.nodes[index];
        Real<N> tNear;
        const auto box = [&](int k, Real<N>& lo, Real<N>& hi) {
            lo = Real<N>::load(node.lo[k]);
            hi = Real<N>::load(node.hi[k]);
        };
        uint32_t hits = meetBoxes(box, tNear).bits();
        if (!hits) return;
        alignas(64) float near[N];
        tNear.store(near);
        const int base = top_;
        for (; hits; hits &= hits - 1) {
            const int slot = lowestBit(hits);
            const uint32_t child = node.child[slot];
            const char* const next =
                child & kWideLeaf
                    ? reinterpret_cast<const char*>(model_.wide.triangles + ((child & ~kWideLeaf) >> 4))
                    : reinterpret_cast<const char*>(model_.wide.nodes + child);
            for (int line = 0; line < 7; ++line) __builtin_prefetch(next + 64 * line);
            int at = top_++;
            const float n = near[slot];
            while (at > base && stack_[at - 1].near < n) {
                stack_[at] = stack_[at - 1];
                --at;
            }
            stack_[at] = {n, index, uint8_t(slot), uint8_t(vectors)};
        }
    }

    void traverse() {
        open(0, vectorsOn_);
        while (top_ > 0) {
            const Entry entry = stack_[--top_];
            if (entry.near > far_) continue;
            COUNT(pops,1); COUNT(slabs, __builtin_popcount(entry.vectors));
            const WideNode& node = model_.wide.nodes[entry.node];
            const uint32_t child = node.child[entry.slot];
            uint32_t vectors = 0;
            Mask<N> active[kTileVectors];
            for (uint32_t rest = entry.vectors; rest; rest &= rest - 1) {
                const int v = lowestBit(rest);
                const Vector& vector = vectors_[v];
                Real<N> tNear = vector.rangeNear, tFar = vector.best;
                for (int k = 0; k < 3; ++k) {
                    const float lo = node.lo[k][entry.slot], hi = node.hi[k][entry.slot];
                    tNear = max(tNear, vector.tree.enterDistance(group_.negative[k] ? hi : lo, k));
                    tFar = min(tFar, vector.tree.leaveDistance(group_.negative[k] ? lo : hi, k));
                }
                active[v] = tNear <= tFar;
                if (any(active[v])) vectors |= 1u << v;
            }
            if (!vectors) continue;
            if (!(child & kWideLeaf)) {
                open(child, vectors);
                continue;
            }
            leaf(child, vectors, active);
            if (M == HitMode::Any && !vectorsOn_) return;
        }
    }

    void finish() {
        if constexpr (M == HitMode::Closest)
            for (int v = 0; v < kTileVectors; ++v)
                select(Mask<N>::fromBits(lanes_[v]), vectors_[v].best, Real<N>::load(query_[v].best))
                    .store(query_[v].best);
    }

    void leaf(uint32_t child, uint32_t vectors, Mask<N>* active) {
        const uint32_t count = (child & 15u) + 1;
        const uint32_t first = (child & ~kWideLeaf) >> 4;
        EdgeFunctions edges;
        uint32_t candidates = common_ ? meetTriangles(first, count, edges) : meetTriangles(first, count);
        COUNT(leaves,1); COUNT(tests, __builtin_popcount(candidates) * __builtin_popcount(vectors));
        bool changed = false;
        for (; candidates; candidates &= candidates - 1) {
            const int i = lowestBit(candidates);
            uint32_t rest = vectors;
            if (common_) {
                rest = 0;
                for (int v = 0; v < kTileVectors; ++v)
                    rest |= uint32_t(mayMeet(edges, i, v, active[v])) << v;
                rest &= vectors;
            }
            for (; rest; rest &= rest - 1) {
                const int v = lowestBit(rest);
                Vector& vector = vectors_[v];
                COUNT(woops, 1);
                Real<N> t;
                Mask<N> hit = vector.precision.meet(first + uint32_t(i), active[v], t);
                if (!any(hit)) continue;
                hit = hit & (t >= vector.rangeNear) & (t <= vector.best);
                if (!any(hit)) continue;
                changed = true;
                vector.best = query_[v].accept(hit, t, vector.best, model_.wide.prims[first + uint32_t(i)]);
                if constexpr (M == HitMode::Any) {
                    active[v] = andNot(active[v], hit);
                    vector.best = select(hit, Real<N>(-__builtin_inff()), vector.best);
                    if (!any(active[v])) vectors &= ~(1u << v);
                    if (query_[v].blocked == lanes_[v]) vectorsOn_ &= ~(1u << v);
                }
            }
        }
        if (changed) {
            updateFar();
        }
    }

    const ModelView& model_;
    const RayGroup& group_;
    Query* const query_;
    const uint32_t* const lanes_;
    Vector vectors_[kTileVectors];
    Real<N> depth_[kTileVectors];
    float sign_[3], enterOrg_[3], leaveOrg_[3], slopeLo_[3], slopeHi_[3];
    float near_, far_;
    float orgRange_[3][2];
    bool common_;
    Real<N> slope_[2][kTileVectors]; ///< of rays from one origin: across the dominant axis, per unit of it, from centre_
    float centre_[2], half_[2];
    uint32_t vectorsOn_ = 0;
    Entry stack_[512];
    int top_ = 0;
};

} // namespace smart::SMART_ISA

// SPDX-License-Identifier: MIT
// Compiled once for each instruction set, into namespace smart::SMART_ISA; fills its KernelTable.
#include <type_traits>

#include "libsmart/kernel/hit_refinement.h"
#include "libsmart/kernel/intersect.h"
#include "libsmart/kernel/hit_rounding.h"
#include "libsmart/kernel/kernels.h"
#include "libsmart/kernel/mixed_scene.h"
#include "libsmart/kernel/ray_preparation.h"
#include "libsmart/kernel/ray_streams.h"
#include "libsmart/kernel/scene_traversal.h"
#include "libsmart/kernel/tile_scene.h"

namespace smart::SMART_ISA {

extern const KernelTable kTable;

namespace {

/// The arrays of N rays, whatever structure they lie in.
struct RayArrays {
    const float* org[3];
    const float* dir[3];
    const float *tNear, *tFar;
    uint32_t active;

    explicit RayArrays(const RayPacket& p)
        : org{p.org[0], p.org[1], p.org[2]},
          dir{p.dir[0], p.dir[1], p.dir[2]},
          tNear(p.tNear),
          tFar(p.tFar),
          active(p.active) {}
    explicit RayArrays(const Ray& r)
        : org{&r.org[0], &r.org[1], &r.org[2]},
          dir{&r.dir[0], &r.dir[1], &r.dir[2]},
          tNear(&r.tNear),
          tFar(&r.tFar),
          active(1) {}
};

template <template <int> class Precision>
inline constexpr bool kIsPrecise = std::is_same_v<Precision<1>, Precise<1>>;

/// Starts `query`, and `world` in the precise mode; returns the lanes that carry a legal ray.
template <template <int> class Precision, int N, HitMode M, class Counter>
uint32_t prepare(const ModelView& scene, const RayArrays& in, typename Precision<N>::Rays& rays,
                 WorldRays<N>& world, Search<N, M, Counter>& query) {
    query.lastOfEqual = scene.lastOfEqual != 0;
    if constexpr (kIsPrecise<Precision>)
        return preparePreciseRays<N, M, Counter>(scene, in.org, in.dir, in.tNear, in.tFar,
                                                 in.active, rays, world, query);
    else
        return prepareRays<N, M, Counter>(in.org, in.dir, in.tNear, in.tFar, in.active, rays,
                                          world.scale, query);
}

/// Fills `query` with what the rays hit, and `world` in the precise mode.
template <template <int> class Precision, int N, HitMode M, class Counter>
void run(const ModelView& scene, const RayArrays& in, WorldRays<N>& world,
         Search<N, M, Counter>& query) {
    typename Precision<N>::Rays rays;
    const uint32_t legal = prepare<Precision>(scene, in, rays, world, query);
    if (legal) SceneTraversal<Precision, N, M, Counter>::model(scene, rays, legal, query);
}

/// Computes where the hits of `query` lie.
template <template <int> class Precision, int N, HitMode M, class Counter>
void place(const ModelView& scene, const RayArrays& in, const WorldRays<N>& world,
           const Search<N, M, Counter>& query, float* t, float* u, float* v) {
    if constexpr (kIsPrecise<Precision>) {
        placeHits(scene, world, query, t, u, v);
    } else {
        refineHits<N>(scene, in.org, in.dir, in.tNear, in.tFar, query.triangle, query.levels,
                      query.path, t, u, v);
    }
}

template <class Counter>
void store(const Search<kPacketSize, HitMode::Closest, Counter>& query, HitPacket& hits) {
    __builtin_memcpy(hits.triangle, query.triangle, sizeof hits.triangle);
    __builtin_memcpy(hits.levels, query.levels, sizeof hits.levels);
    for (uint32_t l = 0; l < query.deepest; ++l)
        __builtin_memcpy(hits.path[l], query.path[l], sizeof hits.path[l]);
}

template <template <int> class Precision, class Counter>
void closestHits(const ModelView& scene, const RayPacket& rays, HitPacket& hits, Counter counter) {
    const RayArrays in(rays);
    WorldRays<kPacketSize> world;
    Search<kPacketSize, HitMode::Closest, Counter> query;
    query.counter = counter;
    run<Precision>(scene, in, world, query);
    place<Precision>(scene, in, world, query, hits.t, hits.u, hits.v);
    store(query, hits);
}

template <template <int> class Precision>
void intersect(const ModelView& scene, const RayPacket& rays, HitPacket& hits) {
    closestHits<Precision>(scene, rays, hits, NoCounts());
}

template <template <int> class Precision>
void intersectCounted(const ModelView& scene, const RayPacket& rays, HitPacket& hits,
                      TraversalCounts& counts) {
    closestHits<Precision>(scene, rays, hits, Counts{&counts});
}

template <template <int> class Precision>
void occluded(const ModelView& scene, const RayPacket& rays, uint32_t& blocked) {
    WorldRays<kPacketSize> world;
    Search<kPacketSize, HitMode::Any, NoCounts> query;
    run<Precision>(scene, RayArrays(rays), world, query);
    blocked = query.blocked;
}

template <template <int> class Precision>
void intersect1(const ModelView& scene, const Ray& ray, Hit& hit) {
    const RayArrays in(ray);
    WorldRays<1> world;
    Search<1, HitMode::Closest, NoCounts> query;
    run<Precision>(scene, in, world, query);
    hit.triangle = query.triangle[0];
    if (hit.triangle == kNoHit) return;
    place<Precision>(scene, in, world, query, &hit.t, &hit.u, &hit.v);
    hit.levels = query.levels[0];
    for (uint32_t l = 0; l < hit.levels; ++l) hit.path[l] = query.path[l][0];
}

/// Computes where hits of a packet's rays lie, sixteen at once.
void placeAll(const ModelView& scene, const RayPacket& packet, const HitList& list,
              uint32_t count) {
    for (uint32_t first = 0; first < count; first += kPacketSize) {
        const uint32_t some = count - first < kPacketSize ? count - first : kPacketSize;
        RayPacket rays = packet;
        HitPacket found;
        for (uint32_t i = 0; i < uint32_t(kPacketSize); ++i) {
            found.triangle[i] = kNoHit;
            found.levels[i] = 0;
            if (i >= some) continue;
            const Hit& hit = list.hits[first + i];
            const uint32_t lane = list.lanes[first + i];
            for (int k = 0; k < 3; ++k) {
                rays.org[k][i] = packet.org[k][lane];
                rays.dir[k][i] = packet.dir[k][lane];
            }
            rays.tNear[i] = packet.tNear[lane];
            rays.tFar[i] = packet.tFar[lane];
            found.triangle[i] = hit.triangle;
            found.levels[i] = hit.levels;
            for (uint32_t l = 0; l < hit.levels; ++l) found.path[l][i] = hit.path[l];
        }
        const RayArrays in(rays);
        refineHits<kPacketSize>(scene, in.org, in.dir, in.tNear, in.tFar, found.triangle,
                                found.levels, found.path, found.t, found.u, found.v);
        for (uint32_t i = 0; i < some; ++i) {
            Hit& hit = list.hits[first + i];
            hit.t = found.t[i];
            hit.u = found.u[i];
            hit.v = found.v[i];
        }
    }
}

/// The same with exact arithmetic, ray by ray.
void placeAllExactly(const ModelView& scene, const RayPacket& packet, const HitList& list,
                     uint32_t count) {
    for (uint32_t lane = 0; lane < uint32_t(kPacketSize); ++lane) {
        Ray ray;
        for (int k = 0; k < 3; ++k) {
            ray.org[k] = packet.org[k][lane];
            ray.dir[k] = packet.dir[k][lane];
        }
        ray.tNear = packet.tNear[lane];
        ray.tFar = packet.tFar[lane];
        bool isPrepared = false;
        WorldRays<1> world;
        Search<1, HitMode::All, NoCounts> query;
        for (uint32_t i = 0; i < count; ++i) {
            if (list.lanes[i] != lane) continue;
            if (!isPrepared) {
                Precise<1>::Rays rays;
                prepare<Precise>(scene, RayArrays(ray), rays, world, query);
                isPrepared = true;
            }
            Hit& hit = list.hits[i];
            query.triangle[0] = hit.triangle;
            query.levels[0] = hit.levels;
            for (uint32_t l = 0; l < hit.levels; ++l) query.path[l][0] = hit.path[l];
            placeHits(scene, world, query, &hit.t, &hit.u, &hit.v);
        }
    }
}

template <template <int> class Precision>
void intersectAll(const ModelView& scene, const RayPacket& rays, HitList& list) {
    WorldRays<kPacketSize> world;
    Search<kPacketSize, HitMode::All, NoCounts> query;
    list.count = 0;
    query.all = &list;
    run<Precision>(scene, RayArrays(rays), world, query);
    const uint32_t stored = list.count < list.capacity ? list.count : list.capacity;
    if constexpr (kIsPrecise<Precision>)
        placeAllExactly(scene, rays, list, stored);
    else
        placeAll(scene, rays, list, stored);
}

template <template <int> class Precision>
bool occluded1(const ModelView& scene, const Ray& ray) {
    WorldRays<1> world;
    Search<1, HitMode::Any, NoCounts> query;
    run<Precision>(scene, RayArrays(ray), world, query);
    return query.blocked != 0;
}

/// Whether all legal rays of a tile start at one point, or end at one: then its apex is set.
template <HitMode M>
bool findApex(const TileLanes& legal, const Search<kPacketSize, M, NoCounts>* query,
              RayTile& tile) {
    using R = Real<kPacketSize>;
    int first = -1;
    bool common = true;
    for (int v = 0; v < kTileVectors; ++v) {
        if (!legal.of[v]) continue;
        const int lane = lowestBit(legal.of[v]);
        if (first < 0) {
            first = v;
            for (int k = 0; k < 3; ++k) tile.apex[k] = tile.rays[v].org[k][lane];
        }
        const Mask<kPacketSize> on = Mask<kPacketSize>::fromBits(legal.of[v]);
        for (int k = 0; k < 3; ++k)
            common = common && !any(on & (R::load(tile.rays[v].org[k]) != R(tile.apex[k])));
    }
    tile.startsThere = true;
    if (common || M == HitMode::Closest) return common && first >= 0;
    tile.startsThere = false;
    const int lane = lowestBit(legal.of[first]);
    for (int k = 0; k < 3; ++k) {
        const double from = tile.rays[first].org[k][lane], towards = tile.rays[first].dir[k][lane];
        tile.apex[k] = float(from + towards * query[first].best[lane]);
        if (!(magnitude(Real<1>(tile.apex[k])).v <= 0x1p40f)) return false;
    }
    for (int v = 0; v < kTileVectors; ++v) {
        if (!legal.of[v]) continue;
        __builtin_memcpy(tile.last[v], query[v].best, sizeof tile.last[v]);
        const Mask<kPacketSize> on = Mask<kPacketSize>::fromBits(legal.of[v]);
        for (int k = 0; k < 3; ++k) {
            const R from = R::load(tile.rays[v].org[k]);
            const R end = from + R::load(tile.rays[v].dir[k]) * R::load(query[v].best);
            const R near = (magnitude(from) + R(magnitude(Real<1>(tile.apex[k])).v)) * R(0x1p-14f);
            if (any(andNot(on, magnitude(end - R(tile.apex[k])) <= near))) return false;
        }
    }
    return true;
}

/// Callers with many tiles have them in a row, and memory is far: while one is traced, the next one
/// comes nearer. What else may lie there is only looked up, never read.
inline void prefetchBehind(const RayPacket* packets, uint32_t count, uint32_t v) {
    const char* const next = reinterpret_cast<const char*>(packets + count + v);
    for (std::size_t at = 0; at < sizeof(RayPacket); at += 64) __builtin_prefetch(next + at);
}

/// Fills the queries of a tile with what its rays hit.
template <template <int> class Precision, HitMode M>
void runTile(const ModelView& scene, const RayPacket* packets, uint32_t count,
             Search<kPacketSize, M, NoCounts>* query) {
    RayTile tile;
    TileLanes legal{};
    WorldRays<kPacketSize> world;
    // Not all at once, which would wait: the others' turn is when hits are refined.
    if (M == HitMode::Any)
        for (uint32_t v = 1; v < count; v += 2) prefetchBehind(packets, count, v);
    for (uint32_t v = 0; v < count; ++v) {
        if (v % 2 == 0) prefetchBehind(packets, count, v);
        const RayArrays in(packets[v]);
        query[v].lastOfEqual = scene.lastOfEqual != 0;
        legal.of[v] = prepareRays<kPacketSize, M, NoCounts>(
            in.org, in.dir, in.tNear, in.tFar, in.active, tile.rays[v], world.scale, query[v]);
    }
    if (!legal.count()) return;
    if (findApex<M>(legal, query, tile)) {
        TileScene<Precision, M>::model(scene, tile, legal, query, false);
        return;
    }
    for (uint32_t v = 0; v < count; ++v)
        if (legal.of[v])
            SceneTraversal<Precision, kPacketSize, M, NoCounts>::model(scene, tile.rays[v],
                                                                       legal.of[v], query[v]);
}

template <template <int> class Precision>
void intersectTile(const ModelView& scene, const RayPacket* packets, uint32_t count,
                   HitPacket* hits) {
    if constexpr (kIsPrecise<Precision>) {
        for (uint32_t v = 0; v < count; ++v) intersect<Precision>(scene, packets[v], hits[v]);
    } else {
        Search<kPacketSize, HitMode::Closest, NoCounts> query[kTilePackets];
        runTile<Precision>(scene, packets, count, query);
        HitRefinement<kPacketSize> found[kTilePackets];
        for (uint32_t v = 0; v < count; ++v) {
            if (v % 2 != 0) prefetchBehind(packets, count, v);
            const RayArrays in(packets[v]);
            found[v].fetch(scene, in.org, in.dir, query[v].triangle, query[v].levels,
                           query[v].path);
        }
        for (uint32_t v = 0; v < count; ++v) {
            found[v].place(packets[v].tNear, packets[v].tFar, hits[v].t, hits[v].u, hits[v].v);
            store(query[v], hits[v]);
        }
    }
}

template <template <int> class Precision>
void occludedTile(const ModelView& scene, const RayPacket* packets, uint32_t count,
                  uint32_t* blocked) {
    if constexpr (kIsPrecise<Precision>) {
        for (uint32_t v = 0; v < count; ++v) occluded<Precision>(scene, packets[v], blocked[v]);
    } else {
        Search<kPacketSize, HitMode::Any, NoCounts> query[kTilePackets];
        runTile<Precision>(scene, packets, count, query);
        for (uint32_t v = 0; v < count; ++v) blocked[v] = query[v].blocked;
    }
}

/// Rays of a packet that need have nothing in common.
template <template <int> class Precision, HitMode M>
void runApart(const ModelView& scene, const RayArrays& in, WorldRays<kPacketSize>& world,
              Search<kPacketSize, M, NoCounts>& query) {
    typename Precision<kPacketSize>::Rays rays;
    const uint32_t legal = prepare<Precision>(scene, in, rays, world, query);
    if constexpr (!kIsPrecise<Precision>) {
        if (startTogether(rays, legal, scene.childTree)) {
            MixedScene<Precision, M>::model(scene, rays, legal, query);
            return;
        }
    }
    SceneTraversal<Precision, kPacketSize, M, NoCounts>::oneByOne(scene, rays, legal, query);
}

template <template <int> class Precision>
void intersectStream(const ModelView& scene, const RayPacket* packets, uint32_t count,
                     HitPacket* hits) {
    if constexpr (!kIsPrecise<Precision>) {
        if (const ModelView* const model = streamedModel(scene)) {
            runStream<Precision, HitMode::Closest>(scene, *model, packets, count, hits, nullptr);
            for (uint32_t p = 0; p < count; ++p) {
                const RayArrays in(packets[p]);
                refineHits<kPacketSize>(scene, in.org, in.dir, in.tNear, in.tFar, hits[p].triangle,
                                        hits[p].levels, hits[p].path, hits[p].t, hits[p].u,
                                        hits[p].v);
            }
            return;
        }
    }
    for (uint32_t p = 0; p < count; ++p) {
        const RayArrays in(packets[p]);
        WorldRays<kPacketSize> world;
        Search<kPacketSize, HitMode::Closest, NoCounts> query;
        runApart<Precision>(scene, in, world, query);
        place<Precision>(scene, in, world, query, hits[p].t, hits[p].u, hits[p].v);
        store(query, hits[p]);
    }
}

template <template <int> class Precision>
void occludedStream(const ModelView& scene, const RayPacket* packets, uint32_t count,
                    uint32_t* blocked) {
    if constexpr (!kIsPrecise<Precision>) {
        if (const ModelView* const model = streamedModel(scene)) {
            runStream<Precision, HitMode::Any>(scene, *model, packets, count, nullptr, blocked);
            return;
        }
    }
    for (uint32_t p = 0; p < count; ++p) {
        WorldRays<kPacketSize> world;
        Search<kPacketSize, HitMode::Any, NoCounts> query;
        runApart<Precision>(scene, RayArrays(packets[p]), world, query);
        blocked[p] = query.blocked;
    }
}

#define SMART_STRINGIZE_(x) #x
#define SMART_STRINGIZE(x) SMART_STRINGIZE_(x)

} // namespace

const KernelTable kTable = {
    SMART_STRINGIZE(SMART_ISA),
    {intersect<Fast>, intersect<Watertight>, intersect<Precise>},
    {occluded<Fast>, occluded<Watertight>, occluded<Precise>},
    {intersect1<Fast>, intersect1<Watertight>, intersect1<Precise>},
    {occluded1<Fast>, occluded1<Watertight>, occluded1<Precise>},
    {intersectTile<Fast>, intersectTile<Watertight>, intersectTile<Precise>},
    {occludedTile<Fast>, occludedTile<Watertight>, occludedTile<Precise>},
    {intersectStream<Fast>, intersectStream<Watertight>, intersectStream<Precise>},
    {occludedStream<Fast>, occludedStream<Watertight>, occludedStream<Precise>},
    {intersectAll<Fast>, intersectAll<Watertight>, intersectAll<Precise>},
    {intersectCounted<Fast>, intersectCounted<Watertight>, intersectCounted<Precise>},
};

} // namespace smart::SMART_ISA

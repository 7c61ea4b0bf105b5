// SPDX-License-Identifier: MIT
// Compiled once for each instruction set, into namespace smart::SMART_ISA; fills its KernelTable.
#include "libsmart/kernel/hit_refinement.h"
#include "libsmart/kernel/kernels.h"
#include "libsmart/kernel/ray_preparation.h"
#include "libsmart/kernel/scene_traversal.h"
#include "libsmart/kernel/tile_traversal.h"

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

template <template <int> class Precision, int N, HitMode M, class Counter>
void run(const ModelView& scene, const RayArrays& in, Search<N, M, Counter>& query) {
    LocalRays<N> rays;
    const uint32_t legal =
        prepareRays<N, M, Counter>(in.org, in.dir, in.tNear, in.tFar, in.active, rays, query);
    if (legal) SceneTraversal<Precision, N, M, Counter>::model(scene, rays, legal, query);
}

template <template <int> class Precision, class Counter>
void closestHits(const ModelView& scene, const RayPacket& rays, HitPacket& hits, Counter counter) {
    const RayArrays in(rays);
    Search<kPacketSize, HitMode::Closest, Counter> query;
    query.counter = counter;
    run<Precision>(scene, in, query);
    refineHits<kPacketSize>(scene, in.org, in.dir, in.tNear, in.tFar, query.triangle,
                            query.levels, query.path, hits.t, hits.u, hits.v);
    __builtin_memcpy(hits.triangle, query.triangle, sizeof hits.triangle);
    __builtin_memcpy(hits.levels, query.levels, sizeof hits.levels);
    __builtin_memcpy(hits.path, query.path, sizeof hits.path);
}

template <template <int> class Precision>
void intersect(const ModelView& scene, const RayPacket& rays, HitPacket& hits) {
    closestHits<Precision>(scene, rays, hits, NoCounts());
}

void intersectCounted(const ModelView& scene, const RayPacket& rays, HitPacket& hits,
                      TraversalCounts& counts) {
    closestHits<Watertight>(scene, rays, hits, Counts{&counts});
}

template <template <int> class Precision>
void occluded(const ModelView& scene, const RayPacket& rays, uint32_t& blocked) {
    Search<kPacketSize, HitMode::Any, NoCounts> query;
    run<Precision>(scene, RayArrays(rays), query);
    blocked = query.blocked;
}

template <template <int> class Precision>
void intersect1(const ModelView& scene, const Ray& ray, Hit& hit) {
    const RayArrays in(ray);
    Search<1, HitMode::Closest, NoCounts> query;
    run<Precision>(scene, in, query);
    hit.triangle = query.triangle[0];
    if (hit.triangle == kNoHit) return;
    refineHits<1>(scene, in.org, in.dir, in.tNear, in.tFar, query.triangle, query.levels,
                  query.path, &hit.t, &hit.u, &hit.v);
    hit.levels = query.levels[0];
    for (uint32_t l = 0; l < hit.levels; ++l) hit.path[l] = query.path[l][0];
}

template <template <int> class Precision>
bool occluded1(const ModelView& scene, const Ray& ray) {
    Search<1, HitMode::Any, NoCounts> query;
    run<Precision>(scene, RayArrays(ray), query);
    return query.blocked != 0;
}

template <template <int> class Precision>
void intersectTile(const ModelView& scene, const RayPacket* rays, HitPacket* hits) {
    using Query = Search<kPacketSize, HitMode::Closest, NoCounts>;
    LocalRays<kPacketSize> local[kTileVectors];
    Query query[kTileVectors];
    uint32_t lanes[kTileVectors];
    for (int v = 0; v < kTileVectors; ++v) {
        const RayArrays in(rays[v]);
        lanes[v] = prepareRays<kPacketSize, HitMode::Closest, NoCounts>(
            in.org, in.dir, in.tNear, in.tFar, in.active, local[v], query[v]);
    }
    TileTraversal<Precision, HitMode::Closest>::scene(scene, local, lanes, query);
    for (int v = 0; v < kTileVectors; ++v) {
        const RayArrays in(rays[v]);
        refineHits<kPacketSize>(scene, in.org, in.dir, in.tNear, in.tFar, query[v].triangle,
                                query[v].levels, query[v].path, hits[v].t, hits[v].u, hits[v].v);
        __builtin_memcpy(hits[v].triangle, query[v].triangle, sizeof hits[v].triangle);
        __builtin_memcpy(hits[v].levels, query[v].levels, sizeof hits[v].levels);
        __builtin_memcpy(hits[v].path, query[v].path, sizeof hits[v].path);
    }
}

template <template <int> class Precision>
void occludedTile(const ModelView& scene, const RayPacket* rays, uint32_t* blocked) {
    using Query = Search<kPacketSize, HitMode::Any, NoCounts>;
    LocalRays<kPacketSize> local[kTileVectors];
    Query query[kTileVectors];
    uint32_t lanes[kTileVectors];
    for (int v = 0; v < kTileVectors; ++v) {
        const RayArrays in(rays[v]);
        lanes[v] = prepareRays<kPacketSize, HitMode::Any, NoCounts>(
            in.org, in.dir, in.tNear, in.tFar, in.active, local[v], query[v]);
    }
    TileTraversal<Precision, HitMode::Any>::scene(scene, local, lanes, query);
    for (int v = 0; v < kTileVectors; ++v) blocked[v] = query[v].blocked;
}

#define SMART_STRINGIZE_(x) #x
#define SMART_STRINGIZE(x) SMART_STRINGIZE_(x)

} // namespace

const KernelTable kTable = {
    SMART_STRINGIZE(SMART_ISA),
    {intersect<Fast>, intersect<Watertight>},
    {occluded<Fast>, occluded<Watertight>},
    {intersect1<Fast>, intersect1<Watertight>},
    {occluded1<Fast>, occluded1<Watertight>},
    {intersectTile<Fast>, intersectTile<Watertight>},
    {occludedTile<Fast>, occludedTile<Watertight>},
    intersectCounted,
};

} // namespace smart::SMART_ISA

// SPDX-License-Identifier: MIT
// Compiled once for each instruction set, into namespace smart::SMART_ISA; fills its KernelTable.
#include <type_traits>

#include "libsmart/kernel/hit_refinement.h"
#include "libsmart/kernel/intersect.h"
#include "libsmart/kernel/hit_rounding.h"
#include "libsmart/kernel/kernels.h"
#include "libsmart/kernel/ray_preparation.h"
#include "libsmart/kernel/scene_traversal.h"

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

/// Fills `query` with what the rays hit, and `world` in the precise mode.
template <template <int> class Precision, int N, HitMode M, class Counter>
void run(const ModelView& scene, const RayArrays& in, WorldRays<N>& world,
         Search<N, M, Counter>& query) {
    typename Precision<N>::Rays rays;
    uint32_t legal;
    query.lastOfEqual = scene.lastOfEqual != 0;
    if constexpr (kIsPrecise<Precision>)
        legal = preparePreciseRays<N, M, Counter>(scene, in.org, in.dir, in.tNear, in.tFar,
                                                  in.active, rays, world, query);
    else
        legal = prepareRays<N, M, Counter>(in.org, in.dir, in.tNear, in.tFar, in.active, rays,
                                           world.scale, query);
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

template <template <int> class Precision, class Counter>
void closestHits(const ModelView& scene, const RayPacket& rays, HitPacket& hits, Counter counter) {
    const RayArrays in(rays);
    WorldRays<kPacketSize> world;
    Search<kPacketSize, HitMode::Closest, Counter> query;
    query.counter = counter;
    run<Precision>(scene, in, world, query);
    place<Precision>(scene, in, world, query, hits.t, hits.u, hits.v);
    __builtin_memcpy(hits.triangle, query.triangle, sizeof hits.triangle);
    __builtin_memcpy(hits.levels, query.levels, sizeof hits.levels);
    __builtin_memcpy(hits.path, query.path, sizeof hits.path);
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

template <template <int> class Precision>
void intersectAll1(const ModelView& scene, const Ray& ray, HitList& list) {
    const RayArrays in(ray);
    WorldRays<1> world;
    Search<1, HitMode::All, NoCounts> query;
    list.count = 0;
    query.all = &list;
    run<Precision>(scene, in, world, query);
    const uint32_t stored = list.count < list.capacity ? list.count : list.capacity;
    for (uint32_t i = 0; i < stored; ++i) {
        Hit& hit = list.hits[i];
        query.triangle[0] = hit.triangle;
        query.levels[0] = hit.levels;
        for (uint32_t l = 0; l < hit.levels; ++l) query.path[l][0] = hit.path[l];
        place<Precision>(scene, in, world, query, &hit.t, &hit.u, &hit.v);
    }
}

template <template <int> class Precision>
bool occluded1(const ModelView& scene, const Ray& ray) {
    WorldRays<1> world;
    Search<1, HitMode::Any, NoCounts> query;
    run<Precision>(scene, RayArrays(ray), world, query);
    return query.blocked != 0;
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
    {intersectAll1<Fast>, intersectAll1<Watertight>, intersectAll1<Precise>},
    {intersectCounted<Fast>, intersectCounted<Watertight>, intersectCounted<Precise>},
};

} // namespace smart::SMART_ISA

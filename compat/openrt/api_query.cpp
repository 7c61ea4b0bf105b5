// SPDX-License-Identifier: MIT
#include "compat/openrt/frame_callback.h"
#include "compat/openrt/guard.h"
#include "compat/openrt/query_handles.h"
#include "compat/openrt/tokens.h"
#include "openrt/rt_query.h"

using namespace smart;
using namespace smart::compat;

namespace {

constexpr std::ptrdiff_t kRayWords = sizeof(RTray) / sizeof(float);
constexpr std::ptrdiff_t kHitWords = sizeof(RThit) / sizeof(float);
static_assert(sizeof(RTray) == 32 && sizeof(RThit) == 40);
static_assert(RT_HIT_BACK == 1); // what intersect() writes

/// Legal with any context or none; in a context not between begin and end, nor in frame callbacks.
template <class Body>
void query(const char* function, Body&& body) noexcept {
    if (refusedInCallback(function) || whyUnusable()) return;
    try {
        if (Context* context = currentContext()) context->recorder().requireOutsidePrimitive();
        body();
    } catch (...) {
        report(function);
    }
}

/// To the context of the calling thread: nothing is shared between threads.
void countRays(RTsizei count) noexcept {
    if (Context* context = currentContext()) context->recorder().countQueryRays(uint64_t(count));
}

ScenePtr checked(RTuint handle, const void* rays, const void* out, RTsizei count) {
    ScenePtr scene = findQueryScene(handle);
    if (!scene) throwError(ErrorCode::InvalidValue, "no compiled scene has this handle");
    if (count < 0) throwError(ErrorCode::InvalidValue, "count is negative");
    if (count > 0) {
        requirePointer(rays, "rays");
        requirePointer(out, "the place for the results");
    }
    return scene;
}

RayStream streamOf(const RTray* r) {
    return {{&r->origin[0], &r->origin[1], &r->origin[2]},
            {&r->direction[0], &r->direction[1], &r->direction[2]},
            &r->tnear,
            &r->tfar,
            false,
            kRayWords};
}

RayStream streamOf(const RTraystream& r) {
    for (const float* pointer : {r.ox, r.oy, r.oz, r.dx, r.dy, r.dz})
        requirePointer(pointer, "an origin or direction");
    if (r.flags & ~RTbitfield(RT_COMMON_ORIGIN))
        throwError(ErrorCode::InvalidValue, "unknown flags of a ray stream");
    return {{r.ox, r.oy, r.oz}, {r.dx, r.dy, r.dz}, r.tnear, r.tfar,
            (r.flags & RT_COMMON_ORIGIN) != 0};
}

} // namespace

RTAPI RTuint RTAPIENTRY rtCompileScene(void) {
    return guardedOr<RTuint>(RT_INVALID, __func__, [](Context& c) {
        return addQueryScene(c.recorder().compileScene());
    });
}

RTAPI void RTAPIENTRY rtReleaseScene(RTuint handle) {
    query(__func__, [&] {
        if (!releaseQueryScene(handle))
            throwError(ErrorCode::InvalidValue, "no compiled scene has this handle");
    });
}

RTAPI void RTAPIENTRY rtIntersect(RTuint handle, const RTray* rays, RThit* hits, RTsizei count,
                                  RTenum coherence) {
    query(__func__, [&] {
        const Coherence how = coherenceOf(coherence);
        const ScenePtr scene = checked(handle, rays, hits, count);
        if (count == 0) return;
        const HitStream out{&hits->t,        &hits->u,      &hits->v,
                            &hits->primitive, &hits->object, &hits->instance,
                            {&hits->normal[0], &hits->normal[1], &hits->normal[2]},
                            &hits->flags,    kHitWords};
        intersect(*scene, streamOf(rays), out, std::size_t(count), how);
        countRays(count);
    });
}

RTAPI void RTAPIENTRY rtIntersectStream(RTuint handle, const RTraystream* rays, RThitstream* hits,
                                        RTsizei count, RTenum coherence) {
    query(__func__, [&] {
        const Coherence how = coherenceOf(coherence);
        const ScenePtr scene = checked(handle, rays, hits, count);
        if (count == 0) return;
        const HitStream out{hits->t,         hits->u,      hits->v,
                            hits->primitive, hits->object, hits->instance,
                            {hits->nx, hits->ny, hits->nz},
                            nullptr};
        intersect(*scene, streamOf(*rays), out, std::size_t(count), how);
        countRays(count);
    });
}

RTAPI void RTAPIENTRY rtOccluded(RTuint handle, const RTray* rays, RTubyte* blocked, RTsizei count,
                                 RTenum coherence) {
    query(__func__, [&] {
        const Coherence how = coherenceOf(coherence);
        const ScenePtr scene = checked(handle, rays, blocked, count);
        if (count == 0) return;
        occluded(*scene, streamOf(rays), blocked, std::size_t(count), how);
        countRays(count);
    });
}

RTAPI void RTAPIENTRY rtOccludedStream(RTuint handle, const RTraystream* rays, RTubyte* blocked,
                                       RTsizei count, RTenum coherence) {
    query(__func__, [&] {
        const Coherence how = coherenceOf(coherence);
        const ScenePtr scene = checked(handle, rays, blocked, count);
        if (count == 0) return;
        occluded(*scene, streamOf(*rays), blocked, std::size_t(count), how);
        countRays(count);
    });
}

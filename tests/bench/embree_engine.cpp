// SPDX-License-Identifier: MIT
#include "tests/bench/embree_engine.h"

#include <pmmintrin.h>
#include <xmmintrin.h>

#include <algorithm>

#include "tests/bench/embree_scene.h"

namespace smart::bench {
namespace {

/// Rays of Embree by width: its types and functions under one name.
template <int N>
struct Wide;
template <>
struct Wide<4> {
    using Rays = RTCRay4;
    using RayHits = RTCRayHit4;
    static constexpr auto intersect = rtcIntersect4;
    static constexpr auto occluded = rtcOccluded4;
};
template <>
struct Wide<8> {
    using Rays = RTCRay8;
    using RayHits = RTCRayHit8;
    static constexpr auto intersect = rtcIntersect8;
    static constexpr auto occluded = rtcOccluded8;
};
template <>
struct Wide<16> {
    using Rays = RTCRay16;
    using RayHits = RTCRayHit16;
    static constexpr auto intersect = rtcIntersect16;
    static constexpr auto occluded = rtcOccluded16;
};

/// Lanes first..first+N-1 of a packet.
template <int N>
void fill(const RayPacket& packet, int first, typename Wide<N>::Rays& ray, int* valid) {
    std::copy_n(packet.org[0] + first, N, ray.org_x);
    std::copy_n(packet.org[1] + first, N, ray.org_y);
    std::copy_n(packet.org[2] + first, N, ray.org_z);
    std::copy_n(packet.dir[0] + first, N, ray.dir_x);
    std::copy_n(packet.dir[1] + first, N, ray.dir_y);
    std::copy_n(packet.dir[2] + first, N, ray.dir_z);
    std::copy_n(packet.tNear + first, N, ray.tnear);
    std::copy_n(packet.tFar + first, N, ray.tfar);
    std::fill_n(ray.time, N, 0.0f);
    std::fill_n(ray.mask, N, ~0u);
    std::fill_n(ray.flags, N, 0u);
    for (int i = 0; i < N; ++i) valid[i] = packet.active >> (first + i) & 1 ? -1 : 0;
}

template <int N>
void clearHits(typename Wide<N>::RayHits& work) {
    std::fill_n(work.hit.geomID, N, RTC_INVALID_GEOMETRY_ID);
    std::fill_n(work.hit.instID[0], N, RTC_INVALID_GEOMETRY_ID);
}

template <int N>
void read(const typename Wide<N>::RayHits& work, int first, Found& found) {
    for (int i = 0; i < N; ++i) {
        const bool hit = work.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
        found.t[first + i] = work.ray.tfar[i];
        found.triangle[first + i] = hit ? work.hit.primID[i] : kNoHit;
    }
}

template <int N>
uint32_t blockedOf(const typename Wide<N>::Rays& work, int first) {
    uint32_t mask = 0;
    for (int i = 0; i < N; ++i) mask |= uint32_t(work.tfar[i] < 0) << (first + i);
    return mask;
}

/// Rays without a lane in use: limits out of order, which streams take as nothing to do.
void fill(const RayPacket& packet, int i, RTCRay& ray) {
    const bool on = packet.active >> i & 1;
    ray.org_x = packet.org[0][i];
    ray.org_y = packet.org[1][i];
    ray.org_z = packet.org[2][i];
    ray.dir_x = packet.dir[0][i];
    ray.dir_y = packet.dir[1][i];
    ray.dir_z = packet.dir[2][i];
    ray.tnear = on ? packet.tNear[i] : 1;
    ray.tfar = on ? packet.tFar[i] : 0;
    ray.time = 0;
    ray.mask = ~0u;
    ray.flags = 0;
}

struct Variant {
    std::shared_ptr<const EmbreeScene> scene;
    bool coherent, robust;
    std::string name;
};

class EmbreeEngine : public Engine {
public:
    explicit EmbreeEngine(Variant variant) : variant_(std::move(variant)) {}
    std::string name() const override { return variant_.name; }
    bool peer() const override { return true; }
    bool robust() const override { return variant_.robust; }
    void enterThread() const override { // as Embree's manual asks for
        _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
        _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
    }

protected:
    RTCScene scene() const { return variant_.scene->scene(); }
    RTCIntersectContext context() const {
        RTCIntersectContext result;
        rtcInitIntersectContext(&result);
        if (variant_.coherent) result.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        return result;
    }

private:
    const Variant variant_;
};

/// Packets that are packed from our own rays inside the time.
template <int N>
class PacketsFromArrays final : public EmbreeEngine {
public:
    using EmbreeEngine::EmbreeEngine;
    void closest(const RaySet& rays, std::size_t first, std::size_t count,
                 Found* found) const override {
        RTCIntersectContext how = context();
        typename Wide<N>::RayHits work;
        alignas(64) int valid[N];
        for (std::size_t p = first; p < first + count; ++p) {
            if (!rays.packets[p].active) continue;
            for (int lane = 0; lane < kPacketSize; lane += N) {
                fill<N>(rays.packets[p], lane, work.ray, valid);
                clearHits<N>(work);
                Wide<N>::intersect(valid, scene(), &how, &work);
                read<N>(work, lane, found[p]);
            }
        }
    }
    void any(const RaySet& rays, std::size_t first, std::size_t count,
             uint32_t* blocked) const override {
        RTCIntersectContext how = context();
        typename Wide<N>::Rays work;
        alignas(64) int valid[N];
        for (std::size_t p = first; p < first + count; ++p) {
            blocked[p] = 0;
            if (!rays.packets[p].active) continue;
            for (int lane = 0; lane < kPacketSize; lane += N) {
                fill<N>(rays.packets[p], lane, work, valid);
                Wide<N>::occluded(valid, scene(), &how, &work);
                blocked[p] |= blockedOf<N>(work, lane);
            }
            blocked[p] &= rays.packets[p].active;
        }
    }
};

template <>
class PacketsFromArrays<1> final : public EmbreeEngine {
public:
    using EmbreeEngine::EmbreeEngine;
    void closest(const RaySet& rays, std::size_t first, std::size_t count,
                 Found* found) const override {
        RTCIntersectContext how = context();
        RTCRayHit work;
        for (std::size_t p = first; p < first + count; ++p) {
            for (int i = 0; i < kPacketSize; ++i) {
                if (!(rays.packets[p].active >> i & 1)) continue;
                fill(rays.packets[p], i, work.ray);
                work.hit.geomID = work.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
                rtcIntersect1(scene(), &how, &work);
                const bool hit = work.hit.geomID != RTC_INVALID_GEOMETRY_ID;
                found[p].t[i] = work.ray.tfar;
                found[p].triangle[i] = hit ? work.hit.primID : kNoHit;
            }
        }
    }
    void any(const RaySet& rays, std::size_t first, std::size_t count,
             uint32_t* blocked) const override {
        RTCIntersectContext how = context();
        RTCRay work;
        for (std::size_t p = first; p < first + count; ++p) {
            blocked[p] = 0;
            for (int i = 0; i < kPacketSize; ++i) {
                if (!(rays.packets[p].active >> i & 1)) continue;
                fill(rays.packets[p], i, work);
                rtcOccluded1(scene(), &how, &work);
                blocked[p] |= uint32_t(work.tfar < 0) << i;
            }
        }
    }
};

/// Packets that lie ready in Embree's own form, traced in place.
template <int N>
class ReadyPackets : public EmbreeEngine {
public:
    using EmbreeEngine::EmbreeEngine;
    void load(const RaySet& rays, Query query) override {
        const std::size_t count = rays.packets.size() * kPerPacket;
        valid_.resize(count);
        query_ = query;
        if (query == Query::Closest) rayHits_.resize(count);
        if (query == Query::Any) rays_.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            const RayPacket& packet = rays.packets[i / kPerPacket];
            const int lane = int(i % kPerPacket) * N;
            if (query == Query::Closest) {
                fill<N>(packet, lane, rayHits_[i].ray, valid_[i].lane);
                clearHits<N>(rayHits_[i]);
            } else {
                fill<N>(packet, lane, rays_[i], valid_[i].lane);
            }
        }
    }
    void closest(const RaySet&, std::size_t first, std::size_t count, Found*) const override {
        RTCIntersectContext how = context();
        for (std::size_t i = first * kPerPacket; i < (first + count) * kPerPacket; ++i)
            Wide<N>::intersect(valid_[i].lane, scene(), &how, &rayHits_[i]);
    }
    void any(const RaySet&, std::size_t first, std::size_t count, uint32_t*) const override {
        RTCIntersectContext how = context();
        for (std::size_t i = first * kPerPacket; i < (first + count) * kPerPacket; ++i)
            Wide<N>::occluded(valid_[i].lane, scene(), &how, &rays_[i]);
    }
    void unload(const RaySet& rays, Found* found, uint32_t* blocked) override {
        for (std::size_t p = 0; p < rays.packets.size(); ++p) {
            uint32_t mask = 0;
            for (std::size_t i = 0; i < kPerPacket; ++i) {
                const std::size_t at = p * kPerPacket + i;
                if (query_ == Query::Closest) read<N>(rayHits_[at], int(i) * N, found[p]);
                else mask |= blockedOf<N>(rays_[at], int(i) * N);
            }
            if (query_ == Query::Any) blocked[p] = mask & rays.packets[p].active;
        }
        rayHits_ = {};
        rays_ = {};
        valid_ = {};
    }

protected:
    static constexpr std::size_t kPerPacket = std::size_t(kPacketSize / N);

    struct alignas(sizeof(int) * N) Valid {
        int lane[N];
    };
    mutable std::vector<typename Wide<N>::RayHits> rayHits_; // Embree writes its answers there
    mutable std::vector<typename Wide<N>::Rays> rays_;
    std::vector<Valid> valid_;
    Query query_ = Query::Closest;
};

/// Streams of packets of 16.
class StreamOfPackets final : public ReadyPackets<16> {
public:
    using ReadyPackets<16>::ReadyPackets;
    void load(const RaySet& rays, Query query) override {
        ReadyPackets<16>::load(rays, query);
        for (std::size_t p = 0; p < rays.packets.size(); ++p) {
            float* const tnear =
                query == Query::Closest ? rayHits_[p].ray.tnear : rays_[p].tnear;
            float* const tfar = query == Query::Closest ? rayHits_[p].ray.tfar : rays_[p].tfar;
            for (int i = 0; i < kPacketSize; ++i) {
                if (rays.packets[p].active >> i & 1) continue;
                tnear[i] = 1; // streams have no mask
                tfar[i] = 0;
            }
        }
    }
    void closest(const RaySet&, std::size_t first, std::size_t count, Found*) const override {
        RTCIntersectContext how = context();
        rtcIntersectNM(scene(), &how, reinterpret_cast<RTCRayHitN*>(&rayHits_[first]), 16,
                       unsigned(count), sizeof(RTCRayHit16));
    }
    void any(const RaySet&, std::size_t first, std::size_t count, uint32_t*) const override {
        RTCIntersectContext how = context();
        rtcOccludedNM(scene(), &how, reinterpret_cast<RTCRayN*>(&rays_[first]), 16,
                      unsigned(count), sizeof(RTCRay16));
    }
};

/// Single rays, each in its own structure: one call a ray, or a stream of them.
class ReadySingles final : public EmbreeEngine {
public:
    ReadySingles(Variant variant, bool stream) : EmbreeEngine(std::move(variant)), stream_(stream) {}
    void load(const RaySet& rays, Query query) override {
        const std::size_t count = rays.packets.size() * kPacketSize;
        query_ = query;
        if (query == Query::Closest) rayHits_.resize(count);
        if (query == Query::Any) rays_.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            RTCRay& ray = query == Query::Closest ? rayHits_[i].ray : rays_[i];
            fill(rays.packets[i / kPacketSize], int(i % kPacketSize), ray);
            if (query == Query::Any) continue;
            rayHits_[i].hit.geomID = rayHits_[i].hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        }
    }
    void closest(const RaySet& rays, std::size_t first, std::size_t count, Found*) const override {
        RTCIntersectContext how = context();
        const std::size_t at = first * kPacketSize;
        if (stream_)
            rtcIntersect1M(scene(), &how, &rayHits_[at], unsigned(count * kPacketSize),
                           sizeof(RTCRayHit));
        else
            forEach(rays, first, count,
                    [&](std::size_t i) { rtcIntersect1(scene(), &how, &rayHits_[i]); });
    }
    void any(const RaySet& rays, std::size_t first, std::size_t count, uint32_t*) const override {
        RTCIntersectContext how = context();
        const std::size_t at = first * kPacketSize;
        if (stream_)
            rtcOccluded1M(scene(), &how, &rays_[at], unsigned(count * kPacketSize), sizeof(RTCRay));
        else
            forEach(rays, first, count,
                    [&](std::size_t i) { rtcOccluded1(scene(), &how, &rays_[i]); });
    }
    void unload(const RaySet& rays, Found* found, uint32_t* blocked) override {
        for (std::size_t p = 0; p < rays.packets.size(); ++p) {
            if (query_ == Query::Any) blocked[p] = 0;
            for (std::size_t i = 0; i < std::size_t(kPacketSize); ++i) {
                if (!(rays.packets[p].active >> i & 1)) continue;
                const std::size_t at = p * kPacketSize + i;
                if (query_ == Query::Any) {
                    blocked[p] |= uint32_t(rays_[at].tfar < 0) << i;
                    continue;
                }
                const RTCHit& hit = rayHits_[at].hit;
                found[p].t[i] = rayHits_[at].ray.tfar;
                found[p].triangle[i] = hit.geomID != RTC_INVALID_GEOMETRY_ID ? hit.primID : kNoHit;
            }
        }
        rayHits_ = {};
        rays_ = {};
    }

private:
    template <class Trace>
    static void forEach(const RaySet& rays, std::size_t first, std::size_t count,
                        const Trace& trace) {
        for (std::size_t p = first; p < first + count; ++p) {
            for (std::size_t i = 0; i < std::size_t(kPacketSize); ++i)
                if (rays.packets[p].active >> i & 1) trace(p * kPacketSize + i);
        }
    }
    mutable std::vector<RTCRayHit> rayHits_;
    mutable std::vector<RTCRay> rays_;
    Query query_ = Query::Closest;
    const bool stream_;
};

/// Streams over arrays: what Embree writes to lies in arrays of its own.
class StreamOfArrays final : public EmbreeEngine {
public:
    using EmbreeEngine::EmbreeEngine;
    void load(const RaySet& rays, Query query) override {
        query_ = query;
        const std::size_t count = rays.tFar.size();
        tFar_ = rays.tFar;
        time_.assign(count, 0.0f);
        mask_.assign(count, ~0u);
        id_.assign(count, 0u);
        flags_.assign(count, 0u);
        if (query == Query::Any) return;
        geometry_.assign(count, RTC_INVALID_GEOMETRY_ID);
        instance_.assign(count, RTC_INVALID_GEOMETRY_ID);
        primitive_.resize(count);
        for (std::vector<float>& values : values_) values.resize(count);
    }
    void closest(const RaySet& rays, std::size_t first, std::size_t count, Found*) const override {
        RTCIntersectContext how = context();
        const std::size_t at = first * kPacketSize;
        RTCRayHitNp work;
        work.ray = pointers(rays, at);
        work.hit = {&values_[0][at], &values_[1][at],  &values_[2][at], &values_[3][at],
                    &values_[4][at], &primitive_[at], &geometry_[at],  {&instance_[at]}};
        rtcIntersectNp(scene(), &how, &work, unsigned(count * kPacketSize));
    }
    void any(const RaySet& rays, std::size_t first, std::size_t count, uint32_t*) const override {
        RTCIntersectContext how = context();
        const RTCRayNp work = pointers(rays, first * kPacketSize);
        rtcOccludedNp(scene(), &how, &work, unsigned(count * kPacketSize));
    }
    void unload(const RaySet& rays, Found* found, uint32_t* blocked) override {
        for (std::size_t p = 0; p < rays.packets.size(); ++p) {
            if (query_ == Query::Any) blocked[p] = 0;
            for (std::size_t i = 0; i < std::size_t(kPacketSize); ++i) {
                if (!(rays.packets[p].active >> i & 1)) continue;
                const std::size_t at = p * kPacketSize + i;
                if (query_ == Query::Any) {
                    blocked[p] |= uint32_t(tFar_[at] < 0) << i;
                    continue;
                }
                found[p].t[i] = tFar_[at];
                found[p].triangle[i] =
                    geometry_[at] != RTC_INVALID_GEOMETRY_ID ? primitive_[at] : kNoHit;
            }
        }
    }

private:
    RTCRayNp pointers(const RaySet& rays, std::size_t at) const {
        const auto inputs = [at](const std::vector<float>& values) { // Embree only reads these
            return const_cast<float*>(values.data()) + at;
        };
        return {inputs(rays.org[0]), inputs(rays.org[1]), inputs(rays.org[2]), inputs(rays.tNear),
                inputs(rays.dir[0]), inputs(rays.dir[1]), inputs(rays.dir[2]), &time_[at],
                &tFar_[at],          &mask_[at],          &id_[at],            &flags_[at]};
    }
    mutable std::vector<float> tFar_, time_, values_[5];
    mutable std::vector<uint32_t> mask_, id_, flags_, primitive_, geometry_, instance_;
    Query query_ = Query::Closest;
};

template <int N>
void addPackets(std::vector<EnginePtr>& engines, const Variant& variant, const std::string& tail) {
    const std::string head = "embree " + std::to_string(N) + variant.name;
    Variant arrays = variant, packed = variant;
    arrays.name = head + " arrays" + tail;
    packed.name = head + " packed" + tail;
    engines.push_back(std::make_unique<PacketsFromArrays<N>>(std::move(arrays)));
    if constexpr (N == 1)
        engines.push_back(std::make_unique<ReadySingles>(std::move(packed), false));
    else
        engines.push_back(std::make_unique<ReadyPackets<N>>(std::move(packed)));
}

} // namespace

BuildReport buildEmbree(const std::vector<Triangle>& triangles, EmbreeQuality quality,
                        unsigned threads) {
    return EmbreeScene(triangles, quality, false, threads, "").report();
}

std::vector<EnginePtr> embreeEngines(const std::vector<Triangle>& triangles, EmbreeQuality quality,
                                     bool robust, unsigned threads, const std::string& isa) {
    std::vector<EnginePtr> engines;
    const auto scene =
        std::make_shared<const EmbreeScene>(triangles, quality, robust, threads, isa);
    const std::string tail = std::string(quality == EmbreeQuality::High ? " high" : " medium") +
                             (robust ? " robust" : "");
    for (const bool coherent : {true, false}) {
        const std::string flag = coherent ? " coherent" : " incoherent";
        const Variant variant{scene, coherent, robust, flag};
        addPackets<1>(engines, variant, tail);
        addPackets<4>(engines, variant, tail);
        addPackets<8>(engines, variant, tail);
        addPackets<16>(engines, variant, tail);
        const auto named = [&](const char* form) {
            return Variant{scene, coherent, robust, "embree " + (form + flag) + tail};
        };
        engines.push_back(std::make_unique<ReadySingles>(named("1M"), true));
        engines.push_back(std::make_unique<StreamOfPackets>(named("NM")));
        engines.push_back(std::make_unique<StreamOfArrays>(named("Np")));
    }
    return engines;
}

std::vector<EnginePtr> embreeEngines(const std::vector<Triangle>& triangles, unsigned threads,
                                     const std::string& isa) {
    std::vector<EnginePtr> engines;
    for (const EmbreeQuality quality : {EmbreeQuality::Medium, EmbreeQuality::High}) {
        for (const bool robust : {false, true}) {
            for (EnginePtr& engine : embreeEngines(triangles, quality, robust, threads, isa))
                engines.push_back(std::move(engine));
        }
    }
    return engines;
}

} // namespace smart::bench

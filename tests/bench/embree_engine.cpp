// SPDX-License-Identifier: MIT
#include "tests/bench/embree_engine.h"

#include <embree3/rtcore.h>
#include <pmmintrin.h>
#include <xmmintrin.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstring>
#include <numeric>
#include <stdexcept>

namespace smart::bench {
namespace {

/// A committed scene. Vertices and indices are shared with it and not part of its bytes: its tree
/// holds copies of the triangles.
class EmbreeScene {
public:
    EmbreeScene(const std::vector<Triangle>& triangles, EmbreeQuality quality, bool robust,
                unsigned threads)
        : vertices_(triangles.size() * 9 + 4), indices_(triangles.size() * 3) {
        std::memcpy(vertices_.data(), triangles.data(), triangles.size() * sizeof(Triangle));
        std::iota(indices_.begin(), indices_.end(), 0u);
        const std::string config = "threads=" + std::to_string(threads);
        device_ = rtcNewDevice(config.c_str());
        if (!device_) throw std::runtime_error("Embree makes no device");
        rtcSetDeviceMemoryMonitorFunction(device_, &EmbreeScene::countBytes, &bytes_);
        scene_ = rtcNewScene(device_);
        rtcSetSceneBuildQuality(scene_, quality == EmbreeQuality::High ? RTC_BUILD_QUALITY_HIGH
                                                                       : RTC_BUILD_QUALITY_MEDIUM);
        if (robust) rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
        const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                   vertices_.data(), 0, 12, triangles.size() * 3);
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                   indices_.data(), 0, 12, triangles.size());
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        const std::ptrdiff_t before = bytes_;
        const auto start = std::chrono::steady_clock::now();
        rtcCommitScene(scene_);
        report_.seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        report_.bytes = std::size_t(bytes_ - before);
        if (rtcGetDeviceError(device_) != RTC_ERROR_NONE) {
            throw std::runtime_error("Embree reports an error at the build");
        }
    }
    ~EmbreeScene() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    RTCScene scene() const { return scene_; }
    const BuildReport& report() const { return report_; }

private:
    static bool countBytes(void* total, ssize_t bytes, bool) {
        *static_cast<std::atomic<std::ptrdiff_t>*>(total) += bytes;
        return true;
    }

    std::vector<float> vertices_;
    std::vector<uint32_t> indices_;
    std::atomic<std::ptrdiff_t> bytes_{0};
    RTCDevice device_;
    RTCScene scene_;
    BuildReport report_;
};

class EmbreeEngine : public Engine {
public:
    EmbreeEngine(std::shared_ptr<const EmbreeScene> scene, std::string name)
        : scene_(std::move(scene)), name_(std::move(name)) {}
    std::string name() const override { return name_; }
    bool peer() const override { return true; }
    void enterThread() const override { // as Embree's manual asks for
        _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
        _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
    }

protected:
    const std::shared_ptr<const EmbreeScene> scene_;

private:
    const std::string name_;
};

class EmbreePackets final : public EmbreeEngine {
public:
    using EmbreeEngine::EmbreeEngine;
    void closest(const RaySet& rays, std::size_t first, std::size_t count,
                 Found* found) const override {
        RTCIntersectContext context = coherent();
        RTCRayHit16 work;
        alignas(64) int valid[16];
        for (std::size_t p = first; p < first + count; ++p) {
            if (!rays.packets[p].active) continue;
            fill(rays.packets[p], work.ray, valid);
            std::fill(work.hit.geomID, work.hit.geomID + 16, RTC_INVALID_GEOMETRY_ID);
            std::fill(work.hit.instID[0], work.hit.instID[0] + 16, RTC_INVALID_GEOMETRY_ID);
            rtcIntersect16(valid, scene_->scene(), &context, &work);
            for (int i = 0; i < 16; ++i) {
                const bool hit = work.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
                found[p].t[i] = work.ray.tfar[i];
                found[p].triangle[i] = hit ? work.hit.primID[i] : kNoHit;
            }
        }
    }
    void any(const RaySet& rays, std::size_t first, std::size_t count,
             uint32_t* blocked) const override {
        RTCIntersectContext context = coherent();
        RTCRay16 work;
        alignas(64) int valid[16];
        for (std::size_t p = first; p < first + count; ++p) {
            blocked[p] = 0;
            if (!rays.packets[p].active) continue;
            fill(rays.packets[p], work, valid);
            rtcOccluded16(valid, scene_->scene(), &context, &work);
            uint32_t mask = 0;
            for (uint32_t i = 0; i < 16; ++i) mask |= uint32_t(work.tfar[i] < 0) << i;
            blocked[p] = mask & rays.packets[p].active;
        }
    }

private:
    static RTCIntersectContext coherent() {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        return context;
    }
    static void fill(const RayPacket& packet, RTCRay16& ray, int valid[16]) {
        std::copy_n(packet.org[0], 16, ray.org_x);
        std::copy_n(packet.org[1], 16, ray.org_y);
        std::copy_n(packet.org[2], 16, ray.org_z);
        std::copy_n(packet.dir[0], 16, ray.dir_x);
        std::copy_n(packet.dir[1], 16, ray.dir_y);
        std::copy_n(packet.dir[2], 16, ray.dir_z);
        std::copy_n(packet.tNear, 16, ray.tnear);
        std::copy_n(packet.tFar, 16, ray.tfar);
        std::fill(ray.time, ray.time + 16, 0.0f);
        std::fill(ray.mask, ray.mask + 16, ~0u);
        std::fill(ray.flags, ray.flags + 16, 0u);
        for (uint32_t i = 0; i < 16; ++i) valid[i] = packet.active >> i & 1 ? -1 : 0;
    }
};

class EmbreeSingles final : public EmbreeEngine {
public:
    using EmbreeEngine::EmbreeEngine;
    void closest(const RaySet& rays, std::size_t first, std::size_t count,
                 Found* found) const override {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRayHit work;
        for (std::size_t p = first; p < first + count; ++p) {
            for (int i = 0; i < 16; ++i) {
                if (!(rays.packets[p].active >> i & 1)) continue;
                fill(rays.packets[p], i, work.ray);
                work.hit.geomID = work.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
                rtcIntersect1(scene_->scene(), &context, &work);
                const bool hit = work.hit.geomID != RTC_INVALID_GEOMETRY_ID;
                found[p].t[i] = work.ray.tfar;
                found[p].triangle[i] = hit ? work.hit.primID : kNoHit;
            }
        }
    }
    void any(const RaySet& rays, std::size_t first, std::size_t count,
             uint32_t* blocked) const override {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRay work;
        for (std::size_t p = first; p < first + count; ++p) {
            blocked[p] = 0;
            for (int i = 0; i < 16; ++i) {
                if (!(rays.packets[p].active >> i & 1)) continue;
                fill(rays.packets[p], i, work);
                rtcOccluded1(scene_->scene(), &context, &work);
                blocked[p] |= uint32_t(work.tfar < 0) << i;
            }
        }
    }

private:
    static void fill(const RayPacket& packet, int i, RTCRay& ray) {
        ray.org_x = packet.org[0][i];
        ray.org_y = packet.org[1][i];
        ray.org_z = packet.org[2][i];
        ray.dir_x = packet.dir[0][i];
        ray.dir_y = packet.dir[1][i];
        ray.dir_z = packet.dir[2][i];
        ray.tnear = packet.tNear[i];
        ray.tfar = packet.tFar[i];
        ray.time = 0;
        ray.mask = ~0u;
        ray.flags = 0;
    }
};

} // namespace

BuildReport buildEmbree(const std::vector<Triangle>& triangles, EmbreeQuality quality,
                        unsigned threads) {
    return EmbreeScene(triangles, quality, false, threads).report();
}

std::vector<EnginePtr> embreeEngines(const std::vector<Triangle>& triangles, bool robust,
                                     unsigned threads) {
    std::vector<EnginePtr> engines;
    for (const EmbreeQuality quality : {EmbreeQuality::Medium, EmbreeQuality::High}) {
        const auto scene = std::make_shared<const EmbreeScene>(triangles, quality, robust, threads);
        const std::string tail = std::string(quality == EmbreeQuality::High ? " high" : " medium") +
                                 (robust ? " robust" : "");
        engines.push_back(std::make_unique<EmbreePackets>(scene, "embree packet" + tail));
        engines.push_back(std::make_unique<EmbreeSingles>(scene, "embree single" + tail));
    }
    return engines;
}

} // namespace smart::bench

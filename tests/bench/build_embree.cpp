// SPDX-License-Identifier: MIT
#include <embree3/rtcore.h>
#include <pmmintrin.h>
#include <xmmintrin.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <numeric>
#include <stdexcept>

#include "tests/bench/build_engine.h"

namespace smart::bench {
namespace {

class EmbreeTree final : public TracedTree {
public:
    EmbreeTree(const std::vector<Triangle>& triangles, unsigned threads)
        : vertices_(triangles.size() * 9 + 4), indices_(triangles.size() * 3) {
        std::memcpy(vertices_.data(), triangles.data(), triangles.size() * sizeof(Triangle));
        std::iota(indices_.begin(), indices_.end(), 0u);
        const std::string config = "threads=" + std::to_string(threads);
        device_ = rtcNewDevice(config.c_str());
        if (!device_) throw std::runtime_error("Embree makes no device");
        rtcSetDeviceMemoryMonitorFunction(device_, &EmbreeTree::countBytes, &bytes_);
        scene_ = rtcNewScene(device_);
    }
    ~EmbreeTree() override {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    EmbreeTree(const EmbreeTree&) = delete;
    EmbreeTree& operator=(const EmbreeTree&) = delete;

    void build(RTCBuildQuality quality, unsigned threads, double& seconds) {
        const bool refits = quality == RTC_BUILD_QUALITY_REFIT;
        rtcSetSceneBuildQuality(scene_, refits ? RTC_BUILD_QUALITY_LOW : quality);
        if (refits) rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_DYNAMIC);
        geometry_ = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        rtcSetGeometryBuildQuality(geometry_, quality);
        rtcSetSharedGeometryBuffer(geometry_, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                   vertices_.data(), 0, 12, indices_.size());
        rtcSetSharedGeometryBuffer(geometry_, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                   indices_.data(), 0, 12, indices_.size() / 3);
        rtcCommitGeometry(geometry_);
        rtcAttachGeometry(scene_, geometry_);
        rtcReleaseGeometry(geometry_);
        const std::ptrdiff_t before = bytes_;
        commit(threads, seconds);
        treeBytes_ = std::size_t(bytes_ - before);
    }
    void move(const std::vector<Triangle>& triangles, unsigned threads, double& seconds) {
        std::memcpy(vertices_.data(), triangles.data(), triangles.size() * sizeof(Triangle));
        rtcUpdateGeometryBuffer(geometry_, RTC_BUFFER_TYPE_VERTEX, 0);
        rtcCommitGeometry(geometry_);
        commit(threads, seconds);
    }

    std::size_t bytes() const override { return treeBytes_; }
    void closest(const RaySet& rays, bool coherent, Found* found) const override {
        const unsigned state = _mm_getcsr();
        _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON); // as Embree's manual asks for
        _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        if (coherent) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        RTCRayHit16 work;
        alignas(64) int valid[16];
        for (std::size_t p = 0; p < rays.packets.size(); ++p) {
            const RayPacket& packet = rays.packets[p];
            float* const org[] = {work.ray.org_x, work.ray.org_y, work.ray.org_z};
            float* const dir[] = {work.ray.dir_x, work.ray.dir_y, work.ray.dir_z};
            for (int k = 0; k < 3; ++k) {
                std::copy_n(packet.org[k], 16, org[k]);
                std::copy_n(packet.dir[k], 16, dir[k]);
            }
            std::copy_n(packet.tNear, 16, work.ray.tnear);
            std::copy_n(packet.tFar, 16, work.ray.tfar);
            std::fill_n(work.ray.time, 16, 0.0f);
            std::fill_n(work.ray.mask, 16, ~0u);
            std::fill_n(work.ray.flags, 16, 0u);
            std::fill_n(work.hit.geomID, 16, RTC_INVALID_GEOMETRY_ID);
            std::fill_n(work.hit.instID[0], 16, RTC_INVALID_GEOMETRY_ID);
            for (int i = 0; i < 16; ++i) valid[i] = packet.active >> i & 1 ? -1 : 0;
            rtcIntersect16(valid, scene_, &context, &work);
            for (int i = 0; i < 16; ++i) {
                const bool hit = work.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
                found[p].t[i] = work.ray.tfar[i];
                found[p].triangle[i] = hit ? work.hit.primID[i] : kNoHit;
            }
        }
        _mm_setcsr(state);
    }

private:
    static bool countBytes(void* total, ssize_t bytes, bool) {
        *static_cast<std::atomic<std::ptrdiff_t>*>(total) += bytes;
        return true;
    }
    void commit(unsigned threads, double& seconds) {
        const BuildClock clock(threads);
        rtcCommitScene(scene_);
        seconds = clock.seconds();
        if (rtcGetDeviceError(device_) != RTC_ERROR_NONE)
            throw std::runtime_error("Embree reports an error at the build");
    }

    std::vector<float> vertices_;
    std::vector<uint32_t> indices_;
    std::atomic<std::ptrdiff_t> bytes_{0};
    std::size_t treeBytes_ = 0;
    RTCDevice device_;
    RTCScene scene_;
    RTCGeometry geometry_ = nullptr; ///< the scene's
};

TreeBuilder builder(const std::string& name, RTCBuildQuality quality) {
    return {name, true,
            [quality](const std::vector<Triangle>& triangles, unsigned threads, double& seconds) {
                auto tree = std::make_unique<EmbreeTree>(triangles, threads);
                tree->build(quality, threads, seconds);
                return tree;
            }};
}

std::unique_ptr<TracedTree> refit(const std::vector<Triangle>& triangles, unsigned threads,
                                  double& seconds) {
    auto tree = std::make_unique<EmbreeTree>(bent(triangles), threads);
    tree->build(RTC_BUILD_QUALITY_REFIT, threads, seconds);
    tree->move(triangles, threads, seconds);
    return tree;
}

} // namespace

std::vector<TreeBuilder> embreeBuilders() {
    return {builder("embree high", RTC_BUILD_QUALITY_HIGH),
            builder("embree medium", RTC_BUILD_QUALITY_MEDIUM),
            builder("embree low", RTC_BUILD_QUALITY_LOW),
            {"embree refit", true, refit}};
}

} // namespace smart::bench

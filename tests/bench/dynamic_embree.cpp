// SPDX-License-Identifier: MIT
#include <embree3/rtcore.h>
#include <pmmintrin.h>
#include <xmmintrin.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <stdexcept>

#include "tests/bench/dynamic_engine.h"

namespace smart::bench {
namespace {

RTCBuildQuality qualityOf(EmbreeWay way) {
    return way == EmbreeWay::Medium ? RTC_BUILD_QUALITY_MEDIUM : RTC_BUILD_QUALITY_LOW;
}

/// Instances and sheets as Embree's manual says for scenes that change every frame.
class DynamicEmbree final : public DynamicEngine {
public:
    DynamicEmbree(const DynamicScene& scene, unsigned threads, EmbreeWay way)
        : scene_(scene), way_(way) {
        device_ = rtcNewDevice(("threads=" + std::to_string(threads)).c_str());
        if (!device_) throw std::runtime_error("Embree makes no device");
        rtcSetDeviceMemoryMonitorFunction(device_, &DynamicEmbree::countBytes, &bytes_);
        top_ = rtcNewScene(device_);
        if (way != EmbreeWay::Medium) rtcSetSceneFlags(top_, RTC_SCENE_FLAG_DYNAMIC);
        rtcSetSceneBuildQuality(top_, qualityOf(way));
        if (scene.isSheet())
            addSheet();
        else
            addInstances();
        check();
    }
    ~DynamicEmbree() override {
        rtcReleaseScene(top_);
        if (model_) rtcReleaseScene(model_);
        rtcReleaseDevice(device_);
    }
    DynamicEmbree(const DynamicEmbree&) = delete;
    DynamicEmbree& operator=(const DynamicEmbree&) = delete;

    std::string name() const override {
        const char* const built = way_ == EmbreeWay::Refit ? "refit"
                                  : way_ == EmbreeWay::Low ? "low"
                                                           : "medium";
        return std::string("embree ") + built;
    }
    bool peer() const override { return true; }

    void update(const DynamicStep& step) override {
        if (scene_.isSheet()) {
            const RTCGeometry sheet = rtcGetGeometry(top_, 0);
            std::memcpy(rtcGetGeometryBufferData(sheet, RTC_BUFFER_TYPE_VERTEX, 0),
                        step.points.data(), step.points.size() * sizeof(float));
            rtcUpdateGeometryBuffer(sheet, RTC_BUFFER_TYPE_VERTEX, 0);
            rtcCommitGeometry(sheet);
            return;
        }
        for (std::size_t i = 0; i < step.matrices.size(); ++i) {
            const RTCGeometry instance = rtcGetGeometry(top_, unsigned(i));
            rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR,
                                    step.matrices[i].data());
            rtcCommitGeometry(instance);
        }
    }

    void build() override {
        rtcCommitScene(top_);
        check();
    }

    void enterThread() const override { // as Embree's manual asks for
        _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
        _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
    }

    void trace(const RaySet& rays, std::size_t first, std::size_t count,
               DynamicFound* found) const override {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        RTCRayHit16 work;
        alignas(64) int valid[16];
        for (std::size_t p = first; p < first + count; ++p) {
            fill(rays.packets[p], work, valid);
            rtcIntersect16(valid, top_, &context, &work);
            for (int i = 0; i < 16; ++i) {
                const bool hit = work.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
                found[p].t[i] = work.ray.tfar[i];
                found[p].triangle[i] = hit ? work.hit.primID[i] : kNoHit;
                found[p].instance[i] = !hit                ? kNoHit
                                       : scene_.isSheet() ? 0
                                                           : work.hit.instID[0][i];
            }
        }
    }

    std::size_t bytes() const override {
        return std::size_t(std::max<std::ptrdiff_t>(bytes_ - modelBytes_, 0));
    }

private:
    static bool countBytes(void* total, ssize_t bytes, bool) {
        *static_cast<std::atomic<std::ptrdiff_t>*>(total) += bytes;
        return true;
    }
    void check() const {
        if (rtcGetDeviceError(device_) != RTC_ERROR_NONE)
            throw std::runtime_error("Embree reports an error");
    }

    void addSheet() {
        const DynamicStep step = scene_.step(0);
        const std::vector<uint32_t> indices = scene_.indices();
        const RTCGeometry sheet = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        std::memcpy(rtcSetNewGeometryBuffer(sheet, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                            12, step.points.size() / 3),
                    step.points.data(), step.points.size() * sizeof(float));
        std::memcpy(rtcSetNewGeometryBuffer(sheet, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12,
                                            indices.size() / 3),
                    indices.data(), indices.size() * sizeof(uint32_t));
        rtcSetGeometryBuildQuality(
            sheet, way_ == EmbreeWay::Refit ? RTC_BUILD_QUALITY_REFIT : qualityOf(way_));
        rtcCommitGeometry(sheet);
        rtcAttachGeometryByID(top_, sheet, 0);
        rtcReleaseGeometry(sheet);
        rtcCommitScene(top_);
    }

    void addInstances() {
        model_ = rtcNewScene(device_);
        const RTCGeometry mesh = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        const std::size_t count = scene_.triangles().size();
        std::memcpy(rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12,
                                            count * 3),
                    scene_.triangles().data(), count * sizeof(Triangle));
        auto* const index = static_cast<uint32_t*>(rtcSetNewGeometryBuffer(
            mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, count));
        for (uint32_t i = 0; i < 3 * count; ++i) index[i] = i;
        rtcCommitGeometry(mesh);
        rtcAttachGeometry(model_, mesh);
        rtcReleaseGeometry(mesh);
        rtcCommitScene(model_);
        modelBytes_ = bytes_;
        for (uint32_t i = 0; i < scene_.instances(); ++i) {
            const RTCGeometry instance = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_INSTANCE);
            rtcSetGeometryInstancedScene(instance, model_);
            rtcAttachGeometryByID(top_, instance, i);
            rtcReleaseGeometry(instance);
        }
    }

    static void fill(const RayPacket& packet, RTCRayHit16& work, int valid[16]) {
        RTCRay16& ray = work.ray;
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
        std::fill(work.hit.geomID, work.hit.geomID + 16, RTC_INVALID_GEOMETRY_ID);
        std::fill(work.hit.instID[0], work.hit.instID[0] + 16, RTC_INVALID_GEOMETRY_ID);
        for (uint32_t i = 0; i < 16; ++i) valid[i] = packet.active >> i & 1 ? -1 : 0;
    }

    const DynamicScene& scene_;
    const EmbreeWay way_;
    std::atomic<std::ptrdiff_t> bytes_{0};
    std::ptrdiff_t modelBytes_ = 0;
    RTCDevice device_ = nullptr;
    RTCScene top_ = nullptr, model_ = nullptr;
};

} // namespace

DynamicEnginePtr dynamicEmbree(const DynamicScene& scene, unsigned threads, EmbreeWay way) {
    return std::make_unique<DynamicEmbree>(scene, threads, way);
}

} // namespace smart::bench

// SPDX-License-Identifier: MIT
#include "tests/accuracy/engine.h"

#ifdef OPENRT_ACCURACY_EMBREE
#include <embree3/rtcore.h>

#include <algorithm>
#include <cstring>
#include <numeric>
#include <stdexcept>
#endif

namespace smart::test {

#ifdef OPENRT_ACCURACY_EMBREE
namespace {

RTCDevice device() {
    static const RTCDevice shared = rtcNewDevice("threads=2");
    if (!shared) throw std::runtime_error("Embree makes no device");
    return shared;
}

/// Instances only where the geometry has some.
class EmbreeScene {
public:
    EmbreeScene(const Geometry& geometry, bool robust) : robust_(robust) {
        for (const auto& mesh : geometry.meshes) meshes_.push_back(meshScene(mesh));
        uint32_t next = 0;
        for (const Placement& placement : geometry.placements) {
            first_.push_back(next);
            next += uint32_t(geometry.meshes[placement.mesh].size());
        }
        if (geometry.plain()) return;
        top_ = newScene();
        for (const Placement& placement : geometry.placements) {
            const RTCGeometry instance = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_INSTANCE);
            rtcSetGeometryInstancedScene(instance, meshes_[placement.mesh]);
            float rows[12];
            std::copy_n(placement.toWorld.data(), 12, rows);
            rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT3X4_ROW_MAJOR, rows);
            rtcCommitGeometry(instance);
            rtcAttachGeometry(top_, instance);
            rtcReleaseGeometry(instance);
        }
        rtcCommitScene(top_);
    }
    ~EmbreeScene() {
        if (top_) rtcReleaseScene(top_);
        for (const RTCScene scene : meshes_) rtcReleaseScene(scene);
    }
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    RTCScene scene() const { return top_ ? top_ : meshes_[0]; }
    Claim claim(unsigned geometry, unsigned triangle, unsigned instance, float t, float u,
                float v) const {
        if (geometry == RTC_INVALID_GEOMETRY_ID) return {};
        return {first_[instance == RTC_INVALID_GEOMETRY_ID ? 0 : instance] + triangle, t, u, v};
    }

private:
    RTCScene newScene() const {
        const RTCScene scene = rtcNewScene(device());
        if (robust_) rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
        return scene;
    }
    RTCScene meshScene(const std::vector<Triangle>& mesh) const {
        const RTCScene scene = newScene();
        const RTCGeometry geometry = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_TRIANGLE);
        void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                 RTC_FORMAT_FLOAT3, 12, mesh.size() * 3);
        std::memcpy(vertices, mesh.data(), mesh.size() * sizeof(Triangle));
        auto* indices = static_cast<uint32_t*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, mesh.size()));
        std::iota(indices, indices + mesh.size() * 3, 0u);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene);
        return scene;
    }

    const bool robust_;
    std::vector<RTCScene> meshes_;
    std::vector<uint32_t> first_;
    RTCScene top_ = nullptr;
};

class EmbreeSingles final : public Engine {
public:
    EmbreeSingles(const Geometry& geometry, bool robust) : scene_(geometry, robust) {}
    void trace(std::span<const Ray> rays, Claim* claims) const override {
        for (const Ray& ray : rays) {
            RTCIntersectContext context;
            rtcInitIntersectContext(&context);
            RTCRayHit work{};
            RTCRay& r = work.ray;
            r.org_x = ray.org[0], r.org_y = ray.org[1], r.org_z = ray.org[2];
            r.dir_x = ray.dir[0], r.dir_y = ray.dir[1], r.dir_z = ray.dir[2];
            r.tnear = ray.tNear, r.tfar = ray.tFar;
            r.mask = ~0u;
            work.hit.geomID = work.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
            rtcIntersect1(scene_.scene(), &context, &work);
            const RTCHit& hit = work.hit;
            *claims++ = scene_.claim(hit.geomID, hit.primID, hit.instID[0], r.tfar, hit.u, hit.v);
        }
    }

private:
    const EmbreeScene scene_;
};

class EmbreePackets final : public Engine {
public:
    EmbreePackets(const Geometry& geometry, bool robust) : scene_(geometry, robust) {}
    void trace(std::span<const Ray> rays, Claim* claims) const override {
        for (std::size_t first = 0; first < rays.size(); first += 16) {
            RTCIntersectContext context;
            rtcInitIntersectContext(&context);
            RTCRayHit16 work{};
            RTCRay16& r = work.ray;
            alignas(64) int valid[16];
            const std::size_t count = std::min<std::size_t>(16, rays.size() - first);
            for (std::size_t i = 0; i < 16; ++i) {
                const Ray& ray = rays[first + std::min(i, count - 1)];
                valid[i] = i < count ? -1 : 0;
                r.org_x[i] = ray.org[0], r.org_y[i] = ray.org[1], r.org_z[i] = ray.org[2];
                r.dir_x[i] = ray.dir[0], r.dir_y[i] = ray.dir[1], r.dir_z[i] = ray.dir[2];
                r.tnear[i] = ray.tNear, r.tfar[i] = ray.tFar;
                r.mask[i] = ~0u;
                work.hit.geomID[i] = work.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
            }
            rtcIntersect16(valid, scene_.scene(), &context, &work);
            const RTCHit16& hit = work.hit;
            for (std::size_t i = 0; i < count; ++i) {
                *claims++ = scene_.claim(hit.geomID[i], hit.primID[i], hit.instID[0][i], r.tfar[i],
                                         hit.u[i], hit.v[i]);
            }
        }
    }

private:
    const EmbreeScene scene_;
};

template <typename Form>
EngineKind kind(const char* name, bool robust) {
    EngineKind result;
    result.name = name;
    result.aborts = true;
    result.make = [robust](const Geometry& geometry) -> EnginePtr {
        return std::make_unique<Form>(geometry, robust);
    };
    return result;
}

} // namespace

std::vector<EngineKind> embreeKinds() {
    return {kind<EmbreeSingles>("embree", false), kind<EmbreeSingles>("embree-robust", true),
            kind<EmbreePackets>("embree-packet", false),
            kind<EmbreePackets>("embree-packet-robust", true)};
}

std::string embreeVersion() {
    const auto number = rtcGetDeviceProperty(device(), RTC_DEVICE_PROPERTY_VERSION);
    return std::to_string(number / 10000) + "." + std::to_string(number / 100 % 100) + "." +
           std::to_string(number % 100);
}

#else

std::vector<EngineKind> embreeKinds() {
    return {};
}
std::string embreeVersion() {
    return "";
}

#endif

} // namespace smart::test

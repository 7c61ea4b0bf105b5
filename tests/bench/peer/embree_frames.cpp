// SPDX-License-Identifier: MIT
#include "tests/bench/peer/embree_frames.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <stdexcept>

#include "tests/bench/peer/embree_tiles.h"

namespace smart::bench {
namespace {

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

RTCBuildQuality qualityOf(PeerWay way) {
    return way == PeerWay::Medium ? RTC_BUILD_QUALITY_MEDIUM : RTC_BUILD_QUALITY_LOW;
}

} // namespace

void PeerRays::add(const PeerRays& more) {
    primary += more.primary;
    shadow += more.shadow;
    reflected += more.reflected;
    hits += more.hits;
}

EmbreeFrames::EmbreeFrames(PeerWay way, unsigned threads)
    : way_(way),
      threads_(threads),
      device_(rtcNewDevice(("threads=" + std::to_string(threads)).c_str())) {
    if (!device_) throw std::runtime_error("Embree makes no device");
    top_ = rtcNewScene(device_);
    if (way != PeerWay::Medium) rtcSetSceneFlags(top_, RTC_SCENE_FLAG_DYNAMIC);
    rtcSetSceneBuildQuality(top_, qualityOf(way));
}

EmbreeFrames::~EmbreeFrames() {
    rtcReleaseScene(top_);
    for (auto& [id, object] : objects_) release(object);
    rtcReleaseDevice(device_);
}

void EmbreeFrames::check() const {
    if (rtcGetDeviceError(device_) != RTC_ERROR_NONE)
        throw std::runtime_error("Embree reports an error");
}

void EmbreeFrames::release(Object& object) {
    if (object.mesh) rtcReleaseGeometry(object.mesh);
    if (object.scene) rtcReleaseScene(object.scene);
    object.mesh = nullptr;
    object.scene = nullptr;
}

void EmbreeFrames::build(Object& object, std::span<const float> points,
                         std::span<const uint32_t> corners, RTCBuildQuality quality) {
    const double begun = now();
    release(object);
    object.points = points.size() / 3;
    object.corners = corners.size();
    object.scene = rtcNewScene(device_);
    if (object.deforms) rtcSetSceneFlags(object.scene, RTC_SCENE_FLAG_DYNAMIC);
    rtcSetSceneBuildQuality(object.scene,
                            quality == RTC_BUILD_QUALITY_REFIT ? RTC_BUILD_QUALITY_LOW : quality);
    object.mesh = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetGeometryBuildQuality(object.mesh, quality);
    std::memcpy(rtcSetNewGeometryBuffer(object.mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                        12, object.points),
                points.data(), points.size_bytes());
    std::memcpy(rtcSetNewGeometryBuffer(object.mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12,
                                        corners.size() / 3),
                corners.data(), corners.size_bytes());
    rtcCommitGeometry(object.mesh);
    rtcAttachGeometry(object.scene, object.mesh);
    rtcCommitScene(object.scene);
    check();
    committing_ += now() - begun;
}

void EmbreeFrames::define(uint32_t id, std::span<const float> points,
                          std::span<const uint32_t> corners, bool lasting, bool reflecting) {
    Object& object = objects_[id];
    object.reflecting = reflecting;
    build(object, points, corners, lasting ? RTC_BUILD_QUALITY_MEDIUM : qualityOf(way_));
}

void EmbreeFrames::redefine(uint32_t id, std::span<const float> points,
                            std::span<const uint32_t> corners) {
    build(objects_.at(id), points, corners, qualityOf(way_));
}

void EmbreeFrames::move(uint32_t id, std::size_t first, std::span<const float> points) {
    Object& object = objects_.at(id);
    if (!object.deforms) { // only now is it known; no frame after the first pays for this
        const auto bufferOf = [&](RTCBufferType type) {
            return rtcGetGeometryBufferData(object.mesh, type, 0);
        };
        const auto* const p = static_cast<const float*>(bufferOf(RTC_BUFFER_TYPE_VERTEX));
        const auto* const c = static_cast<const uint32_t*>(bufferOf(RTC_BUFFER_TYPE_INDEX));
        const std::vector<float> old(p, p + 3 * object.points);
        const std::vector<uint32_t> corners(c, c + object.corners);
        object.deforms = true;
        build(object, old, corners,
              way_ == PeerWay::Refit ? RTC_BUILD_QUALITY_REFIT : qualityOf(way_));
    }
    const double begun = now();
    std::memcpy(
        static_cast<float*>(rtcGetGeometryBufferData(object.mesh, RTC_BUFFER_TYPE_VERTEX, 0)) +
            3 * first,
        points.data(), points.size_bytes());
    rtcUpdateGeometryBuffer(object.mesh, RTC_BUFFER_TYPE_VERTEX, 0);
    rtcCommitGeometry(object.mesh);
    rtcCommitScene(object.scene);
    check();
    committing_ += now() - begun;
}

void EmbreeFrames::remove(uint32_t id) {
    const auto found = objects_.find(id);
    if (found == objects_.end()) return;
    release(found->second);
    objects_.erase(found);
}

RTCScene EmbreeFrames::ready(const PeerFrame& frame) {
    if (frame.instances.size() == 1 && frame.instances[0].identity)
        return objects_.at(frame.instances[0].object).scene;
    for (std::size_t i = 0; i < frame.instances.size(); ++i) {
        const PeerFrame::Instance& instance = frame.instances[i];
        const RTCScene scene = objects_.at(instance.object).scene;
        if (i == placed_.size()) {
            const RTCGeometry added = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_INSTANCE);
            rtcSetGeometryInstancedScene(added, scene);
            rtcAttachGeometryByID(top_, added, unsigned(i));
            rtcReleaseGeometry(added);
            placed_.push_back(scene);
        }
        const RTCGeometry place = rtcGetGeometry(top_, unsigned(i));
        if (placed_[i] != scene) {
            if (!placed_[i]) rtcEnableGeometry(place);
            rtcSetGeometryInstancedScene(place, scene);
            placed_[i] = scene;
        }
        rtcSetGeometryTransform(place, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, instance.toEye.data());
        rtcCommitGeometry(place);
    }
    for (std::size_t i = frame.instances.size(); i < placed_.size(); ++i) {
        if (!placed_[i]) continue;
        rtcDisableGeometry(rtcGetGeometry(top_, unsigned(i)));
        placed_[i] = nullptr;
    }
    rtcCommitScene(top_);
    check();
    return top_;
}

PeerRays EmbreeFrames::render(const PeerFrame& frame) {
    if (frame.instances.empty()) return {};
    const double begun = now();
    const RTCScene scene = ready(frame);
    const double committed = now();
    std::vector<uint8_t> reflecting;
    for (const PeerFrame::Instance& instance : frame.instances)
        reflecting.push_back(objects_.at(instance.object).reflecting);
    const PeerRays rays = traceFrame(scene, frame, reflecting, threads_);
    committing_ += committed - begun;
    tracing_ += now() - committed;
    return rays;
}

} // namespace smart::bench

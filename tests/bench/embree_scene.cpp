// SPDX-License-Identifier: MIT
#include "tests/bench/embree_scene.h"

#include <chrono>
#include <cstring>
#include <numeric>
#include <stdexcept>

namespace smart::bench {
namespace {

std::string configOf(unsigned threads, const std::string& isa) {
    std::string config = "threads=" + std::to_string(threads);
    if (isa == "generic") config += ",max_isa=sse2"; // the least it has
    if (isa == "sse4") config += ",max_isa=sse4.2";
    if (isa == "avx2") config += ",max_isa=avx2";
    return config;
}

} // namespace

EmbreeScene::EmbreeScene(const std::vector<Triangle>& triangles, EmbreeQuality quality,
                         bool robust, unsigned threads, const std::string& isa)
    : vertices_(triangles.size() * 9 + 4), indices_(triangles.size() * 3) {
    if (!triangles.empty())
        std::memcpy(vertices_.data(), triangles.data(), triangles.size() * sizeof(Triangle));
    std::iota(indices_.begin(), indices_.end(), 0u);
    device_ = rtcNewDevice(configOf(threads, isa).c_str());
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
    if (rtcGetDeviceError(device_) != RTC_ERROR_NONE)
        throw std::runtime_error("Embree reports an error at the build");
}

EmbreeScene::~EmbreeScene() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
}

bool EmbreeScene::countBytes(void* total, ssize_t bytes, bool) {
    *static_cast<std::atomic<std::ptrdiff_t>*>(total) += bytes;
    return true;
}

} // namespace smart::bench

// SPDX-License-Identifier: MIT
#pragma once

#include <embree3/rtcore.h>

#include <atomic>
#include <string>
#include <vector>

#include "tests/bench/embree_engine.h"

namespace smart::bench {

/// A committed scene. Vertices and indices are shared with it and not part of its bytes: its tree
/// holds copies of the triangles.
class EmbreeScene {
public:
    /// isa: "" for all that the machine has, or ours whose counterpart Embree is limited to.
    EmbreeScene(const std::vector<Triangle>& triangles, EmbreeQuality quality, bool robust,
                unsigned threads, const std::string& isa);
    ~EmbreeScene();
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    RTCScene scene() const { return scene_; }
    const BuildReport& report() const { return report_; }

private:
    static bool countBytes(void* total, ssize_t bytes, bool);

    std::vector<float> vertices_;
    std::vector<uint32_t> indices_;
    std::atomic<std::ptrdiff_t> bytes_{0};
    RTCDevice device_;
    RTCScene scene_;
    BuildReport report_;
};

} // namespace smart::bench

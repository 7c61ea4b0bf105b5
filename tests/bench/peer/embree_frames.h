// SPDX-License-Identifier: MIT
// Frames of a scene that changes, as a program on Embree would make them: what its scene needs
// from one frame to the next, and the rays of the frame, without shading.
#pragma once

#include <embree3/rtcore.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace smart::bench {

/// Rays by kind, and what camera rays met.
struct PeerRays {
    std::size_t primary = 0, shadow = 0, reflected = 0, hits = 0;
    void add(const PeerRays& more);
};

/// What a frame shows, in the space of the eye.
struct PeerFrame {
    struct Instance {
        uint32_t object;
        std::array<float, 12> toEye; ///< three columns and the translation
        bool identity, lit;
    };
    std::vector<Instance> instances;
    std::vector<std::array<float, 4>> lights; ///< as GL_POSITION
    float slope[2] = {1, 1};                  ///< x and y at depth 1, at the picture's edge
    uint32_t width = 1, height = 1;
    uint8_t* seen = nullptr; ///< if asked for, rows from below: 0 nothing, 128 in shadow, 255 lit
};

/// How an object or the top level comes up to date.
enum class PeerWay { Refit, Low, Medium };

class EmbreeFrames {
public:
    EmbreeFrames(PeerWay way, unsigned threads);
    ~EmbreeFrames();
    EmbreeFrames(const EmbreeFrames&) = delete;
    EmbreeFrames& operator=(const EmbreeFrames&) = delete;

    /// Triangles by three point numbers each. `lasting`: built once, so at medium quality.
    void define(uint32_t object, std::span<const float> points, std::span<const uint32_t> corners,
                bool lasting, bool reflecting);
    /// Others for the same object.
    void redefine(uint32_t object, std::span<const float> points,
                  std::span<const uint32_t> corners);
    void move(uint32_t object, std::size_t first, std::span<const float> points);
    void remove(uint32_t object);

    /// Brings the top level up to date; traces, by all threads.
    PeerRays render(const PeerFrame& frame);
    double committing() const { return committing_; } ///< seconds in all
    double tracing() const { return tracing_; }

private:
    struct Object {
        RTCScene scene = nullptr;
        RTCGeometry mesh = nullptr;
        std::size_t points = 0, corners = 0;
        bool reflecting = false, deforms = false;
    };
    void build(Object& object, std::span<const float> points, std::span<const uint32_t> corners,
               RTCBuildQuality quality);
    void release(Object& object);
    /// What rays of the frame are to be sent into.
    RTCScene ready(const PeerFrame& frame);
    void check() const;

    const PeerWay way_;
    const unsigned threads_;
    RTCDevice device_ = nullptr;
    RTCScene top_ = nullptr;
    std::map<uint32_t, Object> objects_;
    std::vector<RTCScene> placed_; ///< what the instances of top_ show; nullptr: disabled
    double committing_ = 0, tracing_ = 0;
};

} // namespace smart::bench

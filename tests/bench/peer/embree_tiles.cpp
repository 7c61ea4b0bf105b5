// SPDX-License-Identifier: MIT
#include "tests/bench/peer/embree_tiles.h"

#include <pmmintrin.h>
#include <xmmintrin.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <thread>

namespace smart::bench {
namespace {

constexpr int kLanes = 16;
constexpr uint32_t kBlock = 4; ///< pixels a side that one packet takes
constexpr uint32_t kTile = 32;
constexpr float kOffset = 1e-4f; ///< of the distance to the eye, off the surface

struct Point {
    float x, y, z;
};
Point operator-(const Point& a, const Point& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Point operator+(const Point& a, const Point& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Point operator*(const Point& a, float b) {
    return {a.x * b, a.y * b, a.z * b};
}
float dot(const Point& a, const Point& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Where the rays of a packet met something.
struct Met {
    uint32_t lanes = 0;
    Point at[kLanes] = {}, normal[kLanes] = {}, ///< the normal towards the ray's start
          direction[kLanes] = {};
    uint32_t instance[kLanes] = {};
};

class TileRays {
public:
    TileRays(RTCScene scene, const PeerFrame& frame, std::span<const uint8_t> reflecting)
        : scene_(scene), frame_(frame), reflecting_(reflecting) {
        rtcInitIntersectContext(&context_);
        context_.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    }

    void block(uint32_t x0, uint32_t y0) {
        Point direction[kLanes];
        const Point eye[kLanes] = {};
        uint32_t lanes = 0;
        for (int i = 0; i < kLanes; ++i) {
            const uint32_t x = x0 + uint32_t(i) % kBlock, y = y0 + uint32_t(i) / kBlock;
            if (x < frame_.width && y < frame_.height) lanes |= 1u << i;
            direction[i] = {(2 * (float(x) + 0.5f) / float(frame_.width) - 1) * frame_.slope[0],
                            (2 * (float(y) + 0.5f) / float(frame_.height) - 1) * frame_.slope[1],
                            -1};
        }
        rays_.primary += count(lanes);
        Met met;
        meet(eye, direction, lanes, met);
        rays_.hits += count(met.lanes);
        const uint32_t lit = lightsReach(met);
        if (frame_.seen)
            for (uint32_t i = 0; i < kLanes; ++i)
                if (met.lanes >> i & 1)
                    frame_.seen[(y0 + i / kBlock) * frame_.width + x0 + i % kBlock] =
                        lit >> i & 1 ? 255 : 128;
        reflect(met);
    }
    const PeerRays& rays() const { return rays_; }

private:
    const PeerFrame::Instance& placeOf(const Met& met, int i) const {
        const uint32_t instance = met.instance[i];
        return frame_.instances[instance == RTC_INVALID_GEOMETRY_ID ? 0 : instance];
    }
    static std::size_t count(uint32_t lanes) { return std::size_t(__builtin_popcount(lanes)); }

    static void fill(const Point* from, const Point* direction, uint32_t lanes, float far,
                     RTCRay16& ray, int (&valid)[kLanes]) {
        for (int i = 0; i < kLanes; ++i) {
            valid[i] = lanes >> i & 1 ? -1 : 0;
            ray.org_x[i] = from[i].x;
            ray.org_y[i] = from[i].y;
            ray.org_z[i] = from[i].z;
            ray.dir_x[i] = direction[i].x;
            ray.dir_y[i] = direction[i].y;
            ray.dir_z[i] = direction[i].z;
            ray.tnear[i] = ray.time[i] = 0;
            ray.tfar[i] = far;
            ray.mask[i] = ~0u;
            ray.flags[i] = 0;
        }
    }

    void meet(const Point* from, const Point* direction, uint32_t lanes, Met& met) {
        RTCRayHit16 work;
        alignas(64) int valid[kLanes];
        fill(from, direction, lanes, std::numeric_limits<float>::infinity(), work.ray, valid);
        std::fill_n(work.hit.geomID, kLanes, RTC_INVALID_GEOMETRY_ID);
        std::fill_n(work.hit.instID[0], kLanes, RTC_INVALID_GEOMETRY_ID);
        rtcIntersect16(valid, scene_, &context_, &work);
        for (int i = 0; i < kLanes; ++i) {
            if (!(lanes >> i & 1) || work.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
            met.lanes |= 1u << i;
            met.direction[i] = direction[i];
            met.instance[i] = work.hit.instID[0][i];
            Point normal{work.hit.Ng_x[i], work.hit.Ng_y[i], work.hit.Ng_z[i]};
            if (met.instance[i] != RTC_INVALID_GEOMETRY_ID)
                normal = turned(normal, frame_.instances[met.instance[i]].toEye);
            if (dot(normal, direction[i]) > 0) normal = normal * -1.0f;
            normal = normal * (1 / std::sqrt(dot(normal, normal)));
            const Point at = from[i] + direction[i] * work.ray.tfar[i];
            met.at[i] = at + normal * (kOffset * std::sqrt(dot(at, at)));
            met.normal[i] = normal;
        }
    }

    /// By the cofactors: what the transposed inverse does, but for the length.
    static Point turned(const Point& n, const std::array<float, 12>& m) {
        const Point a{m[0], m[1], m[2]}, b{m[3], m[4], m[5]}, c{m[6], m[7], m[8]};
        const auto cross = [](const Point& p, const Point& q) {
            return Point{p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
        };
        return cross(b, c) * n.x + cross(c, a) * n.y + cross(a, b) * n.z;
    }

    /// Lanes that some light reaches.
    uint32_t lightsReach(const Met& met) {
        uint32_t lit = 0;
        for (const std::array<float, 4>& light : frame_.lights) {
            Point direction[kLanes];
            uint32_t lanes = 0;
            const bool isPoint = light[3] != 0;
            for (int i = 0; i < kLanes; ++i) {
                direction[i] = {light[0], light[1], light[2]};
                if (!(met.lanes >> i & 1) || !placeOf(met, i).lit) continue;
                if (isPoint) direction[i] = direction[i] - met.at[i];
                if (dot(direction[i], met.normal[i]) > 0) lanes |= 1u << i;
            }
            if (!lanes) continue;
            rays_.shadow += count(lanes);
            RTCRay16 ray;
            alignas(64) int valid[kLanes];
            fill(met.at, direction, lanes, isPoint ? 1 : std::numeric_limits<float>::infinity(),
                 ray, valid);
            rtcOccluded16(valid, scene_, &context_, &ray);
            for (int i = 0; i < kLanes; ++i)
                if (lanes >> i & 1 && ray.tfar[i] >= 0) lit |= 1u << i;
        }
        return lit;
    }

    void reflect(const Met& met) {
        Point direction[kLanes] = {};
        uint32_t lanes = 0;
        for (int i = 0; i < kLanes; ++i) {
            if (!(met.lanes >> i & 1)) continue;
            if (!reflecting_[std::size_t(&placeOf(met, i) - frame_.instances.data())]) continue;
            lanes |= 1u << i;
            direction[i] =
                met.direction[i] - met.normal[i] * (2 * dot(met.normal[i], met.direction[i]));
        }
        if (!lanes) return;
        rays_.reflected += count(lanes);
        Met seen;
        meet(met.at, direction, lanes, seen);
        lightsReach(seen);
    }

    const RTCScene scene_;
    const PeerFrame& frame_;
    const std::span<const uint8_t> reflecting_;
    RTCIntersectContext context_;
    PeerRays rays_;
};

} // namespace

PeerRays traceFrame(RTCScene scene, const PeerFrame& frame, std::span<const uint8_t> reflecting,
                    unsigned threads) {
    const uint32_t columns = (frame.width + kTile - 1) / kTile;
    const uint32_t rows = (frame.height + kTile - 1) / kTile;
    std::atomic<uint32_t> next{0};
    std::vector<PeerRays> rays(threads);
    std::vector<std::thread> workers;
    for (unsigned thread = 0; thread < threads; ++thread) {
        workers.emplace_back([&, thread] {
            _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON); // as Embree's manual asks for
            _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
            TileRays work(scene, frame, reflecting);
            for (uint32_t tile; (tile = next.fetch_add(1)) < columns * rows;) {
                const uint32_t x0 = tile % columns * kTile, y0 = tile / columns * kTile;
                for (uint32_t y = y0; y < std::min(y0 + kTile, frame.height); y += kBlock)
                    for (uint32_t x = x0; x < std::min(x0 + kTile, frame.width); x += kBlock)
                        work.block(x, y);
            }
            rays[thread] = work.rays();
        });
    }
    for (std::thread& worker : workers) worker.join();
    PeerRays all;
    for (const PeerRays& part : rays) all.add(part);
    return all;
}

} // namespace smart::bench

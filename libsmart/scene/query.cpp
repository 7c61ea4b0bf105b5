// SPDX-License-Identifier: MIT
#include "libsmart/scene/query.h"

#include <algorithm>
#include <cstring>
#include <glm/geometric.hpp>
#include <limits>

#include "libsmart/base/fp_environment.h"
#include "libsmart/scene/hit_chain.h"

namespace smart {
namespace {

constexpr std::size_t kLanes = kPacketSize, kTileLanes = kLanes * kTilePackets;
/// Rays that have nothing in common take turns: the more of them, the less often few are left.
constexpr std::size_t kStreamPackets = 64, kStreamLanes = kLanes * kStreamPackets;

// Compilers unroll loops over lanes before they look for vectors, and leave a branch for each.
typedef uint32_t FourLanes __attribute__((vector_size(16), may_alias, aligned(4)));
typedef uint8_t Bytes __attribute__((vector_size(8), may_alias, aligned(1)));

/// Reads single values of the application's rays.
class RayReader {
public:
    explicit RayReader(const RayStream& stream) : stream_(stream) {}

    float org(int axis, std::size_t i) const {
        return stream_.org[axis][stream_.commonOrigin ? 0 : at(i)];
    }
    float dir(int axis, std::size_t i) const { return stream_.dir[axis][at(i)]; }
    float tNear(std::size_t i) const { return stream_.tNear ? stream_.tNear[at(i)] : 0.0f; }
    float tFar(std::size_t i) const {
        return stream_.tFar ? stream_.tFar[at(i)] : std::numeric_limits<float>::infinity();
    }

    /// Of sixteen rays.
    void tFar(std::size_t first, float* values) const {
        if (!stream_.tFar)
            std::fill_n(values, kLanes, std::numeric_limits<float>::infinity());
        else if (stream_.stride == 1)
            take(stream_.tFar + first, values);
        else
            for (std::size_t lane = 0; lane < kLanes; ++lane) values[lane] = tFar(first + lane);
    }

    Ray ray(std::size_t i) const {
        return {{org(0, i), org(1, i), org(2, i)},
                {dir(0, i), dir(1, i), dir(2, i)},
                tNear(i),
                tFar(i)};
    }
    /// Rays first.. in as many packets as they need; returns how many.
    uint32_t fill(RayPacket* packets, std::size_t first, std::size_t count) const {
        uint32_t used = 0;
        for (std::size_t done = 0; done < count; done += kLanes, ++used) {
            const std::size_t lanes = std::min(kLanes, count - done);
            if (lanes == kLanes && stream_.stride == 1)
                copy(packets[used], first + done);
            else
                fill(packets[used], first + done, lanes);
        }
        return used;
    }

    /// Asks for rays that lie one behind the other before they are needed: memory is far.
    void prefetch(std::size_t first, std::size_t count) const {
        if (stream_.stride != 1) return;
        const auto ask = [&](const float* values) {
            constexpr std::size_t kLine = 64 / sizeof(float);
            for (std::size_t i = 0; values && i < count; i += kLine)
                __builtin_prefetch(values + first + i);
        };
        for (int axis = 0; axis < 3; ++axis) {
            if (!stream_.commonOrigin) ask(stream_.org[axis]);
            ask(stream_.dir[axis]);
        }
        ask(stream_.tNear);
        ask(stream_.tFar);
    }

private:
    static void take(const float* from, float* to) {
        std::memcpy(to, from, kLanes * sizeof(float)); // inline, unlike the same as std::copy_n
    }
    /// Sixteen rays that lie one behind the other.
    void copy(RayPacket& packet, std::size_t first) const {
        for (int axis = 0; axis < 3; ++axis) {
            if (stream_.commonOrigin)
                std::fill_n(packet.org[axis], kLanes, stream_.org[axis][0]);
            else
                take(stream_.org[axis] + first, packet.org[axis]);
            take(stream_.dir[axis] + first, packet.dir[axis]);
        }
        if (stream_.tNear)
            take(stream_.tNear + first, packet.tNear);
        else
            std::fill_n(packet.tNear, kLanes, 0.0f);
        tFar(first, packet.tFar);
        packet.active = (1u << kLanes) - 1;
    }
    /// Lanes left over hold a harmless ray and are not active.
    void fill(RayPacket& packet, std::size_t first, std::size_t lanes) const {
        for (int axis = 0; axis < 3; ++axis) {
            for (std::size_t lane = 0; lane < kLanes; ++lane) {
                packet.org[axis][lane] = lane < lanes ? org(axis, first + lane) : 0.0f;
                packet.dir[axis][lane] = lane < lanes ? dir(axis, first + lane) : 1.0f;
            }
        }
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            packet.tNear[lane] = lane < lanes ? tNear(first + lane) : 0.0f;
            packet.tFar[lane] = lane < lanes ? tFar(first + lane) : 0.0f;
        }
        packet.active = (1u << lanes) - 1;
    }

    std::ptrdiff_t at(std::size_t i) const { return std::ptrdiff_t(i) * stream_.stride; }

    const RayStream& stream_;
};

Hit laneHit(const HitPacket& hits, std::size_t lane) {
    Hit hit;
    hit.triangle = hits.triangle[lane];
    if (hit.triangle == kNoHit) return hit;
    hit.t = hits.t[lane];
    hit.u = hits.u[lane];
    hit.v = hits.v[lane];
    hit.levels = hits.levels[lane];
    for (uint32_t level = 0; level < hit.levels; ++level) hit.path[level] = hits.path[level][lane];
    return hit;
}

/// Writes what the application wants to know of each ray, and computes no more.
class HitWriter {
public:
    HitWriter(const Scene& scene, const RayReader& rays, const HitStream& stream)
        : scene_(scene),
          rays_(rays),
          stream_(stream),
          wantsNormal_(stream.normal[0] || stream.normal[1] || stream.normal[2] || stream.flags),
          wantsChain_(wantsNormal_ || stream.object) {}

    /// Rays first.. of a packet, as many lanes of it as are given.
    void write(std::size_t first, std::size_t lanes, const HitPacket& hits) const {
        if (!wantsChain_ && lanes == kLanes && stream_.stride == 1) return writePlain(first, hits);
        for (std::size_t lane = 0; lane < lanes; ++lane) write(first + lane, laneHit(hits, lane));
    }
    void write(std::size_t i, const Hit& hit) const {
        if (hit.triangle == kNoHit) return writeMiss(i);
        put(stream_.t, i, hit.t);
        put(stream_.u, i, hit.u);
        put(stream_.v, i, hit.v);
        put(stream_.primitive, i, hit.triangle);
        put(stream_.instance, i, hit.path[0]);
        if (!wantsChain_) return;
        const HitChain chain = resolve(scene_, hit.path, hit.levels, hit.triangle);
        put(stream_.object, i, chain.instances[chain.levels - 1]->objectId);
        if (!wantsNormal_) return;
        const glm::dvec3 normal = chain.worldNormal();
        const glm::dvec3 direction(rays_.dir(0, i), rays_.dir(1, i), rays_.dir(2, i));
        for (int axis = 0; axis < 3; ++axis) put(stream_.normal[axis], i, float(normal[axis]));
        put(stream_.flags, i, uint32_t(glm::dot(direction, normal) > 0));
    }

private:
    template <class T>
    void put(T* values, std::size_t i, T value) const {
        if (values) values[std::ptrdiff_t(i) * stream_.stride] = value;
    }
    /// Sixteen rays whose values lie one behind the other: what the kernels found is all there is.
    void writePlain(std::size_t first, const HitPacket& hits) const {
        const auto write = [&](auto* values, const auto* found, const auto* otherwise) {
            if (!values) return;
            for (std::size_t lane = 0; lane < kLanes; lane += 4) {
                const auto four = [lane](const auto* of) { return *(const FourLanes*)(of + lane); };
                const FourLanes none = four(hits.triangle) == kNoHit;
                *(FourLanes*)(values + first + lane) =
                    (four(found) & ~none) | (four(otherwise) & none);
            }
        };
        constexpr float kZero[kLanes] = {};
        float far[kLanes];
        rays_.tFar(first, far);
        write(stream_.t, hits.t, far);
        write(stream_.u, hits.u, kZero);
        write(stream_.v, hits.v, kZero);
        static_assert(kNoId == kNoHit);
        write(stream_.primitive, hits.triangle, hits.triangle);
        write(stream_.instance, hits.path[0], hits.triangle);
    }
    void writeMiss(std::size_t i) const {
        put(stream_.t, i, rays_.tFar(i));
        put(stream_.u, i, 0.0f);
        put(stream_.v, i, 0.0f);
        put(stream_.primitive, i, kNoId);
        put(stream_.object, i, kNoId);
        put(stream_.instance, i, kNoId);
        for (float* component : stream_.normal) put(component, i, 0.0f);
        put(stream_.flags, i, 0u);
    }

    const Scene& scene_;
    const RayReader& rays_;
    const HitStream& stream_;
    const bool wantsNormal_, wantsChain_;
};

/// trace(packets, how many, first ray, rays) for each tile. A tile is read before the one ahead of it
/// is traced: the kernels' wide loads would wait for narrow stores of a moment ago.
template <class Trace>
void forEachTile(const RayReader& reader, std::size_t count, const Trace& trace) {
    RayPacket packets[2][kTilePackets];
    uint32_t used[2];
    const auto lanes = [&](std::size_t first) { return std::min(kTileLanes, count - first); };
    const auto read = [&](std::size_t first, int buffer) {
        used[buffer] = reader.fill(packets[buffer], first, lanes(first));
    };
    read(0, 0);
    int current = 0;
    for (std::size_t first = 0; first < count; first += kTileLanes, current ^= 1) {
        if (const std::size_t next = first + kTileLanes; next < count) {
            read(next, current ^ 1);
            if (next + kTileLanes < count)
                reader.prefetch(next + kTileLanes, lanes(next + kTileLanes));
        }
        trace(packets[current], used[current], first, lanes(first));
    }
}

void intersectRays(const Scene& scene, const RayStream& rays, const HitStream& hits,
                   std::size_t count, Coherence coherence) {
    const FpEnvironment standard;
    const int precision = int(scene.precision());
    const RayReader reader(rays);
    const HitWriter writer(scene, reader, hits);
    if (count == 1) {
        Hit hit;
        kernels().intersect1[precision](scene.view(), reader.ray(0), hit);
        writer.write(0, hit);
        return;
    }
    if (coherence == Coherence::Incoherent && count > kLanes) {
        const auto intersectStream = kernels().intersectStream[precision];
        RayPacket stream[kStreamPackets];
        HitPacket met[kStreamPackets];
        for (std::size_t first = 0; first < count; first += kStreamLanes) {
            const std::size_t lanes = std::min(kStreamLanes, count - first);
            const uint32_t used = reader.fill(stream, first, lanes);
            intersectStream(scene.view(), stream, used, met);
            for (std::size_t done = 0; done < lanes; done += kLanes)
                writer.write(first + done, std::min(kLanes, lanes - done), met[done / kLanes]);
        }
        return;
    }
    const auto intersectTile = kernels().intersectTile[precision];
    HitPacket found[kTilePackets];
    forEachTile(reader, count, [&](const RayPacket* packets, uint32_t used, std::size_t first,
                                   std::size_t lanes) {
        intersectTile(scene.view(), packets, used, found);
        for (uint32_t p = 0; p < used; ++p) {
            const std::size_t done = p * kLanes;
            writer.write(first + done, std::min(kLanes, lanes - done), found[p]);
        }
    });
}

/// A byte for each of `lanes` rays: 1 where its bit is set.
void writeBits(const uint32_t* masks, std::size_t lanes, uint8_t* bytes) {
    constexpr std::size_t kEight = sizeof(Bytes);
    constexpr Bytes kBit = {1, 2, 4, 8, 16, 32, 64, 128};
    std::size_t done = 0;
    for (; done + kEight <= lanes; done += kEight) {
        const uint8_t eight = uint8_t(masks[done / kLanes] >> (done % kLanes));
        *(Bytes*)(bytes + done) = Bytes((eight & kBit) != 0) & 1;
    }
    for (; done < lanes; ++done) bytes[done] = (masks[done / kLanes] >> (done % kLanes)) & 1;
}

void occludeRays(const Scene& scene, const RayStream& rays, uint8_t* blocked, std::size_t count,
                 Coherence coherence) {
    const FpEnvironment standard;
    const int precision = int(scene.precision());
    const RayReader reader(rays);
    if (count == 1) {
        blocked[0] = kernels().occluded1[precision](scene.view(), reader.ray(0));
        return;
    }
    if (coherence == Coherence::Incoherent && count > kLanes) {
        const auto occludedStream = kernels().occludedStream[precision];
        RayPacket stream[kStreamPackets];
        uint32_t met[kStreamPackets];
        for (std::size_t first = 0; first < count; first += kStreamLanes) {
            const std::size_t lanes = std::min(kStreamLanes, count - first);
            const uint32_t used = reader.fill(stream, first, lanes);
            occludedStream(scene.view(), stream, used, met);
            writeBits(met, lanes, blocked + first);
        }
        return;
    }
    const auto occludedTile = kernels().occludedTile[precision];
    forEachTile(reader, count, [&](const RayPacket* packets, uint32_t used, std::size_t first,
                                   std::size_t lanes) {
        uint32_t masks[kTilePackets] = {};
        occludedTile(scene.view(), packets, used, masks);
        writeBits(masks, lanes, blocked + first);
    });
}

/// Of lazy models that the rays came to.
void throwBuildFailure() {
    if (const std::exception_ptr failure = takeBuildFailure()) std::rethrow_exception(failure);
}

} // namespace

void intersect(const Scene& scene, const RayStream& rays, const HitStream& hits, std::size_t count,
               Coherence coherence) {
    intersectRays(scene, rays, hits, count, coherence);
    throwBuildFailure();
}

void occluded(const Scene& scene, const RayStream& rays, uint8_t* blocked, std::size_t count,
              Coherence coherence) {
    occludeRays(scene, rays, blocked, count, coherence);
    throwBuildFailure();
}

} // namespace smart

// SPDX-License-Identifier: MIT
// Many packets of rays that have nothing in common. A scene that is one instance of a model without
// children lets them take turns in the model's wide tree; for others see MixedScene.
#pragma once

#include "libsmart/kernel/ray_preparation.h"
#include "libsmart/kernel/rays_in_flight.h"

namespace smart::SMART_ISA {

/// What a stream's rays find: triangles of the scene's only model, and whether any.
template <HitMode M>
class StreamHits {
public:
    static constexpr int N = kPacketSize;

    StreamHits(const ModelView& scene, const RayPacket* packets, uint32_t count,
               HitPacket* hits, uint32_t* blocked)
        : scene_(scene), packets_(packets), count_(count), hits_(hits), blocked_(blocked) {}

    bool next(PacketRays& packet, uint32_t& name) {
        if (next_ == count_) return false;
        name = next_++;
        const RayPacket& in = packets_[name];
        const float* const org[3] = {in.org[0], in.org[1], in.org[2]};
        const float* const dir[3] = {in.dir[0], in.dir[1], in.dir[2]};
        double scale[N];
        Search<N, M, NoCounts> query;
        const InstanceView& instance = scene_.children[0];
        if (instance.identity) {
            packet.lanes = prepareRays<N>(org, dir, in.tNear, in.tFar, in.active, packet.rays,
                                          scale, query);
        } else {
            LocalRays<N> world;
            packet.lanes =
                prepareRays<N>(org, dir, in.tNear, in.tFar, in.active, world, scale, query);
            transformRays(instance, world, packet.rays);
        }
        __builtin_memcpy(packet.near, query.tNear, sizeof packet.near);
        __builtin_memcpy(packet.far, query.best, sizeof packet.far);
        if constexpr (M == HitMode::Any) {
            blocked_[name] = 0;
        } else {
            HitPacket& hits = hits_[name];
            Word<N>(kNoHit).store(hits.triangle);
            Word<N>(1u).store(hits.levels);
            Word<N>(0u).store(hits.path[0]);
        }
        return true;
    }
    template <int K>
    void open(Search<K, M, NoCounts>& query) const {
        query.lastOfEqual = scene_.lastOfEqual != 0;
        query.currentLevels = 1;
        query.currentPath[0] = 0;
    }
    void done(uint32_t name, const Search<N, M, NoCounts>& query) {
        if constexpr (M == HitMode::Any)
            blocked_[name] = query.blocked;
        else
            __builtin_memcpy(hits_[name].triangle, query.triangle, sizeof query.triangle);
    }
    void done(uint32_t name, int lane, const Search<1, M, NoCounts>& query) {
        if constexpr (M == HitMode::Any)
            blocked_[name] |= query.blocked << lane;
        else
            hits_[name].triangle[lane] = query.triangle[0];
    }

private:
    const ModelView& scene_;
    const RayPacket* packets_;
    const uint32_t count_;
    HitPacket* const hits_;
    uint32_t* const blocked_;
    uint32_t next_ = 0;
};

/// The model in which the rays of a scene can take turns; nullptr where they meet several, or one
/// with children or without a tree for it.
inline const ModelView* streamedModel(const ModelView& scene) {
    if (scene.childCount != 1 || !scene.children[0].model) return nullptr;
    const ModelView& model = reached(scene.children[0]);
    return model.childCount == 0 && model.wide.nodes ? &model : nullptr;
}

/// Finds which triangles of the streamed model are hit, or fills `blocked`.
template <template <int> class Precision, HitMode M>
[[gnu::noinline]] void runStream(const ModelView& scene, const ModelView& model,
                                 const RayPacket* packets, uint32_t count, HitPacket* hits,
                                 uint32_t* blocked) {
    StreamHits<M> source(scene, packets, count, hits, blocked);
    RaysInFlight<Precision, M, StreamHits<M>> flights(model, source);
    flights.run();
}

} // namespace smart::SMART_ISA

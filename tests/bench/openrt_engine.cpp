// SPDX-License-Identifier: MIT
#include "tests/bench/openrt_engine.h"

#include <algorithm>
#include <chrono>

#include "libsmart/geometry/model_builder.h"
#include "libsmart/kernel/kernels.h"
#include "libsmart/scene/query.h"

namespace smart::bench {
namespace {

class OpenrtEngine : public Engine {
public:
    OpenrtEngine(ScenePtr scene, Precision precision)
        : scene_(std::move(scene)), precision_(precision) {}
    std::string name() const override {
        return std::string("openrt ") + form() + " " + kernels_.name;
    }
    bool peer() const override { return false; }

protected:
    virtual const char* form() const = 0;
    int mode() const { return int(precision_); }

    const ScenePtr scene_;
    const Precision precision_;
    const KernelTable& kernels_ = kernels();
};

class PacketEngine final : public OpenrtEngine {
public:
    PacketEngine(ScenePtr scene, Precision precision, bool plantError)
        : OpenrtEngine(std::move(scene), precision), plantError_(plantError) {}
    void closest(const RaySet& rays, std::size_t first, std::size_t count,
                 Found* found) const override {
        HitPacket hits;
        for (std::size_t p = first; p < first + count; ++p) {
            kernels_.intersect[mode()](scene_->view(), rays.packets[p], hits);
            std::copy(hits.t, hits.t + kPacketSize, found[p].t);
            std::copy(hits.triangle, hits.triangle + kPacketSize, found[p].triangle);
            if (plantError_ && p % 1000 == 500) found[p].triangle[0] ^= 1;
        }
    }
    void any(const RaySet& rays, std::size_t first, std::size_t count,
             uint32_t* blocked) const override {
        for (std::size_t p = first; p < first + count; ++p) {
            kernels_.occluded[mode()](scene_->view(), rays.packets[p], blocked[p]);
            if (plantError_ && p % 1000 == 500) blocked[p] ^= rays.packets[p].active;
        }
    }

private:
    const char* form() const override { return "packet"; }
    const bool plantError_;
};

/// Four packets at a time.
class TileEngine final : public OpenrtEngine {
public:
    using OpenrtEngine::OpenrtEngine;
    void closest(const RaySet& rays, std::size_t first, std::size_t count,
                 Found* found) const override {
        HitPacket hits[kTilePackets];
        for (std::size_t p = first, n = 0; p < first + count; p += n) {
            n = std::min<std::size_t>(kTilePackets, first + count - p);
            kernels_.intersectTile[mode()](scene_->view(), &rays.packets[p], uint32_t(n), hits);
            for (std::size_t i = 0; i < n; ++i) {
                std::copy_n(hits[i].t, kPacketSize, found[p + i].t);
                std::copy_n(hits[i].triangle, kPacketSize, found[p + i].triangle);
            }
        }
    }
    void any(const RaySet& rays, std::size_t first, std::size_t count,
             uint32_t* blocked) const override {
        for (std::size_t p = first, n = 0; p < first + count; p += n) {
            n = std::min<std::size_t>(kTilePackets, first + count - p);
            kernels_.occludedTile[mode()](scene_->view(), &rays.packets[p], uint32_t(n),
                                          blocked + p);
        }
    }

private:
    const char* form() const override { return "tile"; }
};

class SingleEngine final : public OpenrtEngine {
public:
    using OpenrtEngine::OpenrtEngine;
    void closest(const RaySet& rays, std::size_t first, std::size_t count,
                 Found* found) const override {
        Hit hit;
        for (std::size_t p = first; p < first + count; ++p) {
            for (int lane = 0; lane < kPacketSize; ++lane) {
                if (!(rays.packets[p].active >> lane & 1)) continue;
                kernels_.intersect1[mode()](scene_->view(), ray(rays, p, lane), hit);
                found[p].t[lane] = hit.t;
                found[p].triangle[lane] = hit.triangle;
            }
        }
    }
    void any(const RaySet& rays, std::size_t first, std::size_t count,
             uint32_t* blocked) const override {
        for (std::size_t p = first; p < first + count; ++p) {
            blocked[p] = 0;
            for (int lane = 0; lane < kPacketSize; ++lane) {
                if (!(rays.packets[p].active >> lane & 1)) continue;
                const bool hit = kernels_.occluded1[mode()](scene_->view(), ray(rays, p, lane));
                blocked[p] |= uint32_t(hit) << lane;
            }
        }
    }

private:
    const char* form() const override { return "single"; }
    static Ray ray(const RaySet& rays, std::size_t p, int lane) {
        const RayPacket& packet = rays.packets[p];
        return {{packet.org[0][lane], packet.org[1][lane], packet.org[2][lane]},
                {packet.dir[0][lane], packet.dir[1][lane], packet.dir[2][lane]},
                packet.tNear[lane],
                packet.tFar[lane]};
    }
};

/// The public query over arrays.
class StreamEngine final : public OpenrtEngine {
public:
    StreamEngine(ScenePtr scene, Precision precision, Coherence coherence)
        : OpenrtEngine(std::move(scene), precision), coherence_(coherence) {}
    void closest(const RaySet& rays, std::size_t first, std::size_t count,
                 Found* found) const override {
        constexpr std::size_t kBatch = 64; // packets
        alignas(64) float t[kBatch * kPacketSize];
        alignas(64) uint32_t triangle[kBatch * kPacketSize];
        HitStream hits{};
        hits.t = t;
        hits.primitive = triangle;
        for (std::size_t p = first, n = 0; p < first + count; p += n) {
            n = std::min(kBatch, first + count - p);
            intersect(*scene_, stream(rays, p), hits, n * kPacketSize, coherence_);
            for (std::size_t i = 0; i < n; ++i) {
                std::copy_n(t + i * kPacketSize, kPacketSize, found[p + i].t);
                std::copy_n(triangle + i * kPacketSize, kPacketSize, found[p + i].triangle);
            }
        }
    }
    void any(const RaySet& rays, std::size_t first, std::size_t count,
             uint32_t* blocked) const override {
        constexpr std::size_t kBatch = 64;
        uint8_t flags[kBatch * kPacketSize];
        for (std::size_t p = first, n = 0; p < first + count; p += n) {
            n = std::min(kBatch, first + count - p);
            occluded(*scene_, stream(rays, p), flags, n * kPacketSize, coherence_);
            for (std::size_t i = 0; i < n; ++i) {
                blocked[p + i] = 0;
                for (uint32_t lane = 0; lane < uint32_t(kPacketSize); ++lane) {
                    blocked[p + i] |= uint32_t(flags[i * kPacketSize + lane]) << lane;
                }
            }
        }
    }

private:
    const char* form() const override {
        return coherence_ == Coherence::Coherent ? "stream" : "stream incoherent";
    }
    static RayStream stream(const RaySet& rays, std::size_t p) {
        const std::size_t at = p * kPacketSize;
        RayStream result{};
        for (int k = 0; k < 3; ++k) {
            result.org[k] = rays.org[k].data() + at;
            result.dir[k] = rays.dir[k].data() + at;
        }
        result.tNear = rays.tNear.data() + at;
        result.tFar = rays.tFar.data() + at;
        return result;
    }
    const Coherence coherence_;
};

} // namespace

ScenePtr buildOpenrt(const std::vector<Triangle>& triangles, Precision precision, unsigned threads,
                     BuildReport& report, BuildQuality quality) {
    ModelBuilder builder;
    builder.triangles = triangles;
    const auto start = std::chrono::steady_clock::now();
    ModelBuildOptions options;
    options.quality = quality;
    options.threads = threads;
    Instance instance;
    instance.model = std::move(builder).build(options);
    const std::size_t bytes = instance.model->bytes();
    auto scene = std::make_shared<const Scene>(std::vector<Instance>{std::move(instance)},
                                               precision, threads);
    report.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    report.bytes = bytes + scene->group().bytes();
    return scene;
}

EnginePtr preciseEngine(const ScenePtr& scene) {
    return std::make_unique<PacketEngine>(scene, Precision::Precise, false);
}

std::vector<EnginePtr> openrtEngines(const ScenePtr& scene, Precision precision,
                                     Coherence coherence, bool plantError) {
    std::vector<EnginePtr> engines;
    engines.push_back(std::make_unique<PacketEngine>(scene, precision, plantError));
    if (precision != Precision::Precise && coherence == Coherence::Coherent)
        engines.push_back(std::make_unique<TileEngine>(scene, precision));
    engines.push_back(std::make_unique<SingleEngine>(scene, precision));
    engines.push_back(std::make_unique<StreamEngine>(scene, precision, coherence));
    return engines;
}

} // namespace smart::bench

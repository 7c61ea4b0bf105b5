// SPDX-License-Identifier: MIT
// The kernels one by one, of every instruction set that the machine has: --benchmark_filter=avx2
// and so on choose. Small scenes that lie in the caches: what is measured is code, not memory.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>

#include "libsmart/kernel/kernels.h"
#include "tests/bench/openrt_engine.h"
#include "tests/support/procedural_meshes.h"

namespace {

using namespace smart;

constexpr const char* kModes[] = {"fast", "watertight", "precise"};

struct Fixture {
    std::vector<Triangle> triangles;
    ScenePtr scenes[kPrecisionCount];
    bench::RaySet primary, shadow, ao, bounce;

    Fixture() : triangles(test::bumpySphere(20'000)) {
        bench::BuildReport report;
        for (int mode = 0; mode < kPrecisionCount; ++mode)
            scenes[mode] = bench::buildOpenrt(triangles, Precision(mode), 1, report);
        const bench::View view;
        primary = bench::primaryRays(view, 256);
        const std::vector<bench::SurfacePacket> points = bench::surfacePoints(
            primary, scenes[int(Precision::Watertight)]->view(), triangles);
        shadow = bench::shadowRays(view, points);
        ao = bench::diffuseRays(points, 4, 0.3f, 1);
        bounce = bench::diffuseRays(points, 1, INFINITY, 1);
    }
};

const Fixture& fixture() {
    static const Fixture made;
    return made;
}

void report(benchmark::State& state, const bench::RaySet& rays) {
    state.counters["rays"] = benchmark::Counter(double(rays.active) * double(state.iterations()),
                                                benchmark::Counter::kIsRate);
}

using bench::RaySet;

void intersect(benchmark::State& state, const KernelTable* table, int mode, RaySet Fixture::*set) {
    const RaySet& rays = fixture().*set;
    const ModelView& view = fixture().scenes[mode]->view();
    HitPacket hits;
    for (auto _ : state) {
        for (const RayPacket& packet : rays.packets) {
            table->intersect[mode](view, packet, hits);
            benchmark::DoNotOptimize(hits);
        }
    }
    report(state, rays);
}

void occluded(benchmark::State& state, const KernelTable* table, int mode, RaySet Fixture::*set) {
    const RaySet& rays = fixture().*set;
    const ModelView& view = fixture().scenes[mode]->view();
    uint32_t blocked = 0;
    for (auto _ : state) {
        for (const RayPacket& packet : rays.packets) {
            table->occluded[mode](view, packet, blocked);
            benchmark::DoNotOptimize(blocked);
        }
    }
    report(state, rays);
}

void intersect1(benchmark::State& state, const KernelTable* table, int mode,
                RaySet Fixture::*set) {
    const RaySet& rays = fixture().*set;
    const ModelView& view = fixture().scenes[mode]->view();
    Hit hit;
    for (auto _ : state) {
        for (const RayPacket& packet : rays.packets) {
            for (int lane = 0; lane < kPacketSize; ++lane) {
                if (!(packet.active >> lane & 1)) continue;
                const Ray ray{{packet.org[0][lane], packet.org[1][lane], packet.org[2][lane]},
                              {packet.dir[0][lane], packet.dir[1][lane], packet.dir[2][lane]},
                              packet.tNear[lane],
                              packet.tFar[lane]};
                table->intersect1[mode](view, ray, hit);
                benchmark::DoNotOptimize(hit);
            }
        }
    }
    report(state, rays);
}

constexpr std::size_t kStreamPackets = 64;

/// A kernel that takes up to `Most` packets at a time.
template <auto Kernel, std::size_t Most>
void intersectMany(benchmark::State& state, const KernelTable* table, int mode,
                   RaySet Fixture::*set) {
    const RaySet& rays = fixture().*set;
    const ModelView& view = fixture().scenes[mode]->view();
    HitPacket hits[Most];
    for (auto _ : state) {
        for (std::size_t p = 0; p < rays.packets.size(); p += Most) {
            const std::size_t count = std::min(Most, rays.packets.size() - p);
            (table->*Kernel)[mode](view, &rays.packets[p], uint32_t(count), hits);
            benchmark::DoNotOptimize(hits);
        }
    }
    report(state, rays);
}

template <auto Kernel, std::size_t Most>
void occludedMany(benchmark::State& state, const KernelTable* table, int mode,
                  RaySet Fixture::*set) {
    const RaySet& rays = fixture().*set;
    const ModelView& view = fixture().scenes[mode]->view();
    uint32_t blocked[Most];
    for (auto _ : state) {
        for (std::size_t p = 0; p < rays.packets.size(); p += Most) {
            const std::size_t count = std::min(Most, rays.packets.size() - p);
            (table->*Kernel)[mode](view, &rays.packets[p], uint32_t(count), blocked);
            benchmark::DoNotOptimize(blocked);
        }
    }
    report(state, rays);
}

constexpr auto intersectTile = intersectMany<&KernelTable::intersectTile, kTilePackets>;
constexpr auto occludedTile = occludedMany<&KernelTable::occludedTile, kTilePackets>;
constexpr auto intersectStream = intersectMany<&KernelTable::intersectStream, kStreamPackets>;
constexpr auto occludedStream = occludedMany<&KernelTable::occludedStream, kStreamPackets>;

using Run = void (*)(benchmark::State&, const KernelTable*, int, RaySet Fixture::*);
struct Kernel {
    const char* name;
    Run run;
    RaySet Fixture::*rays;
    bool precise; ///< there is a form of its own for the precise mode
};
constexpr Kernel kKernels[] = {
    {"intersect/primary", intersect, &Fixture::primary, true},
    {"intersectTile/primary", intersectTile, &Fixture::primary, false},
    {"intersect1/primary", intersect1, &Fixture::primary, true},
    {"intersect/bounce", intersect, &Fixture::bounce, true},
    {"intersect1/bounce", intersect1, &Fixture::bounce, true},
    {"intersectStream/bounce", intersectStream, &Fixture::bounce, false},
    {"occluded/shadow", occluded, &Fixture::shadow, true},
    {"occludedTile/shadow", occludedTile, &Fixture::shadow, false},
    {"occludedStream/ao", occludedStream, &Fixture::ao, false},
};

} // namespace

int main(int argc, char** argv) {
    for (const char* isa : {"generic", "sse4", "avx2", "avx512", "neon"}) {
        const KernelTable* const table = findKernels(isa);
        for (int mode = 0; table && mode < kPrecisionCount; ++mode) {
            for (const Kernel& kernel : kKernels) {
                if (Precision(mode) == Precision::Precise && !kernel.precise) continue;
                const std::string name =
                    std::string(isa) + "/" + kModes[mode] + "/" + kernel.name;
                benchmark::RegisterBenchmark(name.c_str(), kernel.run, table, mode, kernel.rays)
                    ->Unit(benchmark::kMillisecond);
            }
        }
    }
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}

// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>

#include "tests/bench/build_engine.h"
#include "tests/bench/command.h"
#include "tests/bench/options.h"
#include "tests/support/ray_sets.h"

namespace smart::bench {
namespace {

struct Options {
    std::string scene, json;
    std::vector<std::string> peers;
    ViewOptions view;
    uint32_t size = 512;
    unsigned threads = 1, repeat = 5;
};

/// What one builder does; seconds are the least of all repeats.
struct Figures {
    std::string name;
    bool peer = false;
    std::vector<double> buildSeconds; ///< for each number of threads
    std::size_t bytes = 0;
    float cost = 0;
    double traceSeconds[2] = {0, 0};
    std::size_t wrong[2] = {0, 0}; ///< answers other than the first builder's
    std::unique_ptr<TracedTree> tree;
};

const char* const kKinds[2] = {"primary", "random"};
/// Two rays in a million may find another triangle: at edges, engines differ.
constexpr double kTolerated = 2e-6;
/// Distances that count as equal, relative.
constexpr float kSame = 1e-3f;

RaySet randomPackets(const std::vector<Triangle>& triangles, std::size_t count) {
    RaySet set;
    RayPacket packet{};
    uint32_t lane = 0;
    for (const Ray& ray : test::randomRays(triangles, count, 17)) {
        for (int k = 0; k < 3; ++k) {
            packet.org[k][lane] = ray.org[k];
            packet.dir[k][lane] = ray.dir[k];
        }
        packet.tNear[lane] = 0;
        packet.tFar[lane] = std::numeric_limits<float>::max();
        packet.active |= 1u << lane;
        if (++lane < kPacketSize) continue;
        set.add(packet);
        packet = {};
        lane = 0;
    }
    return set;
}

std::size_t countWrong(const RaySet& rays, const std::vector<Found>& truth,
                       const std::vector<Found>& found) {
    std::size_t wrong = 0;
    for (std::size_t p = 0; p < rays.packets.size(); ++p) {
        for (int i = 0; i < kPacketSize; ++i) {
            if (!(rays.packets[p].active >> i & 1)) continue;
            if (truth[p].triangle[i] == found[p].triangle[i]) continue;
            const bool both = truth[p].triangle[i] != kNoHit && found[p].triangle[i] != kNoHit;
            wrong += !both || std::fabs(truth[p].t[i] - found[p].t[i]) > kSame * truth[p].t[i];
        }
    }
    return wrong;
}

void measureBuilds(const std::vector<TreeBuilder>& builders, const Options& options,
                   const std::vector<Triangle>& triangles, std::vector<Figures>& figures) {
    const std::vector<unsigned> threads = threadCounts(options.threads);
    for (std::size_t t = 0; t < threads.size(); ++t) {
        for (unsigned i = 0; i < options.repeat; ++i) {
            for (std::size_t b = 0; b < builders.size(); ++b) {
                Figures& f = figures[b];
                showProgress(f.name + ", build " + std::to_string(i + 1));
                f.tree.reset(); // so that memory is as it was for all
                double seconds = 0;
                f.tree = builders[b].build(triangles, threads[t], seconds);
                f.buildSeconds.resize(t + 1, std::numeric_limits<double>::infinity());
                f.buildSeconds[t] = std::min(f.buildSeconds[t], seconds);
                f.bytes = f.tree->bytes();
                f.cost = f.tree->cost();
            }
        }
    }
}

void measureRays(const RaySet& rays, int kind, unsigned repeat, std::vector<Figures>& figures) {
    std::vector<Found> truth(rays.packets.size()), found(rays.packets.size());
    for (unsigned i = 0; i < repeat; ++i) {
        for (Figures& f : figures) {
            showProgress(f.name + ", " + kKinds[kind] + " rays");
            const BuildClock clock(1);
            f.tree->closest(rays, kind == 0, found.data());
            const double seconds = clock.seconds();
            f.traceSeconds[kind] = i == 0 ? seconds : std::min(f.traceSeconds[kind], seconds);
            if (i > 0) continue;
            if (&f == &figures[0]) truth = found;
            f.wrong[kind] = countWrong(rays, truth, found);
        }
    }
}

int run(const Options& options) {
    const std::vector<Triangle> triangles = readTriangles(options.scene);
    if (triangles.empty()) throw UsageError("--scene: it has no triangles");
    std::vector<TreeBuilder> builders = openrtBuilders();
#ifdef OPENRT_BENCH_EMBREE
    if (wantsEmbree(options.peers))
        for (TreeBuilder& peer : embreeBuilders()) builders.push_back(std::move(peer));
#endif
    std::vector<Figures> figures(builders.size());
    for (std::size_t b = 0; b < builders.size(); ++b) {
        figures[b].name = builders[b].name;
        figures[b].peer = builders[b].peer;
    }
    const RaySet rays[2] = {primaryRays(options.view.view(options.scene), options.size),
                            randomPackets(triangles, std::size_t(options.size) * options.size)};
    measureBuilds(builders, options, triangles, figures);
    for (int kind = 0; kind < 2; ++kind) measureRays(rays[kind], kind, options.repeat, figures);
    showProgress("");

    const std::vector<unsigned> threads = threadCounts(options.threads);
    const double million = 1e-6 * double(triangles.size());
    nlohmann::json root{{"scene", options.scene}, {"triangles", triangles.size()}};
    std::cout << options.scene << ": " << triangles.size() << " triangles\n"
              << "                        ";
    for (const unsigned t : threads) std::cout << "  ms, " << t << " th.   M/s";
    std::cout << "  bytes/tri    cost  Mrays/s primary   random\n" << std::fixed;
    bool refused = false;
    for (const Figures& f : figures) {
        nlohmann::json row{{"builder", f.name}, {"peer", f.peer}, {"bytes", f.bytes}};
        if (f.cost > 0) row["cost"] = f.cost;
        std::cout << "  " << std::left << std::setw(22) << f.name << std::right
                  << std::setprecision(1);
        for (std::size_t t = 0; t < threads.size(); ++t) {
            std::cout << std::setw(11) << 1e3 * f.buildSeconds[t] << std::setw(6)
                      << million / f.buildSeconds[t];
            row["build_seconds"][std::to_string(threads[t])] = f.buildSeconds[t];
        }
        std::cout << std::setw(11) << double(f.bytes) / double(triangles.size()) << std::setw(8)
                  << (f.cost > 0 ? f.cost : 0.0f);
        for (int kind = 0; kind < 2; ++kind) {
            if (double(f.wrong[kind]) > kTolerated * double(rays[kind].active) + 1) {
                std::cout << "  refused: " << f.wrong[kind] << ' ' << kKinds[kind] << " wrong";
                refused |= !f.peer;
                continue;
            }
            const double speed = 1e-6 * double(rays[kind].active) / f.traceSeconds[kind];
            std::cout << std::setw(kind == 0 ? 17 : 9) << std::setprecision(2) << speed;
            row["mrays_per_second"][kKinds[kind]] = speed;
        }
        std::cout << '\n';
        root["builders"].push_back(row);
    }
    writeJson(options.json, root);
    return refused ? kExitRefused : 0;
}

} // namespace

Run addBuild(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    addScene(app, options->scene);
    options->view.add(app);
    addSize(app, options->size);
    addThreads(app, options->threads, "threads measured beside one thread");
    addRepeat(app, options->repeat);
    addPeers(app, options->peers);
    addJson(app, options->json);
    return [options] { return run(*options); };
}

} // namespace smart::bench

// SPDX-License-Identifier: MIT
#include <iostream>
#include <memory>

#include "tests/bench/command.h"
#include "tests/bench/openrt_engine.h"
#include "tests/bench/options.h"
#include "tests/bench/report.h"
#ifdef OPENRT_BENCH_EMBREE
#include "tests/bench/embree_engine.h"
#endif

namespace smart::bench {
namespace {

struct Options {
    std::string scene, json;
    std::vector<std::string> peers;
    unsigned threads = processorCount(), repeat = 5;
};

template <class Build>
BuildReport fastest(const std::string& engine, unsigned repeat, const Build& build) {
    BuildReport best;
    for (unsigned i = 0; i < repeat; ++i) {
        showProgress(engine + ", build " + std::to_string(i + 1));
        const BuildReport one = build();
        if (i == 0 || one.seconds < best.seconds) best = one;
    }
    return best;
}

int run(const Options& options) {
    Report report;
    report.scene = options.scene;
    const std::vector<Triangle> triangles = readTriangles(options.scene);
    report.triangles = triangles.size();
    for (const unsigned threads : threadCounts(options.threads)) {
        const auto add = [&](const std::string& engine, const auto& build) {
            report.builds.push_back({engine, threads, fastest(engine, options.repeat, build)});
        };
        add("openrt", [&] {
            BuildReport one;
            buildOpenrt(triangles, Precision::Watertight, threads, one);
            return one;
        });
#ifdef OPENRT_BENCH_EMBREE
        if (wantsEmbree(options.peers)) {
            add("embree medium",
                [&] { return buildEmbree(triangles, EmbreeQuality::Medium, threads); });
            add("embree high",
                [&] { return buildEmbree(triangles, EmbreeQuality::High, threads); });
        }
#endif
    }
    showProgress("");
    std::cout << report;
    writeJson(options.json, report.json());
    return 0;
}

} // namespace

Run addBuild(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    addScene(app, options->scene);
    addThreads(app, options->threads);
    addRepeat(app, options->repeat);
    addPeers(app, options->peers);
    addJson(app, options->json);
    return [options] { return run(*options); };
}

} // namespace smart::bench

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
    std::string scene, isa, precision = "watertight", json;
    ViewOptions view;
    std::vector<std::string> peers;
    uint32_t size = 1024;
    unsigned threads = processorCount(), repeat = 5;
    bool plantError = false;
};

int run(const Options& options) {
    selectIsa(options.isa);
    Report report;
    report.scene = options.scene;
    const std::vector<Triangle> triangles = readTriangles(options.scene);
    report.triangles = triangles.size();
    const View view = options.view.view();
    const Precision precision = precisionOf(options.precision);
    showProgress("building");
    BuildReport built;
    const ScenePtr scene = buildOpenrt(triangles, precision, options.threads, built);
    report.builds.push_back({"openrt", options.threads, built});
    if (precision != Precision::Precise)
        report.builds.push_back({"openrt, for tiles beside it", 1, prepareTiles(*scene)});
    std::vector<EnginePtr> engines = openrtEngines(scene, precision, options.plantError);
#ifdef OPENRT_BENCH_EMBREE
    for (const bool robust : {false, true}) {
        if (!wantsEmbree(options.peers)) continue;
        for (EnginePtr& engine : embreeEngines(triangles, robust, options.threads)) {
            engines.push_back(std::move(engine));
        }
    }
#endif
    showProgress("making rays");
    const RaySet primary = primaryRays(view, options.size);
    const RaySet shadow = shadowRays(view, primary, scene->view(), triangles);
    for (const Kind kind : {Kind::Primary, Kind::Shadow}) {
        const RaySet& rays = kind == Kind::Primary ? primary : shadow;
        for (const unsigned threads : threadCounts(options.threads)) {
            report.series.push_back(
                measure(triangles, rays, kind, engines, threads, options.repeat, showProgress));
        }
    }
    showProgress("");
    std::cout << report;
    writeJson(options.json, report.json());
    return report.anyRefused() ? kExitRefused : 0;
}

} // namespace

Run addRays(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    addScene(app, options->scene);
    options->view.add(app);
    addSize(app, options->size);
    addThreads(app, options->threads);
    addRepeat(app, options->repeat);
    addIsa(app, options->isa);
    addPrecision(app, options->precision);
    addPeers(app, options->peers);
    addJson(app, options->json);
    app.add_flag("--plant-error", options->plantError,
                 "name wrong triangles now and then, to prove the comparison");
    return [options] { return run(*options); };
}

} // namespace smart::bench

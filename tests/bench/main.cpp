// SPDX-License-Identifier: MIT
// openrt-bench: how fast rays are traced and trees are built, beside Embree where it is installed.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <thread>

#include "libsmart/kernel/kernels.h"
#include "tests/bench/openrt_engine.h"
#include "tests/bench/report.h"
#include "tests/bench/reshade.h"
#include "tests/bench/shaded_frames.h"
#ifdef OPENRT_BENCH_EMBREE
#include "tests/bench/embree_engine.h"
#endif

namespace smart::bench {
namespace {

constexpr int kExitError = 1, kExitRefused = 3;

struct Options {
    std::string scene, cameras, name, isa, precision = "watertight", json;
    std::vector<double> camera, light;
    std::vector<std::string> peers;
    uint32_t size = 1024, instances = 1000;
    unsigned threads = std::max(1u, std::thread::hardware_concurrency()), repeat = 5;
    bool plantError = false;

    bool wants(const char* peer) const {
        return std::find(peers.begin(), peers.end(), peer) != peers.end();
    }
};

/// One line that is written over, where a person watches.
void showProgress(const std::string& text) {
    static const bool terminal = isatty(STDERR_FILENO);
    if (terminal) std::cerr << '\r' << text << "\033[K" << std::flush;
}

View viewOf(const Options& options) {
    View view;
    if (!options.cameras.empty()) view = readView(options.cameras, options.name);
    if (!options.camera.empty()) {
        const std::vector<double>& c = options.camera;
        test::CameraPose& pose = view.camera;
        for (std::size_t k = 0; k < 3; ++k) {
            pose.eye[k] = c[k];
            pose.target[k] = c[3 + k];
            pose.up[k] = c[6 + k];
        }
        pose.fov = c[9];
    }
    if (!options.light.empty()) std::copy_n(options.light.begin(), 3, view.light);
    return view;
}

std::vector<unsigned> threadCounts(const Options& options) {
    if (options.threads == 1) return {1};
    return {1, options.threads};
}

void runBuild(const Options& options, const std::vector<Triangle>& triangles, Report& report) {
    for (const unsigned threads : threadCounts(options)) {
        const auto keepBest = [&](const std::string& engine, const auto& build) {
            BuildReport best;
            for (unsigned i = 0; i < options.repeat; ++i) {
                showProgress(engine + ", build " + std::to_string(i + 1));
                const BuildReport one = build();
                if (i == 0 || one.seconds < best.seconds) best = one;
            }
            report.builds.push_back({engine, threads, best});
        };
        keepBest("openrt", [&] {
            BuildReport one;
            buildOpenrt(triangles, Precision::Watertight, threads, one);
            return one;
        });
#ifdef OPENRT_BENCH_EMBREE
        if (options.wants("embree") || options.wants("embree-robust")) {
            keepBest("embree medium",
                     [&] { return buildEmbree(triangles, EmbreeQuality::Medium, threads); });
            keepBest("embree high",
                     [&] { return buildEmbree(triangles, EmbreeQuality::High, threads); });
        }
#endif
    }
}

void runRays(const Options& options, const std::vector<Triangle>& triangles, Report& report) {
    const View view = viewOf(options);
    const auto precision = options.precision == "fast"      ? Precision::Fast
                           : options.precision == "precise" ? Precision::Precise
                                                            : Precision::Watertight;
    showProgress("building");
    BuildReport built;
    const ScenePtr scene = buildOpenrt(triangles, precision, options.threads, built);
    report.builds.push_back({"openrt", options.threads, built});
    if (precision != Precision::Precise)
        report.builds.push_back({"openrt, for tiles beside it", 1, prepareTiles(*scene)});
    std::vector<EnginePtr> engines = openrtEngines(scene, precision, options.plantError);
#ifdef OPENRT_BENCH_EMBREE
    for (const bool robust : {false, true}) {
        if (!options.wants(robust ? "embree-robust" : "embree")) continue;
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
        for (const unsigned threads : threadCounts(options)) {
            report.series.push_back(
                measure(triangles, rays, kind, engines, threads, options.repeat, showProgress));
        }
    }
}

int runFrames(const Options& options) {
    if (!options.isa.empty() && !selectKernels(options.isa.c_str())) {
        throw std::runtime_error("--isa " + options.isa + ": not in this library or machine");
    }
    const ShadingReport report =
        measureFrames(readTriangles(options.scene), viewOf(options), options.size,
                      options.threads, options.repeat, showProgress);
    showProgress("");
    std::cout << report;
    return report.allSame() ? 0 : kExitRefused;
}

int run(const Options& options, bool rays) {
    if (!options.isa.empty() && !selectKernels(options.isa.c_str())) {
        throw std::runtime_error("--isa " + options.isa + ": not in this library or machine");
    }
    if (options.size == 0 || options.size % 4 != 0) {
        throw std::runtime_error("--size: must be a multiple of 4");
    }
    Report report;
    report.scene = options.scene;
    const std::vector<Triangle> triangles = readTriangles(options.scene);
    report.triangles = triangles.size();
    if (rays)
        runRays(options, triangles, report);
    else
        runBuild(options, triangles, report);
    showProgress("");
    std::cout << report;
    if (!options.json.empty()) {
        std::ofstream file(options.json);
        file << report.json().dump(2) << '\n';
        if (!file) throw std::runtime_error(options.json + ": can not be written");
    }
    return report.anyRefused() ? kExitRefused : 0;
}

int runReshade(const Options& options) {
    std::cout << measureReshading(readTriangles(options.scene), options.instances,
                                  options.threads);
    return 0;
}

} // namespace
} // namespace smart::bench

int main(int argc, char** argv) {
    smart::bench::Options options;
    CLI::App app("Measures ray and build speeds. Exit code 3: answers were wrong, speeds refused.");
    app.require_subcommand(1);
    CLI::App* const rays = app.add_subcommand("rays", "primary and point-light shadow rays");
    CLI::App* const build = app.add_subcommand("build", "build seconds and memory");
    CLI::App* const frame =
        app.add_subcommand("frame", "frames with a point light: packets, points, fixed shaders");
    for (CLI::App* command : {rays, build, frame}) {
        command->add_option("--scene", options.scene, "a .tri file, or generated:N")->required();
        command->add_option("--threads", options.threads, "measured beside one thread")
            ->check(CLI::Range(1, 1024));
        command->add_option("--repeat", options.repeat, "measurements of each kind")
            ->check(CLI::Range(1, 1000));
    }
    for (CLI::App* command : {rays, frame}) {
        command->add_option("--camera", options.camera, "ex,ey,ez,tx,ty,tz,ux,uy,uz,fov")
            ->delimiter(',')
            ->expected(10);
        command->add_option("--light", options.light, "x,y,z")->delimiter(',')->expected(3);
        command->add_option("--cameras", options.cameras,
                            "file of views: name and 13 numbers a line");
        command->add_option("--name", options.name, "which line of --cameras");
        command->add_option("--size", options.size, "width and height in pixels")
            ->check(CLI::Range(4, 16384));
        command->add_option("--isa", options.isa, "generic, sse4, avx2, avx512, neon");
    }
    for (CLI::App* command : {rays, build}) {
        command->add_option("--json", options.json, "also write the figures to this file");
        command->add_option("--peers", options.peers, "embree, embree-robust")
            ->delimiter(',')
#ifdef OPENRT_BENCH_EMBREE
            ->check(CLI::IsMember({"embree", "embree-robust"}));
#else
            ->check([](const std::string&) {
                return std::string("this program was built without Embree");
            });
#endif
    }
    rays->add_option("--precision", options.precision)
        ->check(CLI::IsMember({"watertight", "fast", "precise"}));
    rays->add_flag("--plant-error", options.plantError,
                   "name wrong triangles now and then, to prove the comparison");
    CLI::App* const reshade =
        app.add_subcommand("reshade", "memory of instances with shaders of their own");
    reshade->add_option("--scene", options.scene, "a .tri file, or generated:N")->required();
    reshade->add_option("--instances", options.instances)->check(CLI::Range(1, 10'000'000));
    reshade->add_option("--threads", options.threads)->check(CLI::Range(1, 1024));
    CLI11_PARSE(app, argc, argv);
    try {
        if (reshade->parsed()) return smart::bench::runReshade(options);
        if (frame->parsed()) return smart::bench::runFrames(options);
        return smart::bench::run(options, rays->parsed());
    } catch (const std::exception& error) {
        std::cerr << "openrt-bench: " << error.what() << '\n';
        return smart::bench::kExitError;
    }
}

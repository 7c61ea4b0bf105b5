// SPDX-License-Identifier: MIT
// openrt-accuracy: what each engine and mode gets wrong in the hard cases, and what each costs.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <stdexcept>
#include <thread>

#include "libsmart/kernel/kernels.h"
#include "openrt/version.h"
#include "samples/common/standard_output.h"
#include "tests/accuracy/accuracy_report.h"
#include "tests/bench/json_file.h"

namespace smart::test {
namespace {

constexpr int kExitError = 1, kExitUsage = 2, kExitBroken = 3;

struct Options {
    RunSize size;
    SpeedOptions speed;
    std::vector<std::string> cases, engines, scenes;
    std::vector<double> camera, light;
    std::string isa, cameras, name, json;
    bool table = false, list = false;
};

void showProgress(const std::string& text) {
    static const bool terminal = isatty(STDERR_FILENO);
    if (terminal) std::cerr << '\r' << text << "\033[K" << std::flush;
}

bool startsWithOneOf(const std::string& name, const std::vector<std::string>& starts) {
    return std::any_of(starts.begin(), starts.end(),
                       [&](const std::string& start) { return name.rfind(start, 0) == 0; });
}

std::vector<EngineKind> chosenEngines(const std::vector<std::string>& names) {
    std::vector<EngineKind> chosen;
    const std::vector<EngineKind> all = engineKinds();
    const auto isNamed = [&](const EngineKind& kind) {
        if (names.empty())
            return kind.mode >= 0 || kind.name == "embree" || kind.name == "embree-robust";
        return std::find(names.begin(), names.end(), kind.name) != names.end() ||
               std::find(names.begin(), names.end(), "all") != names.end();
    };
    std::copy_if(all.begin(), all.end(), std::back_inserter(chosen), isNamed);
    return chosen;
}

/// "none" of --cases asks for speeds only.
bool wanted(const Options& options, const std::string& name) {
    return options.cases.empty() || startsWithOneOf(name, options.cases);
}

constexpr const char* kSecondary = "H9";

std::vector<std::string> caseNames() {
    std::vector<std::string> names;
    for (const NamedCase& named : hardCases()) names.push_back(named.name);
    names.push_back(kSecondary);
    return names;
}

std::string faultOfName(bool known, const std::string& name) {
    return known ? std::string() : "there is no " + name + " here; see --list";
}

std::string faultOfCase(const std::string& start) {
    const std::vector<std::string> names = caseNames();
    const auto isMeant = [&](const std::string& name) { return name.starts_with(start); };
    return faultOfName(start == "none" || std::any_of(names.begin(), names.end(), isMeant), start);
}

std::string faultOfEngine(const std::string& name) {
    const std::vector<EngineKind> kinds = engineKinds();
    const auto isMeant = [&](const EngineKind& kind) { return kind.name == name; };
    return faultOfName(name == "all" || std::any_of(kinds.begin(), kinds.end(), isMeant), name);
}

void printNames() {
    for (const std::string& name : caseNames()) std::cout << name << '\n';
    for (const EngineKind& kind : engineKinds()) std::cout << "--engines " << kind.name << '\n';
}

void measureSpeeds(const Options& options, AccuracyReport& report) {
    for (const std::string& scene : options.scenes) {
        showProgress(scene);
        SpeedOptions speed = options.speed;
        speed.scene = scene;
        speed.buildThreads = options.size.threads;
        if (!options.cameras.empty()) {
            // The line that --name says, or the one named like the file.
            std::string name = options.name;
            if (name.empty()) {
                name = scene.substr(scene.find_last_of('/') + 1);
                name = name.substr(0, name.find('.'));
            }
            speed.view = bench::readView(options.cameras, name);
        }
        if (!options.camera.empty()) {
            const std::vector<double>& c = options.camera;
            std::copy_n(&c[0], 3, speed.view.camera.eye);
            std::copy_n(&c[3], 3, speed.view.camera.target);
            std::copy_n(&c[6], 3, speed.view.camera.up);
            speed.view.camera.fov = c[9];
        }
        if (!options.light.empty()) std::copy_n(options.light.begin(), 3, speed.view.light);
        report.speeds.push_back(measureScene(speed));
    }
}

int run(const Options& options) {
    if (options.list) {
        printNames();
        return 0;
    }
    if (!options.isa.empty() && !selectKernels(options.isa.c_str()))
        throw CLI::ValidationError("--isa " + options.isa + ": not in this library or machine");
    if (options.speed.size == 0 || options.speed.size % 4 != 0)
        throw CLI::ValidationError("--size: must be a multiple of 4");
    const std::vector<EngineKind> engines = chosenEngines(options.engines);
    AccuracyReport report;
    report.isa = kernels().name;
    report.embree = embreeVersion();
    report.threads = options.size.threads;
    report.rays = options.size.rays;
    for (const NamedCase& named : hardCases()) {
        if (!wanted(options, named.name)) continue;
        showProgress(named.name);
        report.cases.push_back(runCase(named, engines, options.size));
    }
    if (wanted(options, kSecondary)) {
        showProgress(kSecondary);
        report.secondary = runSecondary(engines, std::max<std::size_t>(1, options.size.rays / 5),
                                        options.size.threads, options.size.seed);
    }
    measureSpeeds(options, report);
    showProgress("");
    if (options.table) report.printTable(std::cout);
    bench::writeJson(options.json, report.json());
    if (report.cases.empty() && report.secondary.empty()) return 0; // no promise was tested
    const std::string broken = report.brokenPromises();
    std::cout << (broken.empty() ? "All promises are kept.\n" : broken);
    return broken.empty() ? 0 : kExitBroken;
}

int statusOf(int argc, char** argv) {
    Options options;
    CLI::App app(
        "Judges engines by exact arithmetic in the hard cases H1 to H12, and measures what "
        "each mode costs. Exit codes: 1 error, 2 wrong options, 3 a mode of the library broke a "
        "promise.",
        "openrt-accuracy");
    app.set_version_flag("--version", "openrt-accuracy " OPENRT_VERSION_STRING);
    auto& size = options.size;
    size.threads = std::max(1u, std::thread::hardware_concurrency());
    app.add_option("--rays", size.rays, "rays of the largest cases; others get their share")
        ->check(CLI::Range(std::size_t(1), std::size_t(1) << 40));
    app.add_option("--identity", size.identityRays,
                   "rays of each case that go through every instruction set and form");
    app.add_option("--brute-tests", size.bruteTests,
                   "triangle tests of each case for engines without a tree");
    app.add_option("--seed", size.seed, "of all rays");
    app.add_option("--threads", size.threads)->check(CLI::Range(1, 1024));
    app.add_option("--cases", options.cases, "how their names start, or none; all if not given")
        ->delimiter(',')
        ->check(&faultOfCase);
    app.add_option("--engines", options.engines,
                   "names, or all; ours, embree and embree-robust if not given")
        ->delimiter(',')
        ->check(&faultOfEngine);
    app.add_flag("--list", options.list, "print the names of cases and engines");
    app.add_option("--scene", options.scenes, "also measure speeds on a .tri file or generated:N")
        ->delimiter(',');
    app.add_option("--cameras", options.cameras, "file of views: name and 13 numbers a line");
    app.add_option("--name", options.name,
                   "which line of --cameras; the scene's name if not given");
    app.add_option("--camera", options.camera, "ex,ey,ez,tx,ty,tz,ux,uy,uz,fov")
        ->delimiter(',')
        ->expected(10);
    app.add_option("--light", options.light, "x,y,z")->delimiter(',')->expected(3);
    app.add_option("--size", options.speed.size, "width and height of a scene's picture")
        ->check(CLI::Range(4, 16384));
    app.add_option("--repeat", options.speed.repeat, "measurements of each kind")
        ->check(CLI::Range(1, 1000));
    app.add_option("--isa", options.isa, "generic, sse4, avx2, avx512, neon");
    bench::addJson(app, options.json);
    app.add_flag("--table", options.table, "print the figures");
    try {
        app.parse(argc, argv);
        return run(options);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error); // --help, --version
        std::cerr << "openrt-accuracy: " << error.what() << '\n';
        return kExitUsage;
    } catch (const std::exception& error) {
        std::cerr << "openrt-accuracy: " << error.what() << '\n';
        return kExitError;
    }
}

} // namespace
} // namespace smart::test

int main(int argc, char** argv) {
    using namespace smart::test;
    return samples::finishOutput("openrt-accuracy", statusOf(argc, argv), kExitError);
}

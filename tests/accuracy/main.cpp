// SPDX-License-Identifier: MIT
// openrt-accuracy: what each engine and mode gets wrong in the hard cases, and what each costs.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <stdexcept>

#include "libsmart/kernel/kernels.h"
#include "openrt/version.h"
#include "samples/common/standard_output.h"
#include "tests/accuracy/accuracy_report.h"
#include "tests/bench/command.h"
#include "tests/bench/options.h"

namespace smart::test {
namespace {

struct Options {
    RunSize size;
    SpeedOptions speed;
    std::vector<std::string> cases, engines, scenes;
    bench::ViewOptions view;
    std::string isa, json;
    bool table = false, list = false;
};

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
        bench::showProgress(scene);
        SpeedOptions speed = options.speed;
        speed.scene = scene;
        speed.buildThreads = options.size.threads;
        speed.view = options.view.view(scene);
        report.speeds.push_back(measureScene(speed));
    }
}

int run(const Options& options) {
    if (options.list) {
        printNames();
        return 0;
    }
    bench::selectIsa(options.isa);
    const std::vector<EngineKind> engines = chosenEngines(options.engines);
    AccuracyReport report;
    report.isa = kernels().name;
    report.embree = embreeVersion();
    report.threads = options.size.threads;
    report.rays = options.size.rays;
    for (const NamedCase& named : hardCases()) {
        if (!wanted(options, named.name)) continue;
        bench::showProgress(named.name);
        report.cases.push_back(runCase(named, engines, options.size));
    }
    if (wanted(options, kSecondary)) {
        bench::showProgress(kSecondary);
        report.secondary = runSecondary(engines, std::max<std::size_t>(1, options.size.rays / 5),
                                        options.size.threads, options.size.seed);
    }
    measureSpeeds(options, report);
    bench::showProgress("");
    if (options.table) report.printTable(std::cout);
    bench::writeJson(options.json, report.json());
    if (report.cases.empty() && report.secondary.empty()) return 0; // no promise was tested
    const std::string broken = report.brokenPromises();
    std::cout << (broken.empty() ? "All promises are kept.\n" : broken);
    return broken.empty() ? 0 : bench::kExitRefused;
}

int statusOf(int argc, char** argv) {
    Options options;
    CLI::App app(
        "Judges engines by exact arithmetic in the hard cases H1 to H12, and measures what "
        "each mode costs. The exit status is 1 for an error, 2 for a wrong command line, 3 if a "
        "mode of the library broke a promise.",
        "openrt-accuracy");
    app.set_version_flag("--version", "openrt-accuracy " OPENRT_VERSION_STRING);
    auto& size = options.size;
    app.add_option("--rays", size.rays, "rays of the largest cases; others get their share")
        ->check(CLI::Range(std::size_t(1), std::size_t(1) << 40))
        ->capture_default_str();
    app.add_option("--identity", size.identityRays,
                   "rays of each case that go through every instruction set and form")
        ->capture_default_str();
    app.add_option("--brute-tests", size.bruteTests,
                   "triangle tests of each case for engines without a tree")
        ->capture_default_str();
    app.add_option("--seed", size.seed, "of all rays")->capture_default_str();
    bench::addThreads(app, size.threads, "threads");
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
    options.view.add(app);
    bench::addSize(app, options.speed.size);
    bench::addRepeat(app, options.speed.repeat);
    bench::addIsa(app, options.isa);
    bench::addJson(app, options.json);
    app.add_flag("--table", options.table, "print the figures");
    try {
        app.parse(argc, argv);
        return run(options);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error); // --help, --version
        std::cerr << "openrt-accuracy: " << error.what() << '\n';
        return bench::kExitUsage;
    } catch (const bench::UsageError& error) {
        std::cerr << "openrt-accuracy: " << error.what() << '\n';
        return bench::kExitUsage;
    } catch (const std::exception& error) {
        std::cerr << "openrt-accuracy: " << error.what() << '\n';
        return bench::kExitError;
    }
}

} // namespace
} // namespace smart::test

int main(int argc, char** argv) {
    using namespace smart::test;
    return samples::finishOutput("openrt-accuracy", statusOf(argc, argv), smart::bench::kExitError);
}

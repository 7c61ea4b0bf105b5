// SPDX-License-Identifier: MIT
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "tests/bench/command.h"
#include "tests/bench/dynamic.h"
#include "tests/bench/dynamic_decay.h"
#include "tests/bench/dynamic_queue.h"
#include "tests/bench/options.h"

namespace smart::bench {
namespace {

struct Options : DynamicOptions {
    std::string json;
    std::vector<std::string> peers;
    unsigned queue = 0, decay = 0;
};

int run(Options& options) {
    options.embree = wantsEmbree(options.peers);
    const DynamicReport report = measureDynamic(options, showProgress);
    showProgress("");
    std::cout << report;
    nlohmann::json root = report.json();
    if (options.queue > 0) {
        constexpr uint32_t kInstances = 1000;
        const QueueFigures figures =
            measureQueue(DynamicScene::balls(kInstances), options, options.queue);
        std::cout << figures;
        root["queue"] = figures.json();
    }
    if (options.decay > 0 && options.sheet > 0) {
        const DecayReport decay = measureDecay(options, options.decay, showProgress);
        showProgress("");
        std::cout << decay;
        root["decay"] = decay.json();
    }
    writeJson(options.json, root);
    return report.anyRefused() ? kExitRefused : 0;
}

} // namespace

Run addDynamic(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    app.add_option("--instances", options->instances, "numbers of moving instances, or 0 for none")
        ->delimiter(',')
        ->check(CLI::Range(0, 10'000'000))
        ->capture_default_str();
    app.add_option("--sheet", options->sheet, "triangles of the deforming sheet, or 0 for none")
        ->check(CLI::Range(0, 100'000'000))
        ->capture_default_str();
    app.add_option("--queue", options->queue, "frames to watch the queue with, or 0 for none")
        ->check(CLI::Range(0, 1'000'000))
        ->capture_default_str();
    app.add_option("--decay", options->decay,
                   "updates of the sheet after which rays are timed against a fresh object, or 0")
        ->check(CLI::Range(0, 100'000))
        ->capture_default_str();
    addSize(app, options->size);
    addThreads(app, options->threads, "threads");
    addRepeat(app, options->repeat);
    addJson(app, options->json);
    addPeers(app, options->peers);
    app.add_flag("--plant-error", options->plantError,
                 "the first engine stays a step behind, to prove the comparison");
    return [options] {
        std::erase(options->instances, 0u);
        return run(*options);
    };
}

} // namespace smart::bench

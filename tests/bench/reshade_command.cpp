// SPDX-License-Identifier: MIT
#include <iostream>
#include <memory>

#include "tests/bench/command.h"
#include "tests/bench/options.h"
#include "tests/bench/reshade.h"

namespace smart::bench {
namespace {

struct Options {
    std::string scene;
    uint32_t instances = 1000;
    unsigned threads = 1;
};

} // namespace

Run addReshade(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    addScene(app, options->scene);
    app.add_option("--instances", options->instances, "instances, each with shaders of its own")
        ->check(CLI::Range(1, 10'000'000))
        ->capture_default_str();
    addThreads(app, options->threads, "threads that build");
    return [options] {
        std::cout << measureReshading(readTriangles(options->scene), options->instances,
                                      options->threads);
        return 0;
    };
}

} // namespace smart::bench

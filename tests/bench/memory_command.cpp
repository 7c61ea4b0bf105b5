// SPDX-License-Identifier: MIT
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "tests/bench/command.h"
#include "tests/bench/dynamic_memory.h"
#include "tests/bench/options.h"

namespace smart::bench {

Run addMemory(CLI::App& app) {
    struct Options {
        unsigned triangles = 200000, objects = 200;
        std::string json;
    };
    const auto options = std::make_shared<Options>();
    app.add_option("--triangles", options->triangles, "triangles of an object")
        ->check(CLI::Range(40, 100'000'000))
        ->capture_default_str();
    app.add_option("--objects", options->objects, "objects, of which a tenth is seen")
        ->check(CLI::Range(1, 1'000'000))
        ->capture_default_str();
    addJson(app, options->json);
    return [options] {
        const MemoryReport report = measureMemory(options->triangles, options->objects);
        std::cout << report;
        writeJson(options->json, report.json());
        return 0;
    };
}

} // namespace smart::bench

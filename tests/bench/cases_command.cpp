// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "tests/bench/cases.h"
#include "tests/bench/command.h"
#include "tests/bench/machine.h"
#include "tests/bench/options.h"

namespace smart::bench {
namespace {

struct Options {
    std::string isa, precision = "watertight", json;
    uint32_t size = 128;
    unsigned repeat = 5;
};

int run(const Options& options) {
    selectIsa(options.isa);
    const std::vector<CaseSeries> cases =
        measureCases(precisionOf(options.precision), options.size, options.repeat, showProgress);
    showProgress("");
    print(std::cout, cases);
    writeJson(options.json, {{"isa", kernels().name},
                             {"precision", options.precision},
                             {"machine", machine()},
                             {"cases", jsonOf(cases)}});
    const bool wrong = std::any_of(cases.begin(), cases.end(), [](const CaseSeries& series) {
        return std::any_of(series.results.begin(), series.results.end(),
                           [](const CaseResult& one) { return one.wrong > 0; });
    });
    return wrong ? kExitRefused : 0;
}

} // namespace

Run addCases(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    addSize(app, options->size);
    addRepeat(app, options->repeat);
    addIsa(app, options->isa);
    addPrecision(app, options->precision);
    addJson(app, options->json);
    return [options] { return run(*options); };
}

} // namespace smart::bench

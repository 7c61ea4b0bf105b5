// SPDX-License-Identifier: MIT
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "tests/bench/command.h"
#include "tests/bench/options.h"
#include "tests/bench/shaded_frames.h"

namespace smart::bench {
namespace {

struct Options {
    std::string scene, surface, isa, json;
    ViewOptions view;
    uint32_t size = 1024;
    unsigned threads = 1, repeat = 5;
};

nlohmann::json toJson(const FrameReport& report) {
    nlohmann::json all = nlohmann::json::array();
    for (const FrameSeries& s : report.series) {
        nlohmann::json row{{"surface", s.surface},
                           {"threads", s.threads},
                           {"pixels", s.pixels},
                           {"shadowRays", s.shadowRays},
                           {"aloneSeconds", s.aloneSeconds},
                           {"cameraSeconds", s.cameraSeconds}};
        for (const FrameCost& way : s.ways) row["ways"][way.way] = way.seconds;
        all.push_back(std::move(row));
    }
    return all;
}

int run(const Options& options) {
    selectIsa(options.isa);
    const FrameReport report =
        measureFrames(readTriangles(options.scene), options.view.view(options.scene),
                      options.surface, options.size, options.threads, options.repeat, showProgress);
    showProgress("");
    std::cout << report;
    writeJson(options.json, {{"scene", options.scene}, {"frames", toJson(report)}});
    return report.allSame() ? 0 : kExitRefused;
}

} // namespace

Run addFrame(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    addScene(app, options->scene);
    options->view.add(app);
    app.add_option("--surface", options->surface, "only surfaces whose name begins so");
    addSize(app, options->size);
    addThreads(app, options->threads, "threads measured beside one thread");
    addRepeat(app, options->repeat);
    addIsa(app, options->isa);
    addJson(app, options->json);
    return [options] { return run(*options); };
}

} // namespace smart::bench

// SPDX-License-Identifier: MIT
#include <iostream>
#include <memory>

#include "tests/bench/command.h"
#include "tests/bench/options.h"
#include "tests/bench/shaded_frames.h"

namespace smart::bench {
namespace {

struct Options {
    std::string scene, isa;
    ViewOptions view;
    uint32_t size = 1024;
    unsigned threads = processorCount(), repeat = 5;
};

int run(const Options& options) {
    selectIsa(options.isa);
    const FrameReport report =
        measureFrames(readTriangles(options.scene), options.view.view(), options.size,
                      options.threads, options.repeat, showProgress);
    showProgress("");
    std::cout << report;
    return report.allSame() ? 0 : kExitRefused;
}

} // namespace

Run addFrame(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    addScene(app, options->scene);
    options->view.add(app);
    addSize(app, options->size);
    addThreads(app, options->threads);
    addRepeat(app, options->repeat);
    addIsa(app, options->isa);
    return [options] { return run(*options); };
}

} // namespace smart::bench

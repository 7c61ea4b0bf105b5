// SPDX-License-Identifier: MIT
#include <algorithm>
#include <stdexcept>

#include "tests/conformance/conformance_case.h"
#include "tests/conformance/ports.h"

namespace conformance {
namespace {

constexpr Size kQuickSize{160, 120};
constexpr Size kSizes[] = {{64, 64}, kQuickSize, {300, 300}, {333, 517}, {512, 512}, {1024, 768}};
constexpr int kFrames = 3;

void addNumbers(Result& result, const Measures& m) {
    const auto worst = [&](const char* name, double value) {
        double& number = result.numbers[name];
        number = std::max(number, value);
    };
    worst("silhouettes", m.silhouettes);
    worst("open", m.open);
    worst("coverageInside", double(m.coverageInside));
    worst("coverageSilhouette", double(m.coverageSilhouette));
    worst("depthMax", m.depthMax);
    worst("colorMean", m.colorMean);
    worst("color999", m.color999);
    worst("silhouetteColorMean", m.silhouetteColorMean);
    worst("flip", m.flip);
}

Result compareWith(const Settings& settings, const Port& port, Size size, int frames,
                   Rasterizer rasterizer) {
    Result result{"picture/" + std::string(port.name) + "/" + size.text(), {}, {}};
    result.reference = nameOf(rasterizer);
    try {
        PortRun run(settings, port.name, size, frames, rasterizer);
        run.renderReference();
        run.renderTest();
        for (int frame = 0; frame < frames; ++frame) {
            const Reference reference = run.reference(frame);
            const Frame test = run.test(frame);
            const Measures measures = compare(reference, test, true);
            addNumbers(result, measures);
            for (const std::string& failure :
                 failuresOf(measures, port.kind, size.width, size.height))
                result.failures.push_back("frame " + std::to_string(frame) + ": " + failure);
            if (settings.keepPictures && frame == 0) {
                result.picture = run.stem();
                writePng(run.picturePath("difference", frame),
                         differencePicture(reference.frame.color, test.color));
            }
        }
    } catch (const std::exception& error) {
        result.failures.push_back(error.what());
    }
    return result;
}

// OpenGL leaves the precision of texture filters open: every frame as one of Mesa's two draws it.
Result comparePort(const Settings& settings, const Port& port, Size size, int frames) {
    const Result usual = compareWith(settings, port, size, frames, Rasterizer::kLlvmpipe);
    if (usual.passed()) return usual;
    const Result other = compareWith(settings, port, size, frames, Rasterizer::kSoftpipe);
    return other.passed() ? other : usual;
}

// OSMesa moved by half a pixel is not what OSMesa draws: a comparison that lets it pass is none.
Result halfPixelControl(const Settings& settings, const Port& port) {
    Result result{"control/half_pixel/" + std::string(port.name), {}, {}};
    const auto failures = [&](const Measures& measures) {
        return failuresOf(measures, port.kind, kQuickSize.width, kQuickSize.height);
    };
    try {
        PortRun run(settings, port.name, kQuickSize, 1, Rasterizer::kLlvmpipe);
        PortRun other(settings, port.name, kQuickSize, 1, Rasterizer::kSoftpipe);
        for (PortRun* const reference : {&run, &other}) {
            reference->renderReference();
            const Measures measures = compare(reference->reference(0), run.shifted(0), true);
            if (reference == &run) addNumbers(result, measures);
            if (failures(measures).empty())
                result.failures.push_back("a shift by half a pixel is not noticed");
        }
        const Measures same = compare(run.reference(0), run.reference(0).frame, true);
        for (const std::string& failure : failures(same))
            result.failures.push_back("OSMesa against itself: " + failure);
    } catch (const std::exception& error) {
        result.failures.push_back(error.what());
    }
    return result;
}

// Surfaces, lines, blending and textures: one port of each.
bool isQuickControl(const std::string& port) {
    return port == "gears" || port == "text" || port == "panes" || port == "texbind";
}

} // namespace

std::vector<Case> pictureCases(const Settings& settings) {
    std::vector<Case> cases;
    for (const Port& port : ports()) {
        for (const Size size : kSizes) {
            const bool quick = size.width == kQuickSize.width && size.height == kQuickSize.height;
            if (settings.quick && !quick) continue;
            const int frames = settings.quick ? 1 : kFrames;
            cases.push_back({"picture/" + std::string(port.name) + "/" + size.text(),
                             [=, &settings] { return comparePort(settings, port, size, frames); }});
        }
    }
    for (const Port& port : ports())
        if (!settings.quick || isQuickControl(port.name))
            cases.push_back({"control/half_pixel/" + std::string(port.name),
                             [=, &settings] { return halfPixelControl(settings, port); }});
    return cases;
}

} // namespace conformance

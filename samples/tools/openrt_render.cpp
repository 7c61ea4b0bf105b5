// SPDX-License-Identifier: MIT
// openrt-render: a scene file in, a picture out.
#include <openrt/rt.h>
#include <unistd.h>

#include <chrono>
#include <iostream>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "samples/common/confined_folder.h"
#include "samples/common/image_file.h"
#include "samples/common/output_file.h"
#include "samples/tools/render_statistics.h"
#include "samples/tools/scene_options.h"
#include "samples/tools/shader_options.h"

namespace {

using samples::PictureSize;
using Clock = std::chrono::steady_clock;

struct RenderOptions : samples::SceneOptions {
    std::string output;
    std::string stats;
    samples::ShaderOptions shaders;
} options;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

enum class Format { Png, Exr };

Format formatFrom(const std::string& output) {
    const std::string ending = samples::endingOf(output);
    if (ending == ".png") return Format::Png;
    if (ending == ".exr") return Format::Exr;
    throw CLI::ValidationError(output + ": its name ends neither in .png nor in .exr");
}

/// Draws a bar on a terminal while the frame in flight is rendered.
void showProgress() {
    using namespace std::chrono_literals;
    constexpr int kWidth = 50;
    if (!isatty(STDERR_FILENO)) return;
    float done = 0.0f;
    do {
        rtGetFloatv(RT_FRAME_PROGRESS, &done);
        const int filled = int(done * kWidth);
        std::cerr << "\r[" << std::string(std::size_t(filled), '#')
                  << std::string(std::size_t(kWidth - filled), ' ') << "] " << int(done * 100)
                  << " %" << std::flush;
        if (done < 1.0f) std::this_thread::sleep_for(40ms);
    } while (done < 1.0f);
    std::cerr << '\r' << std::string(kWidth + 10, ' ') << '\r' << std::flush;
}

/// The frame buffer in the format that the file wants.
class Picture {
public:
    Picture(PictureSize size, Format format) : size_(size), format_(format) {
        const std::size_t pixels = std::size_t(size.width) * size.height;
        if (format == Format::Png) {
            bytes_.resize(pixels * 3);
            rtEnable(RT_FRAMEBUFFER_SRGB);
            rtSetFrameBuffer(bytes_.data(), size.width, size.height, RT_RGB_8);
        } else {
            floats_.resize(pixels * 4);
            rtSetFrameBuffer(reinterpret_cast<RTubyte*>(floats_.data()), size.width, size.height,
                             RT_RGBA_32F);
        }
        samples::checkRt();
    }

    std::vector<uint8_t> encode() const {
        return format_ == Format::Png ? samples::encodePng(size_.width, size_.height, 3, bytes_)
                                      : samples::encodeExr(size_.width, size_.height, floats_);
    }

private:
    PictureSize size_;
    Format format_;
    std::vector<uint8_t> bytes_;
    std::vector<float> floats_;
};

void printStatistics(const samples::RenderStatistics& statistics) {
    if (options.stats == "json") {
        statistics.printJson(std::cout);
    } else if (!options.stats.empty()) {
        statistics.printText(std::cout);
    }
}

int run() {
    // Everything that can be refused without work comes first.
    const Format format = formatFrom(options.output);
    const PictureSize size = samples::sizeFrom(options);
    if (samples::isEnvironmentFile(options.shaders.environment)) {
        options.environment = std::exchange(options.shaders.environment, {});
    }
    const samples::Lighting lighting = samples::lightingFrom(options);
    const std::optional<samples::View> wantedView = samples::viewFrom(options);
    rtInit(nullptr, nullptr);
    samples::applySettings(options);
    samples::OutputFile file(options.output);
    samples::RenderStatistics statistics;
    const Clock::time_point loadStart = Clock::now();
    samples::Bounds bounds;
    const samples::SceneDescription description = samples::loadVisibleScene(options, bounds);
    statistics.loadSeconds = secondsSince(loadStart);

    const samples::View view =
        wantedView ? *wantedView : samples::defaultView(description, bounds, size.aspect());
    const samples::RtScene scene(description, bounds, view, lighting);
    const samples::FrameShaders shaders = options.shaders.make(view, size.aspect());
    const Picture picture(size, format);
    for (uint32_t frame = 0; frame < options.frames; ++frame) {
        scene.describeFrame(view, size.aspect(), shaders);
        samples::checkRt(); // before the frame: whoever throws while it is in flight frees the picture
        const Clock::time_point start = Clock::now();
        rtStartRendering();
        samples::checkRt();
        showProgress();
        samples::endFrame();
        statistics.frameSeconds.push_back(secondsSince(start));
    }
    statistics.scene = options.scene;
    statistics.output = options.output;
    statistics.precision = options.precision;
    statistics.width = size.width;
    statistics.height = size.height;
    statistics.samples = options.samples;
    statistics.query();
    statistics.droppedInstances += int64_t(description.skippedInstances);
    rtExit();
    file.write(picture.encode());

    samples::printNotes(description);
    if (statistics.badPixels > 0) {
        std::cerr << "note: " << statistics.badPixels
                  << " pixels are black: a shader failed there\n";
    }
    if (statistics.droppedTriangles + statistics.droppedInstances > 0) {
        std::cerr << "note: " << statistics.droppedTriangles << " triangles and "
                  << statistics.droppedInstances
                  << " instances are left out: without area, or with numbers that are not finite\n";
    }
    printStatistics(statistics);
    return 0;
}

} // namespace

int main(int argc, char* argv[]) {
    CLI::App app("Renders a scene file to a picture.", "openrt-render");
    options.addSizeTo(app);
    options.addViewTo(app);
    options.addTo(app);
    options.shaders.addTo(app);
    app.add_option("-o,--output", options.output, "picture to write: .png or .exr")->required();
    app.add_option("--frames", options.frames, "renders this often, for timing")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    // A flag, so that what follows it is not taken for its value.
    app.add_flag("--stats{text}", options.stats, "prints statistics; --stats=json as JSON")
        ->check(CLI::IsMember({"text", "json"}));
    return samples::runProgram(app, argc, argv, &run);
}

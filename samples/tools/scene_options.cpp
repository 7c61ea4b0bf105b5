// SPDX-License-Identifier: MIT
#include "samples/tools/scene_options.h"

#include <openrt/version.h>

#include <charconv>
#include <cmath>
#include <iostream>
#include <new>
#include <stdexcept>

#include "samples/common/scene_loader.h"
#include "samples/common/standard_output.h"

namespace samples {
namespace {

/// `count` finite numbers separated by commas.
std::vector<float> numbersFrom(const std::string& option, const std::string& text,
                               std::size_t count) {
    std::vector<float> numbers;
    const char* at = text.data();
    const char* const end = at + text.size();
    while (numbers.size() < count) {
        float number = 0.0f;
        const auto [next, error] = std::from_chars(at, end, number);
        if (error != std::errc() || !std::isfinite(number)) break;
        numbers.push_back(number);
        at = next;
        if (at == end || *at != ',') break;
        ++at;
    }
    if (numbers.size() != count || at != end) {
        throw CLI::ValidationError(option + " wants " + std::to_string(count) +
                                   " numbers separated by commas, not '" + text + "'");
    }
    return numbers;
}

constexpr int kFailure = 1, kWrongCommandLine = 2;

int statusOf(CLI::App& app, int argc, char* argv[], int (*run)()) {
    const auto fail = [&](const std::string& text, int code) {
        std::cerr << app.get_name() << ": " << oneLine(text) << std::endl;
        return code;
    };
    try {
        app.parse(argc, argv);
        return run();
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error); // --help, --version
        return fail(error.what(), kWrongCommandLine);
    } catch (const std::bad_alloc&) {
        return fail("there is not enough memory", kFailure);
    } catch (const std::exception& error) {
        return fail(error.what(), kFailure);
    }
}

} // namespace

void SceneOptions::addTo(CLI::App& app) {
    app.add_option("SCENE", scene, "scene file: .glb .gltf .obj .ply .tri")->required();
    app.add_option("--light", lights, "x,y,z: a point light beside those of the file; repeatable")
        ->allow_extra_args(false);
    app.add_option("--exposure", exposureStops, "stops by which all light is made brighter")
        ->capture_default_str();
    app.add_option("--samples", samples, "samples a pixel")
        ->check(CLI::Range(1, 4096))
        ->capture_default_str();
    app.add_option("--threads", threads,
                   "rendering threads, 0 for all cores; without it OPENRT_THREADS, or all")
        ->check(CLI::Range(0, 1024));
    app.add_option("--precision", precision, "how exact intersections are")
        ->check(CLI::IsMember({"fast", "watertight", "precise"}))
        ->capture_default_str();
}

void SceneOptions::addSizeTo(CLI::App& app) {
    app.add_option("--size", size, "picture size, WxH")->capture_default_str();
}

void SceneOptions::addViewTo(CLI::App& app) {
    app.add_option("--camera", camera,
                   "ex,ey,ez,tx,ty,tz,fov: eye, target, vertical field of view in degrees; "
                   "otherwise the file's first camera, or a view of everything");
}

void SceneOptions::addEnvironmentTo(CLI::App& app) {
    app.add_option("--environment", environment,
                   "picture around the scene by latitude and longitude: .exr .hdr");
}

void SceneOptions::addRoomTo(CLI::App& app) {
    app.add_option("--camera", camera,
                   "ex,ey,ez,tx,ty,tz,fov: where the room stands: the middle of its floor 1.7 m x "
                   "--scale below the eye, its front towards the target, which may not lie "
                   "straight above or below; the field of view has no effect; otherwise the "
                   "file's first camera, or a view of everything");
}

PictureSize sizeFrom(const SceneOptions& options) {
    constexpr uint32_t kMaxSide = 32768;
    const std::string& text = options.size;
    const char* const end = text.data() + text.size();
    PictureSize size{0, 0};
    const auto width = std::from_chars(text.data(), end, size.width);
    bool good = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
    if (good) {
        const auto height = std::from_chars(width.ptr + 1, end, size.height);
        good = height.ec == std::errc() && height.ptr == end;
    }
    if (!good) throw CLI::ValidationError("--size wants WxH, not '" + text + "'");
    if (size.width == 0 || size.height == 0 || size.width > kMaxSide || size.height > kMaxSide) {
        throw CLI::ValidationError("--size " + text + ": 1 to " + std::to_string(kMaxSide) +
                                   " pixels a side are possible");
    }
    return size;
}

Lighting lightingFrom(const SceneOptions& options) {
    Lighting lighting;
    for (const std::string& text : options.lights) {
        const std::vector<float> n = numbersFrom("--light", text, 3);
        lighting.pointLights.emplace_back(n[0], n[1], n[2]);
    }
    lighting.exposure = std::exp2(options.exposureStops);
    if (!(lighting.exposure > 0.0f) || !std::isfinite(lighting.exposure)) {
        throw CLI::ValidationError("--exposure is out of range");
    }
    if (!options.environment.empty()) {
        if (!isEnvironmentFile(options.environment)) {
            throw CLI::ValidationError("--environment " + options.environment +
                                       ": its name ends neither in .exr nor in .hdr");
        }
        lighting.environment = loadEnvironment(options.environment);
    }
    return lighting;
}

std::optional<View> viewFrom(const SceneOptions& options) {
    if (options.camera.empty()) return std::nullopt;
    const std::vector<float> n = numbersFrom("--camera", options.camera, 7);
    View view;
    view.eye = {n[0], n[1], n[2]};
    view.target = {n[3], n[4], n[5]};
    view.fovDegrees = n[6];
    if (view.eye == view.target) throw CLI::ValidationError("--camera looks at its own place");
    if (!(view.fovDegrees > 0.0f && view.fovDegrees < 180.0f)) {
        throw CLI::ValidationError("--camera wants a field of view between 0 and 180 degrees");
    }
    return view;
}

void applySettings(const SceneOptions& options) {
    const bool fast = options.precision == "fast", precise = options.precision == "precise";
    rtHint(RT_PRECISION_HINT, fast ? RT_FASTEST : precise ? RT_NICEST : RT_DONT_CARE);
    if (options.threads) rtThreads(*options.threads);
    rtSamples(options.samples);
    checkRt();
}

SceneDescription loadVisibleScene(const SceneOptions& options, Bounds& bounds) {
    try {
        SceneDescription scene = loadScene(options.scene);
        bounds = boundsOf(scene);
        if (bounds.empty()) throw LoadError("it shows no triangle");
        if (!std::isfinite(bounds.diagonal())) throw LoadError("it is too large for its numbers");
        return scene;
    } catch (const LoadError& error) {
        throw std::runtime_error(oneLine(options.scene) + ": " + error.what());
    }
}

void printNotes(const SceneDescription& scene) {
    for (const std::string& note : scene.notes) std::cerr << "note: " << oneLine(note) << '\n';
}

int runProgram(CLI::App& app, int argc, char* argv[], int (*run)()) {
    app.set_version_flag("--version", app.get_name() + " " OPENRT_VERSION_STRING);
    return finishOutput(app.get_name(), statusOf(app, argc, argv, run), kFailure);
}

} // namespace samples

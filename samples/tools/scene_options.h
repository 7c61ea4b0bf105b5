// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "samples/common/rt_scene.h"

namespace samples {

/// The part of the command line that the programs share.
struct SceneOptions {
    std::string scene;
    std::string size = "1024x768";
    std::string precision = "watertight";
    std::string camera;
    std::string environment; ///< picture around the scene; empty: a plain sky
    std::vector<std::string> lights;
    float exposureStops = 0.0f;
    uint32_t samples = 1, frames = 1;
    std::optional<uint32_t> threads; ///< without a value: OPENRT_THREADS, or all cores

    void addTo(CLI::App& app); ///< those of all programs
    void addSizeTo(CLI::App& app);
    void addViewTo(CLI::App& app); ///< --camera for a picture
    void addEnvironmentTo(CLI::App& app);
    void addRoomTo(CLI::App& app); ///< --camera for a room around a head
};

struct PictureSize {
    uint32_t width, height;
    float aspect() const { return float(width) / float(height); }
};

/// These throw CLI::ValidationError, or std::runtime_error, with one line for the user.
PictureSize sizeFrom(const SceneOptions& options);
Lighting lightingFrom(const SceneOptions& options);
std::optional<View> viewFrom(const SceneOptions& options);
/// Sets threads, precision and samples of the current context.
void applySettings(const SceneOptions& options);
/// Loads the scene; one that shows nothing is refused. Throws std::runtime_error.
SceneDescription loadVisibleScene(const SceneOptions& options, Bounds& bounds);
/// What of the file is left out, a line each on stderr.
void printNotes(const SceneDescription& scene);

/// Parses the command line and calls run(); a failure, also to print, is one line on stderr and exit
/// code 1 (2 for a wrong command line).
int runProgram(CLI::App& app, int argc, char* argv[], int (*run)());

} // namespace samples

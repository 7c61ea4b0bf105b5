// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "samples/common/rt_scene.h"

namespace samples {

/// The part of the command line that chooses shaders of shader libraries, or built-in ones.
struct ShaderOptions {
    // Each LIBRARY:CLASS, or CLASS alone for a built-in class; empty: what the scene says.
    std::string surface, camera, environment, renderingObject;
    std::vector<std::string> lights;
    std::vector<std::string> values; ///< CLASS.PARAMETER=VALUE

    void addTo(CLI::App& app);
    /// Makes the shaders in the current context, with the values given; a camera that has
    /// parameters `origin`, `direction`, `up` and `aspect` starts with those of the view. Throws
    /// std::runtime_error with one line for the user.
    FrameShaders make(const View& view, float aspect) const;
};

} // namespace samples

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "samples/common/image_file.h"

namespace samples {

/// Light from all directions, by latitude and longitude: linear RGB, rows from the bottom as
/// textures have them. Every number is finite and not below 0.
struct Environment {
    uint32_t width = 0, height = 0;
    std::vector<float> rgb;
};

/// Whether a name ends as those of the files do that loadEnvironment reads.
bool isEnvironmentFile(const std::filesystem::path& path);

/// Pictures in OpenEXR (channels R, G and B, or Y alone) or Radiance's format (.hdr), in memory;
/// throws LoadError. Numbers below 0 and those that are none count as 0, above 1e9 as 1e9.
Environment decodeEnvironment(std::span<const uint8_t> bytes, PixelBudget& budget);

/// The same of a file; throws std::runtime_error with the file's name.
Environment loadEnvironment(const std::filesystem::path& path);

} // namespace samples

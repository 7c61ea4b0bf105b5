// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "samples/common/scene_description.h"

namespace samples {

/// A name that leads, or could lead, out of the scene's folder.
class RefusedName : public LoadError {
public:
    using LoadError::LoadError;
};

/// The ending of a file's name, with its dot, in lower case.
std::string endingOf(const std::filesystem::path& path);

/// Reads a whole regular file; throws LoadError: missing, no file, larger than `maxBytes`.
std::vector<uint8_t> readWholeFile(const std::filesystem::path& path, uint64_t maxBytes);

/// The folder of a scene file, beyond which the names in that file can not reach: no absolute
/// paths, no "..", no schemes, no links that lead out. Reads a bounded number of bytes in all.
class ConfinedFolder {
public:
    /// `sceneFile` lies in the folder.
    explicit ConfinedFolder(const std::filesystem::path& sceneFile);

    /// The file that `name` (already free of percent escapes) stands for. Throws RefusedName, or
    /// LoadError if there is no such file.
    std::filesystem::path resolve(const std::string& name) const;
    std::vector<uint8_t> read(const std::string& name);

private:
    std::filesystem::path root_;
    uint64_t bytesLeft_;
};

} // namespace samples

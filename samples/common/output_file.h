// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

namespace samples {

/// A file to be written once. Opening it shows early whether it can be written, leaves what it
/// holds alone, and a file that did not exist before is removed if nothing is written.
class OutputFile {
public:
    /// Throws std::runtime_error with the reason.
    explicit OutputFile(std::filesystem::path path);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    void write(std::span<const uint8_t> bytes);

private:
    std::filesystem::path path_;
    int descriptor_ = -1;
    bool created_ = false;
};

} // namespace samples

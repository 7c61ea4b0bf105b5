// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

namespace samples {

/// A file to be written once. Making this shows early whether it can be written, leaves what it
/// holds alone, and no file behind where there was none.
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
    int descriptor_ = -1; ///< none: the file did not exist
    bool created_ = false;
};

} // namespace samples

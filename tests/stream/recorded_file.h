// SPDX-License-Identifier: MIT
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace smart::compat {

/// Runs a program with its calls recorded; the recording, or nothing where the program failed.
inline std::vector<std::byte> recordingOf(const char* program, const char* argument = nullptr) {
    const std::string file = (std::filesystem::temp_directory_path() /
                              ("openrt_stream_" + std::to_string(getpid()) + ".ort")).string();
    unlink(file.c_str());
    const pid_t child = fork();
    if (child == 0) {
        setenv("OPENRT_TRACE", file.c_str(), 1);
        execl(program, program, argument, nullptr);
        _exit(127);
    }
    int status = 0;
    waitpid(child, &status, 0);
    std::vector<std::byte> bytes;
    if (status == 0) {
        std::ifstream in(file, std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(in), {}};
        bytes.resize(text.size());
        for (std::size_t i = 0; i < text.size(); ++i) bytes[i] = std::byte(text[i]);
    }
    unlink(file.c_str());
    return bytes;
}

} // namespace smart::compat

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <iostream>
#include <string>

namespace samples {

/// The last thing that a program does: its exit status, or `failure` and a line on the error output
/// where something that it printed is lost, as on a full disk.
inline int finishOutput(const std::string& program, int status, int failure) {
    std::cout.flush();
    if (std::cout && std::fflush(stdout) == 0 && !std::ferror(stdout)) return status;
    std::cerr << program << ": the output can not be written\n";
    return failure;
}

} // namespace samples

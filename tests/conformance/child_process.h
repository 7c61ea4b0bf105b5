// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace conformance {

struct Outcome {
    bool started = false;
    bool timedOut = false;
    int status = -1;    // exit status, 128 + signal if killed
    double seconds = 0, processorSeconds = 0; // from start to end, and of all its threads
    std::string output; // standard output
    std::string errors; // standard error

    // One line for a report; empty if the program ran to its end and said 0.
    std::string failure(const std::string& program) const;
};

// Runs a program to its end, or kills it after the seconds given. `environment` holds NAME=value
// and is added to this process's own.
Outcome runProgram(const std::vector<std::string>& arguments,
                   const std::vector<std::string>& environment, int seconds);

} // namespace conformance

// SPDX-License-Identifier: MIT
// The subcommands of openrt-bench; the table of them is in main.cpp.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <stdexcept>

namespace smart::bench {

inline constexpr int kExitError = 1;   ///< files, memory, the machine
inline constexpr int kExitUsage = 2;   ///< options
inline constexpr int kExitRefused = 3; ///< answers were wrong, speeds refused

/// An option has a value that can not be.
class UsageError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Measures, prints, and returns the exit code. Throws std::exception.
using Run = std::function<int()>;

/// Each declares the options of its subcommand and returns what runs once they are parsed.
Run addRays(CLI::App& app);
Run addCases(CLI::App& app);
Run addScale(CLI::App& app);
Run addBuild(CLI::App& app);
Run addFrame(CLI::App& app);
Run addDynamic(CLI::App& app);
Run addMemory(CLI::App& app);
Run addReshade(CLI::App& app);
Run addRemote(CLI::App& app);
Run addRecovery(CLI::App& app);

} // namespace smart::bench

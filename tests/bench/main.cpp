// SPDX-License-Identifier: MIT
#include <iostream>
#include <utility>
#include <vector>

#include "openrt/version.h"
#include "samples/common/standard_output.h"
#include "tests/bench/command.h"

namespace smart::bench {
namespace {

struct Command {
    const char *name, *help;
    Run (*add)(CLI::App&);
};

constexpr Command kCommands[] = {
    {"rays", "rays a second: camera, shadow, ambient occlusion and bounces", addRays},
    {"cases", "rays that suit no packet, against the same rays one by one", addCases},
    {"scale", "time against the number of triangles and of pixels", addScale},
    {"build", "build seconds and memory", addBuild},
    {"frame", "frames with a point light: packets, points, fixed shaders", addFrame},
    {"dynamic", "scenes that change: updates, trees and rays for each step", addDynamic},
    {"memory", "bytes of objects and instances, and what lazy building saves", addMemory},
    {"reshade", "memory of instances with shaders of their own", addReshade},
    {"remote", "machines that render together: costs, and what follows for many", addRemote},
    {"recovery", "workers that die or fall silent: how long a frame takes then", addRecovery},
};

int runCommand(int argc, char** argv) {
    CLI::App app(
        "Measures OpenRT. The exit status is 1 for an error, 2 for a wrong command line, 3 if "
        "answers were wrong and their speeds refused.",
        "openrt-bench");
    app.set_version_flag("--version", "openrt-bench " OPENRT_VERSION_STRING);
    app.require_subcommand(1);
    std::vector<std::pair<CLI::App*, Run>> commands;
    for (const Command& command : kCommands) {
        CLI::App* const sub = app.add_subcommand(command.name, command.help);
        commands.emplace_back(sub, command.add(*sub));
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error); // --help, --version
        throw UsageError(error.what());
    }
    for (const auto& [sub, run] : commands) {
        if (sub->parsed()) return run();
    }
    return kExitUsage;
}

int statusOf(int argc, char** argv) {
    try {
        return runCommand(argc, argv);
    } catch (const UsageError& error) {
        std::cerr << "openrt-bench: " << error.what() << '\n';
        return kExitUsage;
    } catch (const std::exception& error) {
        std::cerr << "openrt-bench: " << error.what() << '\n';
        return kExitError;
    }
}

} // namespace
} // namespace smart::bench

int main(int argc, char** argv) {
    using namespace smart::bench;
    return samples::finishOutput("openrt-bench", statusOf(argc, argv), kExitError);
}

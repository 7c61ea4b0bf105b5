// SPDX-License-Identifier: MIT
#include "tests/conformance/frame_times.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tests/conformance/child_process.h"
#include "tests/conformance/ports.h"
#include "tests/conformance/tested_library.h"

namespace conformance {
namespace {

constexpr int kFirstFrames = 3, kFrames = 10, kMostFrames = 320, kRepetitions = 3;
/// Of the time that the first frames and the start take: what the further ones take must be as
/// much, or it would be lost in what starts of a program differ by.
constexpr double kNoticeable = 0.4;

struct Subject {
    std::string port;
    std::string cells; // of the isosurface, or empty
};

std::vector<std::string> commandOf(const std::filesystem::path& folder, const Subject& subject,
                                   int frames) {
    std::vector<std::string> command = {folder / subject.port, "-geometry", "512x512",
                                        "--rt-offscreen", std::to_string(frames)};
    if (!subject.cells.empty()) command.push_back(subject.cells);
    return command;
}

Milliseconds timeOf(const std::vector<std::string>& command,
                    const std::vector<std::string>& environment, int limit) {
    const Outcome outcome = runProgram(command, environment, limit);
    const std::string failure = outcome.failure(command[0]);
    if (!failure.empty()) throw std::runtime_error(failure);
    return {1e3 * outcome.seconds, 1e3 * outcome.processorSeconds};
}

// The least time of few frames, and of ten or so more.
struct Measurement {
    std::filesystem::path folder;
    std::vector<std::string> environment;
    Milliseconds few, many;
    int frames = kFrames;

    void repeat(const Subject& subject, int limit) {
        const auto add = [&](Milliseconds& least, int count) {
            const Milliseconds time =
                timeOf(commandOf(folder, subject, count), environment, limit);
            least.passed = std::min(least.passed, time.passed);
            least.worked = std::min(least.worked, time.worked);
        };
        add(few, kFirstFrames);
        add(many, kFirstFrames + frames);
        while (frames < kMostFrames && many.passed < (1 + kNoticeable) * few.passed) {
            frames *= 2;
            many = {};
            add(many, kFirstFrames + frames);
        }
    }
    Milliseconds ofFrame() const {
        return {(many.passed - few.passed) / frames, (many.worked - few.worked) / frames};
    }
};

FrameTime measure(const Settings& settings, const Subject& subject) {
    Measurement openGl{settings.openGlPrograms,
                       {"LP_NUM_THREADS=2", "ASAN_OPTIONS=detect_leaks=0"}, {}, {}};
    Measurement openRt{settings.openRtPrograms, withLibrary(settings, {"OPENRT_THREADS=2"}), {}, {}};
    for (int i = 0; i < kRepetitions; ++i) {
        openGl.repeat(subject, settings.seconds);
        openRt.repeat(subject, settings.seconds);
    }
    return {subject.port + (subject.cells.empty() ? "" : " " + subject.cells), openGl.ofFrame(),
            openRt.ofFrame()};
}

// As OpenGL names itself.
std::string rendererOf(const Settings& settings) {
    const std::string report = settings.work / "times.json";
    std::vector<std::string> command = commandOf(settings.openGlPrograms, {ports()[0].name, ""}, 1);
    command.insert(command.end(), {"--rt-report", report});
    timeOf(command, {"LP_NUM_THREADS=2", "ASAN_OPTIONS=detect_leaks=0"}, settings.seconds);
    const nlohmann::json told = nlohmann::json::parse(std::ifstream(report));
    return told["renderer"].get<std::string>() + ", " + told["version"].get<std::string>();
}

} // namespace

std::vector<FrameTime> measureFrameTimes(const Settings& settings, const std::string& prefix) {
    std::vector<Subject> subjects;
    for (const Port& port : ports()) subjects.push_back({port.name, ""});
    for (const char* cells : {"86", "271", "857"}) subjects.push_back({"isosurface", cells});
    std::erase_if(subjects,
                  [&](const Subject& subject) { return !subject.port.starts_with(prefix); });
    if (subjects.empty()) return {};
    std::printf("OpenGL: %s; both with 2 threads, 512x512\n", rendererOf(settings).c_str());
    std::printf("%-16s %21s   %21s\n", "ms of a frame:", "passed OpenGL, OpenRT",
                "worked OpenGL, OpenRT");
    std::vector<FrameTime> times;
    for (const Subject& subject : subjects) {
        times.push_back(measure(settings, subject));
        const FrameTime& time = times.back();
        std::printf("%-16s %10.2f %10.2f   %10.2f %10.2f\n", time.name.c_str(),
                    time.openGl.passed, time.openRt.passed, time.openGl.worked,
                    time.openRt.worked);
        std::fflush(stdout);
    }
    return times;
}

} // namespace conformance

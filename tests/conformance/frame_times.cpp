// SPDX-License-Identifier: MIT
#include "tests/conformance/frame_times.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tests/conformance/child_process.h"
#include "tests/conformance/ports.h"

namespace conformance {
namespace {

constexpr int kFirstFrames = 3, kFrames = 10, kRepetitions = 3;

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

double secondsOf(const std::vector<std::string>& command,
                 const std::vector<std::string>& environment, int limit) {
    const auto start = std::chrono::steady_clock::now();
    const Outcome outcome = runProgram(command, environment, limit);
    const std::string failure = outcome.failure(command[0]);
    if (!failure.empty()) throw std::runtime_error(failure);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void measureOpenGl(const Settings& settings, const Subject& subject, FrameTime& time) {
    const std::string report = settings.work / "times.json";
    std::vector<std::string> command =
        commandOf(settings.openGlPrograms, subject, kFirstFrames + kFrames);
    command.insert(command.end(), {"--rt-report", report});
    secondsOf(command, {"LP_NUM_THREADS=2", "ASAN_OPTIONS=detect_leaks=0"}, settings.seconds);
    const nlohmann::json told = nlohmann::json::parse(std::ifstream(report));
    std::vector<double> times = told["ms"];
    times.erase(times.begin(), times.begin() + kFirstFrames);
    std::nth_element(times.begin(), times.begin() + kFrames / 2, times.end());
    time.openGl = times[kFrames / 2];
    time.renderer = told["renderer"].get<std::string>() + ", " + told["version"].get<std::string>();
}

// What ten more frames take: a library need not tell how long it worked.
void measureOpenRt(const Settings& settings, const Subject& subject, FrameTime& time) {
    std::vector<std::string> environment = {"OPENRT_THREADS=2"};
    if (!settings.library.empty()) environment.push_back("LD_PRELOAD=" + settings.library.string());
    double few = 1e30, many = 1e30;
    for (int i = 0; i < kRepetitions; ++i) {
        few = std::min(few, secondsOf(commandOf(settings.openRtPrograms, subject, kFirstFrames),
                                      environment, settings.seconds));
        many = std::min(
            many, secondsOf(commandOf(settings.openRtPrograms, subject, kFirstFrames + kFrames),
                            environment, settings.seconds));
    }
    time.openRt = 1e3 * (many - few) / kFrames;
}

} // namespace

std::vector<FrameTime> measureFrameTimes(const Settings& settings, const std::string& prefix) {
    std::vector<Subject> subjects;
    for (const Port& port : ports()) subjects.push_back({port.name, ""});
    for (const char* cells : {"62", "196", "620"}) subjects.push_back({"isosurface", cells});
    std::vector<FrameTime> times;
    for (const Subject& subject : subjects) {
        if (subject.port.rfind(prefix, 0) != 0) continue;
        FrameTime time;
        time.name = subject.port + (subject.cells.empty() ? "" : " " + subject.cells);
        measureOpenGl(settings, subject, time);
        measureOpenRt(settings, subject, time);
        if (times.empty()) std::printf("OpenGL: %s, 2 threads\n", time.renderer.c_str());
        std::printf("%-16s OpenGL %9.3f ms, OpenRT %9.3f ms\n", time.name.c_str(), time.openGl,
                    time.openRt);
        std::fflush(stdout);
        times.push_back(time);
    }
    return times;
}

} // namespace conformance

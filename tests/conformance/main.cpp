// SPDX-License-Identifier: MIT
// openrt-conformance: does a libOpenRT.so do what OpenGL does? The sample ports and small programs
// that ask questions run against OSMesa and against the library; docs/conformance.md explains.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "openrt/version.h"
#include "samples/common/standard_output.h"
#include "tests/conformance/conformance_case.h"
#include "tests/conformance/frame_times.h"
#include "tests/conformance/report.h"
#include "tests/conformance/tested_library.h"

namespace {

using namespace conformance;

constexpr int kNothingCompared = 1, kWrongCommandLine = 2, kDifferent = 3;

// A folder of its own for the pictures, removed at the end.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string name = std::filesystem::temp_directory_path() / "openrt-conformance-XXXXXX";
        if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
        path_ = name;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

std::vector<Case> casesWith(const std::string& prefix, const Settings& settings) {
    std::vector<Case> cases;
    const auto add = [&](std::vector<Case> more) {
        for (Case& one : more)
            if (one.name.rfind(prefix, 0) == 0) cases.push_back(std::move(one));
    };
    add(pictureCases(settings));
    add(transcriptCases(settings));
    return cases;
}

std::vector<Result> runAll(const std::vector<Case>& cases, bool failFast) {
    std::vector<Result> results;
    for (const Case& one : cases) {
        results.push_back(one.run());
        const Result& result = results.back();
        std::printf("%s %s\n", result.passed() ? "passed" : "FAILED", result.name.c_str());
        for (const std::string& failure : result.failures) std::printf("    %s\n", failure.c_str());
        std::fflush(stdout);
        if (failFast && !result.passed()) break;
    }
    return results;
}

bool allPassed(const std::vector<Result>& results) {
    long passed = 0;
    for (const Result& result : results) passed += result.passed();
    std::printf("%ld of %zu cases passed\n", passed, results.size());
    return !results.empty() && passed == long(results.size());
}

int run(int argc, char** argv) {
    const auto refuse = [](const char* reason) {
        std::fprintf(stderr, "openrt-conformance: %s\n", reason);
        return kWrongCommandLine;
    };
    constexpr const char* kNoSuchCase = "--cases: none is called so; see --list";
    Settings settings;
    settings.openGlPrograms = OPENRT_CONFORMANCE_GL;
    settings.openRtPrograms = OPENRT_CONFORMANCE_RT;
    std::string json, html, prefix;
    bool list = false, failFast = false, times = false;
    CLI::App app(
        "Compares a libOpenRT.so with OpenGL, as OSMesa renders it. The exit status is 1 if "
        "nothing could be compared or the results not be written, 2 for a wrong command "
        "line, 3 if a case did not pass.",
        "openrt-conformance");
    app.set_version_flag("--version", "openrt-conformance " OPENRT_VERSION_STRING);
    app.add_option("--library", settings.library, "libOpenRT.so to test, instead of the built one")
        ->check(CLI::ExistingFile)
        ->check(&faultOfLibrary);
    app.add_option("--json", json, "file for the results");
    CLI::Option* const report = app.add_option("--html", html, "folder for a report with pictures");
    app.add_option("--cases", prefix, "only cases whose names begin so");
    app.add_option("--opengl-programs", settings.openGlPrograms, "folder of the ports on OSMesa");
    app.add_option("--openrt-programs", settings.openRtPrograms, "folder of the ports to test");
    app.add_option("--opengl-pictures", settings.openGlPictures,
                   "folder in which OpenGL's pictures are kept from one run to the next")
        ->excludes(report);
    app.add_flag("--list", list, "names of the cases, nothing else");
    app.add_flag("--quick", settings.quick, "one size and one frame of each port");
    app.add_flag("--times", times,
                 "milliseconds of a frame of both instead; --cases: of which port");
    app.add_flag("--fail-fast", failFast, "end after the first case that fails");
    app.add_option("--seconds", settings.seconds, "that one program may take")
        ->check(CLI::PositiveNumber);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error); // --help, --version
        return refuse(error.what());
    }
    if (!settings.library.empty()) settings.library = std::filesystem::canonical(settings.library);

    if (!settings.openGlPictures.empty())
        std::filesystem::create_directories(settings.openGlPictures);

    const TemporaryFolder temporary;
    settings.work = temporary.path();
    if (!html.empty()) {
        std::filesystem::create_directories(html);
        settings.work = html;
        settings.keepPictures = true;
    }
    if (times) return measureFrameTimes(settings, prefix).empty() ? refuse(kNoSuchCase) : 0;
    const std::vector<Case> cases = casesWith(prefix, settings);
    if (cases.empty()) return refuse(kNoSuchCase);
    if (list) {
        for (const Case& one : cases) std::printf("%s\n", one.name.c_str());
        return 0;
    }
    const std::vector<Result> results = runAll(cases, failFast);
    const std::string library = settings.library.empty() ? "as built" : settings.library.string();
    if (!json.empty()) {
        std::ofstream file(json);
        file << jsonReport(library, results);
        file.close();
        if (!file) throw std::runtime_error(json + ": not written");
    }
    if (!html.empty()) writeHtmlReport(html, library, results);
    return allPassed(results) ? 0 : kDifferent;
}

int statusOf(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "openrt-conformance: %s\n", error.what());
        return kNothingCompared;
    }
}

} // namespace

int main(int argc, char** argv) {
    return samples::finishOutput("openrt-conformance", statusOf(argc, argv), kNothingCompared);
}

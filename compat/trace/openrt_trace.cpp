// SPDX-License-Identifier: MIT
// openrt-trace: records what a program calls, plays it, shows it, writes it as C.
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "compat/stream/call_player.h"
#include "compat/trace/c_source.h"
#include "compat/trace/call_listing.h"
#include "compat/trace/picture_file.h"
#include "compat/trace/trace_input.h"
#include "openrt/rt.h"
#include "samples/common/standard_output.h"

namespace {

using namespace smart::compat;

constexpr int kFailure = 1, kWrongCommandLine = 2, kDifferent = 3;
/// Of `record`, as of env and timeout: all others are the recorded program's.
constexpr int kNotRecorded = 125, kNotExecutable = 126, kNotFound = 127, kSignal = 128;

/// Takes away what is to be replaced, so that the library can make the file.
void makeRoom(const std::string& file) {
    namespace fs = std::filesystem;
    const fs::file_type type = fs::symlink_status(file).type();
    if (type != fs::file_type::not_found && type != fs::file_type::regular &&
        type != fs::file_type::symlink)
        throw StreamError(file + ": only a file is replaced, not a folder or a device");
    const auto check = [&](bool good) {
        if (!good) throw StreamError(file + ": " + std::strerror(errno));
    };
    check(type == fs::file_type::not_found || unlink(file.c_str()) == 0);
    const int trial = open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    check(trial >= 0);
    close(trial);
    unlink(file.c_str());
}

/// Runs the program with its calls recorded; the exit status.
int record(const std::string& file, const std::vector<std::string>& program) {
    const std::string absolute = std::filesystem::absolute(file).string();
    makeRoom(file);
    const pid_t child = fork();
    if (child < 0) throw StreamError(std::string("fork: ") + std::strerror(errno));
    if (child == 0) {
        setenv("OPENRT_TRACE", absolute.c_str(), 1);
        std::vector<char*> arguments;
        for (const std::string& word : program)
            arguments.push_back(const_cast<char*>(word.c_str()));
        arguments.push_back(nullptr);
        execvp(arguments[0], arguments.data());
        const int reason = errno;
        std::cerr << "openrt-trace: " << program[0] << ": " << std::strerror(reason) << '\n';
        _exit(reason == ENOENT ? kNotFound : kNotExecutable);
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (WIFSIGNALED(status))
        std::cerr << "openrt-trace: the program was ended by signal " << WTERMSIG(status) << '\n';
    const int ofProgram = WIFSIGNALED(status) ? kSignal + WTERMSIG(status) : WEXITSTATUS(status);
    if (std::filesystem::exists(absolute) || ofProgram == kNotExecutable || ofProgram == kNotFound)
        return ofProgram;
    std::cerr << "openrt-trace: the program called nothing of OpenRT: there is no " << file << '\n';
    return ofProgram == 0 ? kNotRecorded : ofProgram;
}

class Replay final : public PlayPolicy {
public:
    Replay(std::string output, std::string shaders)
        : output_(std::move(output)), shaders_(std::move(shaders)) {}

    const RTshaderclass* shaderClass(const std::string& name) override {
        if (shaders_.empty()) return nullptr;
        const RTuint id = rtGenNewShaderClass(name.c_str(), shaders_.c_str());
        return id == RT_INVALID ? nullptr : rtGetShaderClassDescriptor(id);
    }
    void frame(const PlayedFrame& frame) override {
        if (!frame.isEqual) std::cout << "frame " << frame.number << " is not as recorded\n";
        if (!output_.empty()) writePicture(nameOfPicture(output_, frame.number), frame);
    }
    void diverged(const Divergence& divergence) override {
        if (++divergences_ > kMostTold) return;
        std::cout << "call " << divergence.call << ", " << divergence.function << ": "
                  << divergence.text << '\n';
    }

private:
    static constexpr uint64_t kMostTold = 20;
    std::string output_, shaders_;
    uint64_t divergences_ = 0;
};

std::string faultOfPattern(const std::string& pattern) {
    try {
        nameOfPicture(pattern, 1);
        return {};
    } catch (const StreamError& error) {
        return error.what();
    }
}

std::string faultOfCount(const std::string& text) {
    uint64_t count = 0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, count);
    const bool good = error == std::errc() && rest == end && count > 0;
    return good ? std::string() : "'" + text + "' is not a number from 1";
}

/// The records of the calls up to this one.
std::span<const std::byte> firstCalls(const TraceInput& input, uint64_t until) {
    std::span<const std::byte> rest = input.records();
    uint64_t calls = 0;
    while (!rest.empty()) {
        std::span<const std::byte> next = rest;
        RecordHead head;
        takeRecord(next, head);
        if (head.kind == RecordKind::Call && ++calls > until) break;
        rest = next;
    }
    return input.records().first(input.records().size() - rest.size());
}

int replay(const TraceInput& input, Replay& policy, uint64_t until) {
    CallPlayer player(&policy);
    player.play(until ? firstCalls(input, until) : input.records());
    player.finish();
    std::cout << player.calls() << " calls, " << player.frames() << " frames: ";
    if (player.unequalFrames() == 0 && player.divergences() == 0) {
        std::cout << "as recorded";
        if (player.frames() == 0 && player.hasRendered())
            std::cout << ", but none of the frames that were rendered was compared";
        std::cout << '\n';
        return 0;
    }
    std::cout << player.unequalFrames() << " frames and " << player.divergences()
              << " calls are not as recorded\n";
    return kDifferent;
}

bool records(int argc, char* argv[]) {
    return argc > 1 && std::strcmp(argv[1], "record") == 0;
}

int run(int argc, char* argv[]) {
    CLI::App app(
        "Records what a program calls of OpenRT in a file, plays it again and compares "
        "each frame bit by bit, shows it, or writes it as a C program. The exit status "
        "is 1 if a file can not be used, 2 for a wrong command line, 3 if something is not as "
        "recorded. That of record is the program's; or 125 if nothing could be recorded, 126 if "
        "the program can not be run, 127 if there is none, 128 and the signal that ended it.",
        "openrt-trace");
    app.set_version_flag("--version", "openrt-trace " OPENRT_VERSION_STRING);
    app.require_subcommand(1);

    std::string file = "openrt-trace.ort", output, shaders;
    std::vector<std::string> program;
    uint64_t until = 0;
    CLI::App* const recording =
        app.add_subcommand("record", "runs a program and records its calls");
    recording->add_option("-o,--output", file, "recording to write")
        ->type_name("FILE")
        ->capture_default_str();
    recording->add_option("PROGRAM", program, "the program and its arguments")->required();
    recording->positionals_at_end();
    recording->prefix_command(false);
    CLI::App* const playing = app.add_subcommand("replay",
                                                 "makes the calls again and compares each "
                                                 "frame with the recorded one");
    playing->add_option("FILE", file, "a recording")->required();
    playing->add_option("-o,--output", output, "writes each frame, with its number for %d")
        ->type_name("frame%03d.png")
        ->check(&faultOfPattern);
    playing->add_option("--until", until, "makes the first N calls only")
        ->type_name("N")
        ->check(&faultOfCount);
    playing
        ->add_option("--shaders", shaders,
                     "the shader library with the classes that the program registered itself")
        ->type_name("FILE");
    CLI::App* const source =
        app.add_subcommand("source", "writes a C program that makes the calls");
    source->add_option("FILE", file, "a recording")->required();
    CLI::App* const info = app.add_subcommand("info",
                                              "tells how many calls, frames, errors and "
                                              "bytes there are");
    info->add_option("FILE", file, "a recording")->required();
    CLI::App* const dump = app.add_subcommand("dump",
                                              "a line for each call: number, thread, "
                                              "context, the call; and what came of it");
    dump->add_option("FILE", file, "a recording")->required();
    // All that follows PROGRAM is the program's.
    std::vector<std::string> words(argv + 1, argv + argc), own = words;
    if (records(argc, argv)) {
        std::size_t first = 1;
        while (first < words.size() && words[first].starts_with("-"))
            first += words[first] == "-o" || words[first] == "--output" ? 2 : 1;
        if (first < words.size()) {
            program.assign(words.begin() + std::ptrdiff_t(first), words.end());
            own.resize(first + 1);
        }
    }
    const std::vector<std::string> whole = program;
    try {
        app.parse(std::vector<std::string>(own.rbegin(), own.rend()));
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error); // --help, --version
        std::cerr << "openrt-trace: " << error.what() << '\n';
        return records(argc, argv) ? kNotRecorded : kWrongCommandLine;
    }
    if (recording->parsed()) return record(file, whole);
    if (playing->parsed()) {
        Replay policy(output, shaders);
        return replay(TraceInput(file), policy, until);
    }
    const TraceInput input(file);
    if (source->parsed()) writeSource(input, std::cout);
    if (info->parsed()) summarise(input, std::cout);
    if (dump->parsed()) listCalls(input, std::cout);
    return 0;
}

int statusOf(int argc, char* argv[], int failure) {
    try {
        return run(argc, argv);
    } catch (const std::exception& error) {
        std::cerr << "openrt-trace: " << error.what() << '\n';
        return failure;
    }
}

} // namespace

int main(int argc, char* argv[]) {
    const int failure = records(argc, argv) ? kNotRecorded : kFailure;
    return samples::finishOutput("openrt-trace", statusOf(argc, argv, failure), failure);
}

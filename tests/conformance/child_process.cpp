// SPDX-License-Identifier: MIT
#include "tests/conformance/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstring>

extern char** environ;

namespace conformance {
namespace {

class Pipe {
public:
    Pipe() { open_ = pipe2(ends_.data(), O_CLOEXEC) == 0; }
    ~Pipe() {
        if (open_) close(ends_[0]);
        closeWriter();
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;

    int reader() const { return ends_[0]; }
    int writer() const { return ends_[1]; }
    void closeWriter() {
        if (open_ && ends_[1] >= 0) close(ends_[1]);
        ends_[1] = -1;
    }

private:
    std::array<int, 2> ends_{-1, -1};
    bool open_;
};

// Of two settings of one variable the first counts, so what was given goes first.
std::vector<char*> environmentOf(const std::vector<std::string>& added) {
    std::vector<char*> result;
    for (const std::string& setting : added) result.push_back(const_cast<char*>(setting.c_str()));
    for (char** own = environ; *own; ++own) {
        bool replaced = false;
        for (const std::string& setting : added)
            replaced = replaced || !std::strncmp(*own, setting.c_str(), setting.find('=') + 1);
        if (!replaced) result.push_back(*own);
    }
    result.push_back(nullptr);
    return result;
}

// Until both pipes end or time is up; false: time is up.
bool readBoth(Outcome& outcome, int output, int errors, int seconds) {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::seconds(seconds);
    std::array<pollfd, 2> ends{pollfd{output, POLLIN, 0}, pollfd{errors, POLLIN, 0}};
    std::array<std::string*, 2> texts{&outcome.output, &outcome.errors};
    while (ends[0].fd >= 0 || ends[1].fd >= 0) {
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
        if (left <= 0 || poll(ends.data(), 2, int(left)) == 0) return false;
        for (std::size_t i = 0; i < 2; ++i) {
            if (ends[i].fd < 0 || ends[i].revents == 0) continue;
            char buffer[65536];
            const ssize_t count = read(ends[i].fd, buffer, sizeof buffer);
            if (count > 0)
                texts[i]->append(buffer, std::size_t(count));
            else
                ends[i].fd = -1;
        }
    }
    return true;
}

} // namespace

std::string Outcome::failure(const std::string& program) const {
    if (!started) return program + " could not be started";
    if (timedOut) return program + " did not end in time";
    if (status == 0) return {};
    const std::string last = errors.substr(errors.size() > 400 ? errors.size() - 400 : 0);
    return program + " ended with " + std::to_string(status) + (last.empty() ? "" : ": " + last);
}

Outcome runProgram(const std::vector<std::string>& arguments,
                   const std::vector<std::string>& environment, int seconds) {
    Outcome outcome;
    Pipe output, errors;
    std::vector<char*> argv;
    for (const std::string& argument : arguments)
        argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, output.writer(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, errors.writer(), STDERR_FILENO);
    pid_t child = 0;
    const auto start = std::chrono::steady_clock::now();
    outcome.started = posix_spawn(&child, argv[0], &actions, nullptr, argv.data(),
                                  environmentOf(environment).data()) == 0;
    posix_spawn_file_actions_destroy(&actions);
    if (!outcome.started) return outcome;
    output.closeWriter();
    errors.closeWriter();
    outcome.timedOut = !readBoth(outcome, output.reader(), errors.reader(), seconds);
    if (outcome.timedOut) kill(child, SIGKILL);
    int status = 0;
    rusage usage{};
    wait4(child, &status, 0, &usage);
    outcome.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    for (const timeval& part : {usage.ru_utime, usage.ru_stime})
        outcome.processorSeconds += double(part.tv_sec) + 1e-6 * double(part.tv_usec);
    outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return outcome;
}

} // namespace conformance

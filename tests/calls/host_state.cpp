// SPDX-License-Identifier: MIT
#include "tests/calls/host_state.h"

#include <sched.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cfenv>
#include <clocale>
#include <cstdio>
#include <iterator>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

extern char** environ;

namespace openrt::test {
namespace {

const char* const kNames[] = {
    "rounding mode", "floating-point control", "signal mask",    "signal handlers", "locale",
    "affinity",      "current folder",         "file mode mask", "standard output", "environment"};
static_assert(sizeof kNames / sizeof kNames[0] == 10);

template <class T>
std::string bytesOf(const T& value) {
    return std::string(reinterpret_cast<const char*>(&value), sizeof value);
}

/// What the exception flags say is the thread's own affair; masks and modes are not.
std::string floatingPointControl() {
    std::string control;
#if defined(__SSE2__)
    control = bytesOf(_mm_getcsr() & ~0x3Fu);
#endif
#if defined(__x86_64__)
    unsigned short word = 0;
    __asm__("fnstcw %0" : "=m"(word));
    control += bytesOf(word);
#endif
    return control;
}

std::string handlers() {
    std::string all;
    for (int signal = 1; signal < 32; ++signal) {
        struct sigaction action = {};
        sigaction(signal, nullptr, &action);
        all += bytesOf(action.sa_handler) + bytesOf(action.sa_flags);
    }
    return all;
}

std::string affinity() {
    cpu_set_t set;
    CPU_ZERO(&set);
    sched_getaffinity(0, sizeof set, &set);
    return bytesOf(set);
}

std::string signalMask() {
    sigset_t mask;
    sigemptyset(&mask);
    pthread_sigmask(SIG_SETMASK, nullptr, &mask);
    std::string blocked;
    for (int signal = 1; signal < 65; ++signal) blocked += char('0' + sigismember(&mask, signal));
    return blocked;
}

std::string folder() {
    char path[4096] = "";
    return getcwd(path, sizeof path) ? path : "";
}

std::string environment() {
    std::string all;
    for (char** entry = environ; entry && *entry; ++entry) all += bytesOf(*entry);
    return all;
}

std::string modeMask() {
    const mode_t mask = umask(0);
    umask(mask);
    return bytesOf(mask);
}

} // namespace

HostState HostState::now() {
    HostState state;
    std::string* part = state.parts_;
    *part++ = bytesOf(std::fegetround());
    *part++ = floatingPointControl();
    *part++ = signalMask();
    *part++ = handlers();
    *part++ = std::setlocale(LC_ALL, nullptr);
    *part++ = affinity();
    *part++ = folder();
    *part++ = modeMask();
    std::fflush(stdout);
    *part++ = bytesOf(lseek(STDOUT_FILENO, 0, SEEK_CUR));
    *part++ = environment();
    return state;
}

std::string HostState::differences(const HostState& other) const {
    std::string names;
    for (std::size_t i = 0; i < std::size(kNames); ++i)
        if (parts_[i] != other.parts_[i])
            names += std::string(names.empty() ? "" : ", ") + kNames[i];
    return names;
}

void makeHostUnusual() {
    std::setlocale(LC_ALL, "C.UTF-8");
    cpu_set_t set;
    CPU_ZERO(&set);
    CPU_SET(sched_getcpu(), &set);
    sched_setaffinity(0, sizeof set, &set);
    sigset_t mask;
    sigemptyset(&mask);
    sigaddset(&mask, SIGUSR2);
    pthread_sigmask(SIG_BLOCK, &mask, nullptr);
    umask(0137);
    std::fesetround(FE_UPWARD);
#if defined(__SSE2__)
    _mm_setcsr(_mm_getcsr() | 0x8040);
#endif
}

} // namespace openrt::test

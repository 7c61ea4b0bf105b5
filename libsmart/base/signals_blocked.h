// SPDX-License-Identifier: MIT
#pragma once

#include <csignal>
#include <initializer_list>

#if defined(__unix__) || defined(__APPLE__)
#include <pthread.h>
#endif

namespace smart {

/// Blocks signals that come from outside while it lives; threads that are started meanwhile inherit
/// that, so that the application's handlers run on threads of its own. Those that a thread raises
/// by its own fault stay: blocked, they would end the process without the host's handler.
class SignalsBlocked {
public:
#if defined(__unix__) || defined(__APPLE__)
    SignalsBlocked() {
        sigset_t blocked;
        sigfillset(&blocked);
        for (const int own : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGABRT, SIGSYS})
            sigdelset(&blocked, own);
        pthread_sigmask(SIG_BLOCK, &blocked, &previous_);
    }
    ~SignalsBlocked() {
        pthread_sigmask(SIG_SETMASK, &previous_, nullptr);
    }

private:
    sigset_t previous_;
#else
    SignalsBlocked() = default;
#endif
public:
    SignalsBlocked(const SignalsBlocked&) = delete;
    SignalsBlocked& operator=(const SignalsBlocked&) = delete;
};

} // namespace smart

// SPDX-License-Identifier: MIT
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <string>
#include <utility>

#include "tests/support/socket_transport.h"

namespace smart::test {

/// A process of remote_worker_process.cpp, ended in the end.
class WorkerProcess {
public:
    WorkerProcess(const std::string& mode, unsigned number = 0) {
        const SocketPair pair;
        socket = pair.here;
        const std::string last = std::to_string(number);
        id_ = fork();
        if (id_ == 0) {
            const int kept = dup(pair.there); // without closing on exec
            execl(WORKER_PROCESS, WORKER_PROCESS, std::to_string(kept).c_str(), mode.c_str(),
                  last.c_str(), nullptr);
            _exit(9);
        }
        ::close(pair.there);
    }
    ~WorkerProcess() {
        if (id_ <= 0) return;
        kill(SIGKILL);
        waitpid(id_, nullptr, 0);
    }
    WorkerProcess(WorkerProcess&& other) noexcept
        : socket(other.socket), id_(std::exchange(other.id_, -1)) {}
    void kill(int signal) const { ::kill(id_, signal); }
    /// Waits for its end by itself; its exit status.
    int wait() {
        int status = -1;
        waitpid(std::exchange(id_, -1), &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    int socket = -1; ///< of the transport

private:
    pid_t id_ = -1;
};

} // namespace smart::test

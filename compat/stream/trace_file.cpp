// SPDX-License-Identifier: MIT
#include "compat/stream/trace_file.h"

#include <fcntl.h>
#include <pthread.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <stdexcept>
#include <system_error>

#include "libsmart/base/variable_warning.h"

namespace smart::compat {

namespace {

/// Writes through memory that is mapped to the file, so that what was recorded is there whatever
/// becomes of the process. A process that is killed leaves zeros at the end.
class TraceFile final : public CallSink {
public:
    explicit TraceFile(int file) : file_(file) {}

    void record(std::span<const std::byte> records) override {
        while (!records.empty()) {
            if (used_ == kWindow || !window_) nextWindow();
            const std::size_t n = std::min(records.size(), kWindow - used_);
            std::memcpy(window_ + used_, records.data(), n);
            used_ += n;
            records = records.subspan(n);
        }
    }

    void end() noexcept {
        if (window_) munmap(window_, kWindow);
        window_ = nullptr;
        if (ftruncate(file_, off_t(start_ + used_)) != 0)
            std::fprintf(stderr, "openrt: the trace has zeros at its end\n");
        close(file_);
    }

private:
    static constexpr std::size_t kWindow = std::size_t(16) << 20;

    void nextWindow() {
        if (window_) {
            munmap(window_, kWindow);
            window_ = nullptr;
            start_ += kWindow;
            used_ = 0;
        }
        // Blocks are reserved first: a full disk is an error here and no signal later.
        if (const int error = posix_fallocate(file_, off_t(start_), off_t(kWindow)))
            throw std::system_error(error, std::generic_category(), "the trace");
        void* const memory =
            mmap(nullptr, kWindow, PROT_READ | PROT_WRITE, MAP_SHARED, file_, off_t(start_));
        if (memory == MAP_FAILED)
            throw std::system_error(errno, std::generic_category(), "the trace");
        window_ = static_cast<std::byte*>(memory);
    }

    int file_;
    std::byte* window_ = nullptr;
    uint64_t start_ = 0;   ///< of the window in the file
    std::size_t used_ = 0; ///< of the window
};

TraceFile* traceFile = nullptr;

void endTrace() {
    setCallSink(nullptr);
    traceFile->end();
}

/// The child of a fork shares the memory, and must not write there.
void leaveToParent() {
    abandonCallSink();
}

} // namespace

CallSink* traceFileFromEnvironment() noexcept {
    const char* const name = secure_getenv("OPENRT_TRACE");
    if (!name || !*name) return nullptr;
    const int file = open(name, O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file < 0) {
        warnOfVariable("OPENRT_TRACE", name, std::strerror(errno));
        return nullptr;
    }
    traceFile = new (std::nothrow) TraceFile(file); // never ended: threads may still record
    if (!traceFile) {
        close(file);
        return nullptr;
    }
    pthread_atfork(nullptr, nullptr, &leaveToParent);
    std::atexit(&endTrace);
    return traceFile;
}

} // namespace smart::compat

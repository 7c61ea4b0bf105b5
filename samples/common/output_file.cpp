// SPDX-License-Identifier: MIT
#include "samples/common/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace samples {
namespace {

constexpr int kNewFile = O_WRONLY | O_CREAT | O_CLOEXEC;
constexpr mode_t kMode = 0666;

std::runtime_error failure(const std::filesystem::path& path) {
    return std::runtime_error(path.string() + ": " +
                              std::error_code(errno, std::generic_category()).message());
}

} // namespace

OutputFile::OutputFile(std::filesystem::path path) : path_(std::move(path)) {
    const int trial = open(path_.c_str(), kNewFile | O_EXCL, kMode);
    if (trial >= 0) {
        close(trial);
        unlink(path_.c_str());
        return;
    }
    // O_NONBLOCK: a named pipe without a reader is refused and does not hang.
    if (errno == EEXIST) descriptor_ = open(path_.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor_ < 0) throw failure(path_);
}

OutputFile::~OutputFile() {
    if (descriptor_ >= 0) close(descriptor_);
    if (created_) unlink(path_.c_str());
}

void OutputFile::write(std::span<const uint8_t> bytes) {
    if (descriptor_ < 0) {
        descriptor_ = open(path_.c_str(), kNewFile, kMode);
        if (descriptor_ < 0) throw failure(path_);
        created_ = true;
    }
    struct stat status{};
    if (fstat(descriptor_, &status) != 0) throw failure(path_);
    if (S_ISREG(status.st_mode) && ftruncate(descriptor_, 0) != 0) throw failure(path_);
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) throw failure(path_);
        bytes = bytes.subspan(std::size_t(written));
    }
    // Some file systems report a full disk only here.
    if (close(std::exchange(descriptor_, -1)) != 0) throw failure(path_);
    created_ = false;
}

} // namespace samples

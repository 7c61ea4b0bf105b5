// SPDX-License-Identifier: MIT
#include "compat/recorder/error_log.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "libsmart/base/variable_warning.h"

namespace smart::compat {
namespace {

std::FILE* openLog() noexcept {
    const char* const where = secure_getenv("OPENRT_LOG");
    if (!where || !*where) return nullptr;
    if (std::strcmp(where, "stderr") == 0) return stderr;
    std::FILE* const file = std::fopen(where, "ae");
    if (!file) {
        warnOfVariable("OPENRT_LOG", where, std::strerror(errno));
        return nullptr;
    }
    std::setvbuf(file, nullptr, _IOLBF, 0);
    return file;
}

const char* name(ErrorCode code) {
    switch (code) {
    case ErrorCode::InvalidEnum: return "INVALID_ENUM";
    case ErrorCode::InvalidValue: return "INVALID_VALUE";
    case ErrorCode::InvalidOperation: return "INVALID_OPERATION";
    case ErrorCode::StackOverflow: return "STACK_OVERFLOW";
    case ErrorCode::StackUnderflow: return "STACK_UNDERFLOW";
    case ErrorCode::OutOfMemory: return "OUT_OF_MEMORY";
    }
    return "?";
}

} // namespace

void logError(ErrorCode code, const char* function, const char* text) noexcept {
    static std::FILE* const log = openLog();
    if (log) std::fprintf(log, "openrt: %s: %s: %s\n", function, name(code), text);
}

} // namespace smart::compat

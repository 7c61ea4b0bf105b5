// SPDX-License-Identifier: MIT
#include "compat/rtu/report.h"

#include "compat/openrt/guard.h"

namespace smart::compat {

void recordError(ErrorCode code, const char* function, const char* text) noexcept {
    guarded(function, [&](Context&) { throwError(code, text); });
}

bool isMissing(const void* pointer, const char* function, const char* text) noexcept {
    if (!pointer) recordError(ErrorCode::InvalidValue, function, text);
    return !pointer;
}

} // namespace smart::compat

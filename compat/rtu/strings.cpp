// SPDX-License-Identifier: MIT
#include <cstring>
#include <string_view>

#include "openrt/rtu.h"

namespace {

const char* errorText(RTenum error) {
    switch (error) {
    case RT_NO_ERROR: return "no error";
    case RT_INVALID_ENUM: return "invalid enumerant";
    case RT_INVALID_VALUE: return "invalid value";
    case RT_INVALID_OPERATION: return "invalid operation";
    case RT_STACK_OVERFLOW: return "stack overflow";
    case RT_STACK_UNDERFLOW: return "stack underflow";
    case RT_OUT_OF_MEMORY: return "out of memory";
    case RTU_INVALID_ENUM: return "invalid enumerant";
    case RTU_INVALID_VALUE: return "invalid value";
    case RTU_INVALID_OPERATION: return "invalid operation";
    case RTU_OUT_OF_MEMORY: return "out of memory";
    case RTU_INCOMPATIBLE_GL_VERSION: return "incompatible gl version";
    case RTU_TESS_MISSING_BEGIN_POLYGON: return "a polygon was not begun";
    case RTU_TESS_MISSING_BEGIN_CONTOUR: return "a contour was not begun";
    case RTU_TESS_MISSING_END_POLYGON: return "a polygon was not ended";
    case RTU_TESS_MISSING_END_CONTOUR: return "a contour was not ended";
    case RTU_TESS_COORD_TOO_LARGE: return "a coordinate is too large";
    case RTU_TESS_NEED_COMBINE_CALLBACK: return "edges cross, and there is no combine callback";
    default: return nullptr;
    }
}

} // namespace

RTAPI const RTubyte* RTAPIENTRY rtuErrorString(RTenum error) {
    return reinterpret_cast<const RTubyte*>(errorText(error));
}

RTAPI const RTubyte* RTAPIENTRY rtuGetString(RTenum name) {
    const char* const text = name == RTU_VERSION ? "1.3" : name == RTU_EXTENSIONS ? "" : nullptr;
    return reinterpret_cast<const RTubyte*>(text);
}

RTAPI RTboolean RTAPIENTRY rtuCheckExtension(const RTubyte* extName, const RTubyte* extString) {
    if (!extName || !extString) return RT_FALSE;
    const std::string_view wanted(reinterpret_cast<const char*>(extName));
    std::string_view words(reinterpret_cast<const char*>(extString));
    while (!words.empty()) {
        const std::size_t end = words.find(' ');
        if (!wanted.empty() && words.substr(0, end) == wanted) return RT_TRUE;
        words.remove_prefix(end == words.npos ? words.size() : end + 1);
    }
    return RT_FALSE;
}

// SPDX-License-Identifier: MIT
// Makes a shader library (plug-in) of plain C++ classes, see shader.hpp:
//
//   #include <openrt/plugin.hpp>
//   struct Wood { ... };
//   OPENRT_PLUGIN(Wood, "Wood")
//
//   c++ -O2 -shared $(pkg-config --cflags openrt-shader) wood.cpp -o wood.so
//
// OPENRT_PLUGIN may be used for several classes, in several source files of one library, in any
// namespace. Nothing is linked, and nothing runs when the library is loaded: a class is described
// when it is asked for.
#pragma once

#include <cstddef>
#include <exception>

#include "openrt/rts_plugin.h"
#include "openrt/shader.hpp"

namespace openrt::detail {

inline void writeReason(const char* text, char* reason, RTuint size) noexcept {
    if (size == 0) return;
    RTuint i = 0;
    for (; i + 1 < size && text[i]; ++i) reason[i] = text[i];
    reason[i] = '\0';
}

/// RTSpluginclass::describe of class T.
template <class T>
[[gnu::visibility("hidden")]] const RTshaderclass*
describePluginClass(const RTSpluginclass* self, char* reason, RTuint reasonSize) noexcept {
    try {
        const RTshaderclass* const descriptor = shaderClass<T>(self->name);
        static_cast<void>(T()); // here its constructor's words can still be heard
        return descriptor;
    } catch (const std::exception& error) {
        writeReason(error.what(), reason, reasonSize);
    } catch (...) {
        writeReason("an exception that says nothing was thrown", reason, reasonSize);
    }
    return nullptr;
}

} // namespace openrt::detail

/// `Class` is known to rtGenNewShaderClass as `name`, a string literal.
#define OPENRT_PLUGIN(Class, name) OPENRT_PLUGIN_AT_LINE(Class, name, __LINE__)
#define OPENRT_PLUGIN_AT_LINE(Class, name, line) OPENRT_PLUGIN_NUMBERED(Class, name, line)
#define OPENRT_PLUGIN_NUMBERED(Class, name, number)                                                \
    static constexpr RTSpluginclass rtsPluginClass##number = {                                     \
        sizeof(RTSpluginclass), name, nullptr, &openrt::detail::describePluginClass<Class>};       \
    RTS_PLUGIN_LISTED static const RTSpluginclass* const rtsPluginEntry##number =                  \
        &rtsPluginClass##number;

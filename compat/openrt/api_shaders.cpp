// SPDX-License-Identifier: MIT
#include <cstring>
#include <memory>
#include <new>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "compat/openrt/guard.h"
#include "libsmart/shading/plugin_loader.h"
#include "libsmart/shading/plugin_search.h"
#include "openrt/rt_shaders.h"
#include "openrt/rts.h"

using namespace smart;
using namespace smart::compat;

namespace {

bool keep(ListRecording& list, const char* function, RTuint handle, RTStype type,
          std::span<const std::byte> value) noexcept {
    try {
        const auto body = [handle, type,
                           kept = std::vector(value.begin(), value.end())](Context& c) {
            c.recorder().setParameter(handle, {type, kept});
        };
        return keepIn(list, ListOp::Call, function, 0, body);
    } catch (const std::bad_alloc&) {
        return list.lose();
    }
}

/// Copies the value where a list keeps the call, and only there.
void set(const char* function, RTuint handle, RTStype type, const void* data,
         std::size_t bytes) noexcept {
    guarded(function, [&](Context& c) {
        if (bytes > ShaderClass::kMaxBlock)
            throwError(ErrorCode::InvalidOperation, "no parameter has so many bytes");
        const std::span value(static_cast<const std::byte*>(data), bytes);
        if (ListRecording* const list = c.lists().recording())
            if (!keep(*list, function, handle, type, value)) return;
        c.recorder().setParameter(handle, {type, value});
    });
}

template <class T, std::size_t n>
void set(const char* function, RTuint handle, RTStype type, const T (&values)[n]) noexcept {
    set(function, handle, type, values, sizeof values);
}

void setPointer(const char* function, RTuint handle, RTStype type, const RTfloat* v,
                std::size_t n) noexcept {
    guarded(function, [&](Context&) {
        requirePointer(v, "v");
        set(function, handle, type, v, n * sizeof *v);
    });
}

} // namespace

RTAPI RTuint RTAPIENTRY rtGenNewShaderClass(const char* shaderName, const char* fileName) {
    return guardedOr<RTuint>(RT_INVALID, __func__, [&](Context& c) {
        ShaderCatalog& shaders = c.recorder().shaders();
        requirePointer(shaderName, "shaderName");
        if (fileName)
            return shaders.addClass(
                loadShaderClass(shaderName, findShaderLibrary(fileName, shaderFolders())));
        ShaderClassPtr found = shaders.findClass(shaderName);
        if (!found)
            throwError(ErrorCode::InvalidValue,
                       "no shader class named '" + std::string(shaderName) +
                           "' is built in or registered");
        return shaders.addClass(std::move(found));
    });
}

RTAPI const char* RTAPIENTRY rtGetShaderClassNames(const char* fileName) {
    return guardedOr<const char*>(nullptr, __func__, [&](Context& c) {
        c.recorder().requireOutsidePrimitive();
        thread_local std::string text;
        std::string names;
        for (const std::string& name :
             fileName ? shaderClassNames(findShaderLibrary(fileName, shaderFolders()))
                      : builtinClassNames())
            names += name + '\n';
        text = std::move(names);
        return text.c_str();
    });
}

RTAPI const struct RTshaderclass* RTAPIENTRY rtGetShaderClassDescriptor(RTuint shaderClass) {
    return guardedOr<const RTshaderclass*>(nullptr, __func__, [&](Context& c) {
        return &c.recorder().shaders().shaderClass(shaderClass)->descriptor();
    });
}

RTAPI RTuint RTAPIENTRY rtRegisterShaderClass(const struct RTshaderclass* descriptor) {
    return guardedOr<RTuint>(RT_INVALID, __func__, [&](Context& c) {
        ShaderCatalog& shaders = c.recorder().shaders();
        requirePointer(descriptor, "descriptor");
        return shaders.registerClass(std::make_shared<const ShaderClass>(*descriptor, nullptr));
    });
}

RTAPI void RTAPIENTRY rtBindShaderClass(RTuint shaderClass) {
    recorded(__func__, [=](Context& c) { c.recorder().shaders().bindClass(shaderClass); });
}
RTAPI void RTAPIENTRY rtRemoveShaderClass(RTuint shaderClass) {
    guarded(__func__, [&](Context& c) { c.recorder().shaders().removeClass(shaderClass); });
}
RTAPI RTuint RTAPIENTRY rtGenNewShader(void) {
    return guardedOr<RTuint>(RT_INVALID, __func__,
                             [](Context& c) { return c.recorder().shaders().newShader(); });
}
RTAPI void RTAPIENTRY rtBindShader(RTuint shader) {
    recorded(__func__, [=](Context& c) { c.recorder().shaders().bindShader(shader); });
}
RTAPI void RTAPIENTRY rtRemoveShader(RTuint shader) {
    guarded(__func__, [&](Context& c) { c.recorder().shaders().removeShader(shader); });
}
RTAPI RTuint RTAPIENTRY rtParameterHandle(const char* name) {
    return guardedOr<RTuint>(RT_INVALID, __func__, [&](Context& c) {
        c.recorder().requireOutsidePrimitive();
        requirePointer(name, "name");
        return c.recorder().shaders().parameterHandle(name);
    });
}

RTAPI void RTAPIENTRY rtParameter1i(RTuint handle, RTint x) {
    set(__func__, handle, RTS_INT1, {x});
}
RTAPI void RTAPIENTRY rtParameter2i(RTuint handle, RTint x, RTint y) {
    set(__func__, handle, RTS_INT2, {x, y});
}
RTAPI void RTAPIENTRY rtParameter3i(RTuint handle, RTint x, RTint y, RTint z) {
    set(__func__, handle, RTS_INT3, {x, y, z});
}
RTAPI void RTAPIENTRY rtParameter1f(RTuint handle, RTfloat x) {
    set(__func__, handle, RTS_FLOAT1, {x});
}
RTAPI void RTAPIENTRY rtParameter2f(RTuint handle, RTfloat x, RTfloat y) {
    set(__func__, handle, RTS_FLOAT2, {x, y});
}
RTAPI void RTAPIENTRY rtParameter3f(RTuint handle, RTfloat x, RTfloat y, RTfloat z) {
    set(__func__, handle, RTS_FLOAT3, {x, y, z});
}
RTAPI void RTAPIENTRY rtParameter4f(RTuint handle, RTfloat x, RTfloat y, RTfloat z, RTfloat w) {
    set(__func__, handle, RTS_FLOAT4, {x, y, z, w});
}
RTAPI void RTAPIENTRY rtParameter16f(RTuint handle, RTfloat m0, RTfloat m1, RTfloat m2, RTfloat m3,
                                     RTfloat m4, RTfloat m5, RTfloat m6, RTfloat m7, RTfloat m8,
                                     RTfloat m9, RTfloat m10, RTfloat m11, RTfloat m12,
                                     RTfloat m13, RTfloat m14, RTfloat m15) {
    set(__func__, handle, RTS_FLOAT16,
        {m0, m1, m2, m3, m4, m5, m6, m7, m8, m9, m10, m11, m12, m13, m14, m15});
}

RTAPI void RTAPIENTRY rtParameter1fv(RTuint handle, const RTfloat* v) {
    setPointer(__func__, handle, RTS_FLOAT1, v, 1);
}
RTAPI void RTAPIENTRY rtParameter2fv(RTuint handle, const RTfloat* v) {
    setPointer(__func__, handle, RTS_FLOAT2, v, 2);
}
RTAPI void RTAPIENTRY rtParameter3fv(RTuint handle, const RTfloat* v) {
    setPointer(__func__, handle, RTS_FLOAT3, v, 3);
}
RTAPI void RTAPIENTRY rtParameter4fv(RTuint handle, const RTfloat* v) {
    setPointer(__func__, handle, RTS_FLOAT4, v, 4);
}
RTAPI void RTAPIENTRY rtParameter16fv(RTuint handle, const RTfloat* v) {
    setPointer(__func__, handle, RTS_FLOAT16, v, 16);
}

RTAPI void RTAPIENTRY rtParameterRaw(RTuint handle, const void* data, RTuint size) {
    guarded(__func__, [&](Context&) {
        requirePointer(data, "data");
        set("rtParameterRaw", handle, RTS_RAW, data, size);
    });
}
RTAPI void RTAPIENTRY rtParameterString(RTuint handle, const char* text) {
    guarded(__func__, [&](Context&) {
        requirePointer(text, "text");
        set("rtParameterString", handle, RTS_STRING, text, std::strlen(text));
    });
}

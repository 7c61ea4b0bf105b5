// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>

#include "compat/openrt/guard.h"
#include "openrt/rt_arrays.h"

using namespace smart;
using namespace smart::compat;

namespace {

BufferBinding& binding(Context& c, RTenum target) {
    c.recorder().requireOutsidePrimitive();
    switch (target) {
    case RT_ARRAY_BUFFER: return c.arrays().arrayBuffer;
    case RT_ELEMENT_ARRAY_BUFFER: return c.arrays().elementBuffer;
    default: throwError(ErrorCode::InvalidEnum, "no such target of buffers");
    }
}

BufferObject& boundBuffer(Context& c, RTenum target) {
    const BufferBinding& bound = binding(c, target);
    if (!bound.buffer) throwError(ErrorCode::InvalidOperation, "no buffer is bound");
    return *bound.buffer;
}

/// The part of an unmapped buffer that a call reads or writes.
std::byte* part(BufferObject& buffer, RTintptr offset, RTsizeiptr size) {
    if (offset < 0 || size < 0 || uint64_t(offset) + uint64_t(size) > buffer.bytes.size())
        throwError(ErrorCode::InvalidValue, "the part does not lie inside the buffer");
    if (buffer.mapped) throwError(ErrorCode::InvalidOperation, "the buffer is mapped");
    return buffer.bytes.data() + offset;
}

void requireNames(Context& c, RTsizei n, const RTuint* buffers) {
    c.recorder().requireOutsidePrimitive();
    if (n < 0) throwError(ErrorCode::InvalidValue, "n is negative");
    if (n > 0) requirePointer(buffers, "buffers");
}

void unbind(VertexArrays& arrays, RTuint name) noexcept {
    const auto release = [name](BufferBinding& bound) {
        if (bound.name == name) bound = {};
    };
    release(arrays.arrayBuffer);
    release(arrays.elementBuffer);
    for (VertexArray& array : arrays.arrays) {
        if (array.buffer.name == name) array.pointer = nullptr; // it was an offset
        release(array.buffer);
    }
}

bool isUsage(RTenum usage) {
    return usage >= RT_STREAM_DRAW && usage <= RT_DYNAMIC_COPY && usage % 4 != 3;
}

} // namespace

RTAPI void RTAPIENTRY rtGenBuffers(RTsizei n, RTuint* buffers) {
    guarded(__func__, [&](Context& c) {
        requireNames(c, n, buffers);
        for (RTsizei i = 0; i < n; ++i) buffers[i] = c.buffers().generate();
    });
}
RTAPI void RTAPIENTRY rtDeleteBuffers(RTsizei n, const RTuint* buffers) {
    guarded(__func__, [&](Context& c) {
        requireNames(c, n, buffers);
        for (RTsizei i = 0; i < n; ++i) {
            if (buffers[i] == 0) continue;
            c.buffers().remove(buffers[i]);
            unbind(c.arrays(), buffers[i]);
        }
    });
}
RTAPI RTboolean RTAPIENTRY rtIsBuffer(RTuint buffer) {
    return guardedOr<RTboolean>(RT_FALSE, __func__, [&](Context& c) -> RTboolean {
        c.recorder().requireOutsidePrimitive();
        return c.buffers().exists(buffer) ? RT_TRUE : RT_FALSE;
    });
}
RTAPI void RTAPIENTRY rtBindBuffer(RTenum target, RTuint buffer) {
    guarded(__func__, [&](Context& c) {
        BufferBinding& place = binding(c, target);
        place = c.buffers().bind(buffer);
    });
}

RTAPI void RTAPIENTRY rtBufferData(RTenum target, RTsizeiptr size, const void* data, RTenum usage) {
    guarded(__func__, [&](Context& c) {
        BufferObject& buffer = boundBuffer(c, target);
        if (size < 0) throwError(ErrorCode::InvalidValue, "the size is negative");
        if (!isUsage(usage)) throwError(ErrorCode::InvalidEnum, "not a usage of buffers");
        const auto* const from = static_cast<const std::byte*>(data);
        std::vector<std::byte> bytes =
            from ? std::vector(from, from + size) : std::vector<std::byte>(std::size_t(size));
        buffer.bytes.swap(bytes);
        buffer.usage = usage;
        buffer.mapped = false;
    });
}
RTAPI void RTAPIENTRY rtBufferSubData(RTenum target, RTintptr offset, RTsizeiptr size,
                                      const void* data) {
    guarded(__func__, [&](Context& c) {
        std::byte* const to = part(boundBuffer(c, target), offset, size);
        if (size == 0) return;
        requirePointer(data, "data");
        std::copy_n(static_cast<const std::byte*>(data), size, to);
    });
}
RTAPI void RTAPIENTRY rtGetBufferSubData(RTenum target, RTintptr offset, RTsizeiptr size,
                                         void* data) {
    guarded(__func__, [&](Context& c) {
        const std::byte* const from = part(boundBuffer(c, target), offset, size);
        if (size == 0) return;
        requirePointer(data, "data");
        std::copy_n(from, size, static_cast<std::byte*>(data));
    });
}

RTAPI void* RTAPIENTRY rtMapBuffer(RTenum target, RTenum access) {
    return guardedOr<void*>(nullptr, __func__, [&](Context& c) -> void* {
        BufferObject& buffer = boundBuffer(c, target);
        if (access != RT_READ_ONLY && access != RT_WRITE_ONLY && access != RT_READ_WRITE)
            throwError(ErrorCode::InvalidEnum, "not a way to access buffers");
        if (buffer.mapped) throwError(ErrorCode::InvalidOperation, "the buffer is mapped already");
        buffer.access = access;
        buffer.mapped = true;
        return buffer.bytes.data();
    });
}
RTAPI RTboolean RTAPIENTRY rtUnmapBuffer(RTenum target) {
    return guardedOr<RTboolean>(RT_FALSE, __func__, [&](Context& c) -> RTboolean {
        BufferObject& buffer = boundBuffer(c, target);
        if (!buffer.mapped) throwError(ErrorCode::InvalidOperation, "the buffer is not mapped");
        buffer.mapped = false;
        return RT_TRUE;
    });
}

RTAPI void RTAPIENTRY rtGetBufferParameteriv(RTenum target, RTenum pname, RTint* params) {
    guarded(__func__, [&](Context& c) {
        const BufferObject& buffer = boundBuffer(c, target);
        const auto give = [params](uint64_t value) {
            requirePointer(params, "params");
            *params = RTint(std::min<uint64_t>(value, 0x7FFFFFFF));
        };
        switch (pname) {
        case RT_BUFFER_SIZE: give(buffer.bytes.size()); break;
        case RT_BUFFER_USAGE: give(buffer.usage ? buffer.usage : RT_STATIC_DRAW); break;
        case RT_BUFFER_ACCESS: give(buffer.access ? buffer.access : RT_READ_WRITE); break;
        case RT_BUFFER_MAPPED: give(buffer.mapped); break;
        default: throwError(ErrorCode::InvalidEnum, "buffers have no such value");
        }
    });
}
RTAPI void RTAPIENTRY rtGetBufferPointerv(RTenum target, RTenum pname, void** params) {
    guarded(__func__, [&](Context& c) {
        BufferObject& buffer = boundBuffer(c, target);
        if (pname != RT_BUFFER_MAP_POINTER)
            throwError(ErrorCode::InvalidEnum, "buffers have no such pointer");
        requirePointer(params, "params");
        *params = buffer.mapped ? buffer.bytes.data() : nullptr;
    });
}

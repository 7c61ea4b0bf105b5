// SPDX-License-Identifier: MIT
#include "compat/stream/played_arrays.h"

#include <algorithm>
#include <cstring>
#include <optional>

#include "compat/stream/call_memory.h"
#include "compat/stream/call_player.h"
#include "openrt/rt_arrays.h"
#include "openrt/rt_state.h"

namespace smart::compat {

namespace {

bool isCall(const CallSignature& call, const char* name) {
    return std::strcmp(call.name, name) == 0;
}

/// What a drawing call asks of every array.
class Reach {
public:
    explicit Reach(const CallRecord& record) : record_(record) {}

    void addRange(int64_t first, int64_t count) {
        if (first >= 0 && count > 0) add(uint64_t(first)), add(uint64_t(first + count - 1));
    }
    /// `memory` nullptr: in the buffer that is bound, at an offset.
    void addIndices(RTenum type, int64_t count, const RecordedArgument& indices) {
        const std::size_t size = bytesOfIndex(type);
        if (size == 0 || count <= 0) return;
        std::vector<std::byte> copy;
        std::span<const std::byte> bytes = indices.bytes;
        if (indices.tag == PointerTag::Number) {
            copy = fromBuffer(indices.value.as<uint64_t>(), uint64_t(count) * size);
            bytes = copy;
        }
        for (int64_t i = 0; std::size_t(i + 1) * size <= bytes.size() && i < count; ++i) {
            uint32_t index = 0;
            if (size == 1) index = uint32_t(bytes[std::size_t(i)]);
            if (size == 4) std::memcpy(&index, bytes.data() + 4 * i, sizeof index);
            if (uint16_t half = 0; size == 2) {
                std::memcpy(&half, bytes.data() + 2 * i, sizeof half);
                index = half;
            }
            add(index);
        }
    }

private:
    void add(uint64_t element) const {
        for (const RecordedArray& array : record_.arrays)
            if (element < array.first || element - array.first >= array.elements)
                throw StreamError(std::string(record_.call->name) +
                                  " reads elements that were not recorded");
    }
    /// Empty where the buffer does not reach so far: the call is refused then.
    static std::vector<std::byte> fromBuffer(uint64_t offset, uint64_t bytes) {
        RTint bound = 0, size = 0;
        rtGetIntegerv(RT_ELEMENT_ARRAY_BUFFER_BINDING, &bound);
        if (bound == 0) return {};
        rtGetBufferParameteriv(RT_ELEMENT_ARRAY_BUFFER, RT_BUFFER_SIZE, &size);
        if (offset > uint64_t(size) || bytes > uint64_t(size) - offset) return {};
        std::vector<std::byte> copy(std::size_t(bytes), std::byte(0));
        rtGetBufferSubData(RT_ELEMENT_ARRAY_BUFFER, RTintptr(offset), RTsizeiptr(bytes),
                           copy.data());
        return copy;
    }

    const CallRecord& record_;
};

void checkReach(const CallRecord& record, const CallValue* a) {
    Reach reach(record);
    if (isCall(*record.call, "rtDrawArrays")) {
        reach.addRange(a[1].as<RTint>(), a[2].as<RTsizei>());
    } else if (isCall(*record.call, "rtDrawElements")) {
        reach.addIndices(a[2].as<RTenum>(), a[1].as<RTsizei>(), record.arguments[3]);
    } else if (isCall(*record.call, "rtDrawRangeElements")) {
        reach.addIndices(a[4].as<RTenum>(), a[3].as<RTsizei>(), record.arguments[5]);
    } else if (isCall(*record.call, "rtMultiDrawArrays")) {
        const auto* const firsts = a[1].as<const RTint*>();
        const auto* const counts = a[2].as<const RTsizei*>();
        for (RTsizei i = 0; firsts && counts && i < a[3].as<RTsizei>(); ++i)
            reach.addRange(firsts[i], counts[i]);
    } else if (isCall(*record.call, "rtMultiDrawElements")) {
        const auto* const counts = a[1].as<const RTsizei*>();
        const std::vector<RecordedArgument>& indices = record.arguments[3].pieces;
        for (std::size_t i = 0; counts && i < indices.size(); ++i)
            reach.addIndices(a[2].as<RTenum>(), counts[i], indices[i]);
    } else {
        throw StreamError(std::string(record.call->name) + " draws no vertex arrays");
    }
}

RTenum unitOf(const RecordedArray& array) {
    return RT_TEXTURE0 + arrayNames(array.kind)->unit;
}

/// Says where an array lies; with another buffer than now bound it would be an offset.
void setArray(const RecordedArray& array, const void* pointer) {
    const char* const name = arrayNames(array.kind)->pointer;
    rtClientActiveTexture(unitOf(array));
    const auto stride = RTsizei(array.stride);
    if (std::strcmp(name, "rtVertexPointer") == 0)
        rtVertexPointer(array.size, array.type, stride, pointer);
    else if (std::strcmp(name, "rtTexCoordPointer") == 0)
        rtTexCoordPointer(array.size, array.type, stride, pointer);
    else if (std::strcmp(name, "rtColorPointer") == 0)
        rtColorPointer(array.size, array.type, stride, pointer);
    else if (std::strcmp(name, "rtSecondaryColorPointer") == 0)
        rtSecondaryColorPointer(array.size, array.type, stride, pointer);
    else if (std::strcmp(name, "rtNormalPointer") == 0)
        rtNormalPointer(array.type, stride, pointer);
    else if (std::strcmp(name, "rtFogCoordPointer") == 0)
        rtFogCoordPointer(array.type, stride, pointer);
    else if (std::strcmp(name, "rtEdgeFlagPointer") == 0)
        rtEdgeFlagPointer(stride, pointer);
}

const CallSignature& immediate(const RecordedArray& array) {
    const CallSignature* const call = immediateCall(array);
    if (!call) throw StreamError("a vertex array of a size or type that there is not");
    return *call;
}

} // namespace

void playDrawing(const CallRecord& record, const CallValue* arguments, CallArena& arena) {
    CallValue none;
    if (record.arrays.empty()) return invokeCall(*record.call, arguments, none);
    checkReach(record, arguments);
    RTint bound = 0, unit = 0;
    rtGetIntegerv(RT_ARRAY_BUFFER_BINDING, &bound);
    rtGetIntegerv(RT_CLIENT_ACTIVE_TEXTURE, &unit);
    rtBindBuffer(RT_ARRAY_BUFFER, 0);
    for (const RecordedArray& array : record.arrays) {
        immediate(array);
        // The first elements are not there, and not read.
        const auto start = reinterpret_cast<uintptr_t>(arena.copy(array.bytes));
        setArray(array,
                 reinterpret_cast<const void*>(start - uintptr_t(array.first * array.step())));
    }
    rtBindBuffer(RT_ARRAY_BUFFER, RTuint(bound));
    rtClientActiveTexture(RTenum(unit));
    invokeCall(*record.call, arguments, none);
    rtBindBuffer(RT_ARRAY_BUFFER, 0);
    for (const RecordedArray& array : record.arrays) setArray(array, nullptr);
    rtBindBuffer(RT_ARRAY_BUFFER, RTuint(bound));
    rtClientActiveTexture(RTenum(unit));
}

void playElement(const CallRecord& record, CallArena& arena) {
    for (const RecordedArray& array : record.arrays) {
        const CallSignature& call = immediate(array);
        const CallValue pointer(arena.copy(array.bytes));
        const CallValue ofUnit[] = {CallValue(unitOf(array)), pointer};
        CallValue none;
        invokeCall(call, parametersOf(call).size() == 2 ? ofUnit : &pointer, none);
    }
}

} // namespace smart::compat

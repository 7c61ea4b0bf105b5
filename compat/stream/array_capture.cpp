// SPDX-License-Identifier: MIT
#include "compat/stream/array_capture.h"

#include <algorithm>
#include <cstring>
#include <optional>

#include "compat/openrt/array_elements.h"
#include "compat/stream/call_memory.h"

namespace smart::compat {

namespace {

struct ElementRange {
    uint64_t first = UINT64_MAX, last = 0;
    void add(uint64_t from, uint64_t to) {
        first = std::min(first, from);
        last = std::max(last, to);
    }
    bool isEmpty() const { return first > last; }
};

void addRange(ElementRange& range, int64_t first, int64_t count) {
    if (first >= 0 && count > 0) range.add(uint64_t(first), uint64_t(first + count - 1));
}

/// The elements that indices name, which lie in memory or in the bound buffer.
void addIndices(ElementRange& range, const VertexArrays& arrays, RTenum type, int64_t count,
                const void* indices) {
    const std::size_t size = bytesOfIndex(type);
    if (size == 0 || count <= 0) return;
    const auto* from = static_cast<const std::byte*>(indices);
    if (const BufferPtr& buffer = arrays.elementBuffer.buffer) {
        const auto offset = reinterpret_cast<uintptr_t>(indices);
        if (offset > buffer->bytes.size() ||
            (buffer->bytes.size() - offset) / size < uint64_t(count))
            return;
        from = buffer->bytes.data() + offset;
    }
    if (!from) return;
    for (int64_t i = 0; i < count; ++i) {
        uint32_t index = 0;
        if (size == 1) index = uint32_t(from[i]);
        if (size == 2) index = uint32_t(from[2 * i]) | uint32_t(from[2 * i + 1]) << 8;
        if (size == 4) std::memcpy(&index, from + 4 * i, sizeof index);
        range.add(index, index);
    }
}

bool isCall(const CallSignature& call, const char* name) {
    return std::strcmp(call.name, name) == 0;
}

ElementRange elementsOf(const CallSignature& call, const CallValue* a, const VertexArrays& arrays) {
    ElementRange range;
    if (isCall(call, "rtArrayElement")) {
        addRange(range, a[0].as<RTint>(), 1);
    } else if (isCall(call, "rtDrawArrays")) {
        addRange(range, a[1].as<RTint>(), a[2].as<RTsizei>());
    } else if (isCall(call, "rtDrawElements")) {
        addIndices(range, arrays, a[2].as<RTenum>(), a[1].as<RTsizei>(), a[3].as<const void*>());
    } else if (isCall(call, "rtDrawRangeElements")) {
        addIndices(range, arrays, a[4].as<RTenum>(), a[3].as<RTsizei>(), a[5].as<const void*>());
    } else if (isCall(call, "rtMultiDrawArrays")) {
        const auto* const firsts = a[1].as<const RTint*>();
        const auto* const counts = a[2].as<const RTsizei*>();
        for (RTsizei i = 0; firsts && counts && i < a[3].as<RTsizei>(); ++i)
            addRange(range, firsts[i], counts[i]);
    } else if (isCall(call, "rtMultiDrawElements")) {
        const auto* const counts = a[1].as<const RTsizei*>();
        const auto* const indices = a[3].as<const void* const*>();
        for (RTsizei i = 0; counts && indices && i < a[4].as<RTsizei>(); ++i)
            addIndices(range, arrays, a[2].as<RTenum>(), counts[i], indices[i]);
    }
    return range;
}

/// Whether the call gets as far as reading arrays.
bool isLegal(const ElementRange& range, Context& context, bool legalInPrimitive) {
    const ListRecording* const list = context.lists().recording();
    const bool makesCalls = !list || list->executes();
    if (!legalInPrimitive && makesCalls && context.recorder().insidePrimitive()) return false;
    try {
        ArrayElements(context).requireElement(range.last);
        return true;
    } catch (...) {
        return false; // which arrays there are then does not matter
    }
}

void attach(RecordWriter& record, ArrayKind kind, const VertexArray& array,
            const ElementRange& range) {
    const ReadableMemory memory = readable(array.pointer, array.buffer);
    const uint64_t elementBytes = uint64_t(array.size) * sizeOf(array.type);
    const uint64_t step = array.stride ? array.stride : elementBytes;
    const uint64_t bytes = (range.last - range.first) * step + elementBytes;
    record.put(AttachmentKind::VertexArray);
    record.put(kind);
    record.put(tokenOf(array.type));
    record.put(int32_t(array.size));
    record.put(array.stride);
    record.put(range.first);
    record.put(range.last - range.first + 1);
    record.put(bytes);
    record.putBytes(memory.data + range.first * step, std::size_t(bytes));
}

} // namespace

void captureArrays(RecordWriter& record, const CallSignature& call, const CallValue* arguments,
                   Context& context) {
    const VertexArrays& arrays = context.arrays();
    const bool isElement = isCall(call, "rtArrayElement");
    if (!isElement && !std::strstr(call.name, "Draw")) return;
    const auto isInMemory = [&](std::size_t i) {
        const VertexArray& array = arrays.arrays[i];
        return array.enabled && !array.buffer.buffer && ArrayKind(i) != ArrayKind::Index;
    };
    bool any = false;
    for (std::size_t i = 0; i < kArrayKinds; ++i) any |= isInMemory(i);
    if (!any) return;
    const ElementRange range = elementsOf(call, arguments, arrays);
    if (range.isEmpty() || !isLegal(range, context, isElement)) return;
    for (std::size_t i = 0; i < kArrayKinds; ++i) {
        const bool isRead = arrays.arrays[i].enabled && ArrayKind(i) != ArrayKind::Index;
        if (isElement ? isRead : isInMemory(i))
            attach(record, ArrayKind(i), arrays.arrays[i], range);
    }
}

} // namespace smart::compat

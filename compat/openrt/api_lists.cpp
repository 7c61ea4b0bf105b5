// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstring>
#include <optional>
#include <vector>

#include "compat/openrt/guard.h"
#include "compat/openrt/list_replay.h"
#include "openrt/rt_lists.h"

using namespace smart;
using namespace smart::compat;

namespace {

template <class T>
T valueAt(const std::byte* data, std::size_t i) {
    T value;
    std::memcpy(&value, data + i * sizeof(T), sizeof(T));
    return value;
}

/// Big-endian, of so many bytes.
uint32_t bytesAt(const std::byte* data, std::size_t i, std::size_t count) {
    uint32_t value = 0;
    for (std::size_t k = 0; k < count; ++k)
        value = value << 8 | std::to_integer<uint32_t>(data[i * count + k]);
    return value;
}

/// Rounded down; what no integer holds is offset 0.
uint32_t wholePart(float value) {
    const float floor = std::floor(value);
    return std::fabs(floor) < 0x1p32f ? uint32_t(int64_t(floor)) : 0;
}

/// Bytes of one name; empty: no type of names.
std::optional<std::size_t> sizeOfNames(RTenum type) {
    switch (type) {
    case RT_BYTE:
    case RT_UNSIGNED_BYTE: return 1;
    case RT_SHORT:
    case RT_UNSIGNED_SHORT:
    case RT_2_BYTES: return 2;
    case RT_3_BYTES: return 3;
    case RT_INT:
    case RT_UNSIGNED_INT:
    case RT_FLOAT:
    case RT_4_BYTES: return 4;
    default: return std::nullopt;
    }
}

uint32_t offsetAt(RTenum type, const std::byte* names, std::size_t i) {
    switch (type) {
    case RT_BYTE: return uint32_t(valueAt<int8_t>(names, i));
    case RT_UNSIGNED_BYTE: return valueAt<uint8_t>(names, i);
    case RT_SHORT: return uint32_t(valueAt<int16_t>(names, i));
    case RT_UNSIGNED_SHORT: return valueAt<uint16_t>(names, i);
    case RT_FLOAT: return wholePart(valueAt<float>(names, i));
    case RT_2_BYTES: return bytesAt(names, i, 2);
    case RT_3_BYTES: return bytesAt(names, i, 3);
    case RT_4_BYTES: return bytesAt(names, i, 4);
    default: return valueAt<uint32_t>(names, i);
    }
}

void callLists(Context& c, RTsizei n, RTenum type, const std::byte* names) {
    if (n < 0) throwError(ErrorCode::InvalidValue, "n is negative");
    if (!sizeOfNames(type)) throwError(ErrorCode::InvalidEnum, "not a type of list names");
    if (n > 0) requirePointer(names, "lists");
    const uint32_t base = c.lists().base();
    const auto held = currentContextShared(); // an error callback may end it
    for (RTsizei i = 0; i < n; ++i)
        replayList(c, base + offsetAt(type, names, std::size_t(i)));
}

/// Lists start and end outside of everything.
DisplayLists& listsOutside(Context& c) {
    c.recorder().requireOutsideObject();
    return c.lists();
}

} // namespace

RTAPI RTuint RTAPIENTRY rtGenLists(RTsizei range) {
    return guardedOr<RTuint>(0, __func__, [&](Context& c) {
        c.recorder().requireOutsidePrimitive();
        if (range < 0) throwError(ErrorCode::InvalidValue, "the range is negative");
        return c.lists().generate(uint32_t(range));
    });
}
RTAPI void RTAPIENTRY rtDeleteLists(RTuint list, RTsizei range) {
    guarded(__func__, [&](Context& c) {
        c.recorder().requireOutsidePrimitive();
        if (range < 0) throwError(ErrorCode::InvalidValue, "the range is negative");
        c.lists().remove(list, uint32_t(range));
    });
}
RTAPI RTboolean RTAPIENTRY rtIsList(RTuint list) {
    return guardedOr<RTboolean>(RT_FALSE, __func__, [&](Context& c) -> RTboolean {
        c.recorder().requireOutsidePrimitive();
        return c.lists().exists(list) ? RT_TRUE : RT_FALSE;
    });
}

RTAPI void RTAPIENTRY rtNewList(RTuint list, RTenum mode) {
    guarded(__func__, [&](Context& c) {
        DisplayLists& lists = listsOutside(c);
        if (list == 0) throwError(ErrorCode::InvalidValue, "0 is no name of a list");
        if (mode != RT_COMPILE && mode != RT_COMPILE_AND_EXECUTE)
            throwError(ErrorCode::InvalidEnum, "unknown list mode");
        lists.start(list, mode == RT_COMPILE_AND_EXECUTE);
    });
}
RTAPI void RTAPIENTRY rtEndList(void) {
    guarded(__func__, [](Context& c) { listsOutside(c).finish(); });
}

RTAPI void RTAPIENTRY rtCallList(RTuint list) {
    recorded(__func__, [=](Context& c) { replayList(c, list); });
}
RTAPI void RTAPIENTRY rtCallLists(RTsizei n, RTenum type, const void* lists) {
    guarded(__func__, [&](Context& c) {
        const auto* const names = static_cast<const std::byte*>(lists);
        if (ListRecording* const list = c.lists().recording()) {
            const std::size_t size = sizeOfNames(type).value_or(0);
            const auto copy = [&] {
                return names && n > 0 ? std::vector(names, names + std::size_t(n) * size)
                                      : std::vector<std::byte>();
            };
            try {
                const auto body = [n, type, given = names != nullptr,
                                   kept = copy()](Context& context) {
                    callLists(context, n, type, given ? kept.data() : nullptr);
                };
                if (!keepIn(*list, ListOp::Call, "rtCallLists", 0, body)) return;
            } catch (const std::bad_alloc&) {
                if (!list->lose()) return;
            }
        }
        callLists(c, n, type, names);
    });
}
RTAPI void RTAPIENTRY rtListBase(RTuint base) {
    recorded(__func__, [=](Context& c) {
        c.recorder().requireOutsidePrimitive();
        c.lists().setBase(base);
    });
}

// SPDX-License-Identifier: MIT
// Elements of vertex arrays as vertices and primitives, and rectangles.
#include <algorithm>
#include <cstring>

#include "compat/openrt/array_elements.h"
#include "compat/openrt/guard.h"
#include "openrt/rt_arrays.h"
#include "openrt/rt_objects.h"

using namespace smart;
using namespace smart::compat;

namespace {

/// Whether calls are made, and not only kept in a list.
bool makesCalls(Context& c) {
    const ListRecording* const list = c.lists().recording();
    return !list || list->executes();
}

void checkDrawing(Context& c, RTenum mode, RTsizei count) {
    if (makesCalls(c)) c.recorder().requireOutsidePrimitive();
    const bool known = mode <= RT_LINE_STRIP || (mode >= RT_TRIANGLES && mode <= RT_POLYGON);
    if (!known) throwError(ErrorCode::InvalidEnum, "no such primitive");
    if (count < 0) throwError(ErrorCode::InvalidValue, "the number of elements is negative");
}

/// index(i): the number of the i-th element to draw; largest(): the largest of them.
template <class Index, class Largest>
void draw(Context& c, RTenum mode, RTsizei count, const Index& index, const Largest& largest) {
    const ArrayElements elements(c);
    if (count == 0 || !elements.hasVertices()) return;
    elements.requireElement(largest());
    rtBegin(mode);
    if (makesCalls(c) && !c.recorder().insidePrimitive()) return; // it was refused
    try {
        for (RTsizei i = 0; i < count; ++i) elements.make(index(i));
    } catch (...) {
        rtEnd();
        throw;
    }
    rtEnd();
    if (!c.lists().recording()) elements.restoreAttributes();
}

void drawRange(Context& c, RTenum mode, RTint first, RTsizei count) {
    checkDrawing(c, mode, count);
    if (first < 0) throwError(ErrorCode::InvalidValue, "the first element is negative");
    const auto index = [first](RTsizei i) { return uint64_t(first) + uint64_t(i); };
    draw(c, mode, count, index, [&] { return index(count - 1); });
}

template <class T>
void drawIndexed(Context& c, RTenum mode, RTsizei count, const ReadableMemory& indices) {
    if (indices.bytes / sizeof(T) < uint64_t(count))
        throwError(ErrorCode::InvalidOperation, "the buffer ends before the indices do");
    const auto index = [&](RTsizei i) -> uint64_t {
        T value;
        std::memcpy(&value, indices.data + std::size_t(i) * sizeof value, sizeof value);
        return value;
    };
    draw(c, mode, count, index, [&] {
        uint64_t largest = 0;
        for (RTsizei i = 0; i < count; ++i) largest = std::max(largest, index(i));
        return largest;
    });
}

void drawIndexed(Context& c, RTenum mode, RTsizei count, RTenum type, const void* indices) {
    checkDrawing(c, mode, count);
    if (type != RT_UNSIGNED_BYTE && type != RT_UNSIGNED_SHORT && type != RT_UNSIGNED_INT)
        throwError(ErrorCode::InvalidEnum, "not a type of indices");
    if (count == 0) return;
    const ReadableMemory memory = readable(indices, c.arrays().elementBuffer);
    if (type == RT_UNSIGNED_BYTE)
        drawIndexed<RTubyte>(c, mode, count, memory);
    else if (type == RT_UNSIGNED_SHORT)
        drawIndexed<RTushort>(c, mode, count, memory);
    else
        drawIndexed<RTuint>(c, mode, count, memory);
}

void requireDrawings(Context& c, RTsizei drawcount, const void* first, const void* second) {
    if (makesCalls(c)) c.recorder().requireOutsidePrimitive();
    if (drawcount < 0) throwError(ErrorCode::InvalidValue, "drawcount is negative");
    if (drawcount == 0) return;
    requirePointer(first, "an array of the call");
    requirePointer(second, "an array of the call");
}

void rectangle(const char* function, RTdouble x1, RTdouble y1, RTdouble x2, RTdouble y2) noexcept {
    guarded(function, [&](Context& c) {
        if (makesCalls(c)) c.recorder().requireOutsidePrimitive();
        rtBegin(RT_POLYGON);
        rtVertex2d(x1, y1);
        rtVertex2d(x2, y1);
        rtVertex2d(x2, y2);
        rtVertex2d(x1, y2);
        rtEnd();
    });
}

template <class T>
void rectangle(const char* function, const T* v1, const T* v2) noexcept {
    guarded(function, [&](Context&) {
        requirePointer(v1, "v1");
        requirePointer(v2, "v2");
        rectangle(function, v1[0], v1[1], v2[0], v2[1]);
    });
}

} // namespace

RTAPI void RTAPIENTRY rtArrayElement(RTint i) {
    guarded(__func__, [&](Context& c) {
        if (i < 0) throwError(ErrorCode::InvalidValue, "the element is negative");
        const ArrayElements elements(c);
        elements.requireElement(uint64_t(i));
        elements.make(uint64_t(i));
    });
}

RTAPI void RTAPIENTRY rtDrawArrays(RTenum mode, RTint first, RTsizei count) {
    guarded(__func__, [&](Context& c) { drawRange(c, mode, first, count); });
}
RTAPI void RTAPIENTRY rtMultiDrawArrays(RTenum mode, const RTint* first, const RTsizei* count,
                                        RTsizei drawcount) {
    guarded(__func__, [&](Context& c) {
        requireDrawings(c, drawcount, first, count);
        for (RTsizei i = 0; i < drawcount; ++i)
            if (count[i] > 0) drawRange(c, mode, first[i], count[i]);
    });
}

RTAPI void RTAPIENTRY rtDrawElements(RTenum mode, RTsizei count, RTenum type,
                                     const void* indices) {
    guarded(__func__, [&](Context& c) { drawIndexed(c, mode, count, type, indices); });
}
RTAPI void RTAPIENTRY rtDrawRangeElements(RTenum mode, RTuint start, RTuint end, RTsizei count,
                                          RTenum type, const void* indices) {
    guarded(__func__, [&](Context& c) {
        if (end < start) throwError(ErrorCode::InvalidValue, "the range ends before it starts");
        drawIndexed(c, mode, count, type, indices);
    });
}
RTAPI void RTAPIENTRY rtMultiDrawElements(RTenum mode, const RTsizei* count, RTenum type,
                                          const void* const* indices, RTsizei drawcount) {
    guarded(__func__, [&](Context& c) {
        requireDrawings(c, drawcount, count, indices);
        for (RTsizei i = 0; i < drawcount; ++i)
            if (count[i] > 0) drawIndexed(c, mode, count[i], type, indices[i]);
    });
}

RTAPI void RTAPIENTRY rtRects(RTshort x1, RTshort y1, RTshort x2, RTshort y2) {
    rectangle(__func__, x1, y1, x2, y2);
}
RTAPI void RTAPIENTRY rtRecti(RTint x1, RTint y1, RTint x2, RTint y2) {
    rectangle(__func__, x1, y1, x2, y2);
}
RTAPI void RTAPIENTRY rtRectf(RTfloat x1, RTfloat y1, RTfloat x2, RTfloat y2) {
    rectangle(__func__, RTdouble(x1), RTdouble(y1), RTdouble(x2), RTdouble(y2));
}
RTAPI void RTAPIENTRY rtRectd(RTdouble x1, RTdouble y1, RTdouble x2, RTdouble y2) {
    rectangle(__func__, x1, y1, x2, y2);
}
RTAPI void RTAPIENTRY rtRectsv(const RTshort* v1, const RTshort* v2) {
    rectangle(__func__, v1, v2);
}
RTAPI void RTAPIENTRY rtRectiv(const RTint* v1, const RTint* v2) {
    rectangle(__func__, v1, v2);
}
RTAPI void RTAPIENTRY rtRectfv(const RTfloat* v1, const RTfloat* v2) {
    rectangle(__func__, v1, v2);
}
RTAPI void RTAPIENTRY rtRectdv(const RTdouble* v1, const RTdouble* v2) {
    rectangle(__func__, v1, v2);
}

// SPDX-License-Identifier: MIT
// Elements of vertex arrays as vertices and primitives, and rectangles.
#include <algorithm>
#include <cstring>

#include "compat/openrt/array_elements.h"
#include "compat/openrt/guard.h"
#include "compat/openrt/tokens.h"
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

void requirePlaceToDraw(Context& c, RTenum mode) {
    if (makesCalls(c)) c.recorder().requireOutsidePrimitive();
    const bool known = mode <= RT_LINE_STRIP || (mode >= RT_TRIANGLES && mode <= RT_POLYGON);
    if (!known) throwError(ErrorCode::InvalidEnum, "no such primitive");
}

void requireSurface(Context& c) {
    if (makesCalls(c) && !c.recorder().shaders().bound().isSurface)
        throwError(ErrorCode::InvalidOperation, "the bound shader is not a surface shader");
}

template <class Body>
void keepAndMake(Context& c, ListOp op, const char* function, const Body& body) {
    ListRecording* const list = c.lists().recording();
    if (!list || keepIn(*list, op, function, 0, body)) body(c);
}

/// Calls between rtBegin and rtEnd, none of which fails but for lack of memory. No error is told
/// before the caller's guard does: who hears of it may end the context.
template <class Calls>
void makePrimitive(Context& c, RTenum mode, const Calls& calls) {
    const bool filled = mode >= RT_TRIANGLES && mode <= RT_POLYGON;
    try {
        keepAndMake(c, filled ? ListOp::BeginFilled : ListOp::BeginOther, "rtBegin",
                    [mode](Context& context) { context.recorder().begin(primitiveOf(mode)); });
        calls();
        keepAndMake(c, ListOp::End, "rtEnd", [](Context& context) { context.recorder().end(); });
    } catch (...) {
        if (c.recorder().insidePrimitive()) c.recorder().end();
        if (ListRecording* const list = c.lists().recording()) list->lose();
        throw;
    }
}

/// Elements first, first + 1, ...
struct ElementRange {
    RTint first;
    RTsizei count;

    uint64_t operator[](RTsizei i) const { return uint64_t(first) + uint64_t(i); }
    uint64_t largest() const { return (*this)[count - 1]; }
};

template <class T>
struct IndexedElements {
    const std::byte* indices;
    RTsizei count;

    uint64_t operator[](RTsizei i) const {
        T value;
        std::memcpy(&value, indices + std::size_t(i) * sizeof value, sizeof value);
        return value;
    }
    uint64_t largest() const {
        uint64_t largest = 0;
        for (RTsizei i = 0; i < count; ++i) largest = std::max(largest, (*this)[i]);
        return largest;
    }
};

/// Checks all of the drawings, then makes them. elementsOf(i): what the i-th draws.
template <class ElementsOf>
void draw(Context& c, RTenum mode, RTsizei drawings, const ElementsOf& elementsOf) {
    const ArrayElements arrays(c);
    for (RTsizei i = 0; i < drawings; ++i) {
        const auto elements = elementsOf(i);
        if (elements.count > 0 && arrays.hasVertices()) arrays.requireElement(elements.largest());
    }
    if (!arrays.hasVertices()) return;
    requireSurface(c);
    try {
        for (RTsizei i = 0; i < drawings; ++i) {
            const auto elements = elementsOf(i);
            if (elements.count == 0) continue;
            makePrimitive(c, mode, [&] {
                for (RTsizei k = 0; k < elements.count; ++k) arrays.make(elements[k]);
            });
        }
    } catch (...) {
        arrays.restoreAttributes();
        throw;
    }
    if (!c.lists().recording()) arrays.restoreAttributes();
}

void requireCounts(RTsizei drawings, const RTsizei* count) {
    for (RTsizei i = 0; i < drawings; ++i)
        if (count[i] < 0) throwError(ErrorCode::InvalidValue, "the number of elements is negative");
}

bool areAllZero(RTsizei drawings, const RTsizei* count) {
    return std::all_of(count, count + drawings, [](RTsizei n) { return n == 0; });
}

void drawRanges(Context& c, RTenum mode, RTsizei drawings, const RTint* first,
                const RTsizei* count) {
    requireCounts(drawings, count);
    for (RTsizei i = 0; i < drawings; ++i)
        if (first[i] < 0) throwError(ErrorCode::InvalidValue, "the first element is negative");
    if (areAllZero(drawings, count)) return;
    draw(c, mode, drawings, [&](RTsizei i) { return ElementRange{first[i], count[i]}; });
}

template <class T>
void drawIndexed(Context& c, RTenum mode, RTsizei drawings, const RTsizei* count,
                 const void* const* indices) {
    draw(c, mode, drawings, [&](RTsizei i) -> IndexedElements<T> {
        if (count[i] == 0) return {nullptr, 0};
        const ReadableMemory memory = readable(indices[i], c.arrays().elementBuffer);
        if (memory.bytes / sizeof(T) < uint64_t(count[i]))
            throwError(ErrorCode::InvalidOperation, "the buffer ends before the indices do");
        return {memory.data, count[i]};
    });
}

void drawIndexed(Context& c, RTenum mode, RTsizei drawings, const RTsizei* count, RTenum type,
                 const void* const* indices) {
    requireCounts(drawings, count);
    if (type != RT_UNSIGNED_BYTE && type != RT_UNSIGNED_SHORT && type != RT_UNSIGNED_INT)
        throwError(ErrorCode::InvalidEnum, "not a type of indices");
    if (areAllZero(drawings, count)) return;
    if (type == RT_UNSIGNED_BYTE)
        drawIndexed<RTubyte>(c, mode, drawings, count, indices);
    else if (type == RT_UNSIGNED_SHORT)
        drawIndexed<RTushort>(c, mode, drawings, count, indices);
    else
        drawIndexed<RTuint>(c, mode, drawings, count, indices);
}

void requireDrawings(RTsizei drawcount, const void* first, const void* second) {
    if (drawcount < 0) throwError(ErrorCode::InvalidValue, "drawcount is negative");
    if (drawcount == 0) return;
    requirePointer(first, "an array of the call");
    requirePointer(second, "an array of the call");
}

void rectangle(const char* function, RTdouble x1, RTdouble y1, RTdouble x2, RTdouble y2) noexcept {
    guarded(function, [&](Context& c) {
        requirePlaceToDraw(c, RT_POLYGON);
        requireSurface(c);
        makePrimitive(c, RT_POLYGON, [&] {
            ListRecording* const list = c.lists().recording();
            for (const glm::dvec4& corner : {glm::dvec4(x1, y1, 0, 1), glm::dvec4(x2, y1, 0, 1),
                                             glm::dvec4(x2, y2, 0, 1), glm::dvec4(x1, y2, 0, 1)})
                if (!list || list->vertex(corner)) c.recorder().vertex(corner);
        });
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
    guarded(__func__, [&](Context& c) {
        requirePlaceToDraw(c, mode);
        drawRanges(c, mode, 1, &first, &count);
    });
}
RTAPI void RTAPIENTRY rtMultiDrawArrays(RTenum mode, const RTint* first, const RTsizei* count,
                                        RTsizei drawcount) {
    guarded(__func__, [&](Context& c) {
        requirePlaceToDraw(c, mode);
        requireDrawings(drawcount, first, count);
        drawRanges(c, mode, drawcount, first, count);
    });
}

RTAPI void RTAPIENTRY rtDrawElements(RTenum mode, RTsizei count, RTenum type,
                                     const void* indices) {
    guarded(__func__, [&](Context& c) {
        requirePlaceToDraw(c, mode);
        drawIndexed(c, mode, 1, &count, type, &indices);
    });
}
RTAPI void RTAPIENTRY rtDrawRangeElements(RTenum mode, RTuint start, RTuint end, RTsizei count,
                                          RTenum type, const void* indices) {
    guarded(__func__, [&](Context& c) {
        if (end < start) throwError(ErrorCode::InvalidValue, "the range ends before it starts");
        requirePlaceToDraw(c, mode);
        drawIndexed(c, mode, 1, &count, type, &indices);
    });
}
RTAPI void RTAPIENTRY rtMultiDrawElements(RTenum mode, const RTsizei* count, RTenum type,
                                          const void* const* indices, RTsizei drawcount) {
    guarded(__func__, [&](Context& c) {
        requirePlaceToDraw(c, mode);
        requireDrawings(drawcount, count, indices);
        drawIndexed(c, mode, drawcount, count, type, indices);
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

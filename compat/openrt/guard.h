// SPDX-License-Identifier: MIT
// The exception wall: every call of the C interface is a guard around one line or a few.
#pragma once

#include <string>

#include "compat/recorder/context.h"
#include "libsmart/base/error.h"
#include "openrt/types.h"

namespace smart::compat {

RTenum errorToken(ErrorCode code) noexcept;

/// Records the exception being handled in the calling thread's context, if it has one.
void report(const char* function) noexcept;

/// What a call that needs a context does where none is current: nothing, except that the frame
/// whose callback makes it keeps that as its error.
void withoutContext(const char* function) noexcept;

/// Throws InvalidOperation with the text the first time that it is called for `what`.
void refuseOnce(Context& context, const std::string& what, const std::string& text);
/// Records that a function of the interface is not part of this release, once for each function.
void refused(const char* function) noexcept;
/// The same of a function that is legal between begin and end.
void refusedInPrimitive(const char* function) noexcept;

[[noreturn]] void throwError(ErrorCode code, const std::string& text);
/// Throws InvalidValue for nullptr.
void requirePointer(const void* pointer, const char* name);

/// Keeps a copy of the body in the list under compilation; whether the call is also to be made.
template <class Body>
bool keepIn(ListRecording& list, ListOp op, const char* function, uint64_t attribute,
            const Body& body) noexcept {
    try {
        return list.call(op, {function, body, attribute});
    } catch (...) {
        return list.lose();
    }
}

/// Runs body(context), unless no context is current.
template <class Body>
void guarded(const char* function, Body&& body) noexcept {
    Context* const context = currentContext();
    if (!context) return withoutContext(function);
    try {
        body(*context);
    } catch (...) {
        report(function);
    }
}

/// For the calls that display lists record. The body holds all that it needs by value (also what
/// the call's pointers point to), as a list runs it again later; `function` lives forever.
template <class Body>
void recordedAs(ListOp op, const char* function, uint64_t attribute, Body&& body) noexcept {
    guarded(function, [&](Context& c) {
        if (ListRecording* const list = c.lists().recording())
            if (!keepIn(*list, op, function, attribute, body)) return;
        body(c);
    });
}
template <class Body>
void recorded(const char* function, Body body) noexcept {
    recordedAs(ListOp::Call, function, 0, body);
}

/// For calls that are legal between begin and end and set what vertices latch. `attribute`: which
/// part of the current values; calls with the same key replace each other as a whole.
template <class Body>
void recordedAttribute(const char* function, uint64_t attribute, Body body) noexcept {
    recordedAs(ListOp::Attribute, function, attribute, body);
}

/// The same as guarded() for calls with a result.
template <class Result, class Body>
Result guardedOr(Result failure, const char* function, Body&& body) noexcept {
    Context* const context = currentContext();
    if (!context) return withoutContext(function), failure;
    try {
        return body(*context);
    } catch (...) {
        report(function);
    }
    return failure;
}

} // namespace smart::compat

// SPDX-License-Identifier: MIT
#include "compat/openrt/guard.h"

#include <exception>
#include <memory>
#include <new>
#include <stdexcept>

#include "compat/openrt/frame_callback.h"

namespace smart::compat {
namespace {

void refuseFunction(Context& context, const char* function) {
    refuseOnce(context, function, std::string(function) + " is not part of this release");
}

} // namespace

RTenum errorToken(ErrorCode code) noexcept {
    switch (code) {
    case ErrorCode::InvalidEnum: return RT_INVALID_ENUM;
    case ErrorCode::InvalidValue: return RT_INVALID_VALUE;
    case ErrorCode::InvalidOperation: return RT_INVALID_OPERATION;
    case ErrorCode::StackOverflow: return RT_STACK_OVERFLOW;
    case ErrorCode::StackUnderflow: return RT_STACK_UNDERFLOW;
    case ErrorCode::OutOfMemory: return RT_OUT_OF_MEMORY;
    }
    return RT_INVALID_OPERATION;
}

void report(const char* function) noexcept {
    // The listener may end the context; it lives until the error is told.
    const std::shared_ptr<Context> context = currentContextShared();
    if (!context) return;
    ErrorState& errors = context->errors();
    try {
        throw;
    } catch (const Error& error) {
        errors.raise(error.code(), function, error.what());
    } catch (const std::bad_alloc&) {
        errors.raise(ErrorCode::OutOfMemory, function, "out of memory");
    } catch (const std::length_error&) {
        errors.raise(ErrorCode::OutOfMemory, function, "larger than memory can be");
    } catch (const std::exception& error) {
        errors.raise(ErrorCode::InvalidOperation, function, error.what());
    } catch (...) {
        errors.raise(ErrorCode::InvalidOperation, function, "unknown exception");
    }
}

void withoutContext(const char* function) noexcept {
    refusedInCallback(function);
}

void refused(const char* function) noexcept {
    guarded(function, [&](Context& c) {
        c.recorder().requireOutsidePrimitive();
        refuseFunction(c, function);
    });
}

void refusedInPrimitive(const char* function) noexcept {
    guarded(function, [&](Context& c) { refuseFunction(c, function); });
}

void refuseOnce(Context& context, const std::string& what, const std::string& text) {
    if (context.isFirstRefusal(what)) throwError(ErrorCode::InvalidOperation, text);
}

void throwError(ErrorCode code, const std::string& text) {
    throw Error(code, text);
}

void requirePointer(const void* pointer, const char* name) {
    if (!pointer) throwError(ErrorCode::InvalidValue, std::string(name) + " is NULL");
}

} // namespace smart::compat

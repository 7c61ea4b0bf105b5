// SPDX-License-Identifier: MIT
// Calls of functions with parameters from an array.
#pragma once

#include <cstddef>
#include <utility>

#include "compat/stream/call_table.h"
#include "openrt/types.h"

namespace smart::compat {

using Invocation = void (*)(const CallValue* arguments, CallValue& result);

template <class Result, class... Parameters, std::size_t... i>
void invokeWith(Result(RTAPIENTRY* function)(Parameters...), const CallValue* arguments,
                CallValue& result, std::index_sequence<i...>) {
    (void)arguments;
    if constexpr (std::is_void_v<Result>) {
        function(arguments[i].template as<Parameters>()...);
        result = {};
    } else {
        result = CallValue(function(arguments[i].template as<Parameters>()...));
    }
}

template <class Result, class... Parameters>
void invokeWith(Result(RTAPIENTRY* function)(Parameters...), const CallValue* arguments,
                CallValue& result) {
    invokeWith(function, arguments, result, std::index_sequence_for<Parameters...>());
}

template <auto function>
void invoke(const CallValue* arguments, CallValue& result) {
    invokeWith(function, arguments, result);
}

} // namespace smart::compat

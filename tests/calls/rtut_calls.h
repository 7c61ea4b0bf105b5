// SPDX-License-Identifier: MIT
#pragma once

#include "openrt/rtut.h"
#include "tests/calls/values.h"

namespace openrt::test {

/// All functions of librtut; generate_calls.py writes the table.
const std::vector<ApiFunction>& rtutFunctions();

/// A callback of any signature, which takes no notice of its arguments, or none.
struct Callback {
    bool isGiven;

    template <class... Parameters>
    using Pointer = void (*)(Parameters...);
    template <class... Parameters>
    operator Pointer<Parameters...>() const {
        return isGiven ? Pointer<Parameters...>([](Parameters...) { ++callbacks; }) : nullptr;
    }
};

} // namespace openrt::test

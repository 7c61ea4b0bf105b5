// SPDX-License-Identifier: MIT
// Which arguments a function is called with.
#pragma once

#include <string>
#include <vector>

#include "tests/calls/values.h"

namespace openrt::test {

struct Variant {
    std::string what;
    std::vector<Value> arguments;
};

/// The legal call, then one for each other value of each parameter: two of its kind, or with
/// `whole` all, but of OpenRT's tokens, which are many, twelve.
std::vector<Variant> variantsOf(const ApiFunction& function, bool whole);

/// One for each of OpenRT's tokens, and for two numbers that are none, in each parameter that takes
/// one.
std::vector<Variant> tokenVariantsOf(const ApiFunction& function);

/// One for each pair of parameters and each two of four values that they have but the legal one.
std::vector<Variant> pairVariantsOf(const ApiFunction& function);

} // namespace openrt::test

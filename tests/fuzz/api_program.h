// SPDX-License-Identifier: MIT
// How inputs name functions of the library and their arguments: a function by two bytes (its hash,
// or the next one in the order of hashes), an argument by a byte, below kLegal the legal value,
// otherwise one of those of its kind.
#pragma once

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/calls/values.h"
#include "tests/fuzz/input.h"

namespace openrt::test {

inline constexpr int kMaxCalls = 64;
inline constexpr uint8_t kLegal = 112;

inline uint16_t hash(std::string_view name) {
    uint32_t h = 2166136261u;
    for (const char c : name) h = (h ^ uint8_t(c)) * 16777619u;
    return uint16_t(h ^ h >> 16);
}

inline const ApiFunction& functionOf(uint16_t wanted) {
    using Hashed = std::pair<uint16_t, const ApiFunction*>;
    static const std::vector<Hashed> byHash = [] {
        std::vector<Hashed> all;
        for (const ApiFunction& function : apiFunctions())
            all.push_back({hash(function.name), &function});
        std::sort(all.begin(), all.end());
        return all;
    }();
    const auto found = std::lower_bound(byHash.begin(), byHash.end(), Hashed(wanted, nullptr));
    return *(found == byHash.end() ? byHash.front() : *found).second;
}

/// What a byte of the input, and others where it says so, stands for.
inline Value argumentOf(const ApiParameter& parameter, uint8_t choice, Input& input) {
    if (choice < kLegal) return parameter.legal;
    const std::vector<Value>& values = valuesOf(parameter.kind);
    if (parameter.kind == Kind::Token) return values[input.below(uint32_t(values.size()))];
    if (parameter.kind == Kind::Number && choice >= 240) return Value::of(double(input.number()));
    return values[choice % values.size()];
}

} // namespace openrt::test

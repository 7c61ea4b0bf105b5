// SPDX-License-Identifier: MIT
// Programs of up to 64 calls. A call is two bytes that name the function (its hash, or the next one
// in order of hashes), and for each argument a byte: below 112 the legal value, otherwise one of
// those of its kind. Every function of the headers takes part.
#include <algorithm>
#include <string_view>

#include "tests/calls/api_calls.h"
#include "tests/fuzz/input.h"

namespace openrt::test {
namespace {

constexpr int kMaxCalls = 64;
constexpr uint8_t kLegal = 112;

uint16_t hash(std::string_view name) {
    uint32_t h = 2166136261u;
    for (const char c : name) h = (h ^ uint8_t(c)) * 16777619u;
    return uint16_t(h ^ h >> 16);
}

using Hashed = std::pair<uint16_t, const ApiFunction*>;
const std::vector<Hashed>& byHash() {
    static const std::vector<Hashed> sorted = [] {
        std::vector<Hashed> all;
        for (const ApiFunction& function : apiFunctions())
            all.push_back({hash(function.name), &function});
        std::sort(all.begin(), all.end());
        return all;
    }();
    return sorted;
}

const ApiFunction& functionOf(uint16_t wanted) {
    const auto found = std::lower_bound(byHash().begin(), byHash().end(), Hashed(wanted, nullptr));
    return *(found == byHash().end() ? byHash().front() : *found).second;
}

Value argumentOf(const ApiParameter& parameter, Input& input) {
    const uint8_t choice = input.byte();
    if (choice < kLegal) return parameter.legal;
    const std::vector<Value>& values = valuesOf(parameter.kind);
    if (parameter.kind == Kind::Token) return values[input.below(uint32_t(values.size()))];
    if (parameter.kind == Kind::Number && choice >= 240) return Value::of(double(input.number()));
    return values[choice % values.size()];
}

void run(Input& input) {
    rtInit(nullptr, nullptr);
    prepareContext();
    for (int i = 0; i < kMaxCalls && !input.atEnd(); ++i) {
        const ApiFunction& function = functionOf(input.word());
        Value arguments[24];
        int count = 0;
        for (const ApiParameter& parameter : function.parameters)
            arguments[count++] = argumentOf(parameter, input);
        function.call(arguments);
    }
    forgetContext();
    rtExit();
}

} // namespace
} // namespace openrt::test

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
    openrt::test::Input input(data, size);
    openrt::test::run(input);
    return 0;
}

// SPDX-License-Identifier: MIT
#include "tests/calls/variants.h"

#include <algorithm>
#include <cstring>

namespace openrt::test {
namespace {

std::vector<Value> legalOf(const ApiFunction& function) {
    std::vector<Value> legal;
    for (const ApiParameter& parameter : function.parameters) legal.push_back(parameter.legal);
    return legal;
}

std::string name(const ApiParameter& parameter, std::size_t at) {
    return std::string(parameter.name) + " " + std::to_string(at);
}

} // namespace

std::vector<Variant> variantsOf(const ApiFunction& function, bool whole) {
    const std::vector<Value> legal = legalOf(function);
    std::vector<Variant> variants = {{"legal", legal}};
    unsigned turn = unsigned(std::strlen(function.name));
    for (std::size_t i = 0; i < legal.size(); ++i) {
        const std::vector<Value>& values = valuesOf(function.parameters[i].kind);
        const bool some = !whole || function.parameters[i].kind == Kind::Token;
        const std::size_t most = !whole ? 2 : some ? 12 : values.size();
        for (std::size_t k = 0; k < std::min(values.size(), most); ++k) {
            std::size_t at = k;
            if (some) at = k == 0 ? values.size() - 1 : ++turn * 31 % values.size();
            Variant variant = {name(function.parameters[i], at), legal};
            variant.arguments[i] = values[at];
            variants.push_back(std::move(variant));
        }
    }
    return variants;
}

std::vector<Variant> tokenVariantsOf(const ApiFunction& function) {
    std::vector<Variant> variants;
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
        if (function.parameters[i].kind != Kind::Token) continue;
        const std::vector<Value>& values = valuesOf(Kind::Token);
        for (std::size_t at = 0; at < values.size(); ++at) {
            Variant variant = {name(function.parameters[i], at), legalOf(function)};
            variant.arguments[i] = values[at];
            variants.push_back(std::move(variant));
        }
    }
    return variants;
}

std::vector<Variant> pairVariantsOf(const ApiFunction& function) {
    constexpr std::size_t kMost = 4;
    // The last ones of a kind are those most wrong.
    const auto values = [&](std::size_t i) -> const std::vector<Value>& {
        return valuesOf(function.parameters[i].kind);
    };
    const auto first = [&](std::size_t i) {
        return values(i).size() - std::min(values(i).size(), kMost);
    };
    std::vector<Variant> variants;
    for (std::size_t i = 0; i < function.parameters.size(); ++i)
        for (std::size_t j = i + 1; j < function.parameters.size(); ++j)
            for (std::size_t a = first(i); a < values(i).size(); ++a)
                for (std::size_t b = first(j); b < values(j).size(); ++b) {
                    Variant variant = {
                        name(function.parameters[i], a) + ", " + name(function.parameters[j], b),
                        legalOf(function)};
                    variant.arguments[i] = values(i)[a];
                    variant.arguments[j] = values(j)[b];
                    variants.push_back(std::move(variant));
                }
    return variants;
}

} // namespace openrt::test

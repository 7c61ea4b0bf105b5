// SPDX-License-Identifier: MIT
// Compiled with BITS_FUNCTION naming the function, and `smart` renamed so that the inline
// functions of each compilation stay its own.
#include "tests/libsmart/base/transcendental_bits.h"

#include <bit>

#include "libsmart/base/transcendental.h"

uint64_t BITS_FUNCTION() {
    uint64_t digest = 0xcbf29ce484222325ull, random = 1;
    const auto add = [&](float value) {
        digest = (digest ^ std::bit_cast<uint32_t>(value)) * 0x100000001b3ull;
    };
    const auto addDouble = [&](double value) {
        digest = (digest ^ std::bit_cast<uint64_t>(value)) * 0x100000001b3ull;
    };
    const auto next = [&] {
        random = random * 6364136223846793005ull + 1442695040888963407ull;
        return float(double(int64_t(random)) * 0x1p-63);
    };
    namespace m = smart::math;
    for (int i = 0; i < 200000; ++i) {
        const float x = next(), y = next();
        add(m::exp(x * 80));
        add(m::log(x * x + 1e-20f));
        add(m::pow(x * x + 1e-6f, y * 6));
        add(m::sin(x * 1e4f));
        add(m::cos(x * 1e9f));
        add(m::atan2(x, y));
        add(m::asin(x));
        add(m::encodeSrgb(x));
        add(m::decodeSrgb(x));
        // Before the rounding to float, where every difference shows.
        addDouble(m::detail::expOf(double(x) * 80));
        addDouble(m::detail::logOf(double(x) * x + 1e-20));
        addDouble(m::detail::atan2Of(x, y));
    }
    return digest;
}

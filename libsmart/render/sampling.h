// SPDX-License-Identifier: MIT
// Sample positions and random numbers that depend on (pixel, sample, seed) and nothing else.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

namespace smart {

/// Finalizer of SplitMix64: Steele, Lea, Flood, "Fast splittable pseudorandom number generators",
/// OOPSLA 2014.
constexpr uint64_t mixBits(uint64_t z) {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
}

/// Of 32 random bits the upper 24, as a number in [0, 1).
constexpr float unitFloat(uint32_t bits) {
    return float(bits >> 8) * 0x1p-24f;
}

/// Position of the i-th of n samples in a pixel's square: the centre for one sample, otherwise
/// the additive recurrence of the plane with the least gaps (Roberts, "The unreasonable
/// effectiveness of quasirandom sequences", 2018), shifted by a hash of the pixel and the seed.
constexpr glm::vec2 samplePosition(uint32_t x, uint32_t y, uint32_t seed, uint32_t i, uint32_t n) {
    if (n <= 1) return {0.5f, 0.5f};
    const uint64_t shift = mixBits(mixBits((uint64_t(y) << 32 | x) + 0x9E3779B97F4A7C15u) + seed);
    return {unitFloat(uint32_t(shift) + i * 0xC13FA9A9u),
            unitFloat(uint32_t(shift >> 32) + i * 0x91E10DA5u)};
}

/// The random numbers of one sample of a pixel: SplitMix64. Seeded when the first is drawn, since
/// most samples draw none.
class RandomStream {
public:
    constexpr RandomStream() = default;
    constexpr RandomStream(uint32_t x, uint32_t y, uint32_t sample, uint32_t seed)
        : state_(uint64_t(y) << 32 | x), key_(uint64_t(seed) << 32 | sample), seeded_(false) {}

    constexpr float next() {
        if (!seeded_) {
            state_ = mixBits(mixBits(state_) ^ key_);
            seeded_ = true;
        }
        state_ += 0x9E3779B97F4A7C15u;
        return unitFloat(uint32_t(mixBits(state_) >> 32));
    }

private:
    uint64_t state_ = 0; ///< the pixel before it is seeded
    uint64_t key_ = 0;
    bool seeded_ = true;
};

/// A sample of a pixel while it is made: what all rays that belong to it share.
struct PixelSample {
    uint32_t x = 0, y = 0, number = 0;
    RandomStream random;
    bool fault = false; ///< a shader failed

    constexpr PixelSample() = default;
    constexpr PixelSample(uint32_t column, uint32_t row, uint32_t sample, uint32_t seed)
        : x(column), y(row), number(sample), random(column, row, sample, seed) {}
};

} // namespace smart

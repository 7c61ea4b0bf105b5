// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace smart {

class ShaderObject;

/// Which surface shaders ask for the shadows of lights, going by what they did last. A wrong
/// answer costs time, nothing else: the addresses are compared, never followed.
class ShadowGuess {
public:
    bool expects(const ShaderObject* surface) const { return seen_[placeOf(surface)] == surface; }
    void learn(const ShaderObject* surface, bool asked) {
        const ShaderObject*& seen = seen_[placeOf(surface)];
        if (asked)
            seen = surface;
        else if (seen == surface)
            seen = nullptr;
    }

private:
    static constexpr std::size_t kPlaces = 16;
    static std::size_t placeOf(const ShaderObject* surface) {
        return reinterpret_cast<std::uintptr_t>(surface) / 64 % kPlaces;
    }

    std::array<const ShaderObject*, kPlaces> seen_{};
};

} // namespace smart

// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <type_traits>

#include "compat/recorder/context.h"
#include "openrt/types.h"

namespace smart::compat {

inline constexpr uint32_t kMaxViewport = 1u << 30; ///< RT_MAX_VIEWPORT_DIMS

/// A value of state as rtGet finds it, and how it converts to the type that is asked for.
struct StateValue {
    int count = 1;
    double values[16] = {}; ///< whole numbers are exact: none reaches 2^53
    bool normalised = false; ///< as integers, -1..1 maps to the whole range

    static StateValue list(std::initializer_list<double> numbers) {
        StateValue value;
        value.count = int(numbers.size());
        std::copy(numbers.begin(), numbers.end(), value.values);
        return value;
    }
    static StateValue number(double n) { return list({n}); }
    /// Of GLM's.
    template <class Vector>
    static StateValue vector(const Vector& v, bool normalised) {
        StateValue value;
        value.count = v.length();
        for (int k = 0; k < value.count; ++k) value.values[k] = double(v[k]);
        value.normalised = normalised;
        return value;
    }

    template <class T>
    T as(int i) const {
        const double value = values[i];
        if constexpr (std::is_same_v<T, RTboolean>) {
            return value != 0 ? 1 : 0;
        } else if constexpr (std::is_floating_point_v<T>) {
            return T(value);
        } else {
            // OpenGL 1.5, section 6.1.2.
            const double number =
                normalised ? (4294967295.0 * value - 1.0) / 2.0 : std::floor(value + 0.5);
            if (std::isnan(number)) return 0;
            if (number >= 0x1p63) return std::numeric_limits<T>::max();
            if (number <= -0x1p63) return std::numeric_limits<T>::min();
            const auto whole = int64_t(std::floor(number + 0.5));
            if (whole > int64_t(std::numeric_limits<T>::max())) return std::numeric_limits<T>::max();
            if (whole < int64_t(std::numeric_limits<T>::min())) return std::numeric_limits<T>::min();
            return T(whole);
        }
    }
};

/// Throws Error for a name that is none, and between begin and end.
StateValue stateValue(Context& context, RTenum name);

} // namespace smart::compat

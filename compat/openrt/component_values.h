// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <type_traits>

namespace smart::compat {

/// A component of a colour or normal: OpenGL 1.5, table 2.6.
template <class T>
float normalised(T value) {
    if constexpr (std::is_floating_point_v<T>)
        return float(value);
    else if constexpr (std::is_unsigned_v<T>)
        return float(double(value) / std::numeric_limits<T>::max());
    else
        return float((2.0 * value + 1.0) / std::numeric_limits<std::make_unsigned_t<T>>::max());
}

} // namespace smart::compat

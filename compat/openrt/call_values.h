// SPDX-License-Identifier: MIT
// The values that a call such as rtLightfv or rtFogi gives, of whatever type.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/vec4.hpp>
#include <limits>
#include <type_traits>

#include "compat/openrt/guard.h"
#include "compat/openrt/state_values.h"

namespace smart::compat {

/// Throws InvalidValue for what is not a number.
inline void requireNumber(double value) {
    if (std::isnan(value)) throwError(ErrorCode::InvalidValue, "a value is not a number");
}

/// Copied when the call is made, as display lists keep it. Functions that take a value out throw
/// Error where the call did not give it.
class CallValues {
public:
    static constexpr int kMax = 4;

    /// Of a call with one value.
    template <class T>
    static CallValues one(T value) {
        CallValues values;
        values.integers_ = std::is_integral_v<T>;
        values.values_[0] = double(value);
        values.count_ = 1;
        return values;
    }
    /// Of a call with an array, of which n values are read. The array of an unknown name (n = 0)
    /// is not looked at.
    template <class T>
    static CallValues array(const T* params, int n) {
        CallValues values;
        values.integers_ = std::is_integral_v<T>;
        values.isArray_ = true;
        values.isNull_ = !params;
        values.count_ = params ? n : 0;
        for (int i = 0; i < values.count_; ++i) values.values_[i] = double(params[i]);
        return values;
    }

    float number() const { return requireNumbers(1), float(values_[0]); }
    bool isTrue() const { return requireNumbers(1), values_[0] != 0; }
    /// To the nearest whole number; what is out of range is a token that does not exist.
    RTenum token() const {
        require(1);
        if (!(std::fabs(values_[0]) < 0x1p30)) return RT_INVALID;
        return RTenum(RTint(std::floor(values_[0] + 0.5)));
    }
    glm::vec4 vector() const { return glm::vec4(doubles()); }
    glm::dvec4 doubles() const {
        requireNumbers(4);
        return {values_[0], values_[1], values_[2], values_[3]};
    }
    glm::vec3 direction() const {
        requireNumbers(3);
        return {float(values_[0]), float(values_[1]), float(values_[2])};
    }
    /// Integers are mapped from their whole range to -1..1.
    glm::vec4 color() const {
        requireNumbers(4);
        glm::vec4 color;
        for (int k = 0; k < 4; ++k)
            color[k] = integers_ ? float((2.0 * values_[k] + 1.0) / 4294967295.0)
                                 : float(values_[k]);
        return color;
    }

private:
    void require(int n) const {
        if (isNull_) throwError(ErrorCode::InvalidValue, "params is NULL");
        if (!isArray_ && n > 1)
            throwError(ErrorCode::InvalidEnum, "this is set by a call that takes an array");
    }
    void requireNumbers(int n) const {
        require(n);
        for (int i = 0; i < n; ++i) requireNumber(values_[i]);
    }

    double values_[kMax] = {};
    int count_ = 0;
    bool integers_ = false, isArray_ = false, isNull_ = false;
};

/// Writes a value of state to where a query wants it.
template <class T>
void give(const StateValue& value, T* params) {
    requirePointer(params, "params");
    for (int i = 0; i < value.count; ++i) params[i] = value.as<T>(i);
}

} // namespace smart::compat

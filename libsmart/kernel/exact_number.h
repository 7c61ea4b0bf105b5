// SPDX-License-Identifier: MIT
// Numbers of the form integer * 2^(32 * n), added, subtracted and multiplied without any rounding.
#pragma once

#include <cstdint>

namespace smart {

/// Sign and magnitude in base 2^32, without zero digits at either end. Exact while no more than
/// kDigits digits lie between the first and the last, which numbers made of floats never need;
/// beyond that the lowest digits are cut off.
class ExactNumber {
public:
    static constexpr int kDigits = 192;

    ExactNumber() {}
    ExactNumber(double value); ///< finite
    ExactNumber(const ExactNumber& other) { *this = other; }
    ExactNumber& operator=(const ExactNumber& other);

    int sign() const { return size_ == 0 ? 0 : negative_ ? -1 : 1; }
    void negate() { negative_ = !negative_; }
    /// fraction * 2^exponent within a relative error of 2^-50; 0.5 <= |fraction| <= 1, or all 0.
    double fraction(int& exponent) const;

    friend ExactNumber operator+(const ExactNumber& a, const ExactNumber& b) {
        return sum(a, b, false);
    }
    friend ExactNumber operator-(const ExactNumber& a, const ExactNumber& b) {
        return sum(a, b, true);
    }
    friend ExactNumber operator*(const ExactNumber& a, const ExactNumber& b);

private:
    static ExactNumber sum(const ExactNumber& a, const ExactNumber& b, bool subtract);
    uint32_t digit(int position) const;
    void trim();

    int low_ = 0;  ///< position of digit_[0]
    int size_ = 0; ///< 0: the number is zero, and nothing else here holds
    bool negative_ = false;
    uint32_t digit_[kDigits]; ///< lowest first; only size_ of them hold
};

} // namespace smart

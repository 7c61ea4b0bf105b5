// SPDX-License-Identifier: MIT
#include "libsmart/kernel/exact_number.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace smart {

ExactNumber::ExactNumber(double value) : size_(0) {
    uint64_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    const int biased = int(bits >> 52 & 2047);
    uint64_t mantissa = bits & ((uint64_t(1) << 52) - 1);
    if (biased) mantissa |= uint64_t(1) << 52;
    if (mantissa == 0) return;
    // value = mantissa * 2^(place - 1088), where 1088 is a multiple of 32.
    const int place = std::max(biased, 1) + 13;
    const int shift = place % 32;
    const uint64_t lower = mantissa << shift;
    low_ = place / 32 - 34;
    size_ = 3;
    negative_ = bits >> 63 != 0;
    digit_[0] = uint32_t(lower);
    digit_[1] = uint32_t(lower >> 32);
    digit_[2] = shift ? uint32_t(mantissa >> (64 - shift)) : 0;
    trim();
}

ExactNumber& ExactNumber::operator=(const ExactNumber& other) {
    size_ = other.size_;
    if (size_ == 0) return *this;
    low_ = other.low_;
    negative_ = other.negative_;
    std::memmove(digit_, other.digit_, std::size_t(size_) * sizeof *digit_);
    return *this;
}

uint32_t ExactNumber::digit(int position) const {
    const int i = position - low_;
    return i < 0 || i >= size_ ? 0 : digit_[i];
}

void ExactNumber::trim() {
    while (size_ > 0 && digit_[size_ - 1] == 0) --size_;
    int zeros = 0;
    while (zeros < size_ && digit_[zeros] == 0) ++zeros;
    if (zeros == 0) return;
    size_ -= zeros;
    low_ += zeros;
    std::memmove(digit_, digit_ + zeros, std::size_t(size_) * sizeof *digit_);
}

double ExactNumber::fraction(int& exponent) const {
    exponent = 0;
    if (size_ == 0) return 0;
    const int top = low_ + size_ - 1;
    const double head = double(digit(top)) * 0x1p64 + double(digit(top - 1)) * 0x1p32 +
                        double(digit(top - 2));
    const double result = std::frexp(head, &exponent);
    exponent += 32 * (top - 2);
    return negative_ ? -result : result;
}

ExactNumber ExactNumber::sum(const ExactNumber& a, const ExactNumber& b, bool subtract) {
    if (b.size_ == 0) return a;
    const bool bNegative = b.negative_ != subtract;
    ExactNumber result;
    if (a.size_ == 0) {
        result = b;
        result.negative_ = bNegative;
        return result;
    }
    const int high = std::max(a.low_ + a.size_, b.low_ + b.size_) + 1;
    const int low = std::max(std::min(a.low_, b.low_), high - kDigits);
    result.low_ = low;
    result.size_ = high - low;
    int64_t carry = 0;
    for (int i = 0; i < result.size_; ++i) {
        const int64_t fromA = a.digit(low + i), fromB = b.digit(low + i);
        carry += (a.negative_ ? -fromA : fromA) + (bNegative ? -fromB : fromB);
        result.digit_[i] = uint32_t(carry);
        carry >>= 32;
    }
    result.negative_ = carry < 0;
    if (result.negative_) { // two's complement to magnitude
        uint64_t up = 1;
        for (int i = 0; i < result.size_; ++i) {
            up += ~result.digit_[i];
            result.digit_[i] = uint32_t(up);
            up >>= 32;
        }
    }
    result.trim();
    return result;
}

ExactNumber operator*(const ExactNumber& a, const ExactNumber& b) {
    ExactNumber result;
    if (a.size_ == 0 || b.size_ == 0) return result;
    uint32_t product[2 * ExactNumber::kDigits];
    const int size = a.size_ + b.size_;
    std::fill(product, product + size, 0u);
    for (int i = 0; i < a.size_; ++i) {
        uint64_t carry = 0;
        for (int j = 0; j < b.size_; ++j) {
            carry += uint64_t(a.digit_[i]) * b.digit_[j] + product[i + j];
            product[i + j] = uint32_t(carry);
            carry >>= 32;
        }
        product[i + b.size_] = uint32_t(carry);
    }
    const int cut = std::max(0, size - ExactNumber::kDigits);
    result.low_ = a.low_ + b.low_ + cut;
    result.size_ = size - cut;
    result.negative_ = a.negative_ != b.negative_;
    std::copy(product + cut, product + size, result.digit_);
    result.trim();
    return result;
}

} // namespace smart

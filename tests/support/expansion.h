// SPDX-License-Identifier: MIT
// Exact sums of doubles. Shewchuk, "Adaptive precision floating-point arithmetic and fast robust
// geometric predicates", Discrete & Computational Geometry 18, 1997.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace smart::test {

/// A number as an unevaluated sum of doubles that do not overlap, the largest last. Sums,
/// differences and products are exact as long as no part leaves the range of double: products of
/// up to six differences of floats never do. Rounding must be to nearest.
class Expansion {
public:
    Expansion() = default;
    explicit Expansion(double x) { append(x); }
    Expansion(const Expansion& other) { *this = other; }
    Expansion& operator=(const Expansion& other) { // the parts in use only
        size_ = other.size_;
        std::copy_n(other.part_, size_, part_);
        return *this;
    }

    static Expansion difference(double a, double b) {
        Expansion result;
        double low;
        const double high = twoSum(a, -b, low);
        result.append(low);
        result.append(high);
        return result;
    }

    int sign() const {
        if (size_ == 0) return 0;
        return part_[size_ - 1] > 0 ? 1 : -1;
    }
    /// Nearly correctly rounded.
    double value() const {
        double sum = 0;
        for (int i = 0; i < size_; ++i) sum += part_[i];
        return sum;
    }

    Expansion operator-() const {
        Expansion result = *this;
        for (int i = 0; i < size_; ++i) result.part_[i] = -result.part_[i];
        return result;
    }
    friend Expansion operator+(const Expansion& a, const Expansion& b) {
        Expansion result = a;
        for (int i = 0; i < b.size_; ++i) result.grow(b.part_[i]);
        result.compress();
        return result;
    }
    friend Expansion operator-(const Expansion& a, const Expansion& b) { return a + -b; }
    friend Expansion operator*(const Expansion& a, const Expansion& b) {
        Expansion result;
        for (int i = 0; i < a.size_; ++i) {
            for (int j = 0; j < b.size_; ++j) {
                const double high = a.part_[i] * b.part_[j];
                result.grow(std::fma(a.part_[i], b.part_[j], -high));
                result.grow(high);
            }
            result.compress();
        }
        return result;
    }

private:
    // Compressed, 1700 bits (the product of six differences of floats) are 33 doubles; a row of a
    // product adds at most twice as many before it is compressed.
    static constexpr int kCapacity = 112;

    static double twoSum(double a, double b, double& low) {
        const double sum = a + b;
        const double other = sum - a;
        low = (a - (sum - other)) + (b - other);
        return sum;
    }
    static double fastTwoSum(double a, double b, double& low) {
        const double sum = a + b;
        low = b - (sum - a);
        return sum;
    }
    void append(double x) {
        if (x == 0) return;
        if (size_ == kCapacity) std::abort();
        part_[size_++] = x;
    }
    void grow(double x) {
        if (x == 0) return;
        const int count = size_;
        size_ = 0;
        for (int i = 0; i < count; ++i) {
            double low;
            x = twoSum(x, part_[i], low);
            append(low);
        }
        append(x);
    }
    void compress() {
        if (size_ < 2) return;
        int bottom = size_ - 1;
        double sum = part_[bottom], low;
        for (int i = bottom - 1; i >= 0; --i) {
            sum = fastTwoSum(sum, part_[i], low);
            if (low == 0) continue;
            part_[bottom--] = sum;
            sum = low;
        }
        part_[bottom] = sum;
        const int count = size_;
        size_ = 0;
        sum = part_[bottom];
        for (int i = bottom + 1; i < count; ++i) {
            sum = fastTwoSum(part_[i], sum, low);
            append(low);
        }
        append(sum);
    }

    double part_[kCapacity];
    int size_ = 0;
};

} // namespace smart::test

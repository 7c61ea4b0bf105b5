// SPDX-License-Identifier: MIT
#include "libsmart/kernel/affine_inverse.h"

#include <algorithm>
#include <cmath>

namespace smart {
namespace {

/// A determinant of no more of the sum of its terms' sizes: within the rounding errors of a product
/// of two matrices and of the determinant itself, nothing tells the matrix from a singular one.
constexpr double kSingular = 0x1p-49;

} // namespace

bool isUsual(const AffineColumns& matrix) {
    for (int column = 0; column < 3; ++column) {
        for (const double entry : matrix[column]) {
            const double size = std::fabs(entry);
            if (size != 0 && !(size > 0x1p-100 && size < 0x1p100)) return false;
        }
    }
    return true;
}

bool isInvertible(const AffineColumns& m) {
    AffineRows inverse;
    if (!isUsual(m)) return invertAffine(m, inverse);
    double determinant = 0, magnitude = 0;
    for (int column = 0; column < 3; ++column) {
        const double* const a = m[(column + 1) % 3];
        const double* const b = m[(column + 2) % 3];
        const double left = a[1] * b[2], right = b[1] * a[2];
        determinant += m[column][0] * (left - right);
        magnitude += std::fabs(m[column][0]) * (std::fabs(left) + std::fabs(right));
    }
    if (!(std::fabs(determinant) > kSingular * magnitude)) return false;
    // The inverse's entries are below 2^600 then.
    const double farthest =
        std::max({std::fabs(m[3][0]), std::fabs(m[3][1]), std::fabs(m[3][2])});
    if (farthest < 0x1p300 && std::isfinite(m[3][0] + m[3][1] + m[3][2])) return true;
    invertUsual(m, inverse);
    return std::isfinite(inverse[0][3]) && std::isfinite(inverse[1][3]) &&
           std::isfinite(inverse[2][3]);
}

bool invertAffine(const AffineColumns& matrix, AffineRows& inverse) {
    for (const auto& column : matrix) {
        for (const double entry : column) {
            if (!std::isfinite(entry)) return false;
        }
    }
    // Scale columns, then rows, by powers of two to about 1, so that neither tiny nor huge scales
    // look singular or overflow; exact, and undone in the inverse.
    double a[3][3]; // [row][column]
    int columnExponent[3], rowExponent[3];
    for (int column = 0; column < 3; ++column) {
        double largest = 0;
        for (int row = 0; row < 3; ++row) {
            largest = std::max(largest, std::fabs(matrix[column][row]));
        }
        if (largest == 0) return false;
        columnExponent[column] = std::ilogb(largest);
        for (int row = 0; row < 3; ++row) {
            a[row][column] = std::ldexp(matrix[column][row], -columnExponent[column]);
        }
    }
    for (int row = 0; row < 3; ++row) {
        const double largest =
            std::max({std::fabs(a[row][0]), std::fabs(a[row][1]), std::fabs(a[row][2])});
        if (largest == 0) return false;
        rowExponent[row] = std::ilogb(largest);
        for (double& entry : a[row]) entry = std::ldexp(entry, -rowExponent[row]);
    }

    double cofactor[3][3], determinant = 0, magnitude = 0;
    for (int row = 0; row < 3; ++row) {
        const int r1 = (row + 1) % 3, r2 = (row + 2) % 3;
        for (int column = 0; column < 3; ++column) {
            const int c1 = (column + 1) % 3, c2 = (column + 2) % 3;
            const double left = a[r1][c1] * a[r2][c2], right = a[r1][c2] * a[r2][c1];
            cofactor[row][column] = left - right;
            if (row == 0) {
                determinant += a[0][column] * (left - right);
                magnitude += std::fabs(a[0][column]) * (std::fabs(left) + std::fabs(right));
            }
        }
    }
    if (!(std::fabs(determinant) > kSingular * magnitude)) return false;

    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            inverse[row][column] = std::ldexp(cofactor[column][row] / determinant,
                                              -columnExponent[row] - rowExponent[column]);
        }
    }
    for (int row = 0; row < 3; ++row) {
        inverse[row][3] = -(inverse[row][0] * matrix[3][0] + inverse[row][1] * matrix[3][1] +
                            inverse[row][2] * matrix[3][2]);
        for (const double entry : inverse[row]) {
            if (!std::isfinite(entry)) return false;
        }
    }
    return true;
}

} // namespace smart

// SPDX-License-Identifier: MIT
// The inverse of an instance's matrix, computed where rays enter the instance: scenes of many
// instances hold one matrix for each.
//
// Static: see point_math.h.
#pragma once

#include "libsmart/kernel/view.h"

namespace smart {

/// Rows of an affine matrix; the fourth column is the translation.
using AffineRows = double[3][4];
/// Four columns of three.
using AffineColumns = double[4][3];

/// False where the matrix is singular or not finite, or the inverse is. For any scale; slow.
bool invertAffine(const AffineColumns& matrix, AffineRows& inverse);
bool isInvertible(const AffineColumns& matrix);
/// Whether invertUsual() gives what invertAffine() does, to the bit, for an invertible matrix: where
/// nothing in between overflows or is subnormal.
bool isUsual(const AffineColumns& matrix);

/// Cofactors over the determinant. Each row of the inverse has the cross product of two columns.
static inline void invertUsual(const AffineColumns& m, AffineRows& inverse) {
    using Real4 = double __attribute__((vector_size(32)));
    Real4 column[3]; // with the next number as the fourth
    for (int i = 0; i < 3; ++i) __builtin_memcpy(&column[i], &m[0][0] + 3 * i, sizeof column[i]);
    Real4 cofactor[3];
    for (int row = 0; row < 3; ++row) {
        const Real4 a = column[(row + 1) % 3], b = column[(row + 2) % 3];
        cofactor[row] = __builtin_shufflevector(a, a, 1, 2, 0, 3) *
                            __builtin_shufflevector(b, b, 2, 0, 1, 3) -
                        __builtin_shufflevector(b, b, 1, 2, 0, 3) *
                            __builtin_shufflevector(a, a, 2, 0, 1, 3);
    }
    const double determinant =
        m[0][0] * cofactor[0][0] + m[1][0] * cofactor[1][0] + m[2][0] * cofactor[2][0];
    for (int row = 0; row < 3; ++row) {
        const Real4 entries = cofactor[row] / determinant;
        __builtin_memcpy(inverse[row], &entries, sizeof entries);
        inverse[row][3] = -(entries[0] * m[3][0] + entries[1] * m[3][1] + entries[2] * m[3][2]);
    }
}

/// Of an instance that can be hit and is not at identity.
static inline void invert(const InstanceView& instance, AffineRows& toObject) {
    if (instance.usual)
        invertUsual(instance.toParent, toObject);
    else
        invertAffine(instance.toParent, toObject);
}

/// What an inverse matrix X of M, and rays transformed by it, are off by. In the largest component,
/// for any vector y: |M^-1 y - X y| <= relative * |X y|, |X y| <= norm * |y|.
struct InverseBound {
    double relative; ///< infinite where nothing is known
    double norm;
    double offset; ///< largest component of M's translation
};

/// From the residual E = 1 - X M: as M^-1 = (1 - E)^-1 X, |M^-1 y - X y| <= |E| / (1 - |E|) |X y|
/// in the maximum norm. Computing an entry of E errs by less than 4 units of 2^-53 of its terms.
static inline InverseBound boundInverse(const AffineColumns& matrix, const AffineRows& inverse) {
    InverseBound bound{0, 0, 0};
    double residual = 0;
    for (int row = 0; row < 3; ++row) {
        double norm = 0, rest = 0;
        for (int column = 0; column < 3; ++column) {
            norm += __builtin_fabs(inverse[row][column]);
            double entry = 0, size = 1;
            for (int k = 0; k < 3; ++k) {
                const double term = inverse[row][k] * matrix[column][k];
                entry += term;
                size += __builtin_fabs(term);
            }
            rest += __builtin_fabs(entry - (row == column ? 1 : 0)) + 0x1p-50 * size;
        }
        const double offset = __builtin_fabs(matrix[3][row]);
        norm *= 1 + 0x1p-50;
        if (norm > bound.norm) bound.norm = norm;
        if (offset > bound.offset) bound.offset = offset;
        if (rest > residual) residual = rest;
    }
    bound.relative =
        residual < 0.5 ? residual / (1 - residual) * (1 + 0x1p-50) : __builtin_inf();
    return bound;
}

} // namespace smart

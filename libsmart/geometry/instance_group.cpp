// SPDX-License-Identifier: MIT
#include "libsmart/geometry/instance_group.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "libsmart/base/fp_environment.h"
#include "libsmart/geometry/box_view.h"
#include "libsmart/geometry/model.h"

namespace smart {
namespace {

float roundedDown(double value) {
    constexpr double kMax = std::numeric_limits<float>::max();
    if (!(value > -kMax)) return float(-kMax); // NaN too: as far out as floats reach
    const float rounded = float(std::min(value, kMax));
    return double(rounded) <= value ? rounded : std::nextafter(rounded, -Aabb::kInf);
}

float roundedUp(double value) {
    return -roundedDown(-value);
}

/// Box around the transformed box, as the eight corners span it. Padded by some units in the last
/// place of its terms, since rays are rounded to float in object space.
Aabb transformed(const glm::dmat4x3& matrix, const Aabb& box) {
    Aabb result;
    if (box.empty()) return result;
    for (int row = 0; row < 3; ++row) {
        double lo = matrix[3][row], hi = lo, magnitude = std::fabs(lo);
        for (int column = 0; column < 3; ++column) {
            const double a = matrix[column][row] * box.lo[column];
            const double b = matrix[column][row] * box.hi[column];
            lo += std::min(a, b);
            hi += std::max(a, b);
            magnitude += std::max(std::fabs(a), std::fabs(b));
        }
        const double pad = 0x1p-21 * magnitude;
        result.lo[row] = roundedDown(lo - pad);
        result.hi[row] = roundedUp(hi + pad);
    }
    return result;
}

/// From the residual E = 1 - X M: as M^-1 = (1 - E)^-1 X, |M^-1 y - X y| <= |E| / (1 - |E|) |X y|
/// in the maximum norm. Computing an entry of E errs by less than 4 units of 2^-53 of its terms.
InverseBound boundInverse(const glm::dmat4x3& matrix, const glm::dmat4x3& inverse) {
    InverseBound bound{0, 0, 0};
    double residual = 0;
    for (int row = 0; row < 3; ++row) {
        double norm = 0, rest = 0;
        for (int column = 0; column < 3; ++column) {
            norm += std::fabs(inverse[column][row]);
            double entry = 0, size = 1;
            for (int k = 0; k < 3; ++k) {
                const double term = inverse[k][row] * matrix[column][k];
                entry += term;
                size += std::fabs(term);
            }
            rest += std::fabs(entry - (row == column ? 1 : 0)) + 0x1p-50 * size;
        }
        bound.norm = std::max(bound.norm, norm * (1 + 0x1p-50));
        bound.offset = std::max(bound.offset, std::fabs(matrix[3][row]));
        residual = std::max(residual, rest);
    }
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    bound.relative = residual < 0.5 ? residual / (1 - residual) * (1 + 0x1p-50) : kInfinity;
    return bound;
}

InstanceView makeInstanceView(const Instance& instance, const glm::dmat4x3& inverse,
                              bool hittable) {
    InstanceView view{};
    view.identity = instance.toParent == glm::dmat4x3(1.0);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column) {
            view.toObject[row][column] = view.identity ? row == column : inverse[column][row];
        }
    }
    view.inverse = boundInverse(instance.toParent, inverse);
    view.toParent = &instance.toParent[0][0];
    view.model = hittable ? &instance.model->view() : nullptr;
    return view;
}

} // namespace

InstanceGroup::InstanceGroup(std::vector<Instance> instances, unsigned threads)
    : instances_(std::move(instances)) {
    const FpEnvironment standard;
    std::vector<Aabb> boxes;
    boxes.reserve(instances_.size());
    views_.reserve(instances_.size());
    for (const Instance& instance : instances_) {
        glm::dmat4x3 inverse(1.0);
        const bool invertible = invertAffine(instance.toParent, inverse);
        if (!invertible) ++dropped_;
        const Aabb box = invertible && instance.model
                             ? transformed(instance.toParent, instance.model->bounds)
                             : Aabb{};
        views_.push_back(makeInstanceView(instance, inverse, !box.empty()));
        boxes.push_back(box);
        bounds_.add(box);
    }
    if (instances_.size() > 1)
        tree_ = buildWideTree(boxes, std::max(threads, 1u), kInstanceCosts);
}

std::size_t ShaderReplacement::bytes() const {
    constexpr std::size_t kOwnerCounts = 2 * sizeof(void*); // beside it, where it is shared
    return sizeof(ShaderReplacement) + kOwnerCounts + pairs.capacity() * sizeof(pairs[0]) +
           keepAlive.capacity() * sizeof(keepAlive[0]);
}

std::size_t InstanceGroup::bytes() const {
    std::size_t replacements = 0;
    for (const Instance& instance : instances_)
        if (instance.replacement) replacements += instance.replacement->bytes();
    return instances_.capacity() * sizeof(Instance) + views_.capacity() * sizeof(InstanceView) +
           replacements + tree_.bytes();
}

void InstanceGroup::show(ModelView& view) const {
    view.children = views_.data();
    static_cast<BoxView&>(view.childTree) = makeBoxView(bounds_);
    view.childTree.nodes = tree_.nodes.empty() ? nullptr : tree_.nodes.data();
    view.childTree.prims = tree_.prims.data();
    view.childCount = bounds_.empty() ? 0 : uint32_t(views_.size());
}

bool invertAffine(const glm::dmat4x3& matrix, glm::dmat4x3& inverse) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 3; ++row) {
            if (!std::isfinite(matrix[column][row])) return false;
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
    // Within the rounding errors of a product of two matrices and of the determinant itself,
    // nothing tells the matrix from a singular one.
    if (!(std::fabs(determinant) > 0x1p-49 * magnitude)) return false;

    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            inverse[column][row] = std::ldexp(cofactor[column][row] / determinant,
                                              -columnExponent[row] - rowExponent[column]);
        }
    }
    for (int row = 0; row < 3; ++row) {
        inverse[3][row] = -(inverse[0][row] * matrix[3][0] + inverse[1][row] * matrix[3][1] +
                            inverse[2][row] * matrix[3][2]);
        for (int column = 0; column < 4; ++column) {
            if (!std::isfinite(inverse[column][row])) return false;
        }
    }
    return true;
}

} // namespace smart

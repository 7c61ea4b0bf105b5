// SPDX-License-Identifier: MIT
#include "libsmart/kernel/exact_meeting.h"

#include <bit>
#include <cmath>
#include <limits>

namespace smart {
namespace {

struct ExactVector {
    ExactNumber x[3];
};

ExactVector operator-(const ExactVector& a, const ExactVector& b) {
    return {{a.x[0] - b.x[0], a.x[1] - b.x[1], a.x[2] - b.x[2]}};
}
ExactNumber inner(const ExactVector& a, const ExactVector& b) {
    return a.x[0] * b.x[0] + a.x[1] * b.x[1] + a.x[2] * b.x[2];
}
ExactVector cross(const ExactVector& a, const ExactVector& b) {
    return {{a.x[1] * b.x[2] - a.x[2] * b.x[1], a.x[2] * b.x[0] - a.x[0] * b.x[2],
             a.x[0] * b.x[1] - a.x[1] * b.x[0]}};
}

template <class Coordinate>
ExactVector vector(const Coordinate* x) {
    return {{ExactNumber(x[0]), ExactNumber(x[1]), ExactNumber(x[2])}};
}

/// Applies a matrix given by columns, the fourth the translation.
ExactVector transformed(const double* matrix, const ExactVector& point) {
    ExactVector result;
    for (int row = 0; row < 3; ++row) {
        result.x[row] = ExactNumber(matrix[row]) * point.x[0] +
                        ExactNumber(matrix[3 + row]) * point.x[1] +
                        ExactNumber(matrix[6 + row]) * point.x[2] + ExactNumber(matrix[9 + row]);
    }
    return result;
}

} // namespace

// As seen from the origin, the vertices A, B, C have the weights d.(B x C), d.(C x A), d.(A x B)
// over their sum, and the plane the distance A.(B x C) over it.
void meetExactly(const ModelView& scene, const WorldRay& ray, const TriangleName& name,
                 ExactMeeting& result) {
    const InstanceView* chain[kMaxLevels];
    const ModelView* model = &scene;
    for (uint32_t l = 0; l < name.levels; ++l) {
        chain[l] = &model->children[name.path[l]];
        model = chain[l]->model;
    }
    const Triangle& triangle = model->triangles[name.triangle];
    ExactVector corners[3] = {vector(triangle.v0), vector(triangle.v1), vector(triangle.v2)};
    const ExactVector origin = vector(ray.org), direction = vector(ray.dir);
    for (ExactVector& corner : corners) {
        for (uint32_t l = name.levels; l-- > 0;) {
            if (!chain[l]->identity) corner = transformed(&chain[l]->toParent[0][0], corner);
        }
        corner = corner - origin;
    }
    const ExactVector opposite = cross(corners[1], corners[2]);
    ExactNumber first = inner(direction, opposite);
    result.second = inner(direction, cross(corners[2], corners[0]));
    result.third = inner(direction, cross(corners[0], corners[1]));
    result.size = first + result.second + result.third;
    const int side = result.size.sign();
    result.inside = side != 0 && first.sign() * side >= 0 && result.second.sign() * side >= 0 &&
                    result.third.sign() * side >= 0;
    if (!result.inside) return;
    result.depth = inner(corners[0], opposite);
    if (side > 0) return;
    result.size.negate();
    result.depth.negate();
    result.second.negate();
    result.third.negate();
}

int compareQuotient(const ExactNumber& numerator, const ExactNumber& denominator, double x) {
    return (numerator - denominator * ExactNumber(x)).sign();
}

int compareDistances(const ExactMeeting& a, const ExactMeeting& b) {
    return (a.depth * b.size - b.depth * a.size).sign();
}

float roundedQuotient(const ExactNumber& numerator, const ExactNumber& denominator, double scale) {
    if (numerator.sign() == 0) return 0;
    int above, below;
    const double quotient = numerator.fraction(above) / denominator.fraction(below);
    const ExactNumber scaled = numerator * ExactNumber(scale);
    // Within some units in the last place of a double; from there by exact comparisons.
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    float nearest = float(std::ldexp(quotient, above - below) * scale);
    const auto middle = [](float a, float b) { // an infinity counts as 2^128 here
        const double x = std::isinf(a) ? std::copysign(0x1p128, a) : double(a);
        const double y = std::isinf(b) ? std::copysign(0x1p128, b) : double(b);
        return (x + y) / 2;
    };
    const auto isOdd = [](float x) { return (std::bit_cast<uint32_t>(x) & 1) != 0; };
    while (nearest != kInfinity) {
        const float next = std::nextafterf(nearest, kInfinity);
        const int order = compareQuotient(scaled, denominator, middle(nearest, next));
        if (order < 0 || (order == 0 && !isOdd(nearest))) break;
        nearest = next;
    }
    while (nearest != -kInfinity) {
        const float previous = std::nextafterf(nearest, -kInfinity);
        const int order = compareQuotient(scaled, denominator, middle(previous, nearest));
        if (order > 0 || (order == 0 && !isOdd(nearest))) break;
        nearest = previous;
    }
    return nearest == 0 ? 0.0f : nearest;
}

} // namespace smart

// SPDX-License-Identifier: MIT
// The ray is taken to object space and meets the triangle there, in double; every result carries
// a bound of its error. Below, u = 2^-53, and a bound's own roundings are covered by constants
// that are at least a quarter larger than the sum of the errors they stand for. Error analysis in
// the manner of Higham, "Accuracy and Stability of Numerical Algorithms", chapter 3.
#include <cmath>
#include <initializer_list>
#include <limits>

#include "libsmart/kernel/affine_inverse.h"
#include "libsmart/kernel/exact_meeting.h"

namespace smart {
namespace {

constexpr double kU = 0x1p-53;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double largest(const double* x) {
    return std::fmax(std::fabs(x[0]), std::fmax(std::fabs(x[1]), std::fabs(x[2])));
}

// boundInverse() says what the inverse itself is off by. The arithmetic here adds less
// than 8u of the terms to the origin and 4u to the direction.
void enter(const InstanceView& instance, ObjectRay& ray) {
    AffineRows toObject;
    invert(instance, toObject);
    const InverseBound inverse = boundInverse(instance.toParent, toObject);
    const double orgSize = largest(ray.org) + inverse.offset, dirSize = largest(ray.dir);
    double org[3], dir[3];
    for (int k = 0; k < 3; ++k) {
        const double* m = toObject[k];
        org[k] = m[0] * ray.org[0] + m[1] * ray.org[1] + m[2] * ray.org[2] + m[3];
        dir[k] = m[0] * ray.dir[0] + m[1] * ray.dir[1] + m[2] * ray.dir[2];
    }
    ray.orgError = inverse.norm * (ray.orgError + 10 * kU * orgSize);
    ray.dirError = inverse.norm * (ray.dirError + 5 * kU * dirSize);
    ray.orgError += inverse.relative * (largest(org) + ray.orgError);
    ray.dirError += inverse.relative * (largest(dir) + ray.dirError);
    for (int k = 0; k < 3; ++k) {
        ray.org[k] = org[k];
        ray.dir[k] = dir[k];
    }
}

void cross(const double* a, const double* b, double* result) {
    result[0] = a[1] * b[2] - a[2] * b[1];
    result[1] = a[2] * b[0] - a[0] * b[2];
    result[2] = a[0] * b[1] - a[1] * b[0];
}
double inner(const double* a, const double* b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

bool isModerate(double size) {
    return size > 0x1p-250 && size < 0x1p250; // false for NaN
}

/// dividend / divisor, where |divisor.value| > divisor.error.
Estimate quotient(const Estimate& dividend, const Estimate& divisor) {
    Estimate result;
    result.value = dividend.value / divisor.value;
    result.error = (dividend.error + std::fabs(result.value) * divisor.error) /
                       (std::fabs(divisor.value) - divisor.error) * (1 + 8 * kU) +
                   8 * kU * std::fabs(result.value);
    if (!(result.error < kInfinity)) result = {0, kInfinity};
    return result;
}

} // namespace

const Triangle& enterModel(const ModelView& scene, const WorldRay& world, const TriangleName& name,
                           ObjectRay& ray) {
    for (int k = 0; k < 3; ++k) {
        ray.org[k] = world.org[k];
        ray.dir[k] = world.dir[k];
    }
    ray.orgError = ray.dirError = 0;
    const ModelView* model = &scene;
    for (uint32_t l = 0; l < name.levels; ++l) {
        const InstanceView& instance = model->children[name.path[l]];
        if (!instance.identity) enter(instance, ray);
        model = instance.model;
    }
    return model->triangles[name.triangle];
}

// With A, B the first two vertices as seen from the origin, e0, e1, e2 the edges from the second
// to the third vertex and from the first to the others, n = e1 x e2:
//   weights d.(B x e0), d.(e2 x A), d.(A x e1), their sum d.n, and t = A.n / d.n.
// Edges and A, B come out of one subtraction, with an error of u of their size (A and B: of the
// origin's error as well). A component of a cross product of vectors of size a and e is off by at
// most 2ae(u + u + u) + 2ae u = 8u ae, the inner product of that and d by 3 * (8u + 2u + 2u) d a e
// = 36u d a e; n is off by the same and d.n and A.n by 42u and 48u of the product of sizes. An
// error x of A adds at most 3 * 2x d e, one of d 3 * 2x a e.
void meetInDouble(const ModelView& scene, const WorldRay& world, const TriangleName& name,
                  DoubleMeeting& result) {
    constexpr Estimate kUnknown = {0, kInfinity};
    result.side = Side::Unsure;
    result.t = result.u = result.v = kUnknown;

    ObjectRay ray;
    const Triangle& triangle = enterModel(scene, world, name, ray);

    double a[3], b[3], e0[3], e1[3], e2[3];
    for (int k = 0; k < 3; ++k) {
        a[k] = triangle.v0[k] - ray.org[k];
        b[k] = triangle.v1[k] - ray.org[k];
        e0[k] = double(triangle.v2[k]) - triangle.v1[k];
        e1[k] = double(triangle.v1[k]) - triangle.v0[k];
        e2[k] = double(triangle.v2[k]) - triangle.v0[k];
    }
    // Sizes of the true vectors: enlarged by their errors.
    const double sizeD = largest(ray.dir) + 2 * ray.dirError;
    const double sizeA = largest(a) + 2 * ray.orgError, sizeB = largest(b) + 2 * ray.orgError;
    const double size0 = largest(e0), size1 = largest(e1), size2 = largest(e2);
    // Nothing below can overflow then, and what underflows is far below the bounds.
    if (!isModerate(sizeD) || !isModerate(sizeA) || !isModerate(sizeB) || !isModerate(size0) ||
        !isModerate(size1) || !isModerate(size2)) {
        return;
    }
    const auto weight = [&](const double* p, const double* q, double point, double edge) {
        double product[3];
        cross(p, q, product);
        const double error = 64 * kU * sizeD * point + 8 * sizeD * ray.orgError +
                             8 * point * ray.dirError;
        return Estimate{inner(ray.dir, product), error * edge};
    };
    const Estimate first = weight(b, e0, sizeB, size0);
    const Estimate second = weight(e2, a, sizeA, size2);
    const Estimate third = weight(a, e1, sizeA, size1);
    bool positive = false, negative = false, unsure = false;
    for (const Estimate& w : {first, second, third}) {
        positive = positive || w.value > w.error;
        negative = negative || w.value < -w.error;
        unsure = unsure || !(std::fabs(w.value) > w.error);
    }
    if (positive && negative) {
        result.side = Side::Outside;
        return;
    }
    if (!unsure) result.side = Side::Inside;

    double normal[3];
    cross(e1, e2, normal);
    const double area = size1 * size2;
    const Estimate sum = {inner(ray.dir, normal), (64 * kU * sizeD + 8 * ray.dirError) * area};
    const Estimate depth = {inner(a, normal), (64 * kU * sizeA + 8 * ray.orgError) * area};
    if (!(std::fabs(sum.value) > sum.error)) return;
    result.t = quotient(depth, sum);
    result.u = quotient(second, sum);
    result.v = quotient(third, sum);
}

} // namespace smart

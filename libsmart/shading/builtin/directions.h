// SPDX-License-Identifier: MIT
// Random directions and the squares of random numbers that they come from. Vectors are those of a
// point or of a packet.
#pragma once

#include "libsmart/shading/builtin/lane_math.h"

namespace smart::builtin {

using namespace openrt;

inline constexpr float kTwoPi = float(2 * math::kPi);

/// Right-handed axes of length 1; z is given. Duff et al., "Building an orthonormal basis,
/// revisited", Journal of Computer Graphics Techniques 6(1), 2017.
template <class V>
struct Basis {
    V x, y, z;

    explicit Basis(const V& axis) : z(axis) {
        const auto sign = select(axis.z < 0.0f, decltype(axis.z)(-1.0f), 1.0f);
        const auto a = -1.0f / (sign + axis.z);
        const auto b = axis.x * axis.y * a;
        x = V(1.0f + sign * axis.x * axis.x * a, sign * b, -sign * axis.x);
        y = V(b, sign + axis.y * axis.y * a, -axis.y);
    }
    V toWorld(const V& v) const { return x * v.x + y * v.y + z * v.z; }
    V toLocal(const V& v) const { return V(dot(x, v), dot(y, v), dot(z, v)); }
};

/// A direction of the hemisphere around a normal with density cosine / pi, for u and v in [0, 1).
template <class V, class F>
V cosineDirection(const V& normal, const F& u, const F& v) {
    const F radius = sqrt(u), angle = kTwoPi * v;
    return Basis<V>(normal).toWorld(
        V(radius * math::cos(angle), radius * math::sin(angle), sqrt(1.0f - u)));
}

/// The direction, or where it points behind the plane with this normal, its mirror image there.
/// Shading normals allow directions that the triangle does not; thus turned they lose no light.
template <class V>
V inFrontOf(const V& normal, const V& direction) {
    const auto along = dot(normal, direction);
    return direction - normal * (2.0f * min(along, 0.0f));
}

/// Divides the unit square into n cells of equal area, as nearly square as whole numbers allow.
/// Sample i falls into cell i.
struct Strata {
    RTuint columns = 1, rows = 1;

    explicit Strata(RTuint n) : rows(n > 0 ? n : 1) {
        for (RTuint k = 2; k <= n / k; ++k)
            if (n % k == 0) columns = k;
        rows /= columns;
    }
    template <class F>
    F u(RTuint i, const F& random) const {
        return (float(i % columns) + random) / float(columns);
    }
    template <class F>
    F v(RTuint i, const F& random) const {
        return (float(i / columns) + random) / float(rows);
    }
};

} // namespace smart::builtin

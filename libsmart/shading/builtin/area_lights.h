// SPDX-License-Identifier: MIT
// Lights with an extent, and so with soft shadows. `radiance` is what the light's surface emits: a
// diffuse white surface close before a large light shows it unchanged. A point receives
// radiance / pi * (solid angle of a sample); nothing here draws the light itself.
#pragma once

#include <cmath>

#include "libsmart/shading/builtin/directions.h"

namespace smart::builtin {

/// A light's `samples` as a count.
inline RTuint sampleCount(int samples) { return samples > 1 ? RTuint(samples) : 1u; }

/// The parallelogram corner + s edge1 + t edge2, s and t in [0, 1]. It shines to the side from
/// which its normal edge1 x edge2 comes, with `twoSided` to both. Its points are chosen with equal
/// density by area, one of each of `samples` equal parts.
struct QuadLight {
    Vec3 corner{-0.5f, -0.5f, 0};
    Vec3 edge1{1, 0, 0};
    Vec3 edge2{0, 1, 0};
    Color radiance{1.0f};
    int samples = 4;
    bool twoSided = false;

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<Vec3>("corner", PER_SHADER, offsetof(QuadLight, corner));
        r.registerParam<Vec3>("edge1", PER_SHADER, offsetof(QuadLight, edge1));
        r.registerParam<Vec3>("edge2", PER_SHADER, offsetof(QuadLight, edge2));
        r.registerParam<Color>("radiance", PER_SHADER, offsetof(QuadLight, radiance));
        r.registerParam<int>("samples", PER_SHADER, offsetof(QuadLight, samples));
        r.registerParam<bool>("twoSided", PER_SHADER, offsetof(QuadLight, twoSided));
    }
    RTuint lightSamples() const { return sampleCount(samples); }
    template <class Context>
    bool illuminate(Context& c, RTuint i, RTuint n, LightSample& sample) const {
        const Strata strata(n);
        const float s = strata.u(i, c.random()), t = strata.v(i, c.random());
        const Vec3 at = c.position();
        const double x = double(corner.x) - at.x + double(s) * edge1.x + double(t) * edge2.x;
        const double y = double(corner.y) - at.y + double(s) * edge1.y + double(t) * edge2.y;
        const double z = double(corner.z) - at.z + double(s) * edge1.z + double(t) * edge2.z;
        const double squared = x * x + y * y + z * z;
        const double distance = std::sqrt(squared);
        // Area times cosine at the light times distance: the normal is as long as the area.
        const double facing =
            -(x * (double(edge1.y) * edge2.z - double(edge1.z) * edge2.y) +
              y * (double(edge1.z) * edge2.x - double(edge1.x) * edge2.z) +
              z * (double(edge1.x) * edge2.y - double(edge1.y) * edge2.x));
        const double projected = twoSided ? std::fabs(facing) : facing;
        if (!(projected > 0)) return false;
        sample.direction = {float(x / distance), float(y / distance), float(z / distance)};
        sample.distance = float(distance);
        sample.radiance = radiance * float(projected / (math::kPi * squared * distance));
        return std::isfinite(sample.distance) && std::isfinite(sample.radiance.r) &&
               std::isfinite(sample.radiance.g) && std::isfinite(sample.radiance.b);
    }
};

/// A sphere that shines outwards. Directions are chosen with equal density in the cone that it
/// fills, one of each of `samples` equal parts (Wang, "Physically correct direct lighting for
/// distribution ray tracing", Graphics Gems III, 1992), without cancellation however far it is.
struct SphereLight {
    Vec3 center;
    float radius = 0.5f;
    Color radiance{1.0f};
    int samples = 4;

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<Vec3>("center", PER_SHADER, offsetof(SphereLight, center));
        r.registerParam<float>("radius", PER_SHADER, offsetof(SphereLight, radius));
        r.registerParam<Color>("radiance", PER_SHADER, offsetof(SphereLight, radiance));
        r.registerParam<int>("samples", PER_SHADER, offsetof(SphereLight, samples));
    }
    RTuint lightSamples() const { return sampleCount(samples); }
    template <class Context>
    bool illuminate(Context& c, RTuint i, RTuint n, LightSample& sample) const {
        const Strata strata(n);
        const float u = strata.u(i, c.random()), v = strata.v(i, c.random());
        const Vec3 at = c.position();
        const double x = double(center.x) - at.x, y = double(center.y) - at.y,
                     z = double(center.z) - at.z;
        const double squared = x * x + y * y + z * z, distance = std::sqrt(squared);
        const double sine2 = double(radius) * radius / squared; // of the cone's half-angle
        if (!(radius > 0 && sine2 < 1)) return false;           // a point inside gets nothing
        const double opening = sine2 / (1 + std::sqrt(1 - sine2)); // 1 - cosine
        const double below = u * opening;                          // 1 - cosine of the direction
        const double chosen2 = below * (2 - below), cosine = 1 - below;
        const float angle = kTwoPi * v;
        const double right = std::sqrt(chosen2) * math::cos(angle),
                     up = std::sqrt(chosen2) * math::sin(angle);
        const Basis<Vec3> frame(Vec3(float(x / distance), float(y / distance),
                                     float(z / distance)));
        sample.direction = normalize(
            Vec3(float(x / distance * cosine + right * frame.x.x + up * frame.y.x),
                 float(y / distance * cosine + right * frame.x.y + up * frame.y.y),
                 float(z / distance * cosine + right * frame.x.z + up * frame.y.z)));
        const double half = std::sqrt(std::fmax(sine2 - chosen2, 0.0)); // of the chord, by distance
        sample.distance = float(distance * (cosine - half));
        sample.radiance = radiance * float(2 * opening);
        return std::isfinite(sample.distance) && std::isfinite(sample.radiance.r) &&
               std::isfinite(sample.radiance.g) && std::isfinite(sample.radiance.b);
    }
};

} // namespace smart::builtin

// SPDX-License-Identifier: MIT
// A rectangle that shines: soft shadows. The library counts it as several lights and asks for a
// sample of each; a sample is a random point of one cell of the rectangle.
//
// `radiance` is what a camera sees that looks at the rectangle. A point at distance d receives
//     radiance * cos(at the light) * cos(at the point) * area / d^2,
// a white diffuse surface shows 1 / pi of that, and the cosine at the point is the surface's part.
#include <cmath>

#include "openrt/plugin.hpp"

namespace {

using namespace openrt;

struct AreaLight {
    Vec3 corner{-0.5f, 2, -0.5f}, edge1{1, 0, 0}, edge2{0, 0, 1};
    Color radiance{10.0f}; ///< on the side from which edge1, edge2 turn anticlockwise
    int cells = 4;         ///< along each edge

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<Vec3>("corner", PER_SHADER, offsetof(AreaLight, corner));
        r.registerParam<Vec3>("edge1", PER_SHADER, offsetof(AreaLight, edge1));
        r.registerParam<Vec3>("edge2", PER_SHADER, offsetof(AreaLight, edge2));
        r.registerParam<Color>("radiance", PER_SHADER, offsetof(AreaLight, radiance));
        r.registerParam<int>("cells", PER_SHADER, offsetof(AreaLight, cells));
    }

    RTuint side() const { return RTuint(cells < 1 ? 1 : cells > 16 ? 16 : cells); }
    RTuint lightSamples() const { return side() * side(); }

    bool illuminate(TraceContext& c, RTuint i, RTuint, LightSample& sample) const {
        const float u = (float(i % side()) + c.random()) / float(side());
        const float v = (float(i / side()) + c.random()) / float(side());
        const Vec3 towards = corner + edge1 * u + edge2 * v - c.position();
        const float distance = length(towards);
        const Vec3 scaledNormal = cross(edge1, edge2); // as long as the area is large
        if (!(distance > 0)) return false;             // the point is on the light
        const Vec3 direction = towards / distance;
        const float cosineTimesArea = -dot(direction, scaledNormal);
        if (!(cosineTimesArea > 0)) return false; // behind it
        constexpr float kPi = 3.14159265f;
        sample = {direction, distance, radiance * (cosineTimesArea / (kPi * distance * distance))};
        return true;
    }
};

} // namespace

OPENRT_PLUGIN(AreaLight, "AreaLight")

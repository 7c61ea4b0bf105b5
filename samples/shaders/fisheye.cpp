// SPDX-License-Identifier: MIT
// A fish-eye camera with the equidistant projection: the distance from the picture's centre is
// proportional to the angle from the line of sight, so that 180 degrees and more fit.
#include <cmath>

#include "openrt/plugin.hpp"

namespace {

using namespace openrt;

struct Fisheye {
    Vec3 origin, direction{0, 0, -1}, up{0, 1, 0};
    float fieldOfView = 180; ///< degrees across the circle that touches the picture's nearer edges
    float aspect = 1;        ///< width of the picture divided by its height

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<Vec3>("origin", PER_SHADER, offsetof(Fisheye, origin));
        r.registerParam<Vec3>("direction", PER_SHADER, offsetof(Fisheye, direction));
        r.registerParam<Vec3>("up", PER_SHADER, offsetof(Fisheye, up));
        r.registerParam<float>("fieldOfView", PER_SHADER, offsetof(Fisheye, fieldOfView));
        r.registerParam<float>("aspect", PER_SHADER, offsetof(Fisheye, aspect));
    }

    void initPrimaryRay(float x, float y, TraceContext& c) const {
        const Vec3 ahead = normalize(direction);
        const Vec3 right = normalize(cross(ahead, up));
        const Vec3 above = cross(right, ahead);
        // Of the circle: 1 at its edge.
        const float px = (2 * x - 1) * (aspect > 1 ? aspect : 1);
        const float py = (2 * y - 1) / (aspect < 1 ? aspect : 1);
        const float radius = std::sqrt(px * px + py * py);
        const float degrees = std::fmin(radius * fieldOfView / 2, 180.0f); // behind is the limit
        const float angle = degrees * (3.14159265f / 180);
        const float aside = radius > 0 ? std::sin(angle) / radius : 0.0f;
        c.setRay(origin, ahead * std::cos(angle) + right * (px * aside) + above * (py * aside));
    }
};

} // namespace

OPENRT_PLUGIN(Fisheye, "Fisheye")

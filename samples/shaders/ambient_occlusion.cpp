// SPDX-License-Identifier: MIT
// A rendering object that shows how much of the sky each point sees, whatever its surface shader
// says: rays in random directions, more of them the steeper they rise, and the share of those
// that meet nothing near by.
#include <cmath>
#include <limits>

#include "openrt/plugin.hpp"

namespace {

using namespace openrt;

/// A direction over the surface, with a density proportional to the cosine to its normal: a point
/// of the unit sphere that touches the surface from above (a form of Malley's method).
Vec3 cosineDirection(TraceContext& c) {
    const float height = 1 - 2 * c.random();
    const float angle = 6.28318531f * c.random();
    const float radius = std::sqrt(std::fmax(1 - height * height, 0.0f));
    return c.facingNormal() + Vec3(radius * std::cos(angle), radius * std::sin(angle), height);
}

struct Occlusion {
    int rays = 16;
    float distance = std::numeric_limits<float>::infinity(); ///< farther surfaces do not count
    Color background{1.0f};

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<int>("rays", PER_SHADER, offsetof(Occlusion, rays));
        r.registerParam<float>("distance", PER_SHADER, offsetof(Occlusion, distance));
        r.registerParam<Color>("background", PER_SHADER, offsetof(Occlusion, background));
    }

    Color renderPixel(PixelContext& pixel) const {
        Color sum;
        for (RTuint i = 0; i < pixel.samples(); ++i) {
            float open = 0;
            const bool met = pixel.visit(
                pixel.samplePosition(i, pixel.samples()), [&](TraceContext& c) {
                    for (int ray = 0; ray < rays; ++ray) {
                        RTShitinfo hit;
                        const Vec3 direction = cosineDirection(c);
                        // Below the triangle's plane the surface itself is in the way.
                        if (dot(direction, c.facingGeometricNormal()) > 0 &&
                            !(c.traceHit(c.position(), direction, hit) && hit.distance < distance))
                            open += 1;
                    }
                });
            sum += met ? Color(open / float(rays > 0 ? rays : 1)) : background;
        }
        return sum / float(pixel.samples());
    }
};

} // namespace

OPENRT_PLUGIN(Occlusion, "AmbientOcclusion")

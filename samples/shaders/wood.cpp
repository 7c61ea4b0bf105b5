// SPDX-License-Identifier: MIT
// A shader class in C++: a plain class, found by its members. Rings around the y axis, darker
// where they end, lit with shadows.
#include <cmath>

#include "openrt/plugin.hpp"
#include "sample_shaders.h"

namespace {

using namespace openrt;

struct Wood {
    Color light{0.8f, 0.6f, 0.4f}, dark{0.45f, 0.28f, 0.15f};
    float rings = 12; // in a unit of length

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<Color>("light", PER_SHADER, offsetof(Wood, light));
        r.registerParam<Color>("dark", PER_SHADER, offsetof(Wood, dark));
        r.registerParam<float>("rings", PER_SHADER, offsetof(Wood, rings));
    }
    template <class Context>
    void shade(Context& c) const {
        const Vec3 p = c.position();
        const float radius = std::sqrt(p.x * p.x + p.z * p.z) * rings;
        const float age = radius - std::floor(radius); // within the ring
        const Color wood = light * (1 - age) + dark * age;
        Color sum = wood * 0.1f;
        for (RTuint i = 0; i < c.lightCount(); ++i) {
            LightSample sample{};
            if (!c.illuminate(i, sample)) continue;
            const float cosine = dot(c.facingNormal(), sample.direction);
            if (cosine > 0)
                sum += wood * sample.radiance * cosine *
                       c.shadow(c.position(), sample.direction, sample.distance);
        }
        c.setRadiance(sum);
    }
};

} // namespace

OPENRT_PLUGIN(Wood, "Wood")

const RTshaderclass* woodClass() { return shaderClass<Wood>("Wood"); }

// SPDX-License-Identifier: MIT
// Glass: reflects and refracts by Snell's law, shares the light by Fresnel's equations, and takes
// colour from what it passes through (Beer and Lambert). Normals have to point out of the body,
// and the body has to be closed.
#include <cmath>

#include "openrt/plugin.hpp"

namespace {

using namespace openrt;

float exponential(float x) {
    return std::exp(x);
}
Floats exponential(const Floats& x) {
    return forEachLane([](float a) { return std::exp(a); }, x);
}

/// Share of unpolarised light that is reflected where a ray meets the surface at the cosine
/// `outside`, and is refracted to the cosine `behind`; eta as in refractedDirection.
template <class Float>
Float fresnel(const Float& eta, const Float& outside, const Float& behind) {
    const Float parallel = (outside - eta * behind) / (outside + eta * behind);
    const Float perpendicular = (eta * outside - behind) / (eta * outside + behind);
    return 0.5f * (parallel * parallel + perpendicular * perpendicular);
}

struct Glass {
    float index = 1.5f;
    Color absorption; ///< share that a short way takes, per unit of length

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<float>("index", PER_SHADER, offsetof(Glass, index));
        r.registerParam<Color>("absorption", PER_SHADER, offsetof(Glass, absorption));
    }

    static constexpr RTuint reads() {
        return READS_REFLECTION | READS_REFRACTION | READS_TRACE;
    }
    static constexpr bool shadesPackets = true;
    template <class Context>
    void shade(Context& c) const {
        using Float = typename Context::Float;
        using Vec3 = typename Context::Vec3;
        using PointColor = typename Context::Color;

        // From outside the ray enters, from the back it leaves.
        const Float eta = select(c.frontFace(), Float(1 / index), Float(index));
        Vec3 through;
        const auto refracts = c.refractedDirection(eta, through);
        const Float outside = abs(dot(c.rayDirection(), c.shadingNormal()));
        const Float behind = abs(dot(through, c.shadingNormal()));
        const Float mirrored = select(refracts, fresnel(eta, outside, behind), Float(1.0f));

        // A ray with too small a share of the pixel is not traced: trace answers black.
        PointColor sum = mirrored * c.trace(c.position(), c.reflectedDirection(), mirrored);
        const Float passed = 1.0f - mirrored;
        sum += passed * c.trace(c.position(), through, passed, refracts);

        // A ray that meets the back came through the glass.
        if (!absorption.black()) {
            const Float inside = select(c.frontFace(), Float(0.0f), c.rayDistance());
            sum *= PointColor(exponential(-absorption.r * inside),
                              exponential(-absorption.g * inside),
                              exponential(-absorption.b * inside));
        }
        c.setRadiance(sum);
    }

    /// Shadow rays go straight on, past both sides of the body: an approximation.
    Color transparency(TraceContext& c) const {
        const float facing = std::fabs(dot(c.rayDirection(), c.shadingNormal()));
        const float behind = std::sqrt(1 - (1 - facing * facing) / (index * index));
        return Color(index > 1 ? 1 - fresnel(1 / index, facing, behind) : 1.0f);
    }
};

} // namespace

OPENRT_PLUGIN(Glass, "Glass")

// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <limits>

#include "libsmart/shading/builtin/indirect.h"
#include "libsmart/shading/builtin/sample_limit.h"

namespace smart::builtin {

/// color * (mean of what `samples` shadow rays of length `distance` let pass), in directions
/// around the normal with density cosine / pi, one in each of `samples` equal parts: the share of
/// an even sky that reaches the point. Zhukov et al., "An ambient light illumination model",
/// Eurographics Workshop on Rendering, 1998.
struct AmbientOcclusion {
    int samples = 16; ///< 1 to 4096; others count as the nearest of these
    float distance = std::numeric_limits<float>::infinity();
    Color color{1.0f};

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<int>("samples", PER_SHADER, offsetof(AmbientOcclusion, samples));
        r.registerParam<float>("distance", PER_SHADER, offsetof(AmbientOcclusion, distance));
        r.registerParam<Color>("color", PER_SHADER, offsetof(AmbientOcclusion, color));
    }
    static constexpr RTuint reads() { return READS_FACING_NORMAL | READS_TRACE; }
    static constexpr bool shadesPackets = true;
    template <class Context>
    void shade(Context& c) const {
        using Float = typename Context::Float;
        const auto n = RTuint(std::clamp(samples, 1, kMaxSamples));
        const Strata strata(n);
        const auto normal = c.facingNormal(), side = c.facingGeometricNormal();
        typename Context::Color open;
        for (RTuint i = 0; i < n; ++i) {
            const Float u = strata.u(i, c.random()), v = strata.v(i, c.random());
            const auto direction = inFrontOf(side, cosineDirection(normal, u, v));
            open += c.shadow(c.position(), direction, distance);
        }
        c.setRadiance(color * (open / float(n)));
    }
};

} // namespace smart::builtin

// SPDX-License-Identifier: MIT
// Surfaces that say what they read, one of them the truth; the others leave something out.
#include <openrt/plugin.hpp>

namespace {

using namespace openrt;

/// What is left out, the class does not say.
template <RTuint leftOut>
struct Reading {
    static constexpr RTuint reads() {
        return (READS_FACING_NORMAL | READS_TEXCOORD | READS_TEXTURE | READS_LIGHTS | READS_TRACE |
                READS_COLOR) &
               ~leftOut;
    }
    void shade(TraceContext& c) const {
        const auto texel = c.texture(TextureId{1}, c.texCoord());
        Color sum = c.color() * texel.x;
        LightSample light;
        if (c.illuminate(0, light) && c.shadow(c.position(), light.direction, light.distance).r > 0)
            sum += light.radiance * dot(c.facingNormal(), light.direction);
        c.setRadiance(sum);
    }
};

using Truthful = Reading<0>;
using Forgetful = Reading<READS_SHADING_NORMAL | READS_TEXCOORD>;
using Unplaced = Reading<READS_POSITION>;
using Blurred = Reading<READS_FOOTPRINT>;

OPENRT_PLUGIN(Truthful, "Truthful")
OPENRT_PLUGIN(Forgetful, "Forgetful")
OPENRT_PLUGIN(Unplaced, "Unplaced")
OPENRT_PLUGIN(Blurred, "Blurred")

} // namespace

// SPDX-License-Identifier: MIT
// Built-in environments: what a ray sees that meets nothing.
#pragma once

#include "libsmart/base/transcendental.h"
#include "openrt/shader.hpp"

namespace smart::builtin {

using namespace openrt;

struct ConstantEnvironment {
    static constexpr ShaderKind kind = ShaderKind::Environment;
    Color radiance;

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<Color>("radiance", PER_SHADER, offsetof(ConstantEnvironment, radiance));
    }
    template <class Context>
    void shade(Context& c) const {
        c.setRadiance(radiance);
    }
};

/// A latitude-longitude picture around the scene: +y is its upper edge, -z its middle, +x lies to
/// the right of that. `rotation`: degrees about +y, anticlockwise seen from above. The texture
/// should repeat along s and clamp along t, lest the poles mix.
struct ImageEnvironment {
    static constexpr ShaderKind kind = ShaderKind::Environment;
    TextureId texture;
    float scale = 1;
    float rotation = 0;

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<TextureId>("texture", PER_SHADER, offsetof(ImageEnvironment, texture));
        r.registerParam<float>("scale", PER_SHADER, offsetof(ImageEnvironment, scale));
        r.registerParam<float>("rotation", PER_SHADER, offsetof(ImageEnvironment, rotation));
    }
    template <class Context>
    void shade(Context& c) const {
        constexpr float kInversePi = float(1 / math::kPi);
        const Vec3 d = c.rayDirection();
        const float y = d.y > 1 ? 1.0f : d.y < -1 ? -1.0f : d.y; // rounding may leave length 1
        const float s = 0.5f + math::atan2(d.x, -d.z) * (0.5f * kInversePi) + rotation / 360.0f;
        const float t = 0.5f + math::asin(y) * kInversePi;
        const Vec4 texel = c.texture(texture, {s, t});
        c.setRadiance(Color(texel.x, texel.y, texel.z) * scale);
    }
};

} // namespace smart::builtin

// SPDX-License-Identifier: MIT
// Built-in environments: what a ray sees that meets nothing.
#pragma once

#include "libsmart/shading/builtin/lane_math.h"

namespace smart::builtin {

using namespace openrt;

/// radiance
struct ConstantEnvironment {
    static constexpr ShaderKind kind = ShaderKind::Environment;
    static constexpr bool shadesPackets = true;
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
    static constexpr bool shadesPackets = true;
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
        using Float = typename Context::Float;
        constexpr float kInversePi = float(1 / math::kPi);
        const auto d = c.rayDirection();
        const Float y = max(min(d.y, Float(1.0f)), Float(-1.0f)); // rounding may leave length 1
        const Float s =
            0.5f + math::atan2(d.x, -d.z) * (0.5f * kInversePi) + rotation / 360.0f;
        const Float t = 0.5f + math::asin(y) * kInversePi;
        const auto texel = c.texture(texture, {s, t});
        c.setRadiance(typename Context::Color(texel.x, texel.y, texel.z) * scale);
    }
};

} // namespace smart::builtin

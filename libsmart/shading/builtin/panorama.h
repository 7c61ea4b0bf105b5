// SPDX-License-Identifier: MIT
#pragma once

#include "libsmart/shading/builtin/lane_math.h"

namespace smart::builtin {

using namespace openrt;

/// Everything around `origin`, by latitude and longitude: +y is the picture's upper edge, -z its
/// middle, +x lies to the right of that. `rotation`: degrees about +y, anticlockwise seen from
/// above. The picture is what ImageEnvironment takes, with the same rotation.
struct Panorama {
    Vec3 origin;
    float rotation = 0;

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<Vec3>("origin", PER_SHADER, offsetof(Panorama, origin));
        r.registerParam<float>("rotation", PER_SHADER, offsetof(Panorama, rotation));
    }
    template <class Context>
    void initPrimaryRay(float x, float y, Context& c) const {
        const float longitude = (x - 0.5f - rotation / 360.0f) * float(2 * math::kPi);
        const float latitude = (y - 0.5f) * float(math::kPi);
        const float level = math::cos(latitude);
        c.setRay(origin, {level * math::sin(longitude), math::sin(latitude),
                          -level * math::cos(longitude)});
    }
};

} // namespace smart::builtin

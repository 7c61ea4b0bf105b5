// SPDX-License-Identifier: MIT
#pragma once

#include "libsmart/shading/builtin/directions.h"

namespace smart::builtin {

/// The pinhole camera with a lens in the place of the hole: a disk of radius `aperture` around
/// `origin` in the plane of `horizontal` and `vertical`. What lies in the plane at
/// `focusDistance`, measured along the lens's axis, is sharp; a point at distance z becomes a
/// disk of radius aperture * |z - focusDistance| / z in that plane. Each ray starts at a random
/// point of the lens: take many samples. Aperture 0 is the pinhole camera to the bit.
/// Potmesil and Chakravarty, "A lens and aperture camera model for synthetic image generation",
/// 1981; Cook et al., "Distributed ray tracing", 1984.
struct ThinLens {
    Vec3 origin;
    Vec3 lowerLeft{-1, -1, -1};
    Vec3 vertical{0, 2, 0};
    Vec3 horizontal{2, 0, 0};
    float aperture = 0;
    float focusDistance = 1; ///< may be infinite

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<Vec3>("origin", PER_SHADER, offsetof(ThinLens, origin));
        r.registerParam<Vec3>("lowerLeft", PER_SHADER, offsetof(ThinLens, lowerLeft));
        r.registerParam<Vec3>("vertical", PER_SHADER, offsetof(ThinLens, vertical));
        r.registerParam<Vec3>("horizontal", PER_SHADER, offsetof(ThinLens, horizontal));
        r.registerParam<float>("aperture", PER_SHADER, offsetof(ThinLens, aperture));
        r.registerParam<float>("focusDistance", PER_SHADER, offsetof(ThinLens, focusDistance));
    }
    template <class Context>
    void initPrimaryRay(float x, float y, Context& c) const {
        const Vec3 direction = lowerLeft + horizontal * x + vertical * y;
        if (aperture == 0) {
            c.setRay(origin, direction);
            return;
        }
        const Vec3 axis = normalize(cross(horizontal, vertical)); // its sign cancels
        const Vec3 right = normalize(horizontal), up = cross(axis, right);
        const float radius = aperture * sqrt(c.random()), angle = kTwoPi * c.random();
        const Vec3 offset = right * (radius * math::cos(angle)) + up * (radius * math::sin(angle));
        const float along = dot(direction, axis);
        const float shrink = (along < 0 ? -along : along) / focusDistance; // 0: focus at infinity
        c.setRay(origin + offset, direction - offset * shrink);
    }
};

} // namespace smart::builtin

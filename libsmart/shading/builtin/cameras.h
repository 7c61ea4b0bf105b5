// SPDX-License-Identifier: MIT
// Built-in cameras; (0, 0) is the lower left corner of the picture, (1, 1) the upper right one.
#pragma once

#include "openrt/shader.hpp"

namespace smart::builtin {

using namespace openrt;

/// Rays from `origin` with direction lowerLeft + x horizontal + y vertical.
struct PinholeCameraShader {
    Vec3 origin;
    Vec3 lowerLeft{-1, -1, -1};
    Vec3 vertical{0, 2, 0};
    Vec3 horizontal{2, 0, 0};

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<Vec3>("origin", PER_SHADER, offsetof(PinholeCameraShader, origin));
        r.registerParam<Vec3>("lowerLeft", PER_SHADER, offsetof(PinholeCameraShader, lowerLeft));
        r.registerParam<Vec3>("vertical", PER_SHADER, offsetof(PinholeCameraShader, vertical));
        r.registerParam<Vec3>("horizontal", PER_SHADER, offsetof(PinholeCameraShader, horizontal));
    }
    template <class Context>
    void initPrimaryRay(float x, float y, Context& c) const {
        c.setRay(origin, lowerLeft + horizontal * x + vertical * y);
    }
};

/// Parallel rays along `direction` from lowerLeft + x horizontal + y vertical.
struct Orthographic {
    Vec3 direction{0, 0, -1};
    Vec3 lowerLeft{-1, -1, 0};
    Vec3 vertical{0, 2, 0};
    Vec3 horizontal{2, 0, 0};

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<Vec3>("direction", PER_SHADER, offsetof(Orthographic, direction));
        r.registerParam<Vec3>("lowerLeft", PER_SHADER, offsetof(Orthographic, lowerLeft));
        r.registerParam<Vec3>("vertical", PER_SHADER, offsetof(Orthographic, vertical));
        r.registerParam<Vec3>("horizontal", PER_SHADER, offsetof(Orthographic, horizontal));
    }
    template <class Context>
    void initPrimaryRay(float x, float y, Context& c) const {
        c.setRay(lowerLeft + horizontal * x + vertical * y, direction);
    }
};

} // namespace smart::builtin

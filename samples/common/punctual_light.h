// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <limits>
#include <openrt/rt.hpp>

namespace samples {

/// What glTF's KHR_lights_punctual adds to a point light: an end of its reach, and a cone whose rim
/// is smooth between two angles.
struct PunctualLight {
    openrt::Vec3 position, direction{0, 0, -1};
    openrt::Color radiance{1.0f}; ///< arriving at distance 1
    float range = std::numeric_limits<float>::infinity();
    /// Cosines of the half angles where the cone ends and where its rim begins; below -1: no cone.
    float cosOuter = -3.0f, cosInner = -2.0f;

    void registerParams(const openrt::ShaderRegistrator& r) const {
        using Self = PunctualLight;
        using openrt::PER_SHADER;
        r.registerParam<openrt::Vec3>("position", PER_SHADER, offsetof(Self, position));
        r.registerParam<openrt::Vec3>("direction", PER_SHADER, offsetof(Self, direction));
        r.registerParam<openrt::Color>("radiance", PER_SHADER, offsetof(Self, radiance));
        r.registerParam<float>("range", PER_SHADER, offsetof(Self, range));
        r.registerParam<float>("cosOuter", PER_SHADER, offsetof(Self, cosOuter));
        r.registerParam<float>("cosInner", PER_SHADER, offsetof(Self, cosInner));
    }

    bool illuminate(const openrt::Vec3& at, openrt::Vec3& toLight, float& distance,
                    openrt::Color& arriving) const {
        const openrt::Vec3 way = position - at;
        distance = length(way);
        if (!(distance > 0.0f)) return false;
        toLight = way / distance;
        constexpr float kNarrowest = 0.001f; // of the rim; the specification's
        const float rim = std::clamp((-dot(toLight, direction) - cosOuter) /
                                         std::max(cosInner - cosOuter, kNarrowest),
                                     0.0f, 1.0f);
        const float far = distance / range;
        const float share = rim * rim * std::max(1.0f - far * far * far * far, 0.0f);
        arriving = radiance * (share / (distance * distance));
        return share > 0.0f;
    }
};

} // namespace samples

// SPDX-License-Identifier: MIT
// Built-in lights. `radiance` is what a point at distance 1 receives; a white diffuse surface that
// faces the light shows it unchanged (no factor of pi anywhere).
#pragma once

#include <cmath>
#include <limits>

#include "libsmart/base/transcendental.h"
#include "libsmart/kernel/point_math.h"
#include "openrt/shader.hpp"

namespace smart::builtin {

using namespace openrt;

/// A light at `from` that falls off with the square of the distance. Nothing arrives at the light
/// itself, nor so close to it that the radiance is no number any more.
inline bool samplePoint(const Vec3& from, const Color& strength, const Vec3& position,
                        Vec3& direction, float& distance, Color& radiance) {
    const PointLightSample sample =
        samplePointLight({from.x, from.y, from.z}, {position.x, position.y, position.z});
    direction = {float(sample.direction.x), float(sample.direction.y), float(sample.direction.z)};
    distance = float(sample.distance);
    radiance = {float(strength.r * sample.share), float(strength.g * sample.share),
                float(strength.b * sample.share)};
    return sample.distance > 0 && std::isfinite(distance) && std::isfinite(radiance.r) &&
           std::isfinite(radiance.g) && std::isfinite(radiance.b);
}

/// radiance / distance^2 in all directions.
struct PointLight {
    Vec3 position;
    Color radiance{1.0f};

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<Vec3>("position", PER_SHADER, offsetof(PointLight, position));
        r.registerParam<Color>("radiance", PER_SHADER, offsetof(PointLight, radiance));
    }
    bool illuminate(const Vec3& at, Vec3& direction, float& distance, Color& arriving) const {
        return samplePoint(position, radiance, at, direction, distance, arriving);
    }
};

/// A point light; with `cutoff` below 180 degrees only inside the cone of that half-angle around
/// `direction`, times cos^exponent of the angle to it, as OpenGL's spot lights.
struct SpotLightShader {
    Vec3 position;
    Color radiance{1.0f};
    Vec3 direction{0, 0, -1};
    float cutoff = 180;
    float exponent = 0;

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<Vec3>("position", PER_SHADER, offsetof(SpotLightShader, position));
        r.registerParam<Color>("radiance", PER_SHADER, offsetof(SpotLightShader, radiance));
        r.registerParam<Vec3>("direction", PER_SHADER, offsetof(SpotLightShader, direction));
        r.registerParam<float>("cutoff", PER_SHADER, offsetof(SpotLightShader, cutoff));
        r.registerParam<float>("exponent", PER_SHADER, offsetof(SpotLightShader, exponent));
    }
    bool illuminate(const Vec3& at, Vec3& toLight, float& distance, Color& arriving) const {
        if (!samplePoint(position, radiance, at, toLight, distance, arriving)) return false;
        if (cutoff >= 180 && exponent == 0) return true;
        const float cosine = -dot(toLight, normalize(direction));
        if (cutoff < 180 && cosine < math::cos(float(cutoff * (math::kPi / 180)))) return false;
        if (exponent != 0) arriving *= math::pow(cosine > 0 ? cosine : 0.0f, exponent);
        return true;
    }
};

/// A point light with an end of its reach and a cone whose rim is smooth, as glTF's
/// KHR_lights_punctual has them: everything within `innerCutoff` degrees of `direction`, nothing from
/// `cutoff` on, or no cone where that is 180 or more.
struct PunctualLight {
    Vec3 position;
    Color radiance{1.0f};
    float range = std::numeric_limits<float>::infinity();
    Vec3 direction{0, 0, -1};
    float cutoff = 180;
    float innerCutoff = 0;

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<Vec3>("position", PER_SHADER, offsetof(PunctualLight, position));
        r.registerParam<Color>("radiance", PER_SHADER, offsetof(PunctualLight, radiance));
        r.registerParam<float>("range", PER_SHADER, offsetof(PunctualLight, range));
        r.registerParam<Vec3>("direction", PER_SHADER, offsetof(PunctualLight, direction));
        r.registerParam<float>("cutoff", PER_SHADER, offsetof(PunctualLight, cutoff));
        r.registerParam<float>("innerCutoff", PER_SHADER, offsetof(PunctualLight, innerCutoff));
    }
    bool illuminate(const Vec3& at, Vec3& toLight, float& distance, Color& arriving) const {
        if (!samplePoint(position, radiance, at, toLight, distance, arriving)) return false;
        const float far = distance / range;
        float share = 1.0f - far * far * far * far;
        if (cutoff < 180) {
            constexpr float kNarrowest = 0.001f; // of the rim, as the extension has it
            const float outer = cosine(cutoff), rim = cosine(innerCutoff) - outer;
            const float within = -dot(toLight, normalize(direction)) - outer;
            const float part = within / (rim > kNarrowest ? rim : kNarrowest);
            share *= part < 0 ? 0 : part < 1 ? part * part : 1;
        }
        arriving *= share;
        return share > 0;
    }

private:
    static float cosine(float degrees) { return math::cos(float(degrees * (math::kPi / 180))); }
};

/// The same radiance everywhere, travelling along `direction`.
struct DirectionalLight {
    Vec3 direction{0, 0, -1};
    Color radiance{1.0f};

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<Vec3>("direction", PER_SHADER, offsetof(DirectionalLight, direction));
        r.registerParam<Color>("radiance", PER_SHADER, offsetof(DirectionalLight, radiance));
    }
    bool illuminate(const Vec3&, Vec3& toLight, float& distance, Color& arriving) const {
        if (direction == Vec3()) return false;
        toLight = normalize(-direction);
        distance = std::numeric_limits<float>::infinity();
        arriving = radiance;
        return true;
    }
};

} // namespace smart::builtin

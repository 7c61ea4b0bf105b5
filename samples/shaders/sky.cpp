// SPDX-License-Identifier: MIT
// The sky of a clear or hazy day, and the sun in it: Preetham, Shirley and Smits, "A Practical
// Analytic Model for Daylight" (SIGGRAPH 1999), appendix A.2. +y is up.
#include <algorithm>
#include <cmath>

#include "openrt/plugin.hpp"

namespace {

using namespace openrt;

constexpr float kPi = 3.14159265f;

/// Perez' formula: how much of the zenith's value a direction has, up to a factor.
/// cosine: of the direction's angle to the zenith; gamma: its angle to the sun.
struct Perez {
    float a, b, c, d, e;

    float operator()(float cosine, float gamma) const {
        const float cosGamma = std::cos(gamma);
        return (1 + a * std::exp(b / cosine)) *
               (1 + c * std::exp(d * gamma) + e * cosGamma * cosGamma);
    }
};

/// The third power of the sun's zenith angle first.
float cubic(float x, float c3, float c2, float c1, float c0) {
    return ((c3 * x + c2) * x + c1) * x + c0;
}

/// CIE xyY to linear RGB with sRGB's primaries; what they can not show is cut off.
Color toRgb(float x, float y, float luminance) {
    const float bigX = luminance * x / y, bigZ = luminance * (1 - x - y) / y;
    return {std::max(3.2406f * bigX - 1.5372f * luminance - 0.4986f * bigZ, 0.0f),
            std::max(-0.9689f * bigX + 1.8758f * luminance + 0.0415f * bigZ, 0.0f),
            std::max(0.0557f * bigX - 0.2040f * luminance + 1.0570f * bigZ, 0.0f)};
}

struct Sky {
    static constexpr ShaderKind kind = ShaderKind::Environment;
    Vec3 sun{0.5f, 0.6f, 0.3f}; ///< direction to it
    float turbidity = 3;        ///< 2 clear, 10 hazy: as far as the model was fitted
    float scale = 0.05f;        ///< radiance of a thousand candela per square metre
    float sunRadius = 0.27f;    ///< of the disc, in degrees; 0: none
    Color sunRadiance{500.0f};
    Color ground{0.1f, 0.09f, 0.08f}; ///< below the horizon

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<Vec3>("sun", PER_SHADER, offsetof(Sky, sun));
        r.registerParam<float>("turbidity", PER_SHADER, offsetof(Sky, turbidity));
        r.registerParam<float>("scale", PER_SHADER, offsetof(Sky, scale));
        r.registerParam<float>("sunRadius", PER_SHADER, offsetof(Sky, sunRadius));
        r.registerParam<Color>("sunRadiance", PER_SHADER, offsetof(Sky, sunRadiance));
        r.registerParam<Color>("ground", PER_SHADER, offsetof(Sky, ground));
    }

    void shade(TraceContext& c) const {
        const Vec3 direction = c.rayDirection();
        const Vec3 toSun = normalize(sun);
        const float gamma = std::acos(std::clamp(dot(direction, toSun), -1.0f, 1.0f));
        if (direction.y < 0) {
            c.setRadiance(ground);
        } else if (gamma < sunRadius * (kPi / 180)) {
            c.setRadiance(sunRadiance);
        } else {
            c.setRadiance(radiance(direction.y, gamma, toSun));
        }
    }

    Color radiance(float height, float gamma, const Vec3& toSun) const {
        const float t = std::clamp(turbidity, 1.7f, 10.0f);
        const float theta = std::acos(std::clamp(toSun.y, 0.0f, 1.0f)); // a sun that set stays low
        const Perez perezY{0.1787f * t - 1.4630f, -0.3554f * t + 0.4275f, -0.0227f * t + 5.3251f,
                           0.1206f * t - 2.5771f, -0.0670f * t + 0.3703f};
        const Perez perezx{-0.0193f * t - 0.2592f, -0.0665f * t + 0.0008f, -0.0004f * t + 0.2125f,
                           -0.0641f * t - 0.8989f, -0.0033f * t + 0.0452f};
        const Perez perezy{-0.0167f * t - 0.2608f, -0.0950f * t + 0.0092f, -0.0079f * t + 0.2102f,
                           -0.0441f * t - 1.6537f, -0.0109f * t + 0.0529f};
        const float chi = (4.0f / 9.0f - t / 120) * (kPi - 2 * theta);
        const float zenithY = (4.0453f * t - 4.9710f) * std::tan(chi) - 0.2155f * t + 2.4192f;
        const float zenithx =
            (cubic(theta, 0.00166f, -0.00375f, 0.00209f, 0) * t +
             cubic(theta, -0.02903f, 0.06377f, -0.03202f, 0.00394f)) * t +
            cubic(theta, 0.11693f, -0.21196f, 0.06052f, 0.25886f);
        const float zenithy =
            (cubic(theta, 0.00275f, -0.00610f, 0.00317f, 0) * t +
             cubic(theta, -0.04214f, 0.08970f, -0.04153f, 0.00516f)) * t +
            cubic(theta, 0.15346f, -0.26756f, 0.06670f, 0.26688f);

        const float cosine = std::max(height, 0.01f); // the formula has a pole at the horizon
        const auto of = [&](const Perez& perez, float zenith) {
            return zenith * perez(cosine, gamma) / perez(1.0f, theta);
        };
        return toRgb(of(perezx, zenithx), of(perezy, zenithy),
                     std::max(of(perezY, zenithY), 0.0f)) * scale;
    }
};

} // namespace

OPENRT_PLUGIN(Sky, "Sky")

// SPDX-License-Identifier: MIT
// A shader package: a rendering object and the surfaces that go with it, in one library. All light
// that reaches a point counts, also what comes from other surfaces (Kajiya, "The Rendering
// Equation", 1986).
//
// The rendering object follows many paths from the camera for each pixel and takes their mean.
// A surface adds the light that comes directly from the lights, and, where c.indirect() says that
// a path is under way, what one ray in a random direction brings. The recursion limit ends paths:
// set rtRecursionLimit to the number of times that light may bounce.
#include <cmath>

#include "openrt/plugin.hpp"

namespace {

using namespace openrt;

struct Paths {
    int paths = 16; ///< for each sample that rtSamples asks for

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<int>("paths", PER_SHADER, offsetof(Paths, paths));
    }
    Color renderPixel(PixelContext& pixel) const {
        const RTuint count = pixel.samples() * RTuint(paths > 0 ? paths : 1);
        Color sum;
        for (RTuint i = 0; i < count; ++i) {
            const Vec4 rgba = pixel.tracePath(pixel.samplePosition(i, count));
            sum += Color(rgba.x, rgba.y, rgba.z);
        }
        return sum / float(count);
    }
};

/// A direction of a ball around the normal's tip, evenly spread over its surface: over the plane
/// its density is proportional to the cosine.
Vec3 onSphere(TraceContext& c) {
    const float height = 1 - 2 * c.random();
    const float angle = 6.28318531f * c.random();
    const float radius = std::sqrt(std::fmax(1 - height * height, 0.0f));
    return {radius * std::cos(angle), radius * std::sin(angle), height};
}

Color directLight(TraceContext& c) {
    Color sum;
    for (RTuint i = 0; i < c.lightCount(); ++i) {
        LightSample light{};
        if (!c.illuminate(i, light)) continue;
        const float cosine = dot(c.facingNormal(), light.direction);
        if (!(cosine > 0)) continue;
        const Color open = c.shadow(c.position(), light.direction, light.distance);
        sum += light.radiance * open * cosine;
    }
    return sum;
}

/// Reflects the same in all directions.
struct Matte {
    Color color{0.7f};

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<Color>("color", PER_SHADER, offsetof(Matte, color));
    }
    void shade(TraceContext& c) const {
        Color light = directLight(c);
        if (c.indirect()) {
            // The density of the direction and the surface's cosine cancel.
            const Vec3 direction = c.facingNormal() + onSphere(c);
            if (dot(direction, c.facingGeometricNormal()) > 0)
                light += c.trace(c.position(), direction, color.largest());
        }
        c.setRadiance(color * light);
    }
};

/// Reflects around the mirrored direction; the rougher the wider. What light sources it shows,
/// its rays have to meet: it asks no light.
struct Metal {
    Color color{0.9f, 0.8f, 0.6f};
    float roughness = 0.1f;

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<Color>("color", PER_SHADER, offsetof(Metal, color));
        r.registerParam<float>("roughness", PER_SHADER, offsetof(Metal, roughness));
    }
    void shade(TraceContext& c) const {
        Vec3 direction = c.reflectedDirection();
        if (c.indirect()) direction += onSphere(c) * roughness;
        if (dot(direction, c.facingGeometricNormal()) > 0)
            c.setRadiance(color * c.trace(c.position(), direction, color.largest()));
    }
};

/// Shines, on its front.
struct Emitter {
    Color radiance{5.0f};

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<Color>("radiance", PER_SHADER, offsetof(Emitter, radiance));
    }
    void shade(TraceContext& c) const {
        c.setRadiance(c.frontFace() ? radiance : Color());
    }
};

} // namespace

OPENRT_PLUGIN(Paths, "PathTracer")
OPENRT_PLUGIN(Matte, "Matte")
OPENRT_PLUGIN(Metal, "Metal")
OPENRT_PLUGIN(Emitter, "Emitter")

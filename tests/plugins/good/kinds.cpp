// SPDX-License-Identifier: MIT
// A shader package: a class of each kind, with results that are easy to foretell. Compiled from
// the headers of today and from the frozen ones.
#include <openrt/plugin.hpp>

namespace {

using namespace openrt;

/// A matt surface with parameters of all scopes: color * gain * heat * light.
struct Matt {
    Color color{1, 1, 1};
    struct TriangleParam {
        float gain = 1;
    };
    struct VertexParam {
        float heat = 1;
    };
    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<Color>("color", PER_SHADER, offsetof(Matt, color));
        r.registerParam<float>("gain", PER_TRIANGLE, offsetof(TriangleParam, gain));
        r.registerParam<float>("heat", PER_VERTEX, offsetof(VertexParam, heat));
    }
    void shade(TraceContext& c) const {
        Color sum;
        for (RTuint i = 0; i < c.lightCount(); ++i) {
            LightSample light{};
            if (!c.illuminate(i, light)) continue;
            const float cosine = dot(c.facingNormal(), light.direction);
            if (cosine > 0)
                sum += light.radiance * cosine *
                       c.shadow(c.position(), light.direction, light.distance);
        }
        c.setRadiance(color * sum * c.triangleParam<TriangleParam>().gain *
                      c.vertexParam<VertexParam>().heat);
    }
    Color transparency(TraceContext&) const { return {0, 0, 1}; }
};

/// Parallel light along -z.
struct Beam {
    Color radiance{1, 1, 1};
    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<Color>("radiance", PER_SHADER, offsetof(Beam, radiance));
    }
    bool illuminate(const Vec3&, Vec3& direction, float& distance, Color& arriving) const {
        direction = {0, 0, 1};
        distance = std::numeric_limits<float>::infinity();
        arriving = radiance;
        return true;
    }
};

struct Backdrop {
    static constexpr ShaderKind kind = ShaderKind::Environment;
    Color color{1, 1, 1};
    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<Color>("color", PER_SHADER, offsetof(Backdrop, color));
    }
    void shade(TraceContext& c) const { c.setRadiance(color * -c.rayDirection().z); }
};

/// Looks along -z at the square from -1 to 1.
struct Slide {
    void initPrimaryRay(float x, float y, TraceContext& c) const {
        c.setRay({2 * x - 1, 2 * y - 1, 5}, {0, 0, -2});
    }
};

/// Half of what the centre of the pixel shows.
struct Dimmer {
    Color renderPixel(PixelContext& c) const {
        const Vec4 seen = c.trace(c.samplePosition(0, 1));
        return Color(seen.x, seen.y, seen.z) * 0.5f;
    }
};

OPENRT_PLUGIN(Matt, "Matt")
OPENRT_PLUGIN(Beam, "Beam");
OPENRT_PLUGIN(Backdrop, "Backdrop")
OPENRT_PLUGIN(Slide, "Slide")

} // namespace

OPENRT_PLUGIN(Dimmer, "Dimmer")

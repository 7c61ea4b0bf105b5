// SPDX-License-Identifier: MIT
// Marble: veins as in Perlin, "An Image Synthesizer" (1985): a wave along x that noise of several
// frequencies has pushed aside. Solid in world space, lit with shadows.
//
// `shade` is a template of its context and serves one point or a packet of sixteen. Only the noise
// is written for numbers alone; a line each gives it to the lanes of a packet.
#include <cmath>

#include "openrt/plugin.hpp"

namespace {

using namespace openrt;

/// A scrambled number for each cell of the lattice.
unsigned hash(int x, int y, int z) {
    unsigned h = unsigned(x) * 0x8DA6B343u ^ unsigned(y) * 0xD8163841u ^ unsigned(z) * 0xCB1AB31Fu;
    h = (h ^ h >> 16) * 0x7FEB352Du;
    h = (h ^ h >> 15) * 0x846CA68Bu;
    return h ^ h >> 16;
}

/// Product of the offset and one of the twelve directions to a cube's edges.
float gradient(unsigned h, float x, float y, float z) {
    const float u = (h & 8u) != 0 ? y : x;
    const float v = (h & 12u) == 0 ? y : (h & 13u) == 12u ? x : z;
    return ((h & 1u) != 0 ? -u : u) + ((h & 2u) != 0 ? -v : v);
}

/// The cell that holds a coordinate. Beyond a thousand million there is no fraction left to vary.
int cellOf(float floored) {
    return std::fabs(floored) < 1e9f ? int(floored) : 0;
}

float mix(float a, float b, float share) {
    return a + (b - a) * share;
}

/// Gradient noise (Perlin, "Improving Noise", 2002), about -1 to 1.
float noise(float x, float y, float z) {
    const float fx = std::floor(x), fy = std::floor(y), fz = std::floor(z);
    const int i = cellOf(fx), j = cellOf(fy), k = cellOf(fz);
    x -= fx, y -= fy, z -= fz;
    const auto ease = [](float t) { return t * t * t * (t * (t * 6 - 15) + 10); };
    const float u = ease(x), v = ease(y), w = ease(z);
    const auto edge = [&](int dj, int dk) {
        const float b = y - float(dj), c = z - float(dk);
        return mix(gradient(hash(i, j + dj, k + dk), x, b, c),
                   gradient(hash(i + 1, j + dj, k + dk), x - 1, b, c), u);
    };
    return mix(mix(edge(0, 0), edge(1, 0), v), mix(edge(0, 1), edge(1, 1), v), w);
}

struct Marble {
    Color light{0.90f, 0.88f, 0.84f}, dark{0.22f, 0.20f, 0.26f};
    float veins = 4;      ///< in a unit of length
    float turbulence = 1; ///< how far veins stray, in their own width
    float ambient = 0.1f;

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<Color>("light", PER_SHADER, offsetof(Marble, light));
        r.registerParam<Color>("dark", PER_SHADER, offsetof(Marble, dark));
        r.registerParam<float>("veins", PER_SHADER, offsetof(Marble, veins));
        r.registerParam<float>("turbulence", PER_SHADER, offsetof(Marble, turbulence));
        r.registerParam<float>("ambient", PER_SHADER, offsetof(Marble, ambient));
    }

    /// Share of the dark colour at a point: of one, and of each lane.
    float vein(float x, float y, float z) const {
        float pushed = 0, size = 1;
        for (int octave = 0; octave < 5; ++octave, size *= 2)
            pushed += std::fabs(noise(x * size, y * size, z * size)) / size;
        const float wave = std::fabs(std::sin(1.5707963f * (x + turbulence * 2 * pushed)));
        return (1 - wave) * (1 - wave);
    }
    Floats vein(const Floats& x, const Floats& y, const Floats& z) const {
        return forEachLane([this](float a, float b, float c) { return vein(a, b, c); }, x, y, z);
    }

    static constexpr RTuint reads() {
        return READS_FACING_NORMAL | READS_LIGHTS | READS_TRACE;
    }
    static constexpr bool shadesPackets = true;
    template <class Context>
    void shade(Context& c) const {
        const auto p = c.position() * veins;
        const auto share = vein(p.x, p.y, p.z);
        const typename Context::Color stone = light * (1.0f - share) + dark * share;

        typename Context::Color sum = stone * ambient;
        for (RTuint i = 0; i < c.lightCount(); ++i) {
            typename Context::LightSample l{};
            auto lit = c.illuminate(i, l);
            const auto cosine = dot(c.facingNormal(), l.direction);
            lit = lit & (cosine > 0.0f);
            if (!any(lit)) continue;
            const auto open = c.shadow(c.position(), l.direction, l.distance, lit);
            sum = select(lit, sum + stone * l.radiance * open * cosine, sum);
        }
        c.setRadiance(sum);
    }
};

} // namespace

OPENRT_PLUGIN(Marble, "Marble")

// SPDX-License-Identifier: MIT
// Measured values on a surface: a number given with each vertex is shown as a colour, and triangles
// can be marked. Unlit, so that colours can be read off.
//
//     rtParameter1f(heat, 21.5f); rtVertex3f(...);       per vertex, interpolated
//     rtParameter1i(mark, 1);     rtVertex3f(...);       per triangle: as its last vertex is given
#include "openrt/plugin.hpp"

namespace {

using namespace openrt;

struct Heat {
    struct VertexParam {
        float heat = 0;
    };
    struct TriangleParam {
        int mark = 0;
    };
    float low = 0, high = 1; ///< shown black and white; between them red, then yellow
    Color marked{0.0f, 0.2f, 0.8f};

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<float>("low", PER_SHADER, offsetof(Heat, low));
        r.registerParam<float>("high", PER_SHADER, offsetof(Heat, high));
        r.registerParam<Color>("marked", PER_SHADER, offsetof(Heat, marked));
        r.registerParam<int>("mark", PER_TRIANGLE, offsetof(TriangleParam, mark));
        r.registerParam<float>("heat", PER_VERTEX, offsetof(VertexParam, heat));
    }

    static float clamped(float x) { return x < 0 ? 0.0f : x > 1 ? 1.0f : x; }

    void shade(TraceContext& c) const {
        const float heat = c.vertexParam<VertexParam>().heat;
        const float share = clamped((heat - low) / (high - low));
        const Color shown{clamped(3 * share), clamped(3 * share - 1), clamped(3 * share - 2)};
        const bool mark = c.triangleParam<TriangleParam>().mark != 0;
        c.setRadiance(mark ? (shown + marked) * 0.5f : shown);
    }
};

} // namespace

OPENRT_PLUGIN(Heat, "Heat")

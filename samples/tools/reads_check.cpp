// SPDX-License-Identifier: MIT
#include "samples/tools/reads_check.h"

#include <algorithm>

#include "samples/tools/answering_tracer.h"
#include "samples/tools/shaded_points.h"

namespace samples {
namespace {

constexpr int kPointsOfSetting = 256;

struct Value {
    RTuint bit;
    const char* name;
    void (*clear)(RTSstate& point);
};

template <auto... Members>
void clear(RTSstate& point) {
    const auto zero = [](auto& value) { value = {}; };
    const auto zeroAll = [&]<class T, std::size_t N>(T(&values)[N]) {
        for (T& value : values) zero(value);
    };
    const auto any = [&](auto& value) {
        if constexpr (requires { value[0]; })
            zeroAll(value);
        else
            zero(value);
    };
    (any(point.*Members), ...);
}

using S = RTSstate;
constexpr Value kValues[] = {
    {RTS_READS_RAY, "ray", clear<&S::rayOrigin, &S::rayDirection, &S::rayDistance>},
    {RTS_READS_POSITION, "position", clear<&S::position>},
    {RTS_READS_NORMAL, "normal", clear<&S::geometricNormal, &S::frontFace>},
    {RTS_READS_SHADING_NORMAL, "shading normal", clear<&S::shadingNormal>},
    {RTS_READS_RAW_NORMAL, "raw normal", clear<&S::rawNormal>},
    {RTS_READS_BARYCENTRIC, "barycentric coordinates", clear<&S::barycentric>},
    {RTS_READS_TEXCOORD, "texture coordinates", clear<&S::texCoord>},
    {RTS_READS_COLOR, "colour", clear<&S::color>},
    {RTS_READS_IDS, "ids", clear<&S::object, &S::instance, &S::primitive>},
    {RTS_READS_PIXEL, "pixel", clear<&S::pixel, &S::sample>},
    {RTS_READS_FOOTPRINT, "footprint", clear<&S::footprint, &S::texCoordDensity>}};

struct Answer {
    bool failed;
    RTSstate point;
};

Answer shaded(const RTshaderclass& shaderClass, const TestedShader& shader, RTSstate point,
              uint32_t seed) {
    AnsweringTracer tracer;
    tracer.seed[0] = seed;
    point.tracer = &tracer;
    const bool failed = shaderClass.shade(shader.bytes(), &point) != 0;
    return {failed, point};
}

bool same(const Answer& a, const Answer& b) {
    if (a.failed || b.failed) return a.failed == b.failed;
    if (!a.point.resultSet || !b.point.resultSet) return !a.point.resultSet == !b.point.resultSet;
    return std::equal(a.point.result, a.point.result + 4, b.point.result, sameNumber);
}

} // namespace

std::vector<std::string> undeclaredReads(const RTshaderclass& shaderClass) {
    if (!shaderClass.reads || !shaderClass.shade) return {};
    RTuint missing = 0;
    Random random(1);
    for (const bool varied : {false, true}) {
        TestedShader shader(shaderClass);
        if (varied) shader.vary(random);
        const RTuint reads = shaderClass.reads(shader.bytes());
        for (const RTuint flags : {0u, RTS_INDIRECT})
            for (int i = 0; i < kPointsOfSetting; ++i) {
                RTSstate point = randomPoint(random, false);
                point.flags = flags;
                point.triangleParam = shader.triangleBlock();
                point.vertexParam = shader.vertexBlock(i % RTS_PACKET_SIZE);
                const auto seed = uint32_t(random());
                const Answer whole = shaded(shaderClass, shader, point, seed);
                for (const Value& value : kValues) {
                    if ((reads | missing) & value.bit) continue;
                    RTSstate without = point;
                    value.clear(without);
                    if (!same(whole, shaded(shaderClass, shader, without, seed)))
                        missing |= value.bit;
                }
            }
    }
    std::vector<std::string> names;
    for (const Value& value : kValues)
        if (missing & value.bit) names.push_back(value.name);
    return names;
}

} // namespace samples

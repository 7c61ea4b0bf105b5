// SPDX-License-Identifier: MIT
#include "samples/tools/packet_check.h"

#include <cstdio>
#include <iterator>

#include "samples/tools/answering_tracer.h"
#include "samples/tools/shaded_points.h"

namespace samples {
namespace {

constexpr int kPacketsOfSetting = 64;

void put(RTSvectors& v, int i, const float xyz[3]) {
    v.x.lane[i] = xyz[0];
    v.y.lane[i] = xyz[1];
    v.z.lane[i] = xyz[2];
}

RTSpacket packetOf(const RTSstate (&points)[RTS_PACKET_SIZE], RTuint active) {
    RTSpacket p = {};
    p.structSize = sizeof p;
    p.active = active;
    p.functions = &answeringPacketFunctions();
    p.depth = points[0].depth;
    p.flags = points[0].flags;
    for (int i = 0; i < RTS_PACKET_SIZE; ++i) {
        const RTSstate& s = points[i];
        put(p.rayOrigin, i, s.rayOrigin);
        put(p.rayDirection, i, s.rayDirection);
        p.rayDistance.lane[i] = s.rayDistance;
        put(p.position, i, s.position);
        put(p.geometricNormal, i, s.geometricNormal);
        put(p.shadingNormal, i, s.shadingNormal);
        put(p.rawNormal, i, s.rawNormal);
        for (int k = 0; k < 3; ++k) p.barycentric[k].lane[i] = s.barycentric[k];
        for (int k = 0; k < 4; ++k) p.texCoord[k].lane[i] = s.texCoord[k];
        for (int k = 0; k < 4; ++k) p.color[k].lane[i] = s.color[k];
        p.frontFace |= s.frontFace << i;
        p.object.lane[i] = s.object;
        p.instance.lane[i] = s.instance;
        p.primitive.lane[i] = s.primitive;
        p.weight.lane[i] = s.weight;
        p.triangleParam[i] = s.triangleParam;
        p.vertexParam[i] = s.vertexParam;
        p.pixel[0].lane[i] = s.pixel[0];
        p.pixel[1].lane[i] = s.pixel[1];
        p.sample.lane[i] = s.sample;
        p.footprint.lane[i] = s.footprint;
        p.texCoordDensity.lane[i] = s.texCoordDensity;
        p.result[3].lane[i] = 1;
    }
    return p;
}

class Comparison {
public:
    Comparison(const RTshaderclass& c, PacketVerdict& verdict) : class_(c), verdict_(verdict) {}

    void compare(const TestedShader& shader, Random& random, RTuint flags) {
        static constexpr RTuint kMasks[] = {0xFFFF, 0x0001, 0x8000, 0x00FF, 0xA5C3};
        const RTuint active = kMasks[random() % std::size(kMasks)];
        const RTuint depth = random() % 3;
        RTSstate points[RTS_PACKET_SIZE];
        AnsweringTracer ofLanes, ofPoints[RTS_PACKET_SIZE];
        for (int i = 0; i < RTS_PACKET_SIZE; ++i) {
            points[i] = randomPoint(random, class_.kind == RT_ENV_SHADER);
            points[i].flags = flags;
            points[i].depth = depth;
            points[i].triangleParam = shader.triangleBlock();
            points[i].vertexParam = shader.vertexBlock(i);
            points[i].tracer = &ofPoints[i];
            ofLanes.seed[i] = ofPoints[i].seed[0] = uint32_t(random());
        }
        RTSpacket packet = packetOf(points, active);
        packet.tracer = &ofLanes;
        const bool packetFailed = class_.shadePacket(shader.bytes(), &packet) != 0;
        bool anyFailed = false;
        for (int i = 0; i < RTS_PACKET_SIZE; ++i)
            if (active >> i & 1u) anyFailed |= class_.shade(shader.bytes(), &points[i]) != 0;
        for (int i = 0; i < RTS_PACKET_SIZE; ++i) {
            if (!(active >> i & 1u)) continue;
            ++verdict_.points;
            if (packetFailed != anyFailed) {
                differ("one of the forms fails where the other does not");
            } else if (!packetFailed) {
                comparePoint(points[i], packet, i);
            }
        }
    }

private:
    void comparePoint(const RTSstate& point, const RTSpacket& packet, int lane) {
        if ((point.resultSet != 0) != ((packet.resultSet >> lane & 1u) != 0)) {
            differ("one of the forms sets no radiance where the other does");
            return;
        }
        for (int k = 0; k < 4; ++k) {
            const float alone = point.result[k], together = packet.result[k].lane[lane];
            if (sameNumber(alone, together)) continue;
            char text[96];
            std::snprintf(text, sizeof text, "%s is %.9g for the point, %.9g in the packet",
                          k == 3   ? "alpha"
                          : k == 2 ? "blue"
                          : k == 1 ? "green"
                                   : "red",
                          double(alone), double(together));
            differ(text);
            return;
        }
    }
    void differ(const std::string& how) {
        if (verdict_.different++ == 0) verdict_.example = how;
    }

    const RTshaderclass& class_;
    PacketVerdict& verdict_;
};

} // namespace

PacketVerdict checkPackets(const RTshaderclass& shaderClass) {
    PacketVerdict verdict;
    Comparison comparison(shaderClass, verdict);
    Random random(1);
    for (const bool varied : {false, true}) {
        TestedShader shader(shaderClass);
        if (varied) shader.vary(random);
        for (const RTuint flags : {0u, RTS_INDIRECT})
            for (int i = 0; i < kPacketsOfSetting; ++i) comparison.compare(shader, random, flags);
    }
    return verdict;
}

} // namespace samples

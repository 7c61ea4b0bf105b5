// SPDX-License-Identifier: MIT
#include "samples/tools/packet_check.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <limits>
#include <memory>
#include <new>
#include <random>
#include <stdexcept>

#include "openrt/rts_packet.h"
#include "samples/tools/answering_tracer.h"

namespace samples {
namespace {

constexpr int kPacketsOfSetting = 64;
constexpr std::size_t kLargestAlignment = 64;

using Random = std::mt19937;

float between(Random& random, float low, float high) {
    return low + (high - low) * float(random() >> 8) * 0x1p-24f;
}

struct AlignedDelete {
    void operator()(std::byte* p) const {
        ::operator delete(p, std::align_val_t(kLargestAlignment));
    }
};

std::unique_ptr<std::byte, AlignedDelete> block(std::size_t size) {
    void* const memory = ::operator new(size + 1, std::align_val_t(kLargestAlignment));
    std::memset(memory, 0, size + 1);
    return std::unique_ptr<std::byte, AlignedDelete>(static_cast<std::byte*>(memory));
}

/// Floats of a scope become others near them; switches that are off, and textures, go on.
void vary(const RTshaderclass& shaderClass, RTSscope scope, std::byte* bytes, Random& random) {
    for (RTuint i = 0; i < shaderClass.parameterCount; ++i) {
        const RTSparameter& p = shaderClass.parameters[i];
        if (p.scope != scope) continue;
        if (p.type >= RTS_FLOAT1 && p.type <= RTS_FLOAT4) {
            for (RTuint at = p.offset; at < p.offset + p.size; at += sizeof(float)) {
                float value = 0;
                std::memcpy(&value, bytes + at, sizeof value);
                value *= between(random, 0.5f, 1.0f);
                std::memcpy(bytes + at, &value, sizeof value);
            }
        } else if (p.type == RTS_INT1 &&
                   std::all_of(bytes + p.offset, bytes + p.offset + p.size,
                               [](std::byte b) { return b == std::byte(0); })) {
            const RTint one = 1;
            std::memcpy(bytes + p.offset, &one, std::min<std::size_t>(p.size, sizeof one));
        }
    }
}

/// A shader of the class and the blocks of its points.
class Shader {
public:
    explicit Shader(const RTshaderclass& c)
        : class_(c), shader_(block(c.shaderSize)), triangle_(block(c.triangleSize)) {
        for (auto& vertex : vertices_) {
            vertex = block(c.vertexSize);
            // One of them is the shader; the others are made for their vertices' sake.
            const bool first = vertex == vertices_[0];
            void* const place = c.shaderSize == 0 ? nullptr : first ? shader_.get() : scratch();
            if (c.construct(place, triangleBlock(), c.vertexSize ? vertex.get() : nullptr) != 0)
                throw std::runtime_error("the constructor failed");
            if (!first && c.destroy) c.destroy(place);
        }
    }
    ~Shader() {
        if (class_.destroy) class_.destroy(shader_.get());
    }
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;

    void vary(Random& random) {
        samples::vary(class_, RTS_PER_SHADER, shader_.get(), random);
        samples::vary(class_, RTS_PER_TRIANGLE, triangle_.get(), random);
        for (auto& vertex : vertices_) samples::vary(class_, RTS_PER_VERTEX, vertex.get(), random);
    }
    const void* bytes() const { return shader_.get(); }
    void* triangleBlock() const { return class_.triangleSize ? triangle_.get() : nullptr; }
    const void* vertexBlock(int lane) const {
        return class_.vertexSize ? vertices_[lane].get() : nullptr;
    }

private:
    std::byte* scratch() {
        if (!scratch_) scratch_ = block(class_.shaderSize);
        return scratch_.get();
    }

    const RTshaderclass& class_;
    std::unique_ptr<std::byte, AlignedDelete> shader_, triangle_, scratch_;
    std::unique_ptr<std::byte, AlignedDelete> vertices_[RTS_PACKET_SIZE];
};

void randomDirection(Random& random, float v[3]) {
    float squared = 0;
    do {
        squared = 0;
        for (int k = 0; k < 3; ++k) {
            v[k] = between(random, -1, 1);
            squared += v[k] * v[k];
        }
    } while (squared > 1 || squared < 0.01f);
    for (int k = 0; k < 3; ++k) v[k] /= std::sqrt(squared);
}

/// A point as the library could hand it out.
RTSstate randomPoint(Random& random, bool environment) {
    RTSstate s = {};
    s.functions = &answeringFunctions();
    randomDirection(random, s.rayDirection);
    for (float& x : s.rayOrigin) x = between(random, -4, 4);
    s.rayDistance = environment ? std::numeric_limits<float>::infinity() : between(random, 0.1f, 9);
    for (int k = 0; k < 3; ++k)
        s.position[k] = environment ? 0 : s.rayOrigin[k] + s.rayDistance * s.rayDirection[k];
    randomDirection(random, s.geometricNormal);
    float length = 0, facing = 0;
    for (int k = 0; k < 3; ++k) {
        s.rawNormal[k] = s.geometricNormal[k] + between(random, -0.5f, 0.5f);
        length += s.rawNormal[k] * s.rawNormal[k];
        facing += s.geometricNormal[k] * s.rayDirection[k];
    }
    for (int k = 0; k < 3; ++k) s.shadingNormal[k] = s.rawNormal[k] / std::sqrt(length);
    s.frontFace = facing < 0;
    s.barycentric[1] = between(random, 0, 1);
    s.barycentric[2] = between(random, 0, 1 - s.barycentric[1]);
    s.barycentric[0] = 1 - s.barycentric[1] - s.barycentric[2];
    for (float& x : s.texCoord) x = between(random, -2, 2);
    for (float& x : s.color) x = between(random, 0, 1);
    s.object = random() % 4;
    s.instance = random() % 4;
    s.primitive = random() % 64;
    s.weight = between(random, 0.1f, 1);
    s.pixel[0] = random() % 640;
    s.pixel[1] = random() % 480;
    s.sample = random() % 4;
    s.result[3] = 1;
    s.footprint = between(random, 0, 0.1f);
    s.texCoordDensity = between(random, 0, 2);
    return s;
}

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

/// NaN is NaN, whichever.
bool sameNumber(float a, float b) {
    return std::bit_cast<uint32_t>(a) == std::bit_cast<uint32_t>(b) ||
           (std::isnan(a) && std::isnan(b));
}

class Comparison {
public:
    Comparison(const RTshaderclass& c, PacketVerdict& verdict) : class_(c), verdict_(verdict) {}

    void compare(const Shader& shader, Random& random, RTuint flags) {
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
            if (active >> i & 1u)
                anyFailed |= class_.shade(shader.bytes(), &points[i]) != 0;
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
        Shader shader(shaderClass);
        if (varied) shader.vary(random);
        for (const RTuint flags : {0u, RTS_INDIRECT})
            for (int i = 0; i < kPacketsOfSetting; ++i) comparison.compare(shader, random, flags);
    }
    return verdict;
}

} // namespace samples

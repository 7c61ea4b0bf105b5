// SPDX-License-Identifier: MIT
#include "samples/tools/shaded_points.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <new>
#include <stdexcept>

#include "samples/tools/answering_tracer.h"

namespace samples {
namespace {

constexpr std::size_t kLargestAlignment = 64;

float between(Random& random, float low, float high) {
    return low + (high - low) * float(random() >> 8) * 0x1p-24f;
}

std::unique_ptr<std::byte, AlignedDelete> block(std::size_t size) {
    void* const memory = ::operator new(size + 1, std::align_val_t(kLargestAlignment));
    std::memset(memory, 0, size + 1);
    return std::unique_ptr<std::byte, AlignedDelete>(static_cast<std::byte*>(memory));
}

void varyBlock(const RTshaderclass& shaderClass, RTSscope scope, std::byte* bytes, Random& random) {
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

} // namespace

void AlignedDelete::operator()(std::byte* p) const {
    ::operator delete(p, std::align_val_t(kLargestAlignment));
}

TestedShader::TestedShader(const RTshaderclass& c)
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

TestedShader::~TestedShader() {
    if (class_.destroy) class_.destroy(shader_.get());
}

void TestedShader::vary(Random& random) {
    varyBlock(class_, RTS_PER_SHADER, shader_.get(), random);
    varyBlock(class_, RTS_PER_TRIANGLE, triangle_.get(), random);
    for (auto& vertex : vertices_) varyBlock(class_, RTS_PER_VERTEX, vertex.get(), random);
}

std::byte* TestedShader::scratch() {
    if (!scratch_) scratch_ = block(class_.shaderSize);
    return scratch_.get();
}

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

bool sameNumber(float a, float b) {
    return std::bit_cast<uint32_t>(a) == std::bit_cast<uint32_t>(b) ||
           (std::isnan(a) && std::isnan(b));
}

} // namespace samples

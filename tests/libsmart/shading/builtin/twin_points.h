// SPDX-License-Identifier: MIT
// The same random points for a shader's scalar and its packet form, with services whose answers
// are hashes of all bits that they are asked about: a difference in the last place of a direction,
// or one random number more, changes the colour beyond recognition.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <random>
#include <vector>

#include "openrt/rts.h"
#include "openrt/rts_packet.h"

namespace smart::test {

inline uint64_t hashOf(uint64_t seed, std::initializer_list<float> values) {
    const auto mixed = [](uint64_t z) {
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
        return z ^ (z >> 31);
    };
    uint64_t hash = mixed(seed + 0x9E3779B97F4A7C15u);
    for (const float value : values) hash = mixed(hash ^ std::bit_cast<uint32_t>(value));
    return hash;
}

/// What the library answers about one point. Tracing draws a random number, as further surfaces do.
struct PointServices {
    uint64_t seed = 0;
    uint64_t drawn = 0;

    static float unit(uint64_t hash) { return float(hash >> 40) * 0x1p-24f; }
    static std::array<float, 3> color(uint64_t hash) {
        return {float(hash & 0xFF) / 128, float(hash >> 8 & 0xFF) / 128,
                float(hash >> 16 & 0xFF) / 128};
    }
    float random() { return unit(hashOf(seed + ++drawn * 77, {})); }
    bool trace(const float o[3], const float d[3], float weight, float (&radiance)[3]) {
        const uint64_t hash = hashOf(1, {o[0], o[1], o[2], d[0], d[1], d[2], weight, random()});
        const auto answer = color(hash);
        std::copy_n(answer.begin(), 3, radiance);
        return hash >> 60 != 0;
    }
    static void shadow(const float o[3], const float d[3], float distance,
                       float (&attenuation)[3]) {
        const uint64_t hash = hashOf(2, {o[0], o[1], o[2], d[0], d[1], d[2], distance});
        const auto answer = color(hash);
        for (std::size_t k = 0; k < 3; ++k)
            attenuation[k] = hash >> 62 == 0 ? 0.0f : answer[k] / 2;
    }
    /// Every second light has an extent.
    bool illuminate(RTuint light, const float at[3], RTSlightsample& sample) {
        const float number = light % 2 ? random() : 0.0f;
        const uint64_t hash = hashOf(3 + light, {at[0], at[1], at[2], number});
        double d[3], squared = 0;
        for (int k = 0; k < 3; ++k) {
            d[k] = double(hash >> (16 * k) & 0xFFFF) / 32768 - 1 + 1e-3;
            squared += d[k] * d[k];
        }
        const auto radiance = color(hash >> 24);
        for (std::size_t k = 0; k < 3; ++k) {
            sample.direction[k] = float(d[k] / std::sqrt(squared));
            sample.radiance[k] = radiance[k];
        }
        sample.distance = hash >> 63 ? std::numeric_limits<float>::infinity() : 3.0f;
        return hash >> 61 != 0;
    }
    static void texture(RTuint id, float s, float t, float (&rgba)[4]) {
        const auto answer = color(hashOf(40 + id, {s, t}));
        std::copy_n(answer.begin(), 3, rgba);
        rgba[3] = answer[0] / 2;
    }
    static void environment(const float d[3], float (&radiance)[3]) {
        const auto answer = color(hashOf(5, {d[0], d[1], d[2]}));
        std::copy_n(answer.begin(), 3, radiance);
    }
};

constexpr RTuint kTwinLights = 3;

/// A packet of random points. Lanes that are not active hold NaN.
class TwinPoints {
public:
    RTSpacket packet{};
    std::array<RTSstate, RTS_PACKET_SIZE> states{};
    std::array<PointServices, RTS_PACKET_SIZE> ofPacket, ofStates;

    TwinPoints(uint32_t seed, RTuint active, RTuint flags) : random_(seed) {
        packet.structSize = sizeof(RTSpacket);
        packet.active = active;
        packet.functions = packetFunctions();
        packet.tracer = this;
        packet.flags = flags;
        packet.depth = 1;
        for (std::size_t lane = 0; lane < RTS_PACKET_SIZE; ++lane) fill(lane, seed, flags);
    }
    TwinPoints(const TwinPoints&) = delete;

private:
    float number(float low, float high) {
        return std::uniform_real_distribution<float>(low, high)(random_);
    }
    void direction(float (&v)[3]) {
        double d[3], squared = 0;
        for (double& x : d) x = number(-1, 1), squared += x * x;
        for (int k = 0; k < 3; ++k) v[k] = float(d[k] / std::sqrt(squared));
    }
    void fill(std::size_t lane, uint32_t seed, RTuint flags) {
        RTSstate& s = states[lane];
        ofPacket[lane].seed = ofStates[lane].seed = seed * 64 + lane;
        s.functions = functions();
        s.tracer = &ofStates[lane];
        s.flags = flags;
        s.depth = 1;
        for (int k = 0; k < 3; ++k) s.position[k] = number(-9, 9), s.rayOrigin[k] = number(-9, 9);
        direction(s.rayDirection);
        direction(s.geometricNormal);
        s.rayDistance = number(0, 4);
        float along = 0;
        double squared = 0;
        for (int k = 0; k < 3; ++k) {
            s.rawNormal[k] = s.geometricNormal[k] + number(-0.7f, 0.7f);
            squared += double(s.rawNormal[k]) * s.rawNormal[k];
            along += s.rayDirection[k] * s.geometricNormal[k];
        }
        const double side = lane % 5 == 3 ? -1 : 1; // some meshes have their normals turned
        for (int k = 0; k < 3; ++k)
            s.shadingNormal[k] = float(side * s.rawNormal[k] / std::sqrt(squared));
        s.frontFace = along <= 0;
        for (float& x : s.texCoord) x = number(-1, 2);
        for (float& x : s.color) x = number(0, 1);
        s.weight = lane % 3 ? number(0.02f, 1) : 1.0f;
        s.result[3] = 1;
        const bool on = packet.active >> lane & 1u;
        const auto put = [&](RTSfloats& to, float value) {
            to.lane[lane] = on ? value : std::numeric_limits<float>::quiet_NaN();
        };
        const auto putVector = [&](RTSvectors& to, const float (&v)[3]) {
            put(to.x, v[0]), put(to.y, v[1]), put(to.z, v[2]);
        };
        putVector(packet.rayOrigin, s.rayOrigin);
        putVector(packet.rayDirection, s.rayDirection);
        put(packet.rayDistance, s.rayDistance);
        putVector(packet.position, s.position);
        putVector(packet.geometricNormal, s.geometricNormal);
        putVector(packet.shadingNormal, s.shadingNormal);
        putVector(packet.rawNormal, s.rawNormal);
        for (int k = 0; k < 4; ++k) {
            put(packet.texCoord[k], s.texCoord[k]);
            put(packet.color[k], s.color[k]);
            packet.result[k].lane[lane] = k == 3;
        }
        packet.frontFace |= s.frontFace << lane;
        put(packet.weight, s.weight);
    }

    static PointServices& of(const RTSstate* s) { return *static_cast<PointServices*>(s->tracer); }
    static const RTSfunctions* functions() {
        static const RTSfunctions table = {
            sizeof(RTSfunctions),
            [](RTSstate* s, const float o[3], const float d[3], float weight, float rgb[3]) {
                float answer[3];
                const bool traced = of(s).trace(o, d, weight, answer);
                std::copy_n(answer, 3, rgb);
                return int(traced);
            },
            [](RTSstate*, const float*, const float*, RTShitinfo*) { return 0; },
            [](RTSstate*, const float o[3], const float d[3], float distance, float rgb[3]) {
                float answer[3];
                PointServices::shadow(o, d, distance, answer);
                std::copy_n(answer, 3, rgb);
                return 1;
            },
            [](const RTSstate*) { return kTwinLights; },
            [](RTSstate* s, RTuint light, RTSlightsample* sample) {
                return int(of(s).illuminate(light, s->position, *sample));
            },
            [](RTSstate*, RTuint id, float u, float v, float rgba[4]) {
                float answer[4];
                PointServices::texture(id, u, v, answer);
                std::copy_n(answer, 4, rgba);
            },
            [](RTSstate*, const float d[3], float rgb[3]) {
                float answer[3];
                PointServices::environment(d, answer);
                std::copy_n(answer, 3, rgb);
            },
            [](RTSstate* s) { return of(s).random(); }};
        return &table;
    }

    static TwinPoints& of(const RTSpacket* p) { return *static_cast<TwinPoints*>(p->tracer); }
    static std::array<float, 3> at(const RTSvectors& v, std::size_t lane) {
        return {v.x.lane[lane], v.y.lane[lane], v.z.lane[lane]};
    }
    template <class Function>
    static RTuint forLanes(RTuint lanes, Function&& function) {
        RTuint answered = 0;
        for (std::size_t lane = 0; lane < RTS_PACKET_SIZE; ++lane)
            if (lanes >> lane & 1u) answered |= RTuint(bool(function(lane))) << lane;
        return answered;
    }
    static void put(RTScolors& to, std::size_t lane, const float (&rgb)[3]) {
        to.r.lane[lane] = rgb[0];
        to.g.lane[lane] = rgb[1];
        to.b.lane[lane] = rgb[2];
    }
    static const RTSpacketfunctions* packetFunctions() {
        static const RTSpacketfunctions table = {
            sizeof(RTSpacketfunctions),
            [](RTSpacket* p, RTuint lanes, const RTSvectors* o, const RTSvectors* d,
               const RTSfloats* weight, RTScolors* radiance) {
                return forLanes(lanes, [&](std::size_t lane) {
                    float answer[3];
                    const bool traced = of(p).ofPacket[lane].trace(
                        at(*o, lane).data(), at(*d, lane).data(), weight->lane[lane], answer);
                    put(*radiance, lane, answer);
                    return traced;
                });
            },
            [](RTSpacket*, RTuint, const RTSvectors*, const RTSvectors*, RTShitpacket*) {
                return 0u;
            },
            [](RTSpacket*, RTuint lanes, const RTSvectors* o, const RTSvectors* d,
               const RTSfloats* distance, RTScolors* attenuation) {
                return forLanes(lanes, [&](std::size_t lane) {
                    float answer[3];
                    PointServices::shadow(at(*o, lane).data(), at(*d, lane).data(),
                                          distance->lane[lane], answer);
                    put(*attenuation, lane, answer);
                    return true;
                });
            },
            [](const RTSpacket*) { return kTwinLights; },
            [](RTSpacket* p, RTuint lanes, RTuint light, RTSlightpacket* samples) {
                return forLanes(lanes, [&](std::size_t lane) {
                    RTSlightsample s{};
                    const bool lit = of(p).ofPacket[lane].illuminate(
                        light, at(p->position, lane).data(), s);
                    samples->direction.x.lane[lane] = s.direction[0];
                    samples->direction.y.lane[lane] = s.direction[1];
                    samples->direction.z.lane[lane] = s.direction[2];
                    samples->distance.lane[lane] = s.distance;
                    put(samples->radiance, lane, s.radiance);
                    return lit;
                });
            },
            [](RTSpacket*, RTuint lanes, RTuint id, const RTSfloats* u, const RTSfloats* v,
               RTSfloats rgba[4]) {
                forLanes(lanes, [&](std::size_t lane) {
                    float answer[4];
                    PointServices::texture(id, u->lane[lane], v->lane[lane], answer);
                    for (int k = 0; k < 4; ++k) rgba[k].lane[lane] = answer[k];
                    return true;
                });
            },
            [](RTSpacket*, RTuint lanes, const RTSvectors* d, RTScolors* radiance) {
                forLanes(lanes, [&](std::size_t lane) {
                    float answer[3];
                    PointServices::environment(at(*d, lane).data(), answer);
                    put(*radiance, lane, answer);
                    return true;
                });
            },
            [](RTSpacket* p, RTuint lanes, RTSfloats* numbers) {
                forLanes(lanes, [&](std::size_t lane) {
                    numbers->lane[lane] = of(p).ofPacket[lane].random();
                    return true;
                });
            }};
        return &table;
    }

    std::mt19937 random_;
};

} // namespace smart::test

// SPDX-License-Identifier: MIT
#include "samples/tools/answering_tracer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <initializer_list>

namespace samples {
namespace {

/// A number from the bits of others.
class Hash {
public:
    explicit Hash(uint32_t kind) : state_(kind * 0x9E3779B9u + 1u) {}
    Hash& add(uint32_t bits) {
        state_ = (state_ ^ bits) * 0x85EBCA6Bu;
        state_ ^= state_ >> 13;
        state_ *= 0xC2B2AE35u;
        state_ ^= state_ >> 16;
        return *this;
    }
    Hash& add(float number) { return add(std::bit_cast<uint32_t>(number)); }
    Hash& add(std::initializer_list<float> numbers) {
        for (const float number : numbers) add(number);
        return *this;
    }
    /// In [0, 1); another one each time.
    float number() {
        add(0x1234567u);
        return float(state_ >> 8) * 0x1p-24f;
    }
    bool chance(float probability) { return number() < probability; }

private:
    uint32_t state_;
};

enum Kind : uint32_t { Trace = 1, TraceHit, Shadow, Illuminate, Texture, Environment, Random };

void unitVector(Hash& hash, float v[3]) {
    float squared = 0;
    do {
        squared = 0;
        for (int k = 0; k < 3; ++k) {
            v[k] = 2 * hash.number() - 1;
            squared += v[k] * v[k];
        }
    } while (squared > 1 || squared < 0.01f);
    for (int k = 0; k < 3; ++k) v[k] /= std::sqrt(squared);
}

/// One lane of three arrays.
struct Lane3 {
    Lane3(const RTSvectors& v, int i) : values{v.x.lane[i], v.y.lane[i], v.z.lane[i]} {}
    operator const float*() const { return values; }
    float values[3];
};

/// What the library itself reads of the point where a question is asked.
struct Asker {
    explicit Asker(const RTSstate& s)
        : position{s.position[0], s.position[1], s.position[2]},
          numbers{s.rayDirection[0],    s.rayDirection[1],    s.rayDirection[2],
                  s.geometricNormal[0], s.geometricNormal[1], s.geometricNormal[2]},
          footprint(s.footprint) {}
    Asker(const RTSpacket& p, int i)
        : position{p.position.x.lane[i], p.position.y.lane[i], p.position.z.lane[i]},
          numbers{p.rayDirection.x.lane[i],    p.rayDirection.y.lane[i],
                  p.rayDirection.z.lane[i],    p.geometricNormal.x.lane[i],
                  p.geometricNormal.y.lane[i], p.geometricNormal.z.lane[i]},
          footprint(p.footprint.lane[i]) {}
    bool isAt(const float o[3]) const { return std::equal(o, o + 3, position); }

    float position[3], numbers[6], footprint;
};

/// Rays that start at the asker leave its surface, on the side that they point to.
Hash rayHash(Kind kind, const Asker& asker, const float o[3], const float d[3]) {
    Hash hash(kind);
    hash.add({o[0], o[1], o[2], d[0], d[1], d[2]});
    if (asker.isAt(o))
        for (const float number : asker.numbers) hash.add(number);
    return hash;
}

bool answerTrace(const Asker& asker, const float o[3], const float d[3], float weight,
                 float radiance[3]) {
    Hash hash = rayHash(Trace, asker, o, d);
    hash.add(weight);
    if (hash.chance(0.125f)) return false; // the recursion limit
    for (int k = 0; k < 3; ++k) radiance[k] = hash.number();
    return true;
}
bool answerHit(const Asker& asker, const float o[3], const float d[3], RTShitinfo& hit) {
    Hash hash = rayHash(TraceHit, asker, o, d);
    hit = {};
    hit.distance = INFINITY;
    if (hash.chance(0.25f)) return true;
    hit.distance = 8 * hash.number();
    for (int k = 0; k < 3; ++k) hit.position[k] = 2 * hash.number() - 1;
    unitVector(hash, hit.normal);
    return true;
}
void answerShadow(const Asker& asker, const float o[3], const float d[3], float distance,
                  float attenuation[3]) {
    Hash hash = rayHash(Shadow, asker, o, d);
    hash.add(distance);
    const bool open = hash.chance(0.25f), closed = hash.chance(0.25f);
    for (int k = 0; k < 3; ++k) attenuation[k] = open ? 1 : closed ? 0 : hash.number();
}
bool answerLight(const float p[3], uint32_t light, RTSlightsample& sample) {
    Hash hash(Illuminate);
    hash.add({p[0], p[1], p[2]}).add(light);
    if (hash.chance(0.125f)) return false;
    unitVector(hash, sample.direction);
    sample.distance = hash.chance(0.25f) ? INFINITY : 8 * hash.number();
    for (int k = 0; k < 3; ++k) sample.radiance[k] = 3 * hash.number();
    return true;
}
void answerTexture(const Asker& asker, uint32_t texture, float s, float t, float rgba[4]) {
    Hash hash(Texture);
    hash.add(texture).add({s, t, asker.footprint});
    for (const float number : asker.numbers) hash.add(number);
    for (int k = 0; k < 4; ++k) rgba[k] = texture ? hash.number() : 1;
}
void answerEnvironment(const float d[3], float radiance[3]) {
    Hash hash(Environment);
    hash.add({d[0], d[1], d[2]});
    for (int k = 0; k < 3; ++k) radiance[k] = hash.number();
}
float answerRandom(void* tracer, int lane) {
    auto& t = *static_cast<AnsweringTracer*>(tracer);
    return Hash(Random).add(t.seed[lane]).add(t.drawn[lane]++).number();
}

int trace(RTSstate* s, const float o[3], const float d[3], float weight, float radiance[3]) {
    return (s->flags & RTS_STOPPED) == 0 && answerTrace(Asker(*s), o, d, weight, radiance);
}
int traceHit(RTSstate* s, const float o[3], const float d[3], RTShitinfo* hit) {
    return (s->flags & RTS_STOPPED) == 0 && answerHit(Asker(*s), o, d, *hit);
}
int shadow(RTSstate* s, const float o[3], const float d[3], float distance, float attenuation[3]) {
    answerShadow(Asker(*s), o, d, distance, attenuation);
    return 1;
}
RTuint lightCount(const RTSstate*) {
    return AnsweringTracer::kLights;
}
int illuminate(RTSstate* s, RTuint light, RTSlightsample* sample) {
    return answerLight(s->position, light, *sample);
}
void texture(RTSstate* state, RTuint id, float s, float t, float rgba[4]) {
    answerTexture(Asker(*state), id, s, t, rgba);
}
void environment(RTSstate*, const float d[3], float radiance[3]) {
    answerEnvironment(d, radiance);
}
float random(RTSstate* s) {
    return answerRandom(s->tracer, 0);
}

void store(const float v[3], int i, RTSfloats& x, RTSfloats& y, RTSfloats& z) {
    x.lane[i] = v[0];
    y.lane[i] = v[1];
    z.lane[i] = v[2];
}
/// Calls answer(lane) for the lanes of the mask; the lanes for which it says true.
template <class Answer>
RTuint forLanes(const RTSpacket* packet, RTuint lanes, Answer&& answer) {
    RTuint answered = 0;
    for (int i = 0; i < RTS_PACKET_SIZE; ++i)
        if ((lanes & packet->active) >> i & 1u) answered |= RTuint(bool(answer(i))) << i;
    return answered;
}

RTuint tracePacket(RTSpacket* p, RTuint lanes, const RTSvectors* o, const RTSvectors* d,
                   const RTSfloats* weight, RTScolors* radiance) {
    if (p->flags & RTS_STOPPED) return 0;
    return forLanes(p, lanes, [&](int i) {
        float rgb[3] = {0, 0, 0};
        const bool traced =
            answerTrace(Asker(*p, i), Lane3(*o, i), Lane3(*d, i), weight->lane[i], rgb);
        store(rgb, i, radiance->r, radiance->g, radiance->b);
        return traced;
    });
}
RTuint traceHitPacket(RTSpacket* p, RTuint lanes, const RTSvectors* o, const RTSvectors* d,
                      RTShitpacket* hits) {
    if (p->flags & RTS_STOPPED) return 0;
    return forLanes(p, lanes, [&](int i) {
        RTShitinfo hit;
        const bool traced = answerHit(Asker(*p, i), Lane3(*o, i), Lane3(*d, i), hit);
        hits->distance.lane[i] = hit.distance;
        store(hit.position, i, hits->position.x, hits->position.y, hits->position.z);
        store(hit.normal, i, hits->normal.x, hits->normal.y, hits->normal.z);
        hits->object.lane[i] = hit.object;
        hits->instance.lane[i] = hit.instance;
        hits->primitive.lane[i] = hit.primitive;
        return traced;
    });
}
RTuint shadowPacket(RTSpacket* p, RTuint lanes, const RTSvectors* o, const RTSvectors* d,
                    const RTSfloats* distance, RTScolors* attenuation) {
    return forLanes(p, lanes, [&](int i) {
        float rgb[3];
        answerShadow(Asker(*p, i), Lane3(*o, i), Lane3(*d, i), distance->lane[i], rgb);
        store(rgb, i, attenuation->r, attenuation->g, attenuation->b);
        return true;
    });
}
RTuint lightCountPacket(const RTSpacket*) {
    return AnsweringTracer::kLights;
}
RTuint illuminatePacket(RTSpacket* p, RTuint lanes, RTuint light, RTSlightpacket* samples) {
    return forLanes(p, lanes, [&](int i) {
        RTSlightsample sample = {};
        if (!answerLight(Lane3(p->position, i), light, sample)) return false;
        store(sample.direction, i, samples->direction.x, samples->direction.y,
              samples->direction.z);
        samples->distance.lane[i] = sample.distance;
        store(sample.radiance, i, samples->radiance.r, samples->radiance.g, samples->radiance.b);
        return true;
    });
}
void texturePacket(RTSpacket* p, RTuint lanes, RTuint id, const RTSfloats* s, const RTSfloats* t,
                   RTSfloats rgba[4]) {
    forLanes(p, lanes, [&](int i) {
        float texel[4];
        answerTexture(Asker(*p, i), id, s->lane[i], t->lane[i], texel);
        for (int k = 0; k < 4; ++k) rgba[k].lane[i] = texel[k];
        return true;
    });
}
void environmentPacket(RTSpacket* p, RTuint lanes, const RTSvectors* d, RTScolors* radiance) {
    forLanes(p, lanes, [&](int i) {
        float rgb[3];
        answerEnvironment(Lane3(*d, i), rgb);
        store(rgb, i, radiance->r, radiance->g, radiance->b);
        return true;
    });
}
void randomPacket(RTSpacket* p, RTuint lanes, RTSfloats* numbers) {
    forLanes(p, lanes, [&](int i) {
        numbers->lane[i] = answerRandom(p->tracer, i);
        return true;
    });
}

} // namespace

const RTSfunctions& answeringFunctions() {
    static const RTSfunctions functions = {
        sizeof(RTSfunctions), trace,   traceHit,    shadow, lightCount,
        illuminate,           texture, environment, random};
    return functions;
}

const RTSpacketfunctions& answeringPacketFunctions() {
    static const RTSpacketfunctions functions = {sizeof(RTSpacketfunctions),
                                                 tracePacket,
                                                 traceHitPacket,
                                                 shadowPacket,
                                                 lightCountPacket,
                                                 illuminatePacket,
                                                 texturePacket,
                                                 environmentPacket,
                                                 randomPacket};
    return functions;
}

} // namespace samples

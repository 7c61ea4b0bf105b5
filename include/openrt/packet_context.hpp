// SPDX-License-Identifier: MIT
// What a packet shader sees: BasicTraceContext for up to sixteen points at once. A shader that is
// to serve both is a template of its context, takes numbers, vectors and conditions by the names
// that the context gives them, and decides by `select` and by the `wanted` lanes of calls:
//
//   template <class Context>
//   void shade(Context& c) const {
//       typename Context::Color sum = color * 0.1f;
//       for (RTuint i = 0; i < c.lightCount(); ++i) {
//           typename Context::LightSample light;
//           auto lit = c.illuminate(i, light);
//           const auto cosine = dot(c.facingNormal(), light.direction);
//           lit = lit & (cosine > 0.0f);
//           if (!any(lit)) continue;
//           const auto open = c.shadow(c.position(), light.direction, light.distance, lit);
//           sum = select(lit, sum + color * light.radiance * open * cosine, sum);
//       }
//       c.setRadiance(sum);
//   }
//   static constexpr bool shadesPackets = true;
//
// Lanes are independent: what one of them gets never depends on the others. A loop that lanes
// leave at different times goes on while any(lanes) holds.
#pragma once

#include "openrt/packet_vectors.hpp"
#include "openrt/trace_context.hpp"

namespace openrt {

/// LightSample of each lane.
struct PacketLightSample {
    PacketVec3 direction; ///< to the light, length 1
    Floats distance;      ///< may be infinite
    PacketColor radiance; ///< arriving if nothing is between
};

/// TableCalls for packets.
struct PacketTableCalls {
    static RTuint trace(RTSpacket* p, RTuint lanes, const RTSvectors& origin,
                        const RTSvectors& direction, const RTSfloats& weight,
                        RTScolors& radiance) {
        return p->functions->trace(p, lanes, &origin, &direction, &weight, &radiance);
    }
    static RTuint traceHit(RTSpacket* p, RTuint lanes, const RTSvectors& origin,
                           const RTSvectors& direction, RTShitpacket& hits) {
        return p->functions->traceHit(p, lanes, &origin, &direction, &hits);
    }
    static RTuint shadow(RTSpacket* p, RTuint lanes, const RTSvectors& origin,
                         const RTSvectors& direction, const RTSfloats& distance,
                         RTScolors& attenuation) {
        return p->functions->shadow(p, lanes, &origin, &direction, &distance, &attenuation);
    }
    static RTuint lightCount(const RTSpacket* p) { return p->functions->lightCount(p); }
    static RTuint illuminate(RTSpacket* p, RTuint lanes, RTuint light, RTSlightpacket& samples) {
        return p->functions->illuminate(p, lanes, light, &samples);
    }
    static void texture(RTSpacket* p, RTuint lanes, RTuint texture, const RTSfloats& s,
                        const RTSfloats& t, RTSfloats (&rgba)[4]) {
        p->functions->texture(p, lanes, texture, &s, &t, rgba);
    }
    static void environment(RTSpacket* p, RTuint lanes, const RTSvectors& direction,
                            RTScolors& radiance) {
        p->functions->environment(p, lanes, &direction, &radiance);
    }
    static void random(RTSpacket* p, RTuint lanes, RTSfloats& numbers) {
        p->functions->random(p, lanes, &numbers);
    }
};

/// The points being shaded; a view of an RTSpacket.
template <class Calls>
class BasicPacketContext {
public:
    using Float = Floats;
    using Vec2 = PacketVec2;
    using Vec3 = PacketVec3;
    using Vec4 = PacketVec4;
    using Color = PacketColor;
    using LightSample = PacketLightSample;
    using Condition = Mask;

    explicit BasicPacketContext(RTSpacket* packet) : packet_(packet) {}

    /// The lanes that hold a point. Calls and results count for these only.
    Mask active() const { return Mask(packet_->active); }

    Vec3 position() const { return Vec3(packet_->position); }
    Vec3 shadingNormal() const { return Vec3(packet_->shadingNormal); }
    Vec3 rawNormal() const { return Vec3(packet_->rawNormal); }
    Vec3 geometricNormal() const { return Vec3(packet_->geometricNormal); }
    Vec3 barycentrics() const {
        return {packet_->barycentric[0], packet_->barycentric[1], packet_->barycentric[2]};
    }
    Vec2 texCoord() const { return {packet_->texCoord[0], packet_->texCoord[1]}; }
    Vec4 texCoord4() const { return Vec4(packet_->texCoord); }
    Color color() const { return {packet_->color[0], packet_->color[1], packet_->color[2]}; }
    Float alpha() const { return packet_->color[3]; }
    Vec3 rayOrigin() const { return Vec3(packet_->rayOrigin); }
    Vec3 rayDirection() const { return Vec3(packet_->rayDirection); }
    Float rayDistance() const { return packet_->rayDistance; }
    Mask frontFace() const { return Mask(packet_->frontFace); }
    const RTSids& object() const { return packet_->object; }
    const RTSids& instance() const { return packet_->instance; }
    const RTSids& primitive() const { return packet_->primitive; }
    RTuint depth() const { return packet_->depth; }
    Float weight() const { return packet_->weight; }

    /// The geometric normals on the side that the rays came from.
    Vec3 facingGeometricNormal() const {
        return select(frontFace(), geometricNormal(), -geometricNormal());
    }
    /// The shading normals, turned to the side of the surface that the rays came from.
    Vec3 facingNormal() const {
        const Vec3 normal = shadingNormal();
        return select(dot(normal, facingGeometricNormal()) < 0.0f, -normal, normal);
    }
    Vec3 reflectedDirection() const { return reflect(rayDirection(), facingNormal()); }
    /// Lanes without total reflection; the others' directions are unspecified.
    Mask refractedDirection(const Float& eta, Vec3& direction) const {
        const Vec3 d = rayDirection(), n = shadingNormal();
        const Float towards = dot(d, n);
        const Float side = select(towards > 0.0f, Float(-1.0f), Float(1.0f));
        const Float cosine = towards * -side;
        const Float squared = 1.0f - eta * eta * (1.0f - cosine * cosine);
        direction = eta * d + side * (eta * cosine - sqrt(max(squared, 0.0f))) * n;
        return squared >= 0.0f;
    }
    bool indirect() const { return (packet_->flags & RTS_INDIRECT) != 0; }
    void stopRayRecursion() { packet_->flags |= RTS_STOPPED; }

    Color trace(const Vec3& origin, const Vec3& direction, const Float& weight = 1.0f) {
        return trace(origin, direction, weight, active());
    }
    /// Radiance along rays; black where the recursion limit or the weight cut-off stopped them,
    /// and in lanes that are not wanted.
    Color trace(const Vec3& origin, const Vec3& direction, const Float& weight, Mask wanted) {
        RTScolors radiance; // the call sets the lanes that are traced
        const RTuint traced =
            Calls::trace(packet_, lanes(wanted), plain(origin), plain(direction),
                         weight * Float(packet_->weight), radiance);
        return select(Mask(traced), Color(radiance), Color());
    }
    /// Lanes whose rays meet something.
    Mask traceHit(const Vec3& origin, const Vec3& direction, Mask wanted, RTShitpacket& hits) {
        const Mask traced(
            Calls::traceHit(packet_, lanes(wanted), plain(origin), plain(direction), hits));
        return traced & (Float(hits.distance) <= std::numeric_limits<float>::max());
    }
    Color shadow(const Vec3& origin, const Vec3& direction, const Float& distance) {
        return shadow(origin, direction, distance, active());
    }
    /// Share of light that passes: 1 nothing in between, 0 opaque, or not wanted.
    Color shadow(const Vec3& origin, const Vec3& direction, const Float& distance, Mask wanted) {
        const RTuint asked = lanes(wanted);
        if (!asked) return Color();
        RTScolors attenuation; // the call sets the lanes that are asked for
        Calls::shadow(packet_, asked, plain(origin), plain(direction), distance, attenuation);
        return select(Mask(asked), Color(attenuation), Color());
    }
    RTuint lightCount() const { return Calls::lightCount(packet_); }
    /// Lanes to which the light contributes; the samples of the others are unspecified.
    Mask illuminate(RTuint light, LightSample& sample) {
        return illuminate(light, sample, active());
    }
    /// Of a light with an extent no random numbers are drawn in lanes not wanted.
    Mask illuminate(RTuint light, LightSample& sample, Mask wanted) {
        const RTuint asked = lanes(wanted);
        if (!asked) return Mask();
        RTSlightpacket s; // the call sets the lanes that are lit
        const Mask lit(Calls::illuminate(packet_, asked, light, s) & asked);
        if (!any(lit)) return lit;
        sample = {Vec3(s.direction), Float(s.distance), Color(s.radiance)};
        return lit;
    }
    /// RGBA, linear.
    Vec4 texture(TextureId texture, const Vec2& at) const {
        RTSfloats rgba[4] = {};
        Calls::texture(packet_, packet_->active, RTuint(texture.id), at.x, at.y, rgba);
        return Vec4(rgba);
    }
    Color environment(const Vec3& direction) { return environment(direction, active()); }
    Color environment(const Vec3& direction, Mask wanted) {
        const RTuint asked = lanes(wanted);
        if (!asked) return Color();
        RTScolors radiance; // the call sets the lanes that are asked for
        Calls::environment(packet_, asked, plain(direction), radiance);
        return select(Mask(asked), Color(radiance), Color());
    }
    Float random() { return random(active()); }
    /// Next numbers of the pixels' random streams, in [0, 1); not drawn in lanes not wanted.
    Float random(Mask wanted) {
        RTSfloats numbers = {};
        if (any(wanted)) Calls::random(packet_, lanes(wanted), numbers);
        return numbers;
    }

    void setRadiance(const Color& radiance) {
        packet_->result[0] = radiance.r;
        packet_->result[1] = radiance.g;
        packet_->result[2] = radiance.b;
        packet_->resultSet = packet_->active;
    }
    void setAlpha(const Float& alpha) { packet_->result[3] = alpha; }

    /// A member of the lanes' blocks of per-triangle or per-vertex parameters:
    /// c.vertexParam(&VertexParam::heat).
    template <class T>
    Float triangleParam(float T::*member) const {
        return gather(packet_->triangleParam, member);
    }
    template <class T>
    Float vertexParam(float T::*member) const {
        return gather(packet_->vertexParam, member);
    }

    RTSpacket* packet() const { return packet_; }

private:
    RTuint lanes(Mask wanted) const { return wanted.bits & packet_->active; }
    static RTSvectors plain(const Vec3& v) { return {v.x, v.y, v.z}; }
    template <class T>
    Float gather(const void* const (&blocks)[RTS_PACKET_SIZE], float T::*member) const {
        Float values;
        for (int i = 0; i < kLanes; ++i)
            if (active()[i]) values[i] = static_cast<const T*>(blocks[i])->*member;
        return values;
    }

    RTSpacket* packet_;
};

using PacketContext = BasicPacketContext<PacketTableCalls>;

} // namespace openrt

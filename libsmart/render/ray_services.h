// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <span>
#include <vector>

#include "libsmart/kernel/kernels.h"
#include "libsmart/kernel/packet_math.h"
#include "libsmart/render/all_hits.h"
#include "libsmart/render/camera_rays.h"
#include "libsmart/render/fixed_function_shader.h"
#include "libsmart/render/frame.h"
#include "libsmart/render/point_packet.h"
#include "libsmart/render/ray_group.h"
#include "libsmart/render/thread_loan.h"
#include "libsmart/scene/hit_chain.h"
#include "libsmart/scene/query.h"
#include "libsmart/shading/surface_point.h"

namespace smart {

/// Behind RTSstate::tracer: where rays of a state start.
struct RayStart {
    RayServices* services;
    PixelSample* sample;
    RayCone cone{};                  ///< of the rays that go on from the point
    const HitChain* chain = nullptr; ///< of the shaded point; nullptr: none
    float u = 0, v = 0;
    float error = -1.0f;  ///< surfaceError of the point; negative: not yet known
    bool mayTrace = true; ///< false while shadows ask for transparency
    bool asksLight = false; ///< a light that does so itself gets none
};

/// A state for shaders and all that it points to.
struct PointState {
    RTSstate state;
    RayStart start;
    HitChain chain;
    VertexScratch scratch;

    PointState() = default; // nothing is set: the services do
    PointState(const PointState&) = delete;
    PointState& operator=(const PointState&) = delete;
};

inline bool isFinite(const glm::vec4& v) {
    const glm::vec4 none = v - v; // NaN of what is infinite or NaN
    return none.x + none.y + none.z + none.w == 0.0f;
}
/// Of what a traced ray sees alpha says nothing.
inline bool hasFiniteRadiance(const glm::vec4& color) {
    return isFinite({color.r, color.g, color.b, 0.0f});
}

/// What one camera ray brings home.
struct ShadedSample {
    glm::vec4 color{0.0f, 0.0f, 0.0f, 1.0f};
    float distance = std::numeric_limits<float>::infinity();
    glm::vec3 normal{0.0f}; ///< shading normal
    uint32_t object = kNoId, instance = kNoId, primitive = kNoId;
    bool bad = false; ///< a shader failed or its radiance is not finite; the colour is black then

    /// Takes what is known of a hit beside its colour.
    void describe(const Hit& hit, const RTSstate& state) {
        distance = hit.t;
        normal = {state.shadingNormal[0], state.shadingNormal[1], state.shadingNormal[2]};
        object = state.object;
        instance = state.instance;
        primitive = state.primitive;
    }
    void describe(float t, const RTSpacket& points, int lane) {
        distance = t;
        normal = {points.shadingNormal.x.lane[lane], points.shadingNormal.y.lane[lane],
                  points.shadingNormal.z.lane[lane]};
        object = points.object.lane[lane];
        instance = points.instance.lane[lane];
        primitive = points.primitive.lane[lane];
    }
    /// Black if something went wrong.
    void judge(const PixelSample& sample) {
        bad = sample.fault || !isFinite(color);
        if (bad) color = {0.0f, 0.0f, 0.0f, 1.0f};
    }
};

/// Rays whose hits are to be shaded, and where the colours go.
struct HitGroup {
    const RayGroup* rays;
    uint32_t lanes;
    glm::vec4 (&colors)[kPacketSize];
    ShadedSample* found; ///< what else is to be known of the hits; nullptr: nothing
};

/// How points are shaded where their shader can do both; the picture is the same.
enum class ShadingForm { Packets, Points };

/// Answers what shaders ask (RTSfunctions, RTSpacketfunctions), as far as no surface is shaded
/// for it. One for each tile under way; belongs to the thread that renders it.
class RayServices {
public:
    RayServices(const RayServices&) = delete;
    RayServices& operator=(const RayServices&) = delete;

    /// Traces and shades a camera ray, with a direction of length 1.
    virtual ShadedSample traceCameraRay(const Ray& ray, const PathState& path) = 0;

    /// A state at no surface, for shaders that are asked before a ray is traced.
    void atNoSurface(PixelSample& sample, PointState& point);
    /// The state at what a ray met, without the parameters of its shader.
    void atHit(const Ray& ray, const Hit& hit, const PathState& path, PointState& point);

    /// Asks the camera for the ray through a point of a pixel; false where there is none.
    bool makeCameraRay(const CameraRays& camera, double x, double y, PixelSample& sample, Ray& ray,
                       RayCone& cone);
    /// The same for the given lanes, whose samples are set; returns those that have a ray.
    uint32_t makeCameraRays(const CameraRays& camera, const double (&x)[kPacketSize],
                            const double (&y)[kPacketSize], uint32_t lanes, RayGroup& rays);
    /// What the camera makes of columns, and rows, of the picture, sixteen at a time, where no
    /// shader is asked;
    void findColumns(const CameraRays& camera, const double* x, uint32_t packets,
                     LensLanes* columns) const;
    void findRows(const CameraRays& camera, const double* y, uint32_t packets,
                  LensLanes* rows) const;
    /// and rays of these. Returns the lanes that have one.
    uint32_t makeCameraRays(const CameraRays& camera, const LensLanes& columns,
                            const LensLanes& rows, RayGroup& rays) const;
    /// What a camera ray meets, not yet shaded; false: nothing.
    bool visit(const Ray& ray, const PathState& path, PointState& point, ShadedSample& found);

    /// Finds what the rays of the given lanes meet.
    void findHits(RayGroup& rays, uint32_t lanes) const;
    /// The same for a block of camera rays.
    void findTileHits(RayBlock& block, const uint32_t* lanes) const;
    /// Everything that the active rays of a packet meet.
    void findAllHits(const RayPacket& rays, AllHits& found) const;
    /// The surface shader of what a ray hit; nullptr: there is none.
    const ShaderObject* findSurface(const Hit& hit);
    /// Those of the given lanes, which hit something.
    void findSurfaces(const RayGroup& rays, uint32_t lanes,
                      const ShaderObject* (&surfaces)[kPacketSize]);
    /// The same for all of them, where they have one in common; false: some differ.
    bool findSurface(const RayGroup& rays, uint32_t lanes, const ShaderObject*& surface);
    /// Shades what a camera ray hit, where that takes no more than the hit: fixed function without
    /// rays that go on. False: it does take more.
    bool shadeAlone(const Ray& ray, const Hit& hit, const ShaderObject* surface, glm::vec4& color);
    /// What the given rays see that met nothing.
    void shadeMisses(const RayGroup& rays, uint32_t lanes, glm::vec4 (&colors)[kPacketSize]);

    /// Entries of the function table.
    static int traceHit(RTSstate*, const float origin[3], const float direction[3], RTShitinfo*);
    static RTuint lightCount(const RTSstate*);
    static int illuminate(RTSstate*, RTuint light, RTSlightsample*);
    static void texture(RTSstate*, RTuint texture, float s, float t, float rgba[4]);
    static void environment(RTSstate*, const float direction[3], float radiance[3]);
    static float random(RTSstate*);
    /// Entries of the packets' function table.
    static RTuint packetTraceHit(RTSpacket*, RTuint lanes, const RTSvectors* origin,
                                 const RTSvectors* direction, RTShitpacket*);
    static RTuint packetLightCount(const RTSpacket*);
    static RTuint packetIlluminate(RTSpacket*, RTuint lanes, RTuint light, RTSlightpacket*);
    static void packetTexture(RTSpacket*, RTuint lanes, RTuint texture, const RTSfloats* s,
                              const RTSfloats* t, RTSfloats rgba[4]);
    static void packetEnvironment(RTSpacket*, RTuint lanes, const RTSvectors* direction,
                                  RTScolors*);
    static void packetRandom(RTSpacket*, RTuint lanes, RTSfloats*);

protected:
    /// `counters`: where rays are counted. The tables are those that states and packets point to.
    RayServices(const Frame& frame, TilePixels& counters, ShadingForm form,
                const RTSfunctions& functions, const RTSpacketfunctions& packetFunctions);
    ~RayServices() = default;

    static RayStart& startOf(const RTSstate& state) {
        return *static_cast<RayStart*>(state.tracer);
    }
    /// Sets the state to a ray that has met nothing yet.
    void beginState(const Ray& ray, const PathState& path, PointState& point);
    /// atHit for a point whose chain, and the triangle made of it, are set already.
    void placeAt(const Ray& ray, const Hit& hit, const PathState& path, SurfaceTriangle& triangle,
                 PointState& point);
    /// Whether rays may start there; none is traced for transparency.
    static bool mayTrace(const RTSstate& state) {
        return startOf(state).mayTrace && !(state.flags & RTS_STOPPED);
    }
    /// The share of the pixel that a traced ray has; negative: it is not to be traced.
    float shareOf(float weight, float ofPoint, uint32_t depth) const;
    /// A ray with a direction of length 1. Only where it starts exactly at the shaded point is
    /// its origin moved off the surface: another origin is the shader's own choice.
    static Ray spawn(const RTSstate& state, const float origin[3], const float direction[3]);
    static PathState onward(const RTSstate& state, float weight);
    Hit findHit(const Ray& ray) const;
    bool isOccluded(const Ray& ray) const;
    const ShaderObject* findSurface(const HitChain& chain) const;
    glm::vec4 shadeMiss(const Ray& ray, const PathState& path);

    // Fixed function with a state block; see fixed_services.cpp.
    /// The block of a hit's outermost instance; nullptr: none.
    const FixedState* stateOf(const Hit& hit) const { return stateOf(hit.path[0]); }
    const FixedState* stateOf(uint32_t instance) const {
        return frame_.scene->group().instances()[instance].traits->state.get();
    }
    bool isFixed(const HitChain& chain) const {
        return shading_.fixedFunction && chain.instances[0]->traits->state &&
               effectiveShader(chain) == 0;
    }
    /// Among lanes whose hits have the given surface, those that fixed function shades.
    uint32_t fixedLanes(const ShaderObject* surface, const RayGroup& rays, uint32_t lanes) const;
    /// Shades such lanes of up to kTilePackets groups of neighbours.
    void shadeFixed(std::span<const HitGroup> groups, const uint32_t* lanes);
    /// What is known of a camera ray's hit beside its colour and normal.
    void describe(const Hit& hit, ShadedSample& found) const;
    /// What such a surface leaves of light.
    glm::vec3 fixedTransparency(const Ray& ray, const Hit& hit, const PathState& path);

    static PointPacket& packetOf(const RTSpacket& packet) {
        return *static_cast<PointPacket*>(packet.tracer);
    }
    /// Whether so many points of a class that can do both are shaded as a packet.
    bool asPacket(uint32_t lanes, uint32_t depth) const {
        return form_ == ShadingForm::Packets && depth < kMaxPacketDepth &&
               std::popcount(lanes) >= kLeastLanes;
    }
    /// What the points of a surface have to hold that says what it reads (RTS_READS_...).
    uint32_t valuesFor(uint32_t reads) const {
        return shading_.lightsSeePoints ? RTS_READS_EVERYTHING : reads;
    }
    /// The packet of what the given lanes of a group hit, which all has the shader, with the given
    /// values of the points; others are 0. What is to be known beside the colour is stored.
    /// `number`: among those of camera rays, which may be filled before one of them is shaded.
    PointPacket& packetAtHits(const HitGroup& group, uint32_t lanes, const ShaderObject& surface,
                              uint32_t reads, uint32_t number = 0);
    /// Finds what the lights send to neighbouring packets, and whether it arrives, with all rays
    /// to a light in one tile.
    void lookAhead(std::span<PointPacket* const> packets);
    /// What lookAhead found out about these rays, as the lanes that are blocked; false: nothing.
    static bool findAhead(const PointPacket& from, uint32_t lanes, const RTSvectors& origin,
                          const RTSvectors& direction, const RTSfloats& distance,
                          uint32_t& blocked);
    /// The rays that the lanes of a packet send on, but for their weights.
    void spawn(PointPacket& from, uint32_t lanes, const RTSvectors& origin,
               const RTSvectors& direction, RayGroup& rays) const;
    void spawn(PointPacket& from, uint32_t lanes, const RTSvectors& origin,
               const RTSvectors& direction, RayPacket& rays) const;
    /// The lanes among the active ones whose rays are blocked.
    uint32_t findOccluded(const RayPacket& rays) const;
    /// The same for `count` neighbouring packets.
    void findOccluded(const RayPacket* rays, uint32_t count, uint32_t* blocked) const;

    const Frame& frame_;
    const FrameShading& shading_;
    TilePixels& counters_;
    FixedFunctionShader fixed_;
    const KernelTable& kernels_;
    const PacketMath& math_;
    const std::size_t precision_;
    const uint32_t recursionLimit_;
    const bool cones_; ///< of camera rays that no shader makes: whether anybody asks for them
    const ThreadLoan<PacketPool> pool_;

private:
    static constexpr int kLeastLanes = 3; ///< fewer are faster one by one

    /// What a light's answer amounts to; 0: it contributes nothing.
    static int finishLight(const LightPart& part, int answer, PixelSample& asked,
                           RTSlightsample& sample);
    PointPacket& beginPacket(const RayGroup& rays, uint32_t lanes, uint32_t reads,
                             uint32_t number = 0);
    /// Fills lanes whose hits are in one model, met in one way; returns those that it leaves.
    uint32_t fillPoints(const RayGroup& rays, uint32_t lanes, const HitChain& way,
                        uint32_t instance, uint32_t reads, RTSpacket& points, float* error) const;
    /// Fills lanes one by one that the loops over lanes do not take.
    void fillLanes(const RayGroup& rays, uint32_t lanes, uint32_t reads,
                   PointPacket& packet) const;
    /// Points the lanes to the parameter blocks of their triangles and vertices.
    void fillBlocks(uint32_t lanes, PointPacket& packet) const;
    /// The way of a hit from the scene to the triangle.
    const HitChain& chainTo(const Hit& hit);
    /// Lanes to which the light contributes.
    uint32_t samplePointLight(const builtin::PointLight& light, const RTSvectors& position,
                              RTSlightpacket& samples) const;
    struct FixedPacket;
    /// What of a camera ray's hits fixed function shades as packets; `alone`: what takes no more
    /// than the hit.
    uint32_t lanesTogether(const HitGroup& group, uint32_t lanes, uint32_t& alone) const;
    /// Colours that depend on nothing but the hits and what is hidden.
    void shadeTriangles(const RayGroup& rays, uint32_t lanes,
                        const uint32_t (&hidden)[kPacketSize], glm::vec4 (&colors)[kPacketSize]);
    void shadeFixedPackets(std::span<FixedPacket> packets);
    void shadeFixedPoints(const HitGroup& group, uint32_t lanes);
    /// Shadow rays of the lanes that ask about a light, which are returned.
    uint32_t aimAtLight(const FixedPacket& fixed, int light, RTSvectors& direction,
                        RTSfloats& distance) const;
    void findHidden(std::span<FixedPacket> packets, int light);
    void shadeThroughOthers(const FixedPacket& fixed, uint32_t lights);
    void gatherState(PointPacket& packet, int lane, RTSstate& state, RayStart& start,
                     HitChain& chain) const;

    const RTSfunctions& functions_;
    const RTSpacketfunctions& packetFunctions_;
    const ShadingForm form_;
    HitChain recent_; ///< of the hit that chainTo was asked for last
    uint32_t recentPath_[kMaxLevels];
};

/// Length 1; zero where there is no direction: such rays miss.
glm::vec3 unitDirection(const float direction[3]);

/// Shadow rays end this share of the distance before the light, so as not to meet its own surface.
inline constexpr float kBeforeLight = 1.0f - 0x1p-20f;

} // namespace smart

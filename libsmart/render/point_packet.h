// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "libsmart/kernel/kernels.h"
#include "libsmart/render/ray_group.h"
#include "libsmart/render/shadow_guess.h"
#include "libsmart/scene/hit_chain.h"
#include "libsmart/shading/surface_point.h"
#include "openrt/rts_packet.h"

namespace smart {

static_assert(kPacketSize == RTS_PACKET_SIZE);

class RayServices;

/// What a light sends to the points of a packet, and whether it is seen from them, found before
/// the shader asks.
struct LightAhead {
    RTSlightpacket sample;
    uint32_t lit;     ///< lanes to which it contributes
    uint32_t traced;  ///< lanes whose shadow ray was traced
    uint32_t blocked; ///< of those
};
/// A frame's first lights are looked at ahead.
inline constexpr uint32_t kLightsAhead = 4;

/// Points for a packet shader and all that they point to. `points.tracer` points to the whole.
struct PointPacket {
    RTSpacket points;
    RayServices* services;
    const ShaderObject* surface; ///< nullptr: the points are on none
    uint32_t filled; ///< values of the points (RTS_READS_...) that are not 0
    bool hasBlocks;  ///< some lane's parameter blocks are set
    PixelSample* sample[kPacketSize];
    float coneWidth[kPacketSize], coneSpread[kPacketSize]; ///< of the rays that go on
    // Of points on a surface:
    uint32_t triangle[kPacketSize];
    float u[kPacketSize], v[kPacketSize];
    float error[kPacketSize]; ///< surfaceError
    uint32_t errorsMissing;   ///< lanes whose error is not yet known
    HitChain ways[kPacketSize];  ///< the different ways to the points, but for the triangle
    uint8_t wayOf[kPacketSize];
    VertexScratch scratch[kPacketSize];
    uint32_t lightsAhead; ///< how many of the following hold
    LightAhead ahead[kLightsAhead];

    bool atSurface() const { return surface != nullptr; }
    HitChain chain(int lane) const {
        HitChain chain = ways[wayOf[lane]];
        chain.triangle = triangle[lane];
        return chain;
    }
    RayCone cone(int lane) const { return {coneWidth[lane], coneSpread[lane]}; }
};

/// Deeper points are shaded one by one: the stack of a thread is limited.
inline constexpr uint32_t kMaxPacketDepth = 16;

/// Packets for each depth, made when first asked for: while those of one are being shaded, the
/// rays that they spawn meet only deeper ones. There are kTilePackets for what camera rays hit.
class PacketPool {
public:
    PointPacket& at(uint32_t depth, uint32_t number = 0) {
        auto& packet = depth == 0 ? first_[number] : deeper_[depth];
        if (!packet) packet = std::make_unique<PointPacket>();
        return *packet;
    }
    ShadowGuess shadowGuess;

private:
    std::array<std::unique_ptr<PointPacket>, kTilePackets> first_;
    std::array<std::unique_ptr<PointPacket>, kMaxPacketDepth> deeper_;
};

} // namespace smart

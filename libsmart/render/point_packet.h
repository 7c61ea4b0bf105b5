// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "libsmart/render/ray_group.h"
#include "libsmart/scene/hit_chain.h"
#include "libsmart/shading/surface_point.h"
#include "openrt/rts_packet.h"

namespace smart {

static_assert(kPacketSize == RTS_PACKET_SIZE);

class RayServices;

/// Points for a packet shader and all that they point to. `points.tracer` points to the whole.
struct PointPacket {
    RTSpacket points;
    RayServices* services;
    PixelSample* sample[kPacketSize];
    RayCone cone[kPacketSize]; ///< of the rays that go on from the points
    bool atSurface;            ///< then the following hold
    float u[kPacketSize], v[kPacketSize];
    float error[kPacketSize]; ///< surfaceError; negative: not yet known
    HitChain chain[kPacketSize];
    VertexScratch scratch[kPacketSize];
};

/// Deeper points are shaded one by one: the stack of a thread is limited.
inline constexpr uint32_t kMaxPacketDepth = 16;

/// A packet for each depth, made when first asked for: while one is being shaded, the rays that it
/// spawns meet only deeper ones.
class PacketPool {
public:
    PointPacket& at(uint32_t depth) {
        auto& packet = packets_[depth];
        if (!packet) packet = std::make_unique<PointPacket>();
        return *packet;
    }

private:
    std::array<std::unique_ptr<PointPacket>, kMaxPacketDepth> packets_;
};

} // namespace smart

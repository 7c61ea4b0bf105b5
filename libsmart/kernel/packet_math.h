// SPDX-License-Identifier: MIT
// What the renderer computes for the sixteen lanes of a packet at once beside tracing, compiled as
// the kernels are. Lanes that hold nothing are computed along and say nothing.
#pragma once

#include <cstdint>

#include "libsmart/kernel/kernels.h"
#include "libsmart/kernel/point_math.h"
#include "libsmart/kernel/view.h"
#include "openrt/rts_packet.h"

namespace smart {

/// Values of vertices first..; those before take what is inherited.
struct VertexValues {
    const float* values; ///< nullptr: all inherit
    uint32_t first;
    const float* inherited; ///< as many floats as a value has
};

/// A LensPoint for each lane.
struct LensLanes {
    double x[kPacketSize], y[kPacketSize], z[kPacketSize], w[kPacketSize];
};

/// Numbers of the vertices of the lanes' triangles.
using VertexLanes = uint32_t[3][kPacketSize];

/// One model met in one way, as far as shading asks.
struct SurfaceView {
    const Triangle* triangles;
    const double* toWorld; ///< four columns of three
    bool oneLevel;         ///< an instance of the scene itself
    VertexValues normals;    ///< three floats each; what is inherited is no matter
    VertexValues texCoords, colors; ///< four floats each
    uint32_t object, instance;

    bool asksVertices(uint32_t reads) const {
        return (normals.values && (reads & (RTS_READS_SHADING_NORMAL | RTS_READS_RAW_NORMAL))) ||
               (texCoords.values && (reads & (RTS_READS_TEXCOORD | RTS_READS_FOOTPRINT))) ||
               (colors.values && (reads & RTS_READS_COLOR));
    }
};

/// The values (RTS_READS_...) that are found so that those of `reads` can be.
static inline constexpr uint32_t filledFor(uint32_t reads) {
    if (reads & (RTS_READS_SHADING_NORMAL | RTS_READS_RAW_NORMAL | RTS_READS_FOOTPRINT))
        reads |= RTS_READS_NORMAL;
    if (reads & RTS_READS_NORMAL) reads |= RTS_READS_RAY; // for the side
    return reads;
}

struct PacketMath {
    const char* name; ///< as that of the KernelTable
    /// What columns, and rows, of the picture give for its points, for `packets` times sixteen
    /// coordinates: the same for all pixels of a column or a row.
    void (*lensColumns)(const MatrixLens&, const double* x, uint32_t packets, LensLanes*);
    void (*lensRows)(const MatrixLens&, const double* y, uint32_t packets, LensLanes*);
    /// Rays through sixteen points of the picture; returns the lanes that have one. The cones are
    /// stored where there is memory for them.
    uint32_t (*cameraRays)(const MatrixLens&, const LensLanes& columns, const LensLanes& rows,
                           RayPacket&, float* coneWidth, float* coneSpread);
    /// Fills what a packet says of its rays and of the points that they met, as fillSurfacePoint
    /// does for one: filledFor(reads). error: surfaceError, or negative where it takes more; set where rays may start:
    /// RTS_READS_TRACE. Returns the lanes, among the given ones, that take fillSurfacePoint itself.
    /// The vertices are read, in all lanes, where the view asks for them.
    uint32_t (*surfacePoints)(const SurfaceView&, const VertexLanes&, const RayPacket&,
                              const HitPacket&, uint32_t lanes, uint32_t reads, RTSpacket&,
                              float* error);
    /// Rays that go on from a packet's points; where they start exactly there, off the surface by
    /// the errors. error: nullptr where the points are on no surface.
    void (*spawn)(const RTSpacket&, const float* error, const RTSvectors& origin,
                  const RTSvectors& direction, RayPacket&);
    /// A light at `from` whose strength falls off with the square of the distance; returns the
    /// lanes to which it contributes.
    uint32_t (*pointLight)(const float* from, const float* strength, const RTSvectors& position,
                           RTSlightpacket&);
};

/// The one compiled for the instruction set of a table of kernels.
const PacketMath& packetMathOf(const KernelTable& kernels);

} // namespace smart

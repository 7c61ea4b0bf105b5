// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "libsmart/kernel/packet.h"
#include "libsmart/kernel/packet_math.h"
#include "libsmart/render/frame.h"
#include "libsmart/render/ray_cone.h"
#include "libsmart/render/ray_group.h"
#include "libsmart/render/sampling.h"

namespace smart {

/// What a camera shader is given beside the point of the picture.
struct CameraSample {
    RTSstate* state = nullptr;     ///< at no surface
    PixelSample* sample = nullptr; ///< where the state's random numbers come from
};

/// The camera rays of one frame. A pixel's centre is half a pixel off its number, as in OpenGL;
/// row 0 is at the bottom. The frame has to live as long. Thread-safe.
class CameraRays {
public:
    explicit CameraRays(const Frame& frame);

    /// Whether the viewport covers a pixel.
    bool covers(uint32_t x, uint32_t y) const;

    /// The ray through a point given in pixels from the picture's lower left corner; its
    /// direction has length 1. False where there is none: the camera shader failed or gave a
    /// ray that is not finite, or the matrix takes the point nowhere.
    ///
    /// With the projection matrix as camera, rays start at the eye, with the near and far planes
    /// as limits, or on the near plane where the matrix has no eye. With a camera shader they
    /// start where it says.
    bool make(double x, double y, Ray& ray, const CameraSample& sample = {}) const;
    /// The same for sixteen points at once, with the cones or without, where no camera shader is
    /// asked; returns the lanes that have a ray.
    uint32_t makePacket(const PacketMath& math, const double (&x)[kPacketSize],
                        const double (&y)[kPacketSize], bool cones, RayGroup& rays) const;
    /// The same, of what the lens made of the coordinates.
    uint32_t makePacket(const PacketMath& math, const LensLanes& columns, const LensLanes& rows,
                        bool cones, RayGroup& rays) const;
    const MatrixLens& lens() const { return lens_; }

    /// The cone of a ray that make() gave for the same point: what one of the frame's samples
    /// of a pixel stands for, from the neighbours of the ray one pixel to the right and above.
    /// Camera shaders draw the same random numbers for those.
    RayCone cone(double x, double y, const Ray& ray, const CameraSample& sample = {}) const;

    /// Window depth, 0 to 1, of the point at distance t on a ray. A camera shader has no depth
    /// range: there it is t / (1 + t).
    float depth(const Ray& ray, float t) const;

private:
    LensRay fromMatrix(double x, double y) const;
    bool fromShader(double x, double y, Ray& ray, RTSstate* state) const;
    RayCone shaderCone(double x, double y, const Ray& ray, const CameraSample& sample) const;

    const Frame& frame_;
    MatrixLens lens_;
};

} // namespace smart

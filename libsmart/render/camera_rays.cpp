// SPDX-License-Identifier: MIT
#include "libsmart/render/camera_rays.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace smart {
namespace {

bool isFinite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool store(Ray& ray, const glm::dvec3& origin, const glm::dvec3& direction, double near,
           double far) {
    for (int k = 0; k < 3; ++k) {
        ray.org[k] = float(origin[k]);
        ray.dir[k] = float(direction[k]);
        if (!std::isfinite(ray.org[k]) || !std::isfinite(ray.dir[k])) return false;
    }
    ray.tNear = float(near);
    ray.tFar = float(far);
    return true;
}

} // namespace

CameraRays::CameraRays(const Frame& frame) : frame_(frame), lens_{} {
    // Depth moves a point along column 2 of the inverse. The matrix has an eye, where all rays
    // meet, if that changes w too, by more than rounding left in it.
    const glm::dmat4& inverse = frame.matrixCamera.inverse;
    const double w = inverse[2].w;
    const double scale =
        std::max({std::abs(inverse[0].w), std::abs(inverse[1].w), std::abs(inverse[3].w)});
    const glm::dvec3 eye = glm::dvec3(inverse[2]) / w + 0.0; // + 0: no negative zero
    glm::dvec3 turn[2]; // change of motion (see rayThrough) for a pixel to the right, and up
    for (int k = 0; k < 2; ++k)
        turn[k] = 2.0 / (k == 0 ? frame.viewport.width : frame.viewport.height) *
                  (inverse[k].w * glm::dvec3(inverse[2]) - w * glm::dvec3(inverse[k]));
    const glm::dvec3 turning = glm::cross(turn[0], turn[1]);
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) lens_.inverse[column][row] = inverse[column][row];
    for (int k = 0; k < 3; ++k) {
        lens_.eye[k] = eye[k];
        lens_.turning[k] = turning[k];
    }
    lens_.left = frame.viewport.x;
    lens_.bottom = frame.viewport.y;
    lens_.width = frame.viewport.width;
    lens_.height = frame.viewport.height;
    lens_.pixelWidth = 1.0 / lens_.width;
    lens_.pixelHeight = 1.0 / lens_.height;
    lens_.upright = inverse[0].w == 0.0 && inverse[1].w == 0.0;
    const double nearW = inverse[3].w - w;
    lens_.nearScale = -1.0 / (w * nearW);
    lens_.farScale = -1.0 / (w * (nearW + 2.0 * w));
    lens_.sampleSide = 1.0 / std::sqrt(double(std::max(frame.samples, 1u)));
    // Where the near plane is the farther one, rays lead to the eye and can not start there.
    const bool towardsEye = lens_.nearScale < 0.0 && lens_.farScale < 0.0;
    lens_.hasEye =
        std::abs(w) > 0x1p-45 * scale && isFinite(glm::dvec3(glm::vec3(eye))) && !towardsEye;
}

bool CameraRays::covers(uint32_t x, uint32_t y) const {
    return frame_.viewport.contains(x, y);
}

bool CameraRays::make(double x, double y, Ray& ray, const CameraSample& sample) const {
    if (frame_.camera)
        return fromShader((x - lens_.left) / lens_.width, (y - lens_.bottom) / lens_.height, ray,
                          sample.state);
    const LensRay made = fromMatrix(x, y);
    for (int k = 0; k < 3; ++k) {
        ray.org[k] = made.org[k];
        ray.dir[k] = made.dir[k];
    }
    ray.tNear = made.tNear;
    ray.tFar = made.tFar;
    return made.made;
}

uint32_t CameraRays::makePacket(const PacketMath& math, const double (&x)[kPacketSize],
                                const double (&y)[kPacketSize], bool cones,
                                RayGroup& rays) const {
    LensLanes columns, rows;
    math.lensColumns(lens_, x, 1, &columns);
    math.lensRows(lens_, y, 1, &rows);
    return makePacket(math, columns, rows, cones, rays);
}

uint32_t CameraRays::makePacket(const PacketMath& math, const LensLanes& columns,
                                const LensLanes& rows, bool cones, RayGroup& rays) const {
    if (cones)
        return math.cameraRays(lens_, columns, rows, rays.rays, rays.coneWidth, rays.coneSpread);
    std::fill_n(rays.coneWidth, kPacketSize, 0.0f);
    std::fill_n(rays.coneSpread, kPacketSize, 0.0f);
    return math.cameraRays(lens_, columns, rows, rays.rays, nullptr, nullptr);
}

LensRay CameraRays::fromMatrix(double x, double y) const {
    return forLens(lens_, [&](auto hasEye, auto upright) {
        return rayThrough<hasEye.value, upright.value, true>(lens_, lensColumn(lens_, x),
                                                             lensRow(lens_, y));
    });
}

bool CameraRays::fromShader(double x, double y, Ray& ray, RTSstate* state) const {
    RTScameraray given{};
    given.state = state;
    given.tfar = std::numeric_limits<float>::infinity();
    const ShaderObject& camera = *frame_.camera;
    const auto cameraRay = camera.functions().cameraRay;
    if (!cameraRay || cameraRay(camera.block(), float(x), float(y), &given) != 0) return false;
    const glm::dvec3 direction(given.direction[0], given.direction[1], given.direction[2]);
    const double length = glm::length(direction);
    return store(ray, {given.origin[0], given.origin[1], given.origin[2]}, direction / length,
                 given.tnear * length, given.tfar * length);
}

RayCone CameraRays::cone(double x, double y, const Ray& ray, const CameraSample& sample) const {
    if (frame_.camera) return shaderCone(x, y, ray, sample);
    const LensRay made = fromMatrix(x, y);
    return {made.coneWidth, made.coneSpread};
}

RayCone CameraRays::shaderCone(double x, double y, const Ray& ray,
                               const CameraSample& sample) const {
    PixelSample unchanged;
    if (sample.sample) unchanged = *sample.sample;
    const auto neighbour = [&](double column, double row, Ray& next) {
        PixelSample* const drawn = sample.sample;
        if (drawn) *drawn = PixelSample(drawn->x, drawn->y, drawn->number, frame_.seed);
        const bool made = make(column, row, next, sample);
        if (drawn) *drawn = unchanged;
        return made;
    };
    const glm::dvec3 from(ray.org[0], ray.org[1], ray.org[2]);
    const glm::dvec3 along(ray.dir[0], ray.dir[1], ray.dir[2]);
    glm::dvec3 origin[2], direction[2];
    for (int k = 0; k < 2; ++k) {
        Ray next; // where the picture of a camera ends, the neighbour on the other side
        if (!neighbour(x + (k == 0), y + (k == 1), next) &&
            !neighbour(x - (k == 0), y - (k == 1), next))
            return {};
        origin[k] = glm::dvec3(next.org[0], next.org[1], next.org[2]) - from;
        direction[k] = glm::dvec3(next.dir[0], next.dir[1], next.dir[2]) - along;
    }
    return coneBetween(along, origin, direction, lens_.sampleSide);
}

float CameraRays::depth(const Ray& ray, float t) const {
    if (frame_.camera) return t / (1.0f + t);
    const glm::dmat4& projection = frame_.matrixCamera.projection;
    glm::dvec4 point(0.0, 0.0, 0.0, 1.0);
    for (int k = 0; k < 3; ++k) point[k] = double(ray.org[k]) + double(t) * double(ray.dir[k]);
    double z = 0.0, w = 0.0; // of projection * point
    for (int k = 0; k < 4; ++k) {
        z += projection[k].z * point[k];
        w += projection[k].w * point[k];
    }
    const double depth = (z / w + 1.0) / 2.0;
    const double inRange = depth > 0.0 ? std::min(depth, 1.0) : 0.0; // NaN: 0
    const double near = frame_.depthNear, far = frame_.depthFar;
    return float(near + inRange * (far - near));
}

} // namespace smart

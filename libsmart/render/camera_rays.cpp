// SPDX-License-Identifier: MIT
#include "libsmart/render/camera_rays.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace smart {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

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

CameraRays::CameraRays(const Frame& frame)
    : frame_(frame), sampleSide_(1.0 / std::sqrt(double(std::max(frame.samples, 1u)))) {
    // Depth moves a point along column 2 of the inverse. The matrix has an eye, where all rays
    // meet, if that changes w too, by more than rounding left in it.
    const glm::dmat4& inverse = frame.matrixCamera.inverse;
    const double w = inverse[2].w;
    const double scale =
        std::max({std::abs(inverse[0].w), std::abs(inverse[1].w), std::abs(inverse[3].w)});
    eye_ = glm::dvec3(inverse[2]) / w + 0.0; // + 0: no negative zero
    hasEye_ = std::abs(w) > 0x1p-45 * scale && isFinite(glm::dvec3(glm::vec3(eye_)));
    glm::dvec3 turn[2]; // change of motion (see matrixCone) for a pixel to the right, and up
    for (int k = 0; k < 2; ++k)
        turn[k] = 2.0 / (k == 0 ? frame.viewport.width : frame.viewport.height) *
                  (inverse[k].w * glm::dvec3(inverse[2]) - w * glm::dvec3(inverse[k]));
    turning_ = glm::cross(turn[0], turn[1]);
}

bool CameraRays::covers(uint32_t x, uint32_t y) const {
    return frame_.viewport.contains(x, y);
}

bool CameraRays::make(double x, double y, Ray& ray, const CameraSample& sample) const {
    const Viewport& viewport = frame_.viewport;
    x = (x - viewport.x) / viewport.width;
    y = (y - viewport.y) / viewport.height;
    return frame_.camera ? fromShader(x, y, ray, sample.state) : fromMatrix(x, y, ray);
}

bool CameraRays::fromMatrix(double x, double y, Ray& ray) const {
    // Homogeneous points of this pixel: near + s * step with s from 0 (near plane) to 2 (far).
    const glm::dmat4& inverse = frame_.matrixCamera.inverse;
    const glm::dvec4& step = inverse[2];
    const glm::dvec4 near =
        inverse[3] - step + (2.0 * x - 1.0) * inverse[0] + (2.0 * y - 1.0) * inverse[1];
    const double farW = near.w + 2.0 * step.w;
    // Which way the point moves as s grows: the derivative of xyz / w, times a positive number.
    const glm::dvec3 motion = near.w * glm::dvec3(step) - step.w * glm::dvec3(near);
    const double length = glm::length(motion);
    const glm::dvec3 direction = motion / length;
    // A far plane at infinity, or beyond it, is no limit.
    const bool endless = !(farW * near.w > 0.0);
    if (hasEye_) {
        const double nearDistance = -length / (step.w * near.w);
        const double farDistance = endless ? kInfinity : -length / (step.w * farW);
        return store(ray, eye_, direction, std::max(nearDistance, 0.0), farDistance);
    }
    const glm::dvec3 origin = glm::dvec3(near) / near.w;
    const double range = 2.0 * length / std::abs(near.w * farW);
    return store(ray, origin, direction, 0.0, endless ? kInfinity : range);
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
    return frame_.camera ? shaderCone(x, y, ray, sample) : matrixCone(x, y);
}

// The derivatives of fromMatrix: a pixel's step to the side turns the ray by (w of the step) *
// motion's change / length, of which what points along the ray drops out.
RayCone CameraRays::matrixCone(double x, double y) const {
    const Viewport& viewport = frame_.viewport;
    x = (x - viewport.x) / viewport.width;
    y = (y - viewport.y) / viewport.height;
    const glm::dmat4& inverse = frame_.matrixCamera.inverse;
    const glm::dvec4& step = inverse[2];
    const glm::dvec4 near =
        inverse[3] - step + (2.0 * x - 1.0) * inverse[0] + (2.0 * y - 1.0) * inverse[1];
    const glm::dvec3 motion = near.w * glm::dvec3(step) - step.w * glm::dvec3(near);
    const double squared = glm::dot(motion, motion), length = std::sqrt(squared);
    const float spread =
        coneSide(std::fabs(glm::dot(turning_, motion)) / (squared * length), sampleSide_);
    if (hasEye_) return {0.0f, spread};
    glm::dvec3 origin[2];
    for (int k = 0; k < 2; ++k)
        origin[k] =
            (glm::dvec3(inverse[k]) - inverse[k].w / near.w * glm::dvec3(near)) / near.w;
    const double area = std::fabs(glm::dot(glm::cross(origin[0], origin[1]), motion)) / length *
                        (2.0 / viewport.width) * (2.0 / viewport.height);
    return {coneSide(area, sampleSide_), spread};
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
    return coneBetween(along, origin, direction, sampleSide_);
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

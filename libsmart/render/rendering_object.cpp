// SPDX-License-Identifier: MIT
#include "libsmart/render/rendering_object.h"

#include <cmath>

namespace smart {
namespace {

/// The number of the sample that the object's own random numbers are of; its rays count from 0.
constexpr uint32_t kOwnSample = 0xFFFFFFFFu;

/// The pixel that the object sees, and what the library keeps beside it.
struct PixelInTrace : RTSpixel {
    const Frame* frame;
    const CameraRays* camera;
    RayServices* services;
    PixelResult result;
    uint32_t rays;
    PixelSample own, sample; ///< of the object, of the ray
    PointState pixelState, visited;

    /// The next camera ray of the pixel; false where there is none.
    bool nextRay(float atX, float atY, Ray& ray, RayCone& cone) {
        result.bad |= sample.fault; // of the point visited last
        sample = PixelSample(x, y, rays++, frame->seed);
        const double column = double(x) + atX, row = double(y) + atY;
        if (services->makeCameraRay(*camera, column, row, sample, ray, cone)) return true;
        result.bad = true;
        return false;
    }
    void keepFirst(const Ray& ray, const ShadedSample& found) {
        if (result.hasFirst) return;
        result.hasFirst = true;
        result.firstRay = ray;
        result.first = found;
    }
};

void tracePointWith(RTSpixel* pixel, float x, float y, RTuint flags, float rgba[4]) {
    PixelInTrace& self = *static_cast<PixelInTrace*>(pixel);
    for (int k = 0; k < 4; ++k) rgba[k] = k < 3 ? 0.0f : 1.0f;
    Ray ray;
    RayCone cone;
    if (!self.nextRay(x, y, ray, cone)) return;
    const ShadedSample sample =
        self.services->traceCameraRay(ray, {&self.sample, 0, 1.0f, flags, cone});
    self.result.bad |= sample.bad;
    self.keepFirst(ray, sample);
    for (int k = 0; k < 4; ++k) rgba[k] = sample.color[k];
}

void tracePoint(RTSpixel* pixel, float x, float y, float rgba[4]) {
    tracePointWith(pixel, x, y, 0, rgba);
}

RTSstate* visitPoint(RTSpixel* pixel, float x, float y) {
    PixelInTrace& self = *static_cast<PixelInTrace*>(pixel);
    Ray ray;
    RayCone cone;
    if (!self.nextRay(x, y, ray, cone)) return nullptr;
    ShadedSample found;
    const bool met =
        self.services->visit(ray, {&self.sample, 0, 1.0f, 0, cone}, self.visited, found);
    self.keepFirst(ray, found);
    return met ? &self.visited.state : nullptr;
}

void positionInPixel(RTSpixel* pixel, RTuint i, RTuint n, float xy[2]) {
    const PixelInTrace& self = *static_cast<const PixelInTrace*>(pixel);
    const glm::vec2 position = samplePosition(self.x, self.y, self.frame->seed, i, n);
    xy[0] = position.x;
    xy[1] = position.y;
}

} // namespace

PixelResult renderPixel(const Frame& frame, const CameraRays& camera, RayServices& services,
                        uint32_t x, uint32_t y) {
    PixelInTrace pixel;
    static_cast<RTSpixel&>(pixel) = {};
    pixel.structSize = sizeof(RTSpixel);
    pixel.state = &pixel.pixelState.state;
    pixel.x = x;
    pixel.y = y;
    pixel.samples = frame.samples;
    pixel.trace = tracePoint;
    pixel.samplePosition = positionInPixel;
    pixel.traceWith = tracePointWith;
    pixel.visit = visitPoint;
    pixel.frame = &frame;
    pixel.camera = &camera;
    pixel.services = &services;
    pixel.rays = 0;
    pixel.own = PixelSample(x, y, kOwnSample, frame.seed);
    services.atNoSurface(pixel.own, pixel.pixelState);

    const ShaderObject& object = *frame.renderingObject;
    float rgba[4] = {0.0f, 0.0f, 0.0f, 1.0f};
    const int answer = object.functions().renderPixel(object.block(), &pixel, rgba);
    PixelResult& result = pixel.result;
    result.bad |= answer != 0 || pixel.own.fault || pixel.sample.fault;
    for (const float value : rgba) result.bad |= !std::isfinite(value);
    if (!result.bad) result.color = {rgba[0], rgba[1], rgba[2], rgba[3]};
    return result;
}

} // namespace smart

// SPDX-License-Identifier: MIT
#include "libsmart/render/rendering_object.h"

#include <cmath>

namespace smart {
namespace {

/// The pixel that the object sees, and what the library keeps beside it.
struct PixelInTrace : RTSpixel {
    const Frame* frame;
    const CameraRays* camera;
    ShadingServices* services;
    PixelResult result;
    uint32_t rays = 0;
};

void tracePoint(RTSpixel* pixel, float x, float y, float rgba[4]) {
    PixelInTrace& self = *static_cast<PixelInTrace*>(pixel);
    for (int k = 0; k < 4; ++k) rgba[k] = k < 3 ? 0.0f : 1.0f;
    const double column = double(self.x) + x, row = double(self.y) + y;
    Ray ray;
    if (!self.camera->make(column, row, ray)) {
        self.result.bad = true;
        return;
    }
    self.services->beginSample(self.x, self.y, self.rays++);
    const ShadedSample sample = self.services->traceCameraRay(ray, self.camera->cone(column, row, ray));
    self.result.bad |= sample.bad;
    if (!self.result.hasFirst) {
        self.result.hasFirst = true;
        self.result.firstRay = ray;
        self.result.first = sample;
    }
    for (int k = 0; k < 4; ++k) rgba[k] = sample.color[k];
}

void positionInPixel(RTSpixel* pixel, RTuint i, RTuint n, float xy[2]) {
    const PixelInTrace& self = *static_cast<const PixelInTrace*>(pixel);
    const glm::vec2 position = samplePosition(self.x, self.y, self.frame->seed, i, n);
    xy[0] = position.x;
    xy[1] = position.y;
}

} // namespace

PixelResult renderPixel(const Frame& frame, const CameraRays& camera, ShadingServices& services,
                        uint32_t x, uint32_t y) {
    services.beginSample(x, y, 0);
    RTSstate state = services.emptyState();
    PixelInTrace pixel{};
    pixel.structSize = sizeof(RTSpixel);
    pixel.state = &state;
    pixel.x = x;
    pixel.y = y;
    pixel.samples = frame.samples;
    pixel.trace = tracePoint;
    pixel.samplePosition = positionInPixel;
    pixel.frame = &frame;
    pixel.camera = &camera;
    pixel.services = &services;

    const ShaderObject& object = *frame.renderingObject;
    float rgba[4] = {0.0f, 0.0f, 0.0f, 1.0f};
    const int answer = object.functions().renderPixel(object.block(), &pixel, rgba);
    PixelResult& result = pixel.result;
    result.bad |= answer != 0 || services.takeFault();
    for (const float value : rgba) result.bad |= !std::isfinite(value);
    if (!result.bad) result.color = {rgba[0], rgba[1], rgba[2], rgba[3]};
    return result;
}

} // namespace smart

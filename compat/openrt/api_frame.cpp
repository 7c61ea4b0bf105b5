// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdint>
#include <limits>

#include "compat/openrt/guard.h"
#include "compat/openrt/init_arguments.h"
#include "compat/openrt/tokens.h"
#include "openrt/rt_frame.h"

using namespace smart;
using namespace smart::compat;

namespace {

/// Settings that belong to the frame buffer, and like it must not change inside objects.
PixelTarget& target(Context& c) {
    c.recorder().requireOutsideObject();
    return c.recorder().frameSettings().target;
}

void setAux(AuxBuffers& aux, RTenum what, void* memory, RTuint format) {
    const auto require = [&](RTuint needed) {
        if (memory && format != needed)
            throwError(ErrorCode::InvalidEnum, "not the format of this auxiliary buffer");
    };
    switch (what) {
    case RT_DEPTH: require(RT_FLOAT), aux.depth = static_cast<float*>(memory); break;
    case RT_DISTANCE: require(RT_FLOAT), aux.distance = static_cast<float*>(memory); break;
    case RT_NORMAL: require(RT_RGB_32F), aux.normal = static_cast<float*>(memory); break;
    case RT_OBJECT_ID:
        require(RT_UNSIGNED_INT), aux.objectId = static_cast<uint32_t*>(memory);
        break;
    case RT_INSTANCE_ID:
        require(RT_UNSIGNED_INT), aux.instanceId = static_cast<uint32_t*>(memory);
        break;
    case RT_PRIMITIVE_ID:
        require(RT_UNSIGNED_INT), aux.primitiveId = static_cast<uint32_t*>(memory);
        break;
    case RT_ALBEDO:
        require(RT_RGB_32F);
        throwError(ErrorCode::InvalidOperation, "RT_ALBEDO is not part of this release");
    default: throwError(ErrorCode::InvalidEnum, "unknown auxiliary buffer");
    }
}

} // namespace

RTAPI void RTAPIENTRY rtSetFrameBuffer(RTubyte* fb, RTuint width, RTuint height, RTuint format) {
    guarded(__func__, [&](Context& c) {
        PixelTarget& settings = target(c);
        const PixelFormat pixelFormat = pixelFormatOf(format);
        requirePointer(fb, "the frame buffer");
        if (width == 0 || height == 0)
            throwError(ErrorCode::InvalidValue, "the frame buffer has no pixels");
        const uint64_t pixels = uint64_t(width) * height; // below 2^64
        if (pixels > uint64_t(std::numeric_limits<std::ptrdiff_t>::max()) /
                         bytesPerPixel(pixelFormat))
            throwError(ErrorCode::InvalidValue, "the frame buffer is larger than memory can be");
        settings.memory = fb;
        settings.width = width;
        settings.height = height;
        settings.format = pixelFormat;
    });
}

RTAPI void RTAPIENTRY rtFrameBufferStride(RTsizei bytes) {
    guarded(__func__, [&](Context& c) {
        PixelTarget& settings = target(c);
        if (bytes < 0) throwError(ErrorCode::InvalidValue, "the stride is negative");
        settings.stride = std::size_t(bytes);
    });
}

RTAPI void RTAPIENTRY rtSetAuxBuffer(RTenum what, void* memory, RTuint format) {
    guarded(__func__, [&](Context& c) { setAux(target(c).aux, what, memory, format); });
}

RTAPI void RTAPIENTRY rtSamples(RTuint n) {
    guarded(__func__, [&](Context& c) {
        FrameSettings& settings = c.recorder().frameSettings();
        if (n == 0 || n > kMaxSamples)
            throwError(ErrorCode::InvalidValue, "samples are 1 to 4096 a pixel");
        settings.samples = n;
    });
}
RTAPI void RTAPIENTRY rtSeed(RTuint seed) {
    guarded(__func__, [&](Context& c) { c.recorder().frameSettings().seed = seed; });
}
RTAPI void RTAPIENTRY rtRecursionLimit(RTuint n) {
    guarded(__func__, [&](Context& c) {
        FrameSettings& settings = c.recorder().frameSettings();
        if (n > kMaxRecursion)
            throwError(ErrorCode::InvalidValue, "the recursion limit is 256 at most");
        settings.recursionLimit = n;
    });
}
RTAPI void RTAPIENTRY rtWeightCutoff(RTfloat weight) {
    guarded(__func__, [&](Context& c) {
        FrameSettings& settings = c.recorder().frameSettings();
        if (!(weight >= 0 && weight <= 1))
            throwError(ErrorCode::InvalidValue, "the weight cut-off lies between 0 and 1");
        settings.weightCutoff = weight;
    });
}

RTAPI void RTAPIENTRY rtUseLight(RTuint shader) {
    recorded(__func__, [=](Context& c) { c.recorder().useLight(shader, true); });
}
RTAPI void RTAPIENTRY rtUseLightFast(RTuint shader) {
    recorded(__func__, [=](Context& c) { c.recorder().useLight(shader, false); });
}
RTAPI void RTAPIENTRY rtUseCamera(RTuint shader) {
    recorded(__func__, [=](Context& c) { c.recorder().useUnique(UniqueShader::Camera, shader); });
}
RTAPI void RTAPIENTRY rtUseEnvironmentShader(RTuint shader) {
    recorded(__func__,
             [=](Context& c) { c.recorder().useUnique(UniqueShader::Environment, shader); });
}
RTAPI void RTAPIENTRY rtUseRenderingObject(RTuint shader) {
    recorded(__func__,
             [=](Context& c) { c.recorder().useUnique(UniqueShader::RenderingObject, shader); });
}

RTAPI void RTAPIENTRY rtStartRendering(void) {
    guarded(__func__, [](Context& c) { c.frames().start(); });
}
RTAPI void RTAPIENTRY rtEndRendering(void) {
    guarded(__func__, [](Context& c) { c.frames().end(); });
}
RTAPI void RTAPIENTRY rtRender(void) {
    guarded(__func__, [](Context& c) { c.frames().render(); });
}
RTAPI void RTAPIENTRY rtFinish(void) {
    guarded(__func__, [](Context& c) { c.frames().finish(); });
}
RTAPI void RTAPIENTRY rtFlush(void) {
    guarded(__func__, [](Context& c) { c.recorder().requireOutsidePrimitive(); });
}

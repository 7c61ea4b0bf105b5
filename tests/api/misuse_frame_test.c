/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "misuse.h"

static RTubyte other[64];

static RTuint bufferFormat(void) { return rtSetFrameBuffer(other, 4, 4, RT_RGBA), 0u; }
static RTuint bufferNull(void) { return rtSetFrameBuffer(NULL, 4, 4, RT_RGBA_8), 0u; }
static RTuint bufferFlat(void) { return rtSetFrameBuffer(other, 0, 4, RT_RGBA_8), 0u; }
static RTuint bufferHuge(void) {
    return rtSetFrameBuffer(other, 0xFFFFFFFFu, 0xFFFFFFFFu, RT_RGBA_8), 0u;
}
static RTuint buffer(void) { return rtSetFrameBuffer(other, 4, 4, RT_RGBA_8), 0u; }
static RTuint stride(void) { return rtFrameBufferStride(-4), 0u; }
static RTuint strideLegal(void) { return rtFrameBufferStride(1024), 0u; }
static RTuint auxUnknown(void) { return rtSetAuxBuffer(RT_RGB_32F, other, RT_FLOAT), 0u; }
static RTuint auxFormat(void) { return rtSetAuxBuffer(RT_DEPTH, other, RT_UNSIGNED_INT), 0u; }
static RTuint auxIdFormat(void) { return rtSetAuxBuffer(RT_OBJECT_ID, other, RT_FLOAT), 0u; }
static RTuint auxAlbedo(void) { return rtSetAuxBuffer(RT_ALBEDO, other, RT_RGB_32F), 0u; }
static RTuint auxLegal(void) { return rtSetAuxBuffer(RT_DEPTH, other, RT_FLOAT), 0u; }
static RTuint samplesNone(void) { return rtSamples(0), 0u; }
static RTuint samplesMany(void) { return rtSamples(1000000), 0u; }
static RTuint samples(void) { return rtSamples(4), 0u; }
static RTuint seed(void) { return rtSeed(4), 0u; }
static RTuint recursionDeep(void) { return rtRecursionLimit(100000), 0u; }
static RTuint cutoffNan(void) { return rtWeightCutoff(NAN), 0u; }
static RTuint cutoffNegative(void) { return rtWeightCutoff(-0.5f), 0u; }
static RTuint threadsMany(void) { return rtThreads(1000000), 0u; }
static RTuint threads(void) { return rtThreads(1), 0u; }

static RTuint light(void) { return rtUseLight(ids.light), 0u; } /* the frame has it already */
static RTuint lightUnknown(void) { return rtUseLight(4711), 0u; }
static RTuint lightSurface(void) { return rtUseLight(ids.surface), 0u; }
static RTuint lightZero(void) { return rtUseLight(0), 0u; }
static RTuint fastUnknown(void) { return rtUseLightFast(4711), 0u; }
static RTuint fastSurface(void) { return rtUseLightFast(ids.surface), 0u; }
static RTuint fast(void) { return rtUseLightFast(ids.light), 0u; }
static RTuint cameraUnknown(void) { return rtUseCamera(4711), 0u; }
static RTuint cameraLight(void) { return rtUseCamera(ids.light), 0u; }
static RTuint camera(void) { return rtUseCamera(ids.camera), 0u; }
static RTuint environmentUnknown(void) { return rtUseEnvironmentShader(4711), 0u; }
static RTuint environmentCamera(void) { return rtUseEnvironmentShader(ids.camera), 0u; }
static RTuint environment(void) { return rtUseEnvironmentShader(ids.environment), 0u; }
static RTuint renderingUnknown(void) { return rtUseRenderingObject(4711), 0u; }
static RTuint renderingSurface(void) { return rtUseRenderingObject(ids.surface), 0u; }

static RTuint start(void) { return rtStartRendering(), 0u; }
static RTuint endRendering(void) { return rtEndRendering(), 0u; }
static RTuint render(void) { return rtRender(), 0u; }
static RTuint finish(void) { return rtFinish(), 0u; }
static RTuint flush(void) { return rtFlush(), 0u; }
static RTuint singular(void) {
    RTfloat zeros[16] = {0};
    rtMatrixMode(RT_PROJECTION);
    rtPushMatrix();
    rtLoadMatrixf(zeros);
    rtStartRendering();
    rtPopMatrix();
    rtMatrixMode(RT_MODELVIEW);
    return 0;
}
static RTuint shortStride(void) {
    rtFrameBufferStride(8);
    rtStartRendering();
    rtFrameBufferStride(0);
    return 0;
}

static RTuint genScene(void) { return rtGenScene(); }
static RTuint bindScene(void) { return rtBindScene(0), 0u; }
static RTuint bindUnknown(void) { return rtBindScene(1), 0u; }
static RTuint bindInvalid(void) { return rtBindScene(RT_INVALID), 0u; }
static RTuint deleteUnknown(void) { return rtDeleteScene(1), 0u; }
static RTuint deleteZero(void) { return rtDeleteScene(0), 0u; }
static RTuint queueFrame(void) { return rtQueueFrame(); }
static RTuint queueShortStride(void) {
    RTuint frame;
    rtFrameBufferStride(8);
    frame = rtQueueFrame();
    rtFrameBufferStride(0);
    return frame;
}
static RTuint depthNone(void) { return rtFrameDepth(0), 0u; }
static RTuint depth(void) { return rtFrameDepth(2), 0u; }
static RTuint waitUnknown(void) { return rtWaitFrame(4000000000u); }
static RTuint waitZero(void) { return rtWaitFrame(0); }
static RTuint waitInvalid(void) { return rtWaitFrame(RT_INVALID); }
static RTuint statusUnknown(void) { return rtFrameStatus(4000000000u); }
static RTuint progressUnknown(void) { return (RTuint)rtFrameProgress(4000000000u); }
static RTuint cancelUnknown(void) { return rtCancelFrame(4000000000u), 0u; }
static RTuint frameCallback(void) { return rtSetFrameCallback(NULL, NULL), 0u; }
static RTuint clear(void) { return rtClear(RT_COLOR_BUFFER_BIT), 0u; }
static RTuint clearUnknown(void) { return rtClear(RT_COLOR_BUFFER_BIT | 1u << 31), 0u; }
static RTuint clearDepth(void) { return rtClearDepth(0.5), 0u; }
static RTuint scissor(void) { return rtScissor(1, 2, 3, 4), 0u; }
static RTuint scissorNegative(void) { return rtScissor(1, 2, 3, -4), 0u; }
static RTuint depthRange(void) { return rtDepthRange(0.25, 0.5), 0u; }
static RTuint drawUnknown(void) { return rtDrawBuffer(RT_TRIANGLES), 0u; }
static RTuint drawRight(void) { return rtDrawBuffer(RT_RIGHT), 0u; }
static RTuint readNone(void) { return rtReadBuffer(RT_NONE), 0u; }
static RTuint readPixels(void) {
    unsigned char pixel[4];
    return rtReadPixels(0, 0, 1, 1, RT_RGBA, RT_UNSIGNED_BYTE, pixel), 0u;
}
static RTuint readNull(void) {
    return rtReadPixels(0, 0, 1, 1, RT_RGBA, RT_UNSIGNED_BYTE, NULL), 0u;
}
static RTuint readUnknown(void) {
    return rtReadPixels(0, 0, 1, 1, RT_RGBA, RT_TRIANGLES, framePixels), 0u;
}
static RTuint copyDepth(void) { return rtCopyPixels(0, 0, 1, 1, RT_DEPTH), 0u; }

int main(void) {
    static const Misuse misuses[] = {
        MISUSE(bufferFormat, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(bufferNull, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(bufferFlat, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(bufferHuge, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(buffer, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(buffer, IN_OBJECT, RT_INVALID_OPERATION),
        MISUSE(stride, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(strideLegal, IN_OBJECT, RT_INVALID_OPERATION),
        MISUSE(auxUnknown, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(auxFormat, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(auxIdFormat, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(auxAlbedo, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(auxLegal, IN_OBJECT, RT_INVALID_OPERATION),
        MISUSE(samplesNone, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(samplesMany, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(samples, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(seed, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(recursionDeep, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(cutoffNan, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(cutoffNegative, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(threadsMany, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(threads, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(light, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(light, IN_OBJECT, RT_INVALID_OPERATION),
        MISUSE(lightUnknown, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(lightSurface, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(lightZero, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(fastUnknown, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(fastSurface, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(fast, IN_OBJECT, RT_INVALID_OPERATION),
        MISUSE(cameraUnknown, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(cameraLight, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(camera, IN_OBJECT, RT_INVALID_OPERATION),
        MISUSE(camera, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(environmentUnknown, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(environmentCamera, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(environment, IN_OBJECT, RT_INVALID_OPERATION),
        MISUSE(renderingUnknown, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(renderingSurface, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(start, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(start, IN_OBJECT, RT_INVALID_OPERATION),
        MISUSE(start, IN_FLIGHT, RT_INVALID_OPERATION),
        MISUSE(endRendering, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(endRendering, IN_OBJECT, RT_INVALID_OPERATION),
        MISUSE(render, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(render, IN_OBJECT, RT_INVALID_OPERATION),
        MISUSE(finish, IN_OBJECT, RT_INVALID_OPERATION),
        MISUSE(flush, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(singular, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(shortStride, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE_ID(genScene, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE_ID(genScene, IN_OBJECT, RT_INVALID_OPERATION),
        MISUSE(bindUnknown, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(bindInvalid, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(bindScene, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(bindScene, IN_OBJECT, RT_INVALID_OPERATION),
        MISUSE(deleteUnknown, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(deleteZero, OUTSIDE, RT_NO_ERROR),
        MISUSE(deleteZero, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(deleteZero, IN_OBJECT, RT_INVALID_OPERATION),
        MISUSE_ID(queueFrame, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE_ID(queueFrame, IN_OBJECT, RT_INVALID_OPERATION),
        MISUSE_ID(queueShortStride, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(depthNone, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(depth, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(waitUnknown, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(waitUnknown, IN_FLIGHT, RT_INVALID_VALUE),
        MISUSE(waitUnknown, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(waitZero, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(waitInvalid, OUTSIDE, RT_INVALID_VALUE),
        MISUSE_ID(statusUnknown, IN_FLIGHT, RT_INVALID_VALUE),
        MISUSE_ID(statusUnknown, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(progressUnknown, IN_FLIGHT, RT_INVALID_VALUE),
        MISUSE(progressUnknown, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(cancelUnknown, IN_FLIGHT, RT_INVALID_VALUE),
        MISUSE(cancelUnknown, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(frameCallback, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(clear, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(clear, IN_OBJECT, RT_INVALID_OPERATION),
        MISUSE(clearUnknown, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(clearDepth, IN_OBJECT, RT_INVALID_OPERATION),
        MISUSE(scissor, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(scissorNegative, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(depthRange, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(drawUnknown, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(drawRight, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(readNone, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(readPixels, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(readPixels, IN_OBJECT, RT_INVALID_OPERATION),
        MISUSE(readNull, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(readUnknown, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(copyDepth, OUTSIDE, RT_INVALID_OPERATION),
    };
    return CHECK_MISUSES(misuses);
}

// SPDX-License-Identifier: MIT
#include "tests/bench/dynamic_frames.h"

#include <time.h>

#include <chrono>
#include <stdexcept>

#include "openrt/rt.h"
#include "tests/bench/dynamic.h"

namespace smart::bench {
namespace {

void placeCamera(const View& view) {
    const test::CameraPose& c = view.camera;
    rtMatrixMode(RT_PROJECTION);
    rtPerspective(c.fov, 1, 0.01, 100);
    rtMatrixMode(RT_MODELVIEW);
    rtLookAt(c.eye[0], c.eye[1], c.eye[2], c.target[0], c.target[1], c.target[2], c.up[0], c.up[1],
             c.up[2]);
}

/// One white light whose shadows count.
void light() {
    const float position[] = {2, 3, 1, 1};
    rtEnable(RT_LIGHTING);
    rtEnable(RT_LIGHT0);
    rtEnable(RT_NORMALIZE);
    rtEnable(RT_SHADOWS);
    rtLightfv(RT_LIGHT0, RT_POSITION, position);
}

RTuint defineModel(const std::vector<Triangle>& triangles) {
    const RTuint object = rtNewObject(RT_DEFINE);
    rtBegin(RT_TRIANGLES);
    for (const Triangle& triangle : triangles) {
        for (const float* corner : {triangle.v0, triangle.v1, triangle.v2}) {
            rtNormal3fv(corner);
            rtVertex3fv(corner);
        }
    }
    rtEnd();
    rtEndObject();
    return object;
}

/// Processor seconds of this thread: without what other threads took of its core meanwhile.
double processorTime() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

} // namespace

BallFrames::BallFrames(const DynamicScene& scene, unsigned threads, bool lit)
    : context_(rtCreateContext()) {
    if (!context_) throw std::runtime_error("OpenRT makes no context");
    rtMakeCurrent(context_);
    rtThreads(threads);
    placeCamera(scene.view());
    if (lit) light();
    object_ = defineModel(scene.triangles());
}

BallFrames::~BallFrames() {
    rtDestroyContext(context_);
}

void BallFrames::describe(const DynamicStep& step) const {
    for (const auto& m : step.matrices) {
        const float matrix[16] = {m[0], m[1], m[2], 0, m[3], m[4],  m[5],  0,
                                  m[6], m[7], m[8], 0, m[9], m[10], m[11], 1};
        rtPushMatrix();
        rtMultMatrixf(matrix);
        rtInstantiateObject(object_);
        rtPopMatrix();
    }
}

void BallFrames::check() const {
    if (rtGetError() != RT_NO_ERROR) throw std::runtime_error(rtGetErrorText());
}

DynamicFrame measureFrame(const DynamicScene& scene, const DynamicOptions& options, bool lit) {
    using Clock = std::chrono::steady_clock;
    const auto seconds = [](Clock::time_point from, Clock::time_point to) {
        return std::chrono::duration<double>(to - from).count();
    };
    std::vector<RTubyte> pixels(std::size_t(options.size) * options.size * 4);
    const BallFrames application(scene, options.threads, lit);
    rtSetFrameBuffer(pixels.data(), options.size, options.size, RT_RGBA_8);
    std::vector<double> describe, freeze, render, whole;
    for (unsigned number = 0; number <= options.repeat; ++number) {
        const DynamicStep step = scene.step(number);
        const auto start = Clock::now();
        application.describe(step);
        const auto described = Clock::now();
        const double before = processorTime();
        const RTuint frame = rtQueueFrame();
        const double frozen = processorTime() - before;
        rtWaitFrame(frame);
        const auto end = Clock::now();
        if (number == 0) continue;
        describe.push_back(seconds(start, described));
        freeze.push_back(frozen);
        render.push_back(seconds(described, end) - frozen);
        whole.push_back(seconds(start, end));
    }
    application.check();
    return {scene.instances(), lit,           median(describe),
            median(freeze),    median(render), median(whole)};
}

} // namespace smart::bench

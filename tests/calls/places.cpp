// SPDX-License-Identifier: MIT
#include "tests/calls/places.h"

#include <sys/wait.h>
#include <unistd.h>

#include "tests/calls/values.h"

namespace openrt::test {
namespace {

RTcontext left = nullptr;
RTuint frame = 0, openObject = 0;
RTfloat fed[256];
RTuint selected[256];

void corner(float x, float y) { rtVertex3f(x, y, 0.25f); }

void enterPrimitive() {
    rtBegin(RT_TRIANGLES);
    corner(-1, -1);
    corner(0, -1);
}
void leavePrimitive() {
    corner(0, 0);
    rtEnd();
}
void enterObject() {
    openObject = rtNewObject(RT_DEFINE);
    enterPrimitive();
    leavePrimitive();
}
void leaveObject() {
    enterPrimitive();
    leavePrimitive();
    rtEndObject();
    rtInstantiateObject(openObject);
}
void enterPrimitiveOfObject() {
    openObject = rtNewObject(RT_DEFINE);
    enterPrimitive();
}
void leavePrimitiveOfObject() {
    leavePrimitive();
    leaveObject();
}

void startFrame() {
    rtQueueFrame();
    rtInstantiateObject(1);
    frame = rtQueueFrame();
    rtInstantiateObject(1);
}
void endFrame() { rtWaitFrame(frame); }
void startRendering() { rtStartRendering(); }
void endRendering() { rtEndRendering(); }

void select() {
    rtSelectBuffer(256, selected);
    rtRenderMode(RT_SELECT);
}
void feed() {
    rtFeedbackBuffer(256, RT_3D, fed);
    rtRenderMode(RT_FEEDBACK);
}
void renderAgain() { rtRenderMode(RT_RENDER); }

void leaveContext() {
    left = rtGetCurrentContext();
    rtMakeCurrent(nullptr);
}
void returnToContext() { rtMakeCurrent(left); }

const std::function<void()>* callsInCallback = nullptr;
void callThem(RTuint, RTenum event, RTint, RTint, RTsizei, RTsizei, void*) {
    if (event == RT_DONE) (*callsInCallback)();
}

} // namespace

const std::vector<Place>& places() {
    static const std::vector<Place> all = {
        {"outside", [] {}, [] {}},
        {"in a primitive", enterPrimitive, leavePrimitive},
        {"in an object", enterObject, leaveObject},
        {"in a primitive of an object", enterPrimitiveOfObject, leavePrimitiveOfObject},
        {"in a list", [] { rtNewList(2, RT_COMPILE); }, [] { rtEndList(); }},
        {"in a list that executes", [] { rtNewList(2, RT_COMPILE_AND_EXECUTE); },
         [] { rtEndList(); }},
        {"frames queued", startFrame, endFrame},
        {"a frame started", startRendering, endRendering},
        {"selecting", select, renderAgain},
        {"feeding back", feed, renderAgain},
        {"with a tessellation polygon open",
         [] { rtuTessBeginPolygon(first(Kind::Tess).as<RTUtesselator*>(), nullptr); },
         [] { rtuTessEndPolygon(first(Kind::Tess).as<RTUtesselator*>()); }},
        {"without a context", leaveContext, returnToContext, false},
    };
    return all;
}

void insideFrameCallback(const std::function<void()>& calls) {
    callsInCallback = &calls;
    rtSetFrameCallback(callThem, nullptr);
    rtRender();
    rtSetFrameCallback(nullptr, nullptr);
}

bool inChild(const std::function<int()>& calls) {
    startFrame();
    const pid_t child = fork();
    if (child == 0) {
        alarm(60);
        _exit(calls());
    }
    int status = -1;
    waitpid(child, &status, 0);
    endFrame();
    return status == 0;
}

} // namespace openrt::test

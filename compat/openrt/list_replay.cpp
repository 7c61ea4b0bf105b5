// SPDX-License-Identifier: MIT
#include "compat/openrt/list_replay.h"

#include <memory>

#include "compat/openrt/guard.h"

namespace smart::compat {

namespace {

const char* nameOf(const CallStream& calls, const CallStream::Position& at) {
    switch (calls.op(at)) {
    case ListOp::Vertex3:
    case ListOp::Vertex4: return "rtVertex";
    case ListOp::Normal: return "rtNormal";
    case ListOp::Color: return "rtColor";
    default: break;
    }
    return calls.op(at) >= ListOp::TexCoord ? "rtTexCoord" : calls.callAt(at).function;
}

void make(Context& c, const CallStream& calls, const CallStream::Position& at) {
    switch (calls.op(at)) {
    case ListOp::Vertex3:
    case ListOp::Vertex4: c.recorder().vertex(calls.vertexAt(at)); break;
    case ListOp::Normal: c.recorder().normal(calls.vec3At(at)); break;
    case ListOp::Color: c.recorder().color(calls.vec4At(at)); break;
    default:
        if (calls.op(at) >= ListOp::TexCoord)
            c.recorder().texCoord(calls.vec4At(at), calls.unitAt(at));
        else
            calls.callAt(at).body(c);
    }
}

void makeEach(Context& c, const CallStream& calls, const ListSegment& segment) {
    for (CallStream::Position at = segment.begin; at.op < segment.end.op; calls.advance(at)) {
        try {
            make(c, calls, at);
        } catch (...) {
            report(nameOf(calls, at));
        }
    }
}

/// Whether there is a model of the run for the bound shader; one that a call fails in has none.
bool compile(Context& c, const CallStream& calls, ListSegment& run) {
    Recorder& recorder = c.recorder();
    const BoundShader& bound = recorder.shaders().bound();
    if (run.hasErrors || !bound.isSurface) return false;
    if (run.compiled && run.compiled->fits(bound, recorder.attributes().materials)) return true;
    run.compiled.reset();
    try {
        run.compiled.emplace(recorder.compileRun([&] {
            for (CallStream::Position at = run.begin; at.op < run.end.op; calls.advance(at))
                make(c, calls, at);
        }));
    } catch (const Error& error) {
        if (error.code() == ErrorCode::OutOfMemory) throw;
        run.hasErrors = true;
        return false;
    }
    return true;
}

bool place(Context& c, const CallStream& calls, ListSegment& run) {
    Recorder& recorder = c.recorder();
    if (!recorder.canPlaceRuns() || !compile(c, calls, run)) return false;
    recorder.placeRun(*run.compiled);
    if (run.color) recorder.color(*run.color);
    if (run.normal) recorder.normal(*run.normal);
    for (std::size_t unit = 0; unit < kTextureUnits; ++unit)
        if (run.texCoords[unit]) recorder.texCoord(*run.texCoords[unit], unit);
    for (const std::size_t number : run.attributeCalls) calls.call(number).body(c);
    return true;
}

} // namespace

void replayList(Context& c, uint32_t name) {
    DisplayLists& lists = c.lists();
    if (lists.depth() == DisplayLists::kMaxNesting) return;
    if (lists.callsExhausted())
        throwError(ErrorCode::InvalidOperation,
                   "the lists that a list calls call lists more than " +
                       std::to_string(DisplayLists::kMaxCalls) + " times");
    // Both may be let go of on the way, by a call in the list or by who hears of an error.
    const std::shared_ptr<DisplayList> list = lists.find(name);
    if (!list) return;
    const std::shared_ptr<Context> keepAlive =
        lists.depth() == 0 ? currentContextShared() : nullptr;
    const DisplayLists::Replay replay(lists);
    for (ListSegment& segment : list->segments()) {
        try {
            if (segment.isRun && place(c, list->calls(), segment)) continue;
        } catch (...) {
            report("rtCallList");
            continue;
        }
        makeEach(c, list->calls(), segment);
    }
}

} // namespace smart::compat

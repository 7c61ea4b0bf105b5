// SPDX-License-Identifier: MIT
// The layers of the scene under way: which primitives are seen alike, and what clears leave.
#include <algorithm>
#include <utility>

#include "compat/recorder/recorder.h"

namespace smart::compat {

LayerView Recorder::currentView() const {
    const FrameSettings& settings = frameSettings_;
    LayerView view;
    view.projection = matrices_.projection();
    view.viewport = settings.viewport;
    if (settings.scissorTest) view.scissor = scissorNow();
    view.depthNear = float(settings.depthNear);
    view.depthFar = float(settings.depthFar);
    view.drawsColor = settings.drawsColor;
    return view;
}

Viewport Recorder::scissorNow() const {
    const PixelTarget& target = frameSettings_.target;
    return frameSettings_.scissor.value_or(Viewport{0, 0, target.width, target.height});
}

void Recorder::enterLayer() {
    const LayerView view = currentView();
    if (scene().view == view) return;
    if (hasContent()) endLayer();
    scene().view = view;
}

bool Recorder::hasContent() const {
    const SceneRecording& recording = scenes_.bound();
    return !recording.instances.empty() || recording.loose.hasPrimitives();
}

void Recorder::endLayer() {
    SceneRecording& recording = scene();
    if (recording.below.capacity() == recording.below.size())
        recording.below.reserve(2 * recording.below.capacity() + 2);
    endLooseRun(); // the last step that may fail
    FinishedLayer& layer = recording.below.emplace_back();
    layer.view = *recording.view;
    layer.instances = std::exchange(recording.instances, {});
    layer.clears = std::exchange(recording.clears, {});
    recording.view.reset();
}

void Recorder::clear(bool color, bool depth) {
    requireOutsideObject();
    const FrameSettings& settings = frameSettings_;
    const FixedFragmentOps& ops = fixedState_.state().ops;
    BufferClear clear;
    if (settings.scissorTest) clear.scissor = scissorNow();
    if (color && settings.drawsColor)
        std::copy_n(ops.colorMask, 4, clear.colorMask);
    clear.color = settings.clearColor;
    if (depth && ops.depthMask) clear.depth = float(settings.clearDepth);
    const bool writes = clear.depth || std::any_of(clear.colorMask, clear.colorMask + 4,
                                                   [](bool channel) { return channel; });
    if (writes) {
        SceneRecording& recording = scene();
        if (hasContent() && !forgetEverything({clear})) endLayer();
        std::vector<BufferClear>& clears = recording.clears;
        clears.reserve(clears.size() + 1);
        std::erase_if(clears,
                      [&](const BufferClear& before) { return coversAll(clear, before); });
        clears.push_back(clear);
        if (forgetEverything(clears)) {
            recording.below.clear();
            recording.instances = {};
            recording.loose = GeometryRecording();
            recording.looseCount = 0;
            recording.view.reset();
        }
        ++recording.additions;
    }
    fixedState_.bufferCleared();
}

} // namespace smart::compat

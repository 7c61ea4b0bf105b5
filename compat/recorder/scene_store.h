// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>

#include "compat/recorder/scene_recording.h"

namespace smart::compat {

/// The scenes of one context, and which of them is bound. Ids count from 1 and are never used
/// again; scene 0 always exists. A function that throws has changed nothing.
class SceneStore {
public:
    SceneStore() = default;
    SceneStore(const SceneStore&) = delete;
    SceneStore& operator=(const SceneStore&) = delete;

    uint32_t add();
    /// Throws Error (InvalidValue) for an unknown id, as remove() does.
    void bind(uint32_t id);
    /// Binds scene 0 if the removed one was bound; scene 0 itself stays.
    void remove(uint32_t id);

    uint32_t boundId() const { return boundId_; }
    SceneRecording& bound() { return *bound_; }
    const SceneRecording& bound() const { return *bound_; }

private:
    std::map<uint32_t, SceneRecording>::iterator find(uint32_t id);

    std::map<uint32_t, SceneRecording> scenes_ = {{0, {}}};
    SceneRecording* bound_ = &scenes_.begin()->second;
    uint32_t boundId_ = 0, last_ = 0;
};

} // namespace smart::compat

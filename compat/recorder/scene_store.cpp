// SPDX-License-Identifier: MIT
#include "compat/recorder/scene_store.h"

#include <string>

#include "libsmart/base/error.h"

namespace smart::compat {

std::map<uint32_t, SceneRecording>::iterator SceneStore::find(uint32_t id) {
    const auto found = scenes_.find(id);
    if (found == scenes_.end())
        throw Error(ErrorCode::InvalidValue, "no scene has the id " + std::to_string(id));
    return found;
}

uint32_t SceneStore::add() {
    if (last_ == 0xFFFFFFFEu) throw Error(ErrorCode::OutOfMemory, "no scene id is left");
    scenes_.try_emplace(last_ + 1);
    return ++last_;
}

void SceneStore::bind(uint32_t id) {
    bound_ = &find(id)->second;
    boundId_ = id;
}

void SceneStore::remove(uint32_t id) {
    if (id == 0) return;
    const auto removed = find(id);
    if (boundId_ == id) bind(0);
    scenes_.erase(removed);
}

} // namespace smart::compat

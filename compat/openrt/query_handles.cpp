// SPDX-License-Identifier: MIT
#include "compat/openrt/query_handles.h"

#include <map>
#include <mutex>
#include <shared_mutex>
#include <utility>

#include "libsmart/base/error.h"
#include "libsmart/base/immortal.h"

namespace smart::compat {

namespace {

struct QueryScenes {
    std::shared_mutex mutex;
    std::map<uint32_t, ScenePtr> scenes;
    uint32_t last = 0;
};

QueryScenes& all() {
    static Immortal<QueryScenes> scenes;
    return scenes.get();
}

} // namespace

uint32_t addQueryScene(ScenePtr scene) {
    const std::unique_lock lock(all().mutex);
    if (all().last == 0xFFFFFFFEu) throw Error(ErrorCode::OutOfMemory, "no handle is left");
    all().scenes.emplace(all().last + 1, std::move(scene));
    return ++all().last;
}

ScenePtr findQueryScene(uint32_t handle) {
    const std::shared_lock lock(all().mutex);
    const auto found = all().scenes.find(handle);
    return found == all().scenes.end() ? nullptr : found->second;
}

bool releaseQueryScene(uint32_t handle) {
    ScenePtr scene; // ends outside the lock
    const std::unique_lock lock(all().mutex);
    const auto found = all().scenes.find(handle);
    if (found == all().scenes.end()) return false;
    scene = std::move(found->second);
    all().scenes.erase(found);
    return true;
}

void releaseAllQueryScenes() {
    std::map<uint32_t, ScenePtr> old;
    const std::unique_lock lock(all().mutex);
    old.swap(all().scenes);
}

} // namespace smart::compat

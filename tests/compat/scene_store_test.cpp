// SPDX-License-Identifier: MIT
#include "compat/recorder/scene_store.h"

#include <gtest/gtest.h>

#include "libsmart/base/error.h"

namespace smart::compat {
namespace {

TEST(SceneStore, SceneZeroIsBoundAndStays) {
    SceneStore store;
    EXPECT_EQ(store.boundId(), 0u);
    store.bound().additions = 7;
    store.remove(0);
    EXPECT_EQ(store.bound().additions, 7u);
}

TEST(SceneStore, ScenesKeepWhatTheyHold) {
    SceneStore store;
    EXPECT_EQ(store.add(), 1u);
    EXPECT_EQ(store.add(), 2u);
    EXPECT_EQ(store.boundId(), 0u);
    for (const uint32_t id : {0u, 1u, 2u}) {
        store.bind(id);
        store.bound().additions = 10 + id;
    }
    for (const uint32_t id : {1u, 0u, 2u}) {
        store.bind(id);
        EXPECT_EQ(store.boundId(), id);
        EXPECT_EQ(store.bound().additions, 10 + id);
    }
    store.remove(1); // not the bound one
    EXPECT_EQ(store.boundId(), 2u);
    store.remove(2);
    EXPECT_EQ(store.boundId(), 0u);
    EXPECT_EQ(store.bound().additions, 10u);
    EXPECT_EQ(store.add(), 3u);
}

TEST(SceneStore, UnknownIdsAreRefused) {
    SceneStore store;
    store.add();
    store.bind(1);
    for (const uint32_t id : {2u, 0xFFFFFFFFu}) {
        EXPECT_THROW(store.bind(id), Error);
        EXPECT_THROW(store.remove(id), Error);
        EXPECT_EQ(store.boundId(), 1u);
    }
}

} // namespace
} // namespace smart::compat

// SPDX-License-Identifier: MIT
#include "compat/recorder/texture_store.h"

#include <gtest/gtest.h>

#include <set>

#include "libsmart/base/error.h"

namespace smart::compat {
namespace {

std::shared_ptr<const Texture> image(TextureOptions options = {}) {
    return std::make_shared<const Texture>(2, 1, 1, TexelType::Byte, std::vector<std::byte>(2),
                                           options);
}

TEST(TextureStore, GeneratesUnusedIds) {
    TextureStore store;
    store.bind(2);
    std::set<uint32_t> ids;
    for (int i = 0; i < 100; ++i) ids.insert(store.generate());
    EXPECT_EQ(ids.size(), 100u);
    EXPECT_FALSE(ids.contains(0) || ids.contains(2));
    EXPECT_FALSE(store.exists(*ids.begin())) << "not before it is bound";
    EXPECT_TRUE(store.exists(2));
    EXPECT_THROW(store.bind(TextureStore::kMaxId + 1), Error);
    EXPECT_EQ(store.bound(), 2u);
}

TEST(TextureStore, FreezesAndKeepsWhatWasFrozen) {
    TextureStore store;
    store.bind(3);
    store.setImage(image());
    const auto first = store.freeze();
    EXPECT_EQ(store.freeze(), first) << "nothing changed";
    ASSERT_GT(first->size(), 3u);
    EXPECT_EQ((*first)[0], nullptr);
    ASSERT_NE((*first)[3], nullptr);

    TextureOptions options = store.options();
    options.wrapS = TextureWrap::Mirror;
    store.setOptions(options);
    const auto second = store.freeze();
    EXPECT_NE(second, first);
    EXPECT_EQ((*second)[3]->options().wrapS, TextureWrap::Mirror);
    EXPECT_EQ((*first)[3]->options().wrapS, TextureWrap::Repeat);

    TextureOptions srgb;
    srgb.srgb = true;
    store.setImage(image(srgb));
    options = store.options();
    options.filter = TextureFilter::Nearest;
    store.setOptions(options);
    EXPECT_TRUE((*store.freeze())[3]->options().srgb) << "a filter does not change the encoding";

    store.remove(3);
    EXPECT_EQ(store.bound(), 0u);
    EXPECT_LT(store.freeze()->size(), 4u);
    EXPECT_NE((*first)[3], nullptr);
}

} // namespace
} // namespace smart::compat

// SPDX-License-Identifier: MIT
#include "compat/recorder/texture_store.h"

#include <gtest/gtest.h>

#include <set>

#include "libsmart/base/error.h"

namespace smart::compat {
namespace {

TextureImagePtr image(uint32_t width, uint32_t height, uint8_t value = 0) {
    return std::make_shared<const TextureImage>(
        width, height, 1, TexelType::Byte, false,
        std::vector<std::byte>(width * height, std::byte(value)));
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
    store.setImage(0, image(2, 1), 1);
    const auto first = store.freeze();
    EXPECT_EQ(store.freeze(), first) << "nothing changed";
    ASSERT_GT(first->size(), 3u);
    EXPECT_EQ((*first)[0], nullptr);
    ASSERT_NE((*first)[3], nullptr);

    TextureParameters parameters = store.parameters();
    parameters.options.wrapS = TextureWrap::Mirror;
    store.setParameters(parameters);
    const auto second = store.freeze();
    EXPECT_NE(second, first);
    EXPECT_EQ((*second)[3]->options().wrapS, TextureWrap::Mirror);
    EXPECT_EQ((*first)[3]->options().wrapS, TextureWrap::Repeat);

    store.remove(3);
    EXPECT_EQ(store.bound(), 0u);
    EXPECT_LT(store.freeze()->size(), 4u);
    EXPECT_NE((*first)[3], nullptr);
}

} // namespace
} // namespace smart::compat

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

/// Value of the frozen texture 1 where a sample covers `side` of its image.
float lookUp(TextureStore& store, float side) {
    const auto table = store.freeze();
    const auto& texture = table->at(1);
    return texture ? texture->sample(0.5f, 0.5f, side).r * 255.0f : -1.0f;
}

void setParameters(TextureStore& store, void (*change)(TextureParameters&)) {
    TextureParameters parameters = store.parameters();
    change(parameters);
    store.setParameters(parameters);
}

TEST(TextureStore, StartsAsOpenGLSays) {
    TextureStore store;
    store.bind(1);
    const TextureParameters& p = store.parameters();
    EXPECT_EQ(p.options.wrapS, TextureWrap::Repeat);
    EXPECT_EQ(p.options.magnification, TextureFilter::Linear);
    EXPECT_EQ(p.options.minification,
              (MinificationFilter{TextureFilter::Nearest, LevelChoice::Linear}));
    EXPECT_EQ(p.options.minLevel, -1000);
    EXPECT_EQ(p.options.maxLevel, 1000);
    EXPECT_EQ(p.options.lastLevel, 1000u);
    EXPECT_FALSE(p.generateMipmap);
}

TEST(TextureStore, GivenLevelsAreUsedWhenAllAreThere) {
    TextureStore store;
    store.bind(1);
    store.setImage(0, image(4, 2, 10), 1);
    store.setImage(1, image(2, 1, 20), 1);
    EXPECT_EQ(lookUp(store, 9), 10) << "the last level lacks: the base level";
    store.setImage(2, image(1, 1, 30), 1);
    EXPECT_EQ(lookUp(store, 9), 30);
    EXPECT_EQ(lookUp(store, 0), 10);
    store.setImage(1, image(2, 2, 20), 1);
    EXPECT_EQ(lookUp(store, 9), 10) << "a level of the wrong size";
    store.setImage(1, image(2, 1, 20), 2);
    EXPECT_EQ(lookUp(store, 9), 10) << "of another internal format";
    store.setImage(1, nullptr, 1);
    EXPECT_EQ(lookUp(store, 9), 10);
    setParameters(store, [](TextureParameters& p) { p.options.lastLevel = 0; });
    EXPECT_EQ(lookUp(store, 9), 10) << "complete again: one level";
    store.setImage(1, image(2, 1, 20), 1);
    setParameters(store, [](TextureParameters& p) { p.options.lastLevel = 1; });
    EXPECT_EQ(lookUp(store, 9), 20);
    setParameters(store, [](TextureParameters& p) { p.options.firstLevel = 1; });
    EXPECT_EQ(lookUp(store, 0), 20);
    setParameters(store, [](TextureParameters& p) { p.options.firstLevel = 3; });
    EXPECT_EQ(lookUp(store, 0), -1) << "no image at the base level: no texture";
    store.setImage(3, image(7, 7, 40), 1);
    EXPECT_EQ(lookUp(store, 9), 40) << "the base lies behind the last level: the base alone";
    store.setImage(0, nullptr, 1);
    setParameters(store, [](TextureParameters& p) { p.options.firstLevel = 0; });
    EXPECT_EQ(lookUp(store, 9), -1);
}

TEST(TextureStore, AnIncompleteTextureIsMagnifiedOnly) {
    TextureStore store;
    store.bind(1);
    store.setImage(0, std::make_shared<const TextureImage>(
                          2, 1, 1, TexelType::Byte, false,
                          std::vector<std::byte>{std::byte(0), std::byte(200)}),
                   1);
    EXPECT_EQ(lookUp(store, 9), 100) << "linear, not nearest as the minification filter";
}

TEST(TextureStore, LevelsAreMadeFromTheBaseLevelWhenItIsGiven) {
    TextureStore store;
    store.bind(1);
    store.setImage(0, image(4, 4, 10), 1);
    setParameters(store, [](TextureParameters& p) { p.generateMipmap = true; });
    EXPECT_EQ(store.info(1).width, 0u) << "nothing was given since";
    store.setImage(1, image(2, 2, 99), 1);
    store.setImage(0, image(4, 4, 50), 7);
    EXPECT_EQ(store.info(2).width, 1u);
    EXPECT_EQ(store.info(2).internalFormat, 7);
    EXPECT_EQ(store.info(3).channels, 0u);
    ASSERT_NE(store.image(2), nullptr);
    EXPECT_EQ(store.image(2)->width(), 1u);
    EXPECT_EQ(store.image(3), nullptr);
    const auto table = store.freeze();
    EXPECT_EQ((*table)[1]->bytes(), 16u);
    EXPECT_EQ(lookUp(store, 0.5f), 50) << "the level given before was dropped";
    EXPECT_EQ((*table)[1]->bytes(), 21u);
    setParameters(store, [](TextureParameters& p) { p.options.wrapS = TextureWrap::Mirror; });
    EXPECT_EQ((*store.freeze())[1]->bytes(), 21u) << "other parameters keep what was made";
    store.setImage(1, image(2, 2, 60), 7);
    EXPECT_EQ(lookUp(store, 0.5f), 60) << "a level given afterwards";
    EXPECT_EQ(lookUp(store, 9), 50);
    setParameters(store, [](TextureParameters& p) { p.options.firstLevel = 2; });
    EXPECT_EQ(lookUp(store, 0), 50) << "a made level as the base";
    setParameters(store, [](TextureParameters& p) {
        p.options.firstLevel = 0;
        p.generateMipmap = false;
    });
    store.setImage(0, image(4, 4, 70), 7);
    EXPECT_EQ(lookUp(store, 9), 70) << "no longer made: incomplete";
    EXPECT_EQ(store.image(2), nullptr);
    EXPECT_EQ((*table)[1]->sample(0.5f, 0.5f, 1.0f).r * 255.0f, 50) << "frames keep theirs";
}

// OpenGL 1.5, section 3.8.10.
TEST(TextureStore, FixedFunctionSeesCompleteTexturesOnly) {
    TextureStore store;
    EXPECT_EQ(store.completeBound(), nullptr) << "texture 0 has no image";
    store.setImage(0, image(4, 2), 1);
    EXPECT_EQ(store.completeBound(), nullptr) << "the filter of the start asks for levels";
    setParameters(store, [](TextureParameters& p) {
        p.options.minification = {TextureFilter::Linear, LevelChoice::First};
    });
    ASSERT_NE(store.completeBound(), nullptr) << "texture 0 is one too";
    EXPECT_EQ(store.completeBound()->format(), TexelFormat::Luminance);
    store.setImage(0, image(4, 2), 1, TexelFormat::Intensity);
    EXPECT_EQ(store.completeBound()->format(), TexelFormat::Intensity);
    setParameters(store, [](TextureParameters& p) {
        p.options.minification = {TextureFilter::Linear, LevelChoice::Linear};
    });
    store.setImage(1, image(2, 1), 1);
    EXPECT_EQ(store.completeBound(), nullptr);
    store.setImage(2, image(1, 1), 1);
    EXPECT_NE(store.completeBound(), nullptr);
    store.setImage(1, image(2, 2), 1);
    EXPECT_EQ(store.completeBound(), nullptr) << "a level of the wrong size";
    store.bind(5);
    EXPECT_EQ(store.completeBound(), nullptr);
}

} // namespace
} // namespace smart::compat

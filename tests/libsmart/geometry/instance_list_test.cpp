// SPDX-License-Identifier: MIT
// Truth: what was put in.
#include "libsmart/geometry/instance_list.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <vector>

#include "libsmart/geometry/model_builder.h"

namespace smart {
namespace {

ModelPtr makeModel() {
    ModelBuilder builder;
    builder.triangles = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 1}}};
    return std::move(builder).build();
}

std::shared_ptr<const ShaderReplacement> replacementBy(uint32_t shader) {
    auto replacement = std::make_shared<ShaderReplacement>();
    replacement->all = true;
    replacement->allBy = shader;
    return replacement;
}

void expectSame(const InstanceView& placed, const Instance& given) {
    const Instance found = asGiven(placed);
    EXPECT_TRUE(found.sameAs(given));
    EXPECT_EQ(found.toParent, given.toParent);
    EXPECT_EQ(found.objectId, given.objectId);
}

class InstanceListTest : public ::testing::Test {
protected:
    /// Of few kinds, in any order.
    Instance any() {
        Instance instance;
        instance.model = models_[random_() % 2];
        instance.inherited.color.x = float(random_() % 3);
        instance.inherited.ownNormal = random_() % 2 == 0;
        if (random_() % 2) instance.replacement = replacementBy(uint32_t(random_() % 2));
        instance.objectId = uint32_t(random_() % 1000);
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 3; ++row) instance.toParent[column][row] = double(random_());
        return instance;
    }
    static constexpr std::size_t kKinds = 2 * 3 * 2 * 3;

    const ModelPtr models_[2] = {makeModel(), makeModel()};
    std::mt19937 random_{5};
};

TEST_F(InstanceListTest, GivesBackWhatWasAddedAndKeepsWhatIsSharedOnce) {
    InstanceList list;
    std::vector<Instance> given;
    for (int i = 0; i < 3000; ++i) {
        given.push_back(any());
        list.add(given.back());
    }
    ASSERT_EQ(list.size(), given.size());
    for (std::size_t i = 0; i < given.size(); ++i) expectSame(list.views()[i], given[i]);
    EXPECT_EQ(list.traits().size(), kKinds);
    list.shrink();
    EXPECT_LT(list.bytes(), 3400 * sizeof(InstanceView) + 12000);
    for (std::size_t i = 0; i < given.size(); ++i) expectSame(list.views()[i], given[i]);
    given.push_back(any()); // it may go on
    list.add(given.back());
    expectSame(list.views().back(), given.back());
    EXPECT_EQ(list.traits().size(), kKinds);
}

TEST_F(InstanceListTest, CopiesAreApartAndListsCanBeJoined) {
    std::vector<Instance> given;
    for (int i = 0; i < 50; ++i) given.push_back(any());
    const InstanceList first(given);
    InstanceList list = first;
    const InstanceList second = {any(), any(), given[0]};
    list.add(second);
    list.add(InstanceList());
    ASSERT_EQ(list.size(), 53u);
    EXPECT_EQ(first.size(), 50u);
    for (std::size_t i = 0; i < 50; ++i) {
        expectSame(first.views()[i], given[i]);
        expectSame(list.views()[i], given[i]);
    }
    for (std::size_t i = 0; i < 3; ++i)
        expectSame(list.views()[50 + i], asGiven(second.views()[i]));
    EXPECT_EQ(list.views()[52].traits, list.views()[0].traits);
    const InstanceList moved = std::move(list);
    expectSame(moved.views()[52], given[0]);
}

TEST_F(InstanceListTest, ColoursAreToldApartToTheBit) {
    InstanceList list;
    Instance instance = any();
    for (const float red : {0.0f, -0.0f, 1.0f, std::nextafter(1.0f, 2.0f)}) {
        instance.inherited.color.x = red;
        list.add(instance);
    }
    EXPECT_EQ(list.traits().size(), 4u);
}

TEST_F(InstanceListTest, ReplacementsByPairsHaveManyHashes) {
    std::set<std::size_t> hashes;
    Instance instance = any();
    for (uint32_t by = 0; by < 1000; ++by) {
        auto replacement = std::make_shared<ShaderReplacement>();
        replacement->pairs = {{1, by}, {2, 3}};
        instance.replacement = std::move(replacement);
        hashes.insert(instance.hash());
    }
    EXPECT_EQ(hashes.size(), 1000u);
}

} // namespace
} // namespace smart

// SPDX-License-Identifier: MIT
#include "libsmart/geometry/model_builder.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "tests/support/procedural_meshes.h"

namespace smart {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

const ModelBuildOptions kKdTree{.quality = BuildQuality::KdTree};

template <class Tree>
std::set<uint32_t> referenced(const Tree& tree) {
    return {tree.prims.begin(), tree.prims.end()};
}

Instance place(ModelPtr model, double x = 0) {
    Instance instance;
    instance.model = std::move(model);
    instance.toParent[3].x = x;
    return instance;
}

TEST(ModelBuilderTest, DroppedTrianglesKeepTheirNumbers) {
    const std::vector<Triangle> mesh = test::icosphere(2);
    const std::vector<Triangle> bad = {{{kNan, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                                       {{0, 0, 0}, {kInf, 0, 0}, {0, 1, 0}},
                                       {{0, 0, 0}, {1, 0, 0}, {0, -kInf, 0}},
                                       {{5, 5, 5}, {5, 5, 5}, {5, 5, 5}},
                                       {{0, 0, 0}, {9, 9, 9}, {3, 3, 3}}};
    ModelBuilder builder;
    std::set<uint32_t> expected;
    uint32_t dropped = 0;
    for (std::size_t i = 0; i < mesh.size(); ++i) {
        if (i % 7 == 3) {
            builder.triangles.push_back(bad[dropped % bad.size()]);
            ++dropped;
        }
        expected.insert(uint32_t(builder.triangles.size()));
        builder.triangles.push_back(mesh[i]);
    }
    const std::size_t count = builder.triangles.size();
    const ModelPtr model = std::move(builder).build(kKdTree);
    EXPECT_EQ(model->droppedTriangles, dropped);
    EXPECT_EQ(model->triangles.size(), count);
    EXPECT_EQ(referenced(model->kdTree()), expected);
    for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(model->bounds.lo[k], -1, 0.1);
        EXPECT_NEAR(model->bounds.hi[k], 1, 0.1);
    }
    EXPECT_GT(model->treeEvents(), 0u);
}

TEST(ModelBuilderTest, ViewShowsTheModel) {
    ModelBuilder builder;
    builder.triangles = test::icosphere(1);
    const ModelPtr model = std::move(builder).build(kKdTree);
    const ModelView& view = model->view();
    EXPECT_EQ(view.triangles, model->triangles.data());
    EXPECT_EQ(view.records, nullptr);
    EXPECT_EQ(view.tree.nodes, model->kdTree().nodes.data());
    EXPECT_EQ(view.tree.prims, model->kdTree().prims.data());
    EXPECT_EQ(view.childCount, 0u);
    EXPECT_EQ(view.childTree.nodes, nullptr);
    float largest = 0;
    for (int k = 0; k < 3; ++k) {
        EXPECT_EQ(view.tree.lo[k], model->kdTree().bounds.lo[k]);
        EXPECT_EQ(view.tree.hi[k], model->kdTree().bounds.hi[k]);
        largest = std::max({largest, -view.tree.lo[k], view.tree.hi[k]});
    }
    EXPECT_EQ(view.tree.maxAbs, largest);
}

TEST(ModelBuilderTest, NothingToHitIsNoError) {
    for (const BuildQuality quality : {BuildQuality::Nicest, BuildQuality::KdTree}) {
        const ModelPtr empty = ModelBuilder().build({.quality = quality});
        EXPECT_TRUE(empty->bounds.empty());
        EXPECT_EQ(empty->view().tree.nodes, nullptr);
        EXPECT_EQ(empty->view().wide.nodes, nullptr);
        EXPECT_EQ(empty->levels, 1u);

        ModelBuilder builder;
        builder.triangles = {{{0, 0, 0}, {0, 0, 0}, {1, 1, 1}}};
        const ModelPtr dropped = std::move(builder).build({.quality = quality});
        EXPECT_TRUE(dropped->bounds.empty());
        EXPECT_EQ(dropped->view().tree.nodes, nullptr);
        EXPECT_EQ(dropped->view().wide.nodes, nullptr);
        EXPECT_EQ(dropped->view().tree.maxAbs, 0);
        EXPECT_EQ(dropped->droppedTriangles, 1u);
    }
}

TEST(ModelBuilderTest, NestedModelsAddLevelsAndBounds) {
    ModelBuilder leafBuilder;
    leafBuilder.triangles = test::icosphere(1);
    const ModelPtr leaf = std::move(leafBuilder).build();
    EXPECT_EQ(leaf->levels, 1u);

    ModelBuilder middleBuilder;
    middleBuilder.children = {place(leaf, -10), place(leaf, 10)};
    const ModelPtr middle = std::move(middleBuilder).build();
    EXPECT_EQ(middle->levels, 2u);
    EXPECT_NEAR(middle->bounds.lo[0], -11, 0.1);
    EXPECT_NEAR(middle->bounds.hi[0], 11, 0.1);
    EXPECT_EQ(middle->view().childCount, 2u);
    EXPECT_EQ(middle->view().wide.nodes, nullptr);
    EXPECT_EQ(referenced(middle->children.tree()), (std::set<uint32_t>{0, 1}));

    ModelBuilder topBuilder;
    topBuilder.triangles = {{{0, 50, 0}, {1, 50, 0}, {0, 50, 1}}};
    topBuilder.children = {place(leaf), place(middle, 100)};
    const ModelPtr top = std::move(topBuilder).build();
    EXPECT_EQ(top->levels, 3u);
    EXPECT_NEAR(top->bounds.hi[0], 111, 0.1);
    EXPECT_EQ(top->bounds.hi[1], 50);
    EXPECT_EQ(top->view().children[1].model, &middle->view());
}

TEST(ModelBuilderTest, ShadingIsKeptAsGiven) {
    ModelBuilder builder;
    builder.triangles = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    builder.shading.corners = {{0, 1, 2}, {0, 2, 3}};
    builder.shading.firstColor = 1;
    builder.shading.colors = {glm::vec4(1), glm::vec4(2), glm::vec4(3)};
    builder.shading.shaders = {7, 9};
    builder.shading.slots = {0, 1};
    const ModelPtr model = std::move(builder).build();
    EXPECT_EQ(model->shading.corners[1][2], 3u);
    EXPECT_EQ(model->shading.colors[2], glm::vec4(3));
    EXPECT_EQ(model->shading.slots, (std::vector<uint32_t>{0, 1}));
    EXPECT_EQ(model->shading.shaders, (std::vector<uint32_t>{7, 9}));
}

TEST(ModelBuilderTest, ThreadsDoNotChangeTheTree) {
    ModelBuilder one, two;
    one.triangles = two.triangles = test::bumpySphere(4000);
    ModelBuildOptions options = kKdTree;
    const ModelPtr a = std::move(one).build(options);
    options.threads = 2;
    const ModelPtr b = std::move(two).build(options);
    EXPECT_EQ(a->kdTree().prims, b->kdTree().prims);
    ASSERT_EQ(a->kdTree().nodes.size(), b->kdTree().nodes.size());
    for (std::size_t i = 0; i < a->kdTree().nodes.size(); ++i) {
        EXPECT_EQ(a->kdTree().nodes[i].bits, b->kdTree().nodes[i].bits);
        EXPECT_EQ(a->kdTree().nodes[i].firstPrim, b->kdTree().nodes[i].firstPrim);
    }
}

} // namespace
} // namespace smart

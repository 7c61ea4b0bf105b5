// SPDX-License-Identifier: MIT
#include "libsmart/scene/scene.h"

#include <gtest/gtest.h>

#include "tests/support/procedural_meshes.h"
#include "tests/support/traced_scene.h"

namespace smart {
namespace {

using test::makeModel;
using test::place;

TEST(SceneTest, ViewHasChildrenAndNoTriangles) {
    const ModelPtr model = makeModel(test::icosphere(1));
    const Scene scene({place(model), place(model, glm::dmat4x3(2.0))}, Precision::Watertight, 1);
    EXPECT_EQ(scene.view().triangles, nullptr);
    EXPECT_EQ(scene.view().tree.nodes, nullptr);
    EXPECT_EQ(scene.view().childCount, 2u);
    EXPECT_EQ(scene.view().children, scene.group().instances().data());
    EXPECT_EQ(scene.view().children[1].model, &model->view());
}

TEST(SceneTest, FastModeAloneMakesRecords) {
    const ModelPtr inner = makeModel(test::icosphere(1));
    const ModelPtr outer = makeModel(test::icosphere(0), {place(inner)});
    const Scene watertight({place(outer)}, Precision::Watertight, 1);
    EXPECT_EQ(inner->view().records, nullptr);
    EXPECT_EQ(outer->view().records, nullptr);
    const Scene fast({place(outer), place(nullptr)}, Precision::Fast, 1);
    EXPECT_NE(inner->view().records, nullptr);
    EXPECT_NE(outer->view().records, nullptr);
}

TEST(SceneTest, StatisticsCountEachModelOnce) {
    std::vector<Triangle> triangles = test::icosphere(1);
    triangles.push_back({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}});
    const ModelPtr inner = makeModel(triangles, {}, BuildQuality::KdTree);
    const ModelPtr outer =
        makeModel(test::icosphere(0),
                  {place(inner), place(inner), place(inner, glm::dmat4x3(0.0))},
                  BuildQuality::KdTree);
    const Scene scene({place(outer), place(inner), place(outer, glm::dmat4x3(0.0)), place(nullptr)},
                      Precision::Watertight, 1);

    SceneStatistics expected;
    for (const KdTree* tree : {&inner->kdTree(), &outer->kdTree()}) {
        expected.nodes += tree->nodes.size();
        expected.references += tree->prims.size();
        // In a binary tree of two children each, leaves are one more than inner nodes.
        expected.leaves += (tree->nodes.size() + 1) / 2;
    }
    for (const WideTree* tree : {&outer->children.tree(), &scene.group().tree()}) {
        expected.nodes += tree->nodes.size();
        expected.references += tree->prims.size();
        expected.leaves += 1; // two instances that can be hit are one leaf
    }
    const SceneStatistics found = statistics(scene);
    EXPECT_EQ(found.triangles, 80u + 1 + 20);
    EXPECT_EQ(found.instances, 4u);
    EXPECT_EQ(found.nodes, expected.nodes);
    EXPECT_EQ(found.leaves, expected.leaves);
    EXPECT_EQ(found.references, expected.references);
    EXPECT_EQ(found.droppedTriangles, 1u);
    EXPECT_EQ(found.droppedInstances, 2u);
    EXPECT_GE(found.bytes, inner->bytes() + outer->bytes() + scene.group().bytes());
    EXPECT_LE(found.bytes, inner->bytes() + outer->bytes() + scene.group().bytes() + sizeof(Scene));
}

TEST(SceneTest, AnEmptySceneIsNoError) {
    const Scene scene({}, Precision::Fast, 2);
    EXPECT_EQ(scene.view().childCount, 0u);
    const SceneStatistics found = statistics(scene);
    EXPECT_EQ(found.triangles + found.instances + found.nodes + found.references, 0u);
}

} // namespace
} // namespace smart

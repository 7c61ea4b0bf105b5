// SPDX-License-Identifier: MIT
#include "libsmart/geometry/model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <thread>

#include "libsmart/geometry/model_builder.h"
#include "libsmart/geometry/model_update.h"
#include "tests/support/procedural_meshes.h"

namespace smart {
namespace {

ModelPtr makeModel(std::vector<Triangle> triangles, std::vector<Instance> children = {}) {
    ModelBuilder builder;
    builder.triangles = std::move(triangles);
    builder.children = std::move(children);
    return std::move(builder).build();
}

Instance place(ModelPtr model) {
    Instance instance;
    instance.model = std::move(model);
    return instance;
}

/// How far the record is from the definition of plane and weights at the point of the triangle
/// with weights 1 - u - v, u, v: in units of 2^-24 of the terms' size.
double recordError(const TriangleRecord& record, const Triangle& triangle, double u, double v) {
    double point[3];
    for (int k = 0; k < 3; ++k) {
        point[k] = (1 - u - v) * triangle.v0[k] + u * triangle.v1[k] + v * triangle.v2[k];
    }
    const uint32_t k = record.axis;
    const double p = point[(k + 1) % 3], q = point[(k + 2) % 3];
    const auto error = [](double a, double b, double c, double expected) {
        const double size = std::fabs(a) + std::fabs(b) + std::fabs(c) + std::fabs(expected);
        return std::fabs(a + b + c - expected) / (size * 0x1p-24);
    };
    return std::max({error(record.nu * p, record.nv * q, point[k], record.nd),
                     error(record.bu * p, record.bv * q, record.bd, u),
                     error(record.cu * p, record.cv * q, record.cd, v)});
}

TEST(TriangleRecordTest, GivesPlaneAndWeightsOfAnyPointInTheTriangle) {
    const std::vector<Triangle> triangles = test::triangleSoup(3000, 0.3f, 5);
    const ModelPtr model = makeModel(triangles);
    model->prepareFastRecords();
    const TriangleRecord* records = model->view().records;
    ASSERT_NE(records, nullptr);
    std::mt19937 generator(3);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        ASSERT_LT(records[i].axis, 3u);
        EXPECT_LE(std::fabs(records[i].nu), 1) << "the axis is the dominant one";
        EXPECT_LE(std::fabs(records[i].nv), 1);
        for (int point = 0; point < 4; ++point) {
            const double u = double(generator()) * 0x1p-33, v = double(generator()) * 0x1p-33;
            EXPECT_LT(recordError(records[i], triangles[i], u, v), 3);
        }
    }
    // Control: a record with two edges exchanged is found out.
    TriangleRecord wrong = records[0];
    std::swap(wrong.bu, wrong.cu);
    EXPECT_GT(recordError(wrong, triangles[0], 0.3, 0.1), 1000);
}

TEST(TriangleRecordTest, WhatCannotBeHitHasAxis3) {
    const float inf = std::numeric_limits<float>::infinity();
    const ModelPtr model = makeModel({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                                      {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}},
                                      {{0, 0, inf}, {1, 0, 0}, {0, 1, 0}},
                                      {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}});
    model->prepareFastRecords();
    EXPECT_EQ(model->view().records[0].axis, 2u);
    for (int i = 1; i < 4; ++i) EXPECT_EQ(model->view().records[i].axis, 3u);
}

TEST(ModelTest, RecordsAreMadeOnceHereAndInNestedModels) {
    const ModelPtr leaf = makeModel(test::icosphere(2));
    const ModelPtr middle = makeModel({}, {place(leaf), place(leaf)});
    const ModelPtr top = makeModel(test::icosphere(1), {place(middle), place(leaf)});
    EXPECT_EQ(leaf->view().records, nullptr);
    const std::size_t before = leaf->bytes();

    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i) {
        threads.emplace_back([&, i] {
            (i % 2 ? top : leaf)->prepareFastRecords();
            EXPECT_GT(top->bytes(), 0u);
        });
    }
    for (std::thread& thread : threads) thread.join();
    const TriangleRecord* records = leaf->view().records;
    ASSERT_NE(records, nullptr);
    EXPECT_NE(top->view().records, nullptr);
    EXPECT_GE(leaf->bytes(), before + leaf->triangles.size() * sizeof(TriangleRecord));
    middle->prepareFastRecords();
    EXPECT_EQ(leaf->view().records, records);
}

TEST(ModelTest, QualityChoosesTheTree) {
    const std::vector<Triangle> triangles = test::bumpySphere(2000);
    const auto build = [&](BuildQuality quality, bool lazy) {
        ModelBuilder builder;
        builder.triangles = triangles;
        return std::move(builder).build({quality, lazy, 2, nullptr});
    };
    const ModelPtr kd = build(BuildQuality::KdTree, false);
    EXPECT_NE(kd->view().tree.nodes, nullptr);
    EXPECT_EQ(kd->view().wide.nodes, nullptr);
    for (const BuildQuality quality :
         {BuildQuality::Nicest, BuildQuality::DontCare, BuildQuality::Fastest}) {
        const ModelPtr model = build(quality, false);
        EXPECT_TRUE(model->treeBuilt());
        EXPECT_EQ(model->view().tree.nodes, nullptr);
        EXPECT_EQ(model->view().deferred, nullptr);
        ASSERT_NE(model->view().wide.nodes, nullptr);
        EXPECT_GE(model->treeSizes().references, triangles.size());
        for (int k = 0; k < 3; ++k) {
            EXPECT_EQ(model->bounds.lo[k], kd->bounds.lo[k]);
            EXPECT_EQ(model->view().wide.hi[k], kd->bounds.hi[k]);
        }
    }
}

/// A few of them so large that cutting them pays.
std::vector<Triangle> largeAndSmall() {
    std::vector<Triangle> triangles = test::triangleSoup(6000, 0.02f, 1);
    for (const Triangle& large : test::triangleSoup(300, 1.0f, 2)) triangles.push_back(large);
    return triangles;
}

TEST(ModelTest, OnlyTheNicestTreeCutsTriangles) {
    const std::vector<Triangle> triangles = largeAndSmall();
    const auto references = [&](BuildQuality quality) {
        ModelBuilder builder;
        builder.triangles = triangles;
        return std::move(builder).build({.quality = quality})->treeSizes().references;
    };
    EXPECT_GT(references(BuildQuality::Nicest), triangles.size());
    EXPECT_EQ(references(BuildQuality::DontCare), triangles.size());
    EXPECT_EQ(references(BuildQuality::Fastest), triangles.size());
}

TEST(ModelTest, AnUpdateHasTheTreeThatIsAskedForThen) {
    constexpr BuildQuality kQualities[] = {BuildQuality::Nicest, BuildQuality::DontCare,
                                           BuildQuality::Fastest, BuildQuality::KdTree};
    const std::vector<Triangle> triangles = largeAndSmall();
    std::vector<float> elsewhere; // in the order from last to first: a refitted tree would be bad
    for (std::size_t i = triangles.size(); i-- > 0;)
        for (const float* v : {triangles[i].v0, triangles[i].v1, triangles[i].v2})
            elsewhere.insert(elsewhere.end(), v, v + 3);
    for (const BuildQuality from : kQualities)
        for (const BuildQuality to : kQualities) {
            ModelBuilder builder;
            builder.triangles = triangles;
            for (uint32_t i = 0; i < triangles.size(); ++i) {
                builder.shading.corners.makeRoom(1);
                builder.shading.corners.push_back({3 * i, 3 * i + 1, 3 * i + 2});
            }
            const ModelPtr old = std::move(builder).build({.quality = from});
            const ModelPtr moved = updateModel(*old, 0, 3 * uint32_t(triangles.size()),
                                               elsewhere.data(), {.quality = to});
            EXPECT_EQ(moved->view().tree.nodes != nullptr, to == BuildQuality::KdTree);
            EXPECT_EQ(moved->view().wide.nodes != nullptr, to != BuildQuality::KdTree);
            EXPECT_EQ(moved->triangles[0].v1[2], triangles.back().v1[2]);
            if (to != BuildQuality::KdTree) {
                EXPECT_EQ(moved->treeSizes().references, triangles.size()) << "cut though moved";
            }
        }
}

TEST(ModelTest, ALazyModelIsBuiltOnceByTheThreadThatComesFirst) {
    for (const BuildQuality quality : {BuildQuality::Nicest, BuildQuality::DontCare,
                                       BuildQuality::Fastest, BuildQuality::KdTree}) {
        ModelBuilder builder;
        builder.triangles = test::bumpySphere(3000);
        const auto memory = std::make_shared<MemoryCounter>();
        ModelPtr model = std::move(builder).build({quality, true, 1, memory});
        const uint64_t before = memory->bytes();
        ASSERT_NE(model->view().deferred, nullptr);
        EXPECT_FALSE(model->treeBuilt());
        EXPECT_FALSE(model->bounds.empty());
        EXPECT_EQ(model->treeSizes().nodes, 0u);

        const ModelView* seen[6] = {};
        std::vector<std::thread> threads;
        for (const ModelView*& view : seen)
            threads.emplace_back([&view, &model] {
                const DeferredView& deferred = *model->view().deferred;
                view = deferred.reach(deferred);
                model->prepareFastRecords();
                EXPECT_GT(model->treeSizes().nodes, 0u);
            });
        for (std::thread& thread : threads) thread.join();
        EXPECT_TRUE(model->treeBuilt());
        for (const ModelView* view : seen) EXPECT_EQ(view, seen[0]);
        EXPECT_EQ(seen[0]->deferred, nullptr);
        EXPECT_EQ(seen[0]->triangles, model->triangles.data());
        EXPECT_NE(seen[0]->records, nullptr);
        EXPECT_EQ(seen[0]->tree.nodes != nullptr, quality == BuildQuality::KdTree);
        EXPECT_EQ(seen[0]->wide.nodes != nullptr, quality != BuildQuality::KdTree);
        EXPECT_EQ(takeBuildFailure(), nullptr);
        EXPECT_GT(memory->bytes(), before);
        EXPECT_EQ(memory->bytes(), model->ownBytes() + sizeof(ShadingData) +
                                       model->shading.bytes() + sizeof(InstanceGroup));
        model.reset();
        EXPECT_EQ(memory->bytes(), 0u);
    }
}

TEST(ModelTest, BytesCountWhatIsStored) {
    ModelBuilder builder;
    builder.triangles = test::icosphere(2);
    const std::size_t triangles = builder.triangles.size();
    builder.shading.normals.resize(1000);
    builder.shading.firstNormal = 0;
    const ModelPtr model = std::move(builder).build({.quality = BuildQuality::KdTree});
    const std::size_t least = triangles * sizeof(Triangle) + 1000 * sizeof(glm::vec3) +
                              model->kdTree().nodes.size() * sizeof(KdNode) +
                              model->kdTree().prims.size() * sizeof(uint32_t);
    EXPECT_GE(model->bytes(), least);
    EXPECT_LE(model->bytes(), 2 * least + sizeof(Model));
}

} // namespace
} // namespace smart

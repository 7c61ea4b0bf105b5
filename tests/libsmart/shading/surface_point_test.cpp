// SPDX-License-Identifier: MIT
#include "libsmart/shading/surface_point.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat4x4.hpp>

#include "openrt/shader.hpp"
#include "tests/libsmart/shading/fake_tracer.h"

namespace smart {
namespace {

using test::bytesOf;

/// One triangle in a chain of instances, as a hit would give it.
struct Fixture {
    std::shared_ptr<ShadingData> stored = std::make_shared<ShadingData>();
    ShadingData& shading = *stored;
    Model model{stored};
    std::vector<Instance> instances{1};
    InstanceList list;
    Ray ray{{0, 0, 10}, {0, 0, -2}, 0, 1e30f};
    RTSstate state{};

    Fixture() {
        model.triangles = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
        shading.corners = {{0, 1, 2}};
    }
    HitChain chain() {
        list = InstanceList(instances);
        HitChain c{};
        c.levels = uint32_t(instances.size());
        c.toWorld = glm::dmat4x3(1.0);
        for (uint32_t i = 0; i < c.levels; ++i) {
            c.instances[i] = &list.views()[i];
            c.toWorld = glm::dmat4x3(glm::dmat4(c.toWorld) * glm::dmat4(instances[i].toParent));
        }
        c.model = &model;
        return c;
    }
    const RTSstate& fill(float u, float v) {
        fillSurfacePoint(chain(), 3, ray, 5, u, v, state);
        return state;
    }
};

glm::vec3 vec(const float (&v)[3]) { return {v[0], v[1], v[2]}; }
glm::vec4 vec(const float (&v)[4]) { return {v[0], v[1], v[2], v[3]}; }

TEST(SurfacePointTest, PositionsAndWeightsAreBarycentric) {
    Fixture f;
    f.instances[0].objectId = 9;
    const RTSstate& s = f.fill(0.25f, 0.5f);
    EXPECT_EQ(vec(s.position), glm::vec3(1, 2, 0));
    EXPECT_EQ(vec(s.barycentric), glm::vec3(0.25f, 0.25f, 0.5f));
    EXPECT_EQ(vec(s.geometricNormal), glm::vec3(0, 0, 1));
    EXPECT_EQ(vec(s.shadingNormal), glm::vec3(0, 0, 1));
    EXPECT_EQ(vec(s.rayOrigin), glm::vec3(0, 0, 10));
    EXPECT_EQ(vec(s.rayDirection), glm::vec3(0, 0, -1));
    EXPECT_EQ(s.rayDistance, 10);
    EXPECT_EQ(s.frontFace, 1u);
    EXPECT_EQ(s.object, 9u);
    EXPECT_EQ(s.instance, 3u);
    EXPECT_EQ(s.primitive, 0u);
    f.ray.dir[2] = 2;
    EXPECT_EQ(f.fill(0.25f, 0.5f).frontFace, 0u);
}

TEST(SurfacePointTest, DensityOfTextureCoordinates) {
    Fixture f;
    EXPECT_EQ(f.fill(0.25f, 0.5f).texCoordDensity, 0) << "none given";
    f.instances[0].inherited.texCoord = {0.5f, 0.5f, 0, 1};
    EXPECT_EQ(f.fill(0.25f, 0.5f).texCoordDensity, 0) << "inherited: the same everywhere";
    f.shading.firstTexCoord = 0;
    f.shading.texCoords = {{0, 0, 0, 1}, {2, 0, 0, 1}, {0, 8, 0, 1}};
    EXPECT_EQ(f.fill(0.25f, 0.5f).texCoordDensity, 1) << "16 in texture space, 16 in the world";
    f.instances[0].toParent = glm::dmat4x3(glm::scale(glm::dmat4(1.0), glm::dvec3(4, 1, 1)));
    EXPECT_EQ(f.fill(0.25f, 0.5f).texCoordDensity, 0.5f);
    f.shading.texCoords = {{1, 1, 0, 1}, {2, 2, 0, 1}, {3, 3, 0, 1}};
    EXPECT_EQ(f.fill(0.25f, 0.5f).texCoordDensity, 0) << "no area in texture space";
}

TEST(SurfacePointTest, AttributesAreInterpolated) {
    Fixture f;
    f.shading.firstTexCoord = f.shading.firstColor = f.shading.firstNormal = 0;
    f.shading.texCoords = {{0, 0, 0, 1}, {1, 0, 2, 1}, {0, 1, 4, 1}};
    f.shading.colors = {{1, 0, 0, 1}, {0, 1, 0, 0.5f}, {0, 0, 1, 0}};
    f.shading.normals = {{0, 0, 1}, {0, 3, 0}, {4, 0, 0}};
    const RTSstate& s = f.fill(0.25f, 0.5f);
    EXPECT_EQ(vec(s.texCoord), glm::vec4(0.25f, 0.5f, 2.5f, 1));
    EXPECT_EQ(vec(s.color), glm::vec4(0.25f, 0.25f, 0.5f, 0.375f));
    EXPECT_EQ(vec(s.rawNormal), glm::vec3(2, 0.75f, 0.25f));
    const double length = std::sqrt(4 + 0.5625 + 0.0625);
    EXPECT_FLOAT_EQ(s.shadingNormal[0], float(2 / length));
    EXPECT_FLOAT_EQ(s.shadingNormal[2], float(0.25 / length));
    // At a corner the attribute is the vertex's own, bit for bit.
    EXPECT_EQ(vec(f.fill(1, 0).color), glm::vec4(0, 1, 0, 0.5f));
    EXPECT_EQ(vec(f.fill(0, 1).texCoord), glm::vec4(0, 1, 4, 1));
}

TEST(SurfacePointTest, NormalsGoThroughTheInverseTranspose) {
    Fixture f;
    f.shading.firstNormal = 0;
    f.shading.normals = {{1, 1, 0}, {1, 1, 0}, {1, 1, 0}};
    // A plane x + y = c scaled by (2, 1, 1) is x/2 + y = c.
    f.instances[0].toParent = glm::dmat4x3(glm::scale(glm::dmat4(1.0), {2.0, 1.0, 1.0}));
    const double length = std::sqrt(1.25);
    const RTSstate& s = f.fill(0.25f, 0.25f);
    EXPECT_FLOAT_EQ(s.shadingNormal[0], float(0.5 / length));
    EXPECT_FLOAT_EQ(s.shadingNormal[1], float(1 / length));
    EXPECT_EQ(vec(s.rawNormal), glm::vec3(0.5f, 1, 0));
    EXPECT_EQ(vec(s.position), glm::vec3(2, 1, 0));
    // The normal times the matrix itself, which is the usual mistake, is elsewhere.
    EXPECT_GT(std::fabs(s.shadingNormal[0] - float(2 / std::sqrt(5.0))), 0.4f);
}

TEST(SurfacePointTest, MirroringKeepsGivenNormalsOutsideAndTurnsTheWinding) {
    Fixture f;
    f.shading.firstNormal = 0;
    f.shading.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    f.instances[0].toParent = glm::dmat4x3(glm::scale(glm::dmat4(1.0), {-1.0, 1.0, 1.0}));
    const RTSstate& s = f.fill(0.25f, 0.25f);
    EXPECT_EQ(vec(s.position), glm::vec3(-1, 1, 0));
    EXPECT_EQ(vec(s.shadingNormal), glm::vec3(0, 0, 1));
    EXPECT_EQ(vec(s.geometricNormal), glm::vec3(0, 0, -1));
    EXPECT_EQ(s.frontFace, 0u);
    // Seen through the shader interface both face the ray.
    const openrt::TraceContext context(&f.state);
    EXPECT_EQ(context.facingNormal(), openrt::Vec3(0, 0, 1));
    EXPECT_EQ(context.facingGeometricNormal(), openrt::Vec3(0, 0, 1));
}

TEST(SurfacePointTest, NormalsAgreeWithATransformedTangentPlane) {
    Fixture f;
    f.shading.firstNormal = 0;
    const glm::dvec3 n(0.6, -0.48, 0.64), t1(0.8, 0.36, -0.48), t2 = glm::cross(n, t1);
    f.shading.normals = {glm::vec3(n), glm::vec3(n), glm::vec3(n)};
    glm::dmat4 m = glm::rotate(glm::dmat4(1.0), 0.7, {1.0, 2.0, -1.0});
    m = glm::scale(m, {1e-3, 5.0, -200.0});
    m = glm::rotate(m, -1.3, {0.5, 0.1, 1.0});
    m = glm::translate(m, {3.0, 4.0, 1e4});
    f.instances[0].toParent = glm::dmat4x3(m);
    const RTSstate& s = f.fill(0.3f, 0.3f);
    const glm::dvec3 world(vec(s.shadingNormal));
    EXPECT_NEAR(glm::dot(world, world), 1, 1e-6);
    for (const glm::dvec3& t : {t1, t2}) {
        const glm::dvec3 tangent = glm::dmat3(m) * t;
        EXPECT_NEAR(glm::dot(world, tangent) / glm::length(tangent), 0, 2e-6);
    }
    EXPECT_GT(glm::dot(world, glm::dmat3(m) * n), 0); // on the side it was on
}

TEST(SurfacePointTest, WithoutNormalsTheGeometricOneServes) {
    Fixture f;
    f.instances[0].inherited.normal = {1, 0, 0}; // for fixed function, not for programmable ones
    EXPECT_EQ(vec(f.fill(0.25f, 0.5f).shadingNormal), glm::vec3(0, 0, 1));
    // From the second vertex on there is one; the first counts as the triangle's own.
    f.shading.firstNormal = 1;
    f.shading.normals = {{0, 1, 0}, {0, 1, 0}};
    EXPECT_EQ(vec(f.fill(0.25f, 0.25f).rawNormal), glm::vec3(0, 0.5f, 0.5f));
    EXPECT_EQ(vec(f.fill(0, 0).rawNormal), glm::vec3(0, 0, 1));
    // Normals that cancel, or are no numbers.
    f.shading.firstNormal = 0;
    f.shading.normals = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    EXPECT_EQ(vec(f.fill(0.25f, 0.25f).shadingNormal), glm::vec3(0, 0, 1));
    f.shading.normals[1].x = std::nanf("");
    EXPECT_EQ(vec(f.fill(0.25f, 0.25f).shadingNormal), glm::vec3(0, 0, 1));
}

TEST(SurfacePointTest, TinyAndHugeTrianglesHaveNormals) {
    for (const float scale : {1e-38f, 1e-20f, 1e-6f, 1e6f, 1e18f, 1e37f}) {
        Fixture f;
        f.model.triangles = {{{0, 0, 0}, {4 * scale, 0, 0}, {0, 4 * scale, 0}}};
        const RTSstate& s = f.fill(0.25f, 0.5f);
        EXPECT_EQ(vec(s.geometricNormal), glm::vec3(0, 0, 1)) << scale;
        EXPECT_EQ(vec(s.position), glm::vec3(scale, 2 * scale, 0)) << scale;
    }
}

TEST(SurfacePointTest, WhatAnObjectDidNotSetComesFromTheInstanceAbove) {
    Fixture f;
    f.instances.resize(3);
    f.instances[0].inherited.color = {0.1f, 0, 0, 1};
    f.instances[1].inherited.color = {0.2f, 0, 0, 1};
    f.instances[2].inherited.color = {0.3f, 0, 0, 1};
    f.instances[0].inherited.texCoord = {1, 0, 0, 1};
    f.instances[2].inherited.texCoord = {3, 0, 0, 1};
    const auto red = [&] { return f.fill(0.25f, 0.5f).color[0]; };
    EXPECT_EQ(red(), 0.3f);
    f.instances[2].inherited.ownColor = false;
    EXPECT_EQ(red(), 0.2f);
    f.instances[1].inherited.ownColor = false;
    EXPECT_EQ(red(), 0.1f);
    f.instances[0].inherited.ownColor = false; // there is nothing above the scene
    EXPECT_EQ(red(), 0.1f);
    EXPECT_EQ(f.state.texCoord[0], 3); // each attribute on its own
    // A colour set before the second vertex of the model.
    f.shading.firstColor = 1;
    f.shading.colors = {{0.5f, 0, 0, 1}, {0.5f, 0, 0, 1}};
    EXPECT_FLOAT_EQ(red(), 0.25f * 0.1f + 0.75f * 0.5f);
    f.state.object = 0;
    f.instances[2].objectId = 7;
    EXPECT_EQ(f.fill(0, 0).object, 7u);
}

TEST(SurfacePointTest, ReplacementsApplyFromTheInnermostOutward) {
    Fixture f;
    EXPECT_EQ(effectiveShader(f.chain()), 0u); // no shader: the default surface
    f.shading.shaders = {5, 6};
    EXPECT_EQ(effectiveShader(f.chain()), 5u); // no slots: all of the first
    f.shading.slots = {1};
    EXPECT_EQ(effectiveShader(f.chain()), 6u);

    f.instances.resize(2);
    const auto inner = std::make_shared<ShaderReplacement>();
    const auto outer = std::make_shared<ShaderReplacement>();
    inner->pairs = {{5, 50}, {6, 60}};
    outer->pairs = {{6, 61}, {60, 62}};
    f.instances[1].replacement = inner;
    EXPECT_EQ(effectiveShader(f.chain()), 60u);
    f.instances[0].replacement = outer;
    EXPECT_EQ(effectiveShader(f.chain()), 62u);
    f.instances[1].replacement = nullptr;
    EXPECT_EQ(effectiveShader(f.chain()), 61u);
    outer->all = true;
    outer->allBy = 4;
    EXPECT_EQ(effectiveShader(f.chain()), 4u);
}

// Parameter blocks ----------------------------------------------------------------------------

struct Heated {
    struct TriangleParam {
        int id = -1;
    };
    struct VertexParam {
        float heat = 8;
        openrt::Vec2 flow{16, 32};
    };
    void registerParams(const openrt::ShaderRegistrator& r) const {
        r.registerParam<int>("id", openrt::PER_TRIANGLE, 0);
        r.registerParam<float>("heat", openrt::PER_VERTEX, offsetof(VertexParam, heat));
        r.registerParam<openrt::Vec2>("flow", openrt::PER_VERTEX, offsetof(VertexParam, flow));
    }
    void shade(openrt::TraceContext&) const {}
};

struct BlockFixture : Fixture {
    ShaderRegistry registry;
    ShaderClassPtr heated =
        std::make_shared<ShaderClass>(*openrt::shaderClass<Heated>("Heated"), nullptr);
    ShaderClassPtr other =
        std::make_shared<ShaderClass>(*openrt::shaderClass<Heated>("Other"), nullptr);
    std::shared_ptr<Shader> shader = registry.create(heated), same = registry.create(heated),
                            foreign = registry.create(other);
    VertexScratch scratch;

    BlockFixture() {
        shading.shaders = {shader->index()};
        shading.triangleBlocks = {16};
        shading.triangleData.resize(32);
        const int id = 77;
        std::memcpy(shading.triangleData.data() + 16, &id, sizeof(id));
        shading.vertexBlocks = {0, 16, 32};
        shading.vertexData.resize(48);
        const Heated::VertexParam blocks[3] = {{0, {0, 4}}, {1, {2, 0}}, {3, {0, 0}}};
        for (std::size_t i = 0; i < 3; ++i)
            std::memcpy(shading.vertexData.data() + 16 * i, &blocks[i], sizeof(blocks[i]));
    }
    void fill(const Shader& by) {
        const auto table = registry.freeze();
        Fixture::fill(0.25f, 0.5f);
        fillParameterBlocks(chain(), *table, *(*table)[by.index()], scratch, state);
    }
    int id() const { return static_cast<const Heated::TriangleParam*>(state.triangleParam)->id; }
    Heated::VertexParam vertex() const {
        return *static_cast<const Heated::VertexParam*>(state.vertexParam);
    }
};

TEST(ParameterBlockTest, TheTrianglesBlockAndTheInterpolatedOneOfItsVertices) {
    BlockFixture f;
    f.fill(*f.shader);
    EXPECT_EQ(f.id(), 77);
    EXPECT_EQ(f.vertex().heat, 0.25f + 1.5f);
    EXPECT_EQ(f.vertex().flow, openrt::Vec2(0.5f, 1));
    f.fill(*f.same); // reshaded by another shader of the class
    EXPECT_EQ(f.id(), 77);
    EXPECT_EQ(f.vertex().heat, 1.75f);
}

TEST(ParameterBlockTest, ShadersOfAnotherClassSeeTheirOwnDefaults) {
    BlockFixture f;
    f.fill(*f.foreign);
    EXPECT_EQ(f.id(), -1);
    EXPECT_EQ(f.vertex().heat, 8);
    EXPECT_EQ(f.vertex().flow, openrt::Vec2(16, 32));
}

TEST(ParameterBlockTest, WithoutBlocksTheDefaultsServe) {
    BlockFixture f;
    f.shading.triangleBlocks[0] = ShadingData::kNone;
    f.shading.vertexBlocks[2] = ShadingData::kNone;
    f.fill(*f.shader);
    EXPECT_EQ(f.id(), -1);
    EXPECT_EQ(f.vertex().heat, 0.25f * 1 + 0.5f * 8);
    f.shading.triangleBlocks.clear();
    f.shading.vertexBlocks.clear();
    f.shading.corners.clear();
    f.fill(*f.shader);
    EXPECT_EQ(f.vertex().heat, 8);
}

TEST(ParameterBlockTest, ClassesWithoutSuchParametersHaveNone) {
    BlockFixture f;
    f.state.triangleParam = f.state.vertexParam = &f;
    f.fill(*f.registry.defaultSurface());
    EXPECT_EQ(f.state.triangleParam, nullptr);
    EXPECT_EQ(f.state.vertexParam, nullptr);
}

} // namespace
} // namespace smart

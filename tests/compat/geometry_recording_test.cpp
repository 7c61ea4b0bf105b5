// SPDX-License-Identifier: MIT
#include "compat/recorder/geometry_recording.h"

#include <gtest/gtest.h>

#include <cstring>
#include <iterator>

namespace smart::compat {
namespace {

constexpr uint32_t kNone = ShadingData::kNone;

int constructBlocks(void*, void* triangle, void* vertex) {
    if (triangle) *static_cast<float*>(triangle) = -1;
    if (vertex) *static_cast<float*>(vertex) = -2;
    return 0;
}
int shadeNothing(const void*, RTSstate*) { return 0; }

/// A surface class with one float per triangle and one per vertex.
ShaderClassPtr blockClass() {
    static const RTSparameter parameters[] = {{"t", RTS_PER_TRIANGLE, RTS_FLOAT1, 0, 4},
                                              {"v", RTS_PER_VERTEX, RTS_FLOAT1, 0, 4}};
    RTshaderclass c = {};
    c.structSize = sizeof c;
    c.interfaceVersion = RTS_INTERFACE_VERSION;
    c.kind = RT_SURFACE_SHADER;
    c.name = "Blocks";
    c.triangleSize = c.vertexSize = 4;
    c.alignment = 4;
    c.parameters = parameters;
    c.parameterCount = 2;
    c.construct = constructBlocks;
    c.shade = shadeNothing;
    return std::make_shared<const ShaderClass>(c, nullptr);
}

class GeometryRecordingTest : public testing::Test {
protected:
    void vertex(float x, float y = 0) {
        recording_.vertex({x, y, 0}, attributes_, attributes_.normal, shaders_.bound());
    }
    void triangle(float x) {
        recording_.begin(Primitive::Triangles);
        vertex(x, 0), vertex(x + 1, 0), vertex(x, 1);
    }
    void set(uint32_t handle, float value) {
        shaders_.setParameter(handle, {RTS_FLOAT1, std::as_bytes(std::span(&value, 1))});
    }
    static float at(const std::vector<std::byte>& data, uint32_t offset) {
        float value;
        std::memcpy(&value, &data[offset], sizeof value);
        return value;
    }

    ShaderCatalog shaders_;
    GeometryRecording recording_;
    Attributes attributes_;
};

TEST_F(GeometryRecordingTest, StoresOnlyWhatIsGiven) {
    triangle(0);
    triangle(5);
    const ModelPtr model = recording_.compile({});
    ASSERT_EQ(model->triangles.size(), 2u);
    EXPECT_EQ(model->triangles[1].v1[0], 6);
    const ShadingData& shading = model->shading;
    EXPECT_EQ(shading.firstColor, kNone);
    EXPECT_EQ(shading.firstNormal, kNone);
    EXPECT_EQ(shading.firstTexCoord, kNone);
    EXPECT_TRUE(shading.colors.empty() && shading.slots.empty());
    EXPECT_TRUE(shading.moreTexCoords.empty());
    EXPECT_EQ(shading.vertices, 6u);
    EXPECT_EQ(shading.corners, (TriangleCorners{{0, 1, 2}, {3, 4, 5}}));
    EXPECT_TRUE(shading.vertexBlocks.empty() && shading.triangleBlocks.empty());
    EXPECT_EQ(shading.shaders, std::vector<uint32_t>{0});
    EXPECT_TRUE(recording_.empty()) << "compiling empties the recording";
}

TEST_F(GeometryRecordingTest, LatchesAttributesFromTheFirstOneGiven) {
    recording_.begin(Primitive::TriangleStrip);
    vertex(0);
    vertex(1);
    recording_.given.color = true;
    attributes_.color = {0.5f, 0, 0, 1};
    vertex(2);
    recording_.given.texCoord = true;
    attributes_.texCoord = {7, 8, 0, 1};
    attributes_.color = {0.25f, 0, 0, 1};
    vertex(3);
    const ModelPtr model = recording_.compile({});
    const ShadingData& shading = model->shading;
    EXPECT_EQ(shading.firstColor, 2u);
    ASSERT_EQ(shading.colors.size(), 2u);
    EXPECT_EQ(shading.colors[0].r, 0.5f);
    EXPECT_EQ(shading.colors[1].r, 0.25f);
    EXPECT_EQ(shading.firstTexCoord, 3u);
    EXPECT_EQ(shading.texCoords[0].y, 8);
    EXPECT_EQ(shading.firstNormal, kNone);
    ASSERT_EQ(shading.corners.size(), 2u);
    EXPECT_EQ(shading.corners[1], (std::array<uint32_t, 3>{2, 1, 3}));
}

TEST_F(GeometryRecordingTest, TextureUnitsStoreTheirOwnCoordinates) {
    recording_.begin(Primitive::Triangles);
    vertex(0);
    recording_.given.moreTexCoords = 1u << 1;
    attributes_.moreTexCoords[1] = {1, 2, 0, 1};
    attributes_.moreTexCoords[2] = {9, 9, 9, 9};
    vertex(1);
    attributes_.moreTexCoords[1] = {3, 4, 0, 1};
    vertex(2);
    GeometryRecording copy = recording_;
    const ModelPtr model = recording_.compile({});
    const std::vector<UnitTexCoords>& units = model->shading.moreTexCoords;
    ASSERT_EQ(units.size(), kMoreUnits);
    EXPECT_EQ(units[1].first, 1u);
    EXPECT_EQ(units[1].values, (std::vector<glm::vec4>{{1, 2, 0, 1}, {3, 4, 0, 1}}));
    EXPECT_TRUE(units[0].values.empty() && units[2].values.empty());
    EXPECT_EQ(units[0].first, kNone);
    EXPECT_TRUE(copy.givesAgain(*model));
    EXPECT_GE(model->shading.bytes(), 2 * sizeof(glm::vec4) + sizeof(UnitTexCoords));
}

TEST_F(GeometryRecordingTest, SlotsNumberShadersByFirstUse) {
    const ShaderClassPtr constant = findBuiltinClass("ConstantShader");
    shaders_.addClass(constant);
    const uint32_t a = shaders_.newShader();
    const uint32_t b = shaders_.newShader();
    for (const uint32_t id : {b, a, 0u, b, a}) {
        shaders_.bindShader(id);
        triangle(0);
    }
    ASSERT_EQ(recording_.usedShaders().size(), 3u);
    EXPECT_EQ(recording_.usedShaders()[0].id, b);
    EXPECT_EQ(recording_.usedShaders()[1].id, a);
    EXPECT_EQ(recording_.usedShaders()[2].id, 0u);
    const ModelPtr model = recording_.compile({});
    EXPECT_EQ(model->shading.slots, (std::vector<uint32_t>{0, 1, 2, 0, 1}));
    EXPECT_EQ(model->shading.shaders[0], shaders_.shader(b)->shader->index());
    EXPECT_EQ(model->shading.shaders[2], 0u);
    EXPECT_EQ(model->shading.keepAlive.size(), 3u);
}

TEST_F(GeometryRecordingTest, SharesParameterBlocksThatDidNotChange) {
    triangle(0); // of a shader without blocks
    shaders_.registerClass(blockClass());
    shaders_.newShader();
    const uint32_t t = shaders_.parameterHandle("t"), v = shaders_.parameterHandle("v");
    triangle(1); // the defaults
    set(t, 5);
    set(v, 6);
    triangle(2);
    triangle(3);
    shaders_.bindShader(0);
    triangle(4);
    const ModelPtr model = recording_.compile({});
    const ShadingData& shading = model->shading;
    ASSERT_EQ(shading.triangleBlocks.size(), 5u);
    EXPECT_EQ(shading.triangleBlocks[0], kNone);
    EXPECT_EQ(shading.triangleBlocks[4], kNone);
    EXPECT_EQ(at(shading.triangleData, shading.triangleBlocks[1]), -1);
    EXPECT_EQ(at(shading.triangleData, shading.triangleBlocks[2]), 5);
    EXPECT_EQ(shading.triangleBlocks[3], shading.triangleBlocks[2]);
    ASSERT_EQ(shading.vertexBlocks.size(), 15u);
    EXPECT_EQ(shading.vertexBlocks[2], kNone);
    EXPECT_EQ(at(shading.vertexData, shading.vertexBlocks[3]), -2);
    EXPECT_EQ(at(shading.vertexData, shading.vertexBlocks[11]), 6);
    EXPECT_EQ(shading.vertexBlocks[14], kNone);
    for (const uint32_t block : shading.vertexBlocks) {
        if (block != kNone) {
            EXPECT_EQ(block % 16, 0u);
        }
    }
}

TEST_F(GeometryRecordingTest, LatchesTriangleParametersAtTheLastVertex) {
    shaders_.registerClass(blockClass());
    shaders_.newShader();
    const uint32_t t = shaders_.parameterHandle("t");
    recording_.begin(Primitive::Quads);
    vertex(0, 0);
    set(t, 1);
    vertex(1, 0);
    set(t, 2);
    vertex(1, 1);
    set(t, 3);
    vertex(0, 1);
    set(t, 4);
    const ModelPtr model = recording_.compile({});
    const ShadingData& shading = model->shading;
    EXPECT_EQ(at(shading.triangleData, shading.triangleBlocks[0]), 3);
    EXPECT_EQ(at(shading.triangleData, shading.triangleBlocks[1]), 3);
}

/// The vertex that a triangle's code names, by its x.
float provokingX(const Model& model, uint32_t triangle) {
    const std::vector<uint8_t>& codes = model.shading.provoking;
    uint32_t code = codes.empty() ? uint32_t(ShadingData::kLastCorner) : codes[triangle];
    if (code >= ShadingData::kOfNext) {
        code -= ShadingData::kOfNext;
        ++triangle;
    }
    const Triangle& t = model.triangles[triangle];
    return code == 0 ? t.v0[0] : code == 1 ? t.v1[0] : t.v2[0];
}

// OpenGL 1.5, table 2.12. Vertices have their numbers, from 0, as x.
TEST_F(GeometryRecordingTest, KnowsTheProvokingVertices) {
    const auto give = [&](Primitive primitive, int count) {
        recording_.begin(primitive);
        for (int i = 0; i < count; ++i) vertex(float(i), float(i * i));
    };
    give(Primitive::Triangles, 6);
    give(Primitive::TriangleFan, 4);
    EXPECT_TRUE(ModelPtr(recording_.compile({}))->shading.provoking.empty()) << "the last of each";
    give(Primitive::TriangleStrip, 4);
    give(Primitive::Quads, 8);
    give(Primitive::QuadStrip, 6);
    give(Primitive::Polygon, 5);
    give(Primitive::Triangles, 3);
    const ModelPtr model = recording_.compile({});
    const float expected[] = {2, 3, 3, 3, 7, 7, 3, 3, 5, 5, 0, 0, 0, 2};
    ASSERT_EQ(model->triangles.size(), std::size(expected));
    for (uint32_t i = 0; i < std::size(expected); ++i)
        EXPECT_EQ(provokingX(*model, i), expected[i]) << i;
}

TEST_F(GeometryRecordingTest, CountsLevelsAndShadersOfChildren) {
    triangle(0);
    Instance child;
    child.model = recording_.compile({});
    EXPECT_EQ(recording_.levels(), 1u);
    recording_.addChild(child, 3, {{7, 70}, {8, 80}});
    recording_.addChild(child, 1, {{8, 80}, {9, 90}});
    EXPECT_EQ(recording_.levels(), 4u);
    ASSERT_EQ(recording_.usedShaders().size(), 3u);
    EXPECT_EQ(recording_.usedShaders()[2].id, 90u);
    EXPECT_FALSE(recording_.empty());
    EXPECT_EQ(recording_.compile({})->children.instances().size(), 2u);
}

} // namespace
} // namespace smart::compat

// SPDX-License-Identifier: MIT
#include "compat/recorder/fixed_state_recorder.h"

#include <gtest/gtest.h>

#include <functional>
#include <glm/geometric.hpp>
#include <vector>

#include "compat/recorder/recorder.h"

namespace smart::compat {
namespace {

TEST(FixedStateRecorder, NeedsNoBlockUntilSomethingShows) {
    FixedStateRecorder fixed;
    EXPECT_EQ(fixed.block({}), nullptr);
    // Switched off, and back to the start.
    fixed.change().fog.density = 3;
    fixed.change().lighting.lights[2].enabled = true;
    fixed.change().texture.mode = TexEnvMode::Decal;
    EXPECT_EQ(fixed.block({}), nullptr);
    fixed.change().ops.blend = true;
    EXPECT_NE(fixed.block({}), nullptr);
    fixed.change().ops.blend = false;
    EXPECT_EQ(fixed.block({}), nullptr);
    EXPECT_EQ(fixed.state().fog.density, 3.0f);
}

TEST(FixedStateRecorder, EqualStatesAreOneBlock) {
    FixedStateRecorder fixed;
    fixed.change().ops.blend = true;
    const FixedStatePtr blended = fixed.block({});
    EXPECT_EQ(fixed.block({}), blended);
    fixed.change().fog.enabled = true;
    const FixedStatePtr both = fixed.block({});
    EXPECT_NE(both, blended);
    EXPECT_FALSE(blended->fog.enabled);
    fixed.change().fog.enabled = false;
    EXPECT_EQ(fixed.block({}), blended);
    fixed.change().fog.enabled = true;
    EXPECT_EQ(fixed.block({}), both);
    fixed.change().fog.density = 0.5f;
    EXPECT_NE(fixed.block({}), both);
}

TEST(FixedStateRecorder, LightingThatIsOffCountsForNothing) {
    FixedStateRecorder fixed;
    fixed.change().ops.blend = true;
    const FixedStatePtr dark = fixed.block({});
    fixed.change().lighting.lights[0].position = {1, 2, 3, 1};
    fixed.change().lighting.twoSided = true;
    EXPECT_EQ(fixed.block({}), dark);
    fixed.change().lighting.enabled = true;
    const FixedStatePtr lit = fixed.block({});
    ASSERT_NE(lit, dark);
    EXPECT_EQ(lit->lighting.lights[0].position, glm::vec4(1, 2, 3, 1));
    EXPECT_TRUE(lit->lighting.twoSided);
}

TEST(FixedStateRecorder, DepthTestBeforeAndAfterTheFirstClear) {
    FixedStateRecorder fixed;
    EXPECT_TRUE(fixed.state().ops.depthTest);
    fixed.bufferCleared();
    EXPECT_FALSE(fixed.state().ops.depthTest);
    EXPECT_NE(fixed.block({}), nullptr);
    fixed.setDepthTest(true);
    EXPECT_EQ(fixed.block({}), nullptr);

    FixedStateRecorder chosen;
    chosen.setDepthTest(true);
    chosen.bufferCleared();
    EXPECT_TRUE(chosen.state().ops.depthTest);
}

TEST(FixedStateRecorder, ObjectPlanesOfLooseGeometryAreSeenFromTheEye) {
    FixedStateRecorder fixed;
    fixed.change().texture.enabled2D = true;
    TexGen& s = fixed.change().texture.generate[0];
    s.enabled = true;
    s.mode = TexGenMode::ObjectLinear;
    s.objectPlane = {1, 2, 3, 4};
    FixedStateSources sources;
    sources.texture.image = std::make_shared<const Texture>(
        1, 1, 4, TexelType::Byte, std::vector<std::byte>(4), TextureOptions{});
    sources.objectToEye[0] = {2, 0, 0, 0};
    sources.objectToEye[3] = {8, -4, 16, 1};
    const FixedStatePtr block = fixed.block(sources);
    ASSERT_NE(block, nullptr);
    // The value at an object's point is that at the point's place in eye space.
    const glm::dvec4 point(0.5, -1, 3, 1);
    EXPECT_EQ(glm::dot(glm::dvec4(block->texture.generate[0].objectPlane),
                       sources.objectToEye * point),
              glm::dot(glm::dvec4(1, 2, 3, 4), point));
    EXPECT_EQ(fixed.state().texture.generate[0].objectPlane, glm::vec4(1, 2, 3, 4));
}

TEST(FixedStateRecorder, TextureUnitsStandInBlocksUpToTheLastOneWithATexture) {
    const auto image = std::make_shared<const Texture>(
        1, 1, 4, TexelType::Byte, std::vector<std::byte>(4), TextureOptions{});
    FixedStateRecorder fixed;
    fixed.selectUnit(2);
    EXPECT_EQ(fixed.texture(), FixedTexture());
    EXPECT_TRUE(fixed.state().moreTextures.empty()) << "asking makes nothing";
    fixed.changeTexture().mode = TexEnvMode::Add;
    EXPECT_EQ(fixed.texture().mode, TexEnvMode::Add);
    EXPECT_EQ(fixed.state().texture.mode, TexEnvMode::Modulate);
    EXPECT_EQ(fixed.block({}), nullptr) << "no unit has a texture";

    FixedStateSources sources;
    sources.moreTextures.resize(2);
    sources.moreTextures[1].image = image;
    sources.moreTextures[1].matrix[3] = {1, 2, 3, 1};
    const FixedStatePtr block = fixed.block(sources);
    ASSERT_NE(block, nullptr);
    EXPECT_EQ(block->texture, FixedTexture());
    ASSERT_EQ(block->moreTextures.size(), 2u);
    EXPECT_EQ(block->moreTextures[0], FixedTexture());
    EXPECT_EQ(block->moreTextures[1].image, image);
    EXPECT_EQ(block->moreTextures[1].mode, TexEnvMode::Add);
    EXPECT_EQ(block->moreTextures[1].matrix, sources.moreTextures[1].matrix);
    EXPECT_EQ(fixed.block(sources), block);

    sources.moreTextures[1].matrix[3].x = 2;
    const FixedStatePtr moved = fixed.block(sources);
    EXPECT_NE(moved, block);
    sources.moreTextures[1].matrix[3].x = 1;
    EXPECT_EQ(fixed.block(sources), block) << "equal states are one block";
    EXPECT_EQ(fixed.block({}), nullptr);
}

TEST(FixedStateRecorder, ColorMaterialReplacesItsPart) {
    FixedLighting lighting;
    const glm::vec4 color(0.1f, 0.2f, 0.3f, 0.4f);
    EXPECT_EQ(withColor({}, lighting, color), FixedMaterials());
    lighting.colorMaterial = true;
    FixedMaterials expected;
    expected.front.ambient = expected.front.diffuse = color;
    expected.back = expected.front;
    EXPECT_EQ(withColor({}, lighting, color), expected);
    lighting.colorMaterialFace = FixedFace::Back;
    lighting.colorMaterialMode = ColorMaterialMode::Emission;
    expected = {};
    expected.back.emission = color;
    EXPECT_EQ(withColor({}, lighting, color), expected);
}

/// What the recorder makes of calls: the instances of the frame.
class RecordedState : public testing::Test {
protected:
    void triangle(const std::function<void()>& inside = [] {}) {
        recorder_.begin(Primitive::Triangles);
        for (int i = 0; i < 3; ++i) {
            recorder_.vertex({double(i == 1), double(i == 2), -2, 1});
            inside();
        }
        recorder_.end();
    }
    static FixedMaterials shiny(float shininess) {
        FixedMaterials materials;
        materials.front.shininess = shininess;
        return materials;
    }
    std::vector<Instance> instances() {
        scene_ = recorder_.compileScene();
        std::vector<Instance> given;
        for (const InstanceView& instance : scene_->group().instances())
            given.push_back(asGiven(instance));
        return given;
    }

    Recorder recorder_;

private:
    ScenePtr scene_;
};

TEST_F(RecordedState, LooseRunsEndWhereTheStateChanges) {
    triangle();
    triangle();
    recorder_.fixedState().change().ops.blend = true;
    triangle();
    recorder_.fixedState().change().ops.blendColor.x = 0.5f;
    recorder_.fixedState().change().ops.blendColor.x = 0;
    triangle();
    recorder_.fixedState().change().ops.blend = false;
    triangle();
    const std::vector<Instance> runs = instances();
    ASSERT_EQ(runs.size(), 3u);
    EXPECT_EQ(runs[0].model->triangles.size(), 2u);
    EXPECT_EQ(runs[1].model->triangles.size(), 2u);
    EXPECT_EQ(runs[2].model->triangles.size(), 1u);
    EXPECT_EQ(runs[0].state, nullptr);
    ASSERT_NE(runs[1].state, nullptr);
    EXPECT_TRUE(runs[1].state->ops.blend);
    EXPECT_EQ(runs[2].state, nullptr);
}

TEST_F(RecordedState, ObjectsTakeTheStateWhenTheyArePlaced) {
    const uint32_t object = recorder_.newObject(ObjectMode::Define);
    triangle();
    recorder_.endObject();
    recorder_.instantiate(object);
    recorder_.fixedState().change().fog.enabled = true;
    recorder_.setMaterials(shiny(3));
    recorder_.instantiate(object);
    const std::vector<Instance> placed = instances();
    ASSERT_EQ(placed.size(), 2u);
    EXPECT_EQ(placed[0].state, nullptr);
    EXPECT_EQ(placed[0].inherited.materials, nullptr);
    ASSERT_NE(placed[1].state, nullptr);
    EXPECT_TRUE(placed[1].state->fog.enabled);
    ASSERT_NE(placed[1].inherited.materials, nullptr);
    EXPECT_EQ(*placed[1].inherited.materials, shiny(3));
}

TEST_F(RecordedState, VerticesLatchMaterials) {
    recorder_.setMaterials(shiny(1));
    triangle();
    float next = 2;
    triangle([&] { recorder_.setMaterials(shiny(next = 5 - next)); });
    const std::vector<Instance> runs = instances();
    ASSERT_EQ(runs.size(), 1u);
    EXPECT_EQ(*runs[0].inherited.materials, shiny(1));
    const ShadingData& shading = runs[0].model->shading;
    // The first triangle and the next vertex have the run's; then 3 and 2.
    EXPECT_EQ(shading.firstMaterial, 4u);
    ASSERT_EQ(shading.vertexMaterials.size(), 2u);
    EXPECT_EQ(*shading.materials[shading.vertexMaterials[0]], shiny(3));
    EXPECT_EQ(*shading.materials[shading.vertexMaterials[1]], shiny(2));
    ASSERT_EQ(shading.corners.size(), 2u);
    EXPECT_EQ(shading.corners[1][2], 5u);
}

TEST_F(RecordedState, FewMaterialsAreStoredOnce) {
    for (int i = 0; i < 100; ++i) {
        recorder_.setMaterials(shiny(float(1 + i % 4)));
        triangle();
    }
    const std::vector<Instance> runs = instances();
    ASSERT_EQ(runs.size(), 1u);
    EXPECT_EQ(runs[0].model->shading.materials.size(), 4u);
}

TEST_F(RecordedState, NormalsOfLooseGeometryAreRescaledByTheirMatrix) {
    recorder_.fixedState().change().lighting.enabled = true;
    recorder_.fixedState().change().lighting.rescaleNormal = true;
    glm::dmat4 scaling(4.0);
    scaling[3][3] = 1;
    recorder_.matrices().current().load(scaling);
    recorder_.normal({0, 0, 1});
    triangle();
    recorder_.fixedState().change().lighting.rescaleNormal = false;
    triangle();
    const std::vector<Instance> runs = instances();
    ASSERT_EQ(runs.size(), 2u);
    EXPECT_EQ(runs[0].model->shading.normals.at(0), glm::vec3(0, 0, 1));
    EXPECT_EQ(runs[1].model->shading.normals.at(0), glm::vec3(0, 0, 0.25f));
}

TEST_F(RecordedState, EnabledLightsAreLightsOfTheFrame) {
    float pixel[3];
    recorder_.frameSettings().target.memory = pixel;
    recorder_.frameSettings().target.width = recorder_.frameSettings().target.height = 1;
    EXPECT_TRUE(recorder_.makeFrame(recorder_.frameSettings().target)->lights.empty());
    recorder_.fixedState().change().lighting.lights[0].enabled = true;
    recorder_.fixedState().change().lighting.lights[7].enabled = true;
    EXPECT_EQ(recorder_.makeFrame(recorder_.frameSettings().target)->lights.size(), 2u);
}

} // namespace
} // namespace smart::compat

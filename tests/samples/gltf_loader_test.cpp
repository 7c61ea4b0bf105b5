// SPDX-License-Identifier: MIT
#ifdef SAMPLES_HAVE_GLTF

#include "samples/common/gltf_loader.h"

#include <gtest/gtest.h>

#include <cstring>
#include <glm/glm.hpp>

#include "samples/common/image_file.h"
#include "tests/samples/temporary_folder.h"

namespace samples {
namespace {

/// Builds .gltf text around one external buffer.
class GltfLoader : public testing::Test {
protected:
    template <class T>
    std::size_t append(const std::vector<T>& values) {
        while (buffer.size() % 4 != 0) buffer.push_back(0);
        const std::size_t offset = buffer.size();
        const auto* bytes = reinterpret_cast<const uint8_t*>(values.data());
        buffer.insert(buffer.end(), bytes, bytes + values.size() * sizeof(T));
        return offset;
    }
    SceneDescription load(const std::string& body) const {
        temporary.write("data.bin", buffer);
        const std::string text = R"({"asset":{"version":"2.0"},"buffers":[{"uri":"data.bin",)"
                                 R"("byteLength":)" +
                                 std::to_string(buffer.size()) + "}]," + body + "}";
        return loadGltf(temporary.write("scene.gltf", text));
    }
    static std::string view(std::size_t offset, std::size_t length) {
        return R"({"buffer":0,"byteOffset":)" + std::to_string(offset) + R"(,"byteLength":)" +
               std::to_string(length) + "}";
    }

    std::vector<uint8_t> buffer;
    test::TemporaryFolder temporary;
};

TEST_F(GltfLoader, AMeshOfManyNodesIsOneMeshWithManyInstances) {
    const std::vector<float> square = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    const std::vector<uint16_t> indices = {0, 1, 2, 0, 2, 3};
    const std::string views = view(append(square), 48) + "," + view(append(indices), 12);
    const SceneDescription scene = load(
        R"("bufferViews":[)" + views +
        R"(],"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},
        {"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
        "scenes":[{"nodes":[0,3]}],
        "nodes":[{"translation":[10,0,0],"children":[1,2]},
                 {"mesh":0,"translation":[0,2,0],"scale":[1,-3,1]},
                 {"mesh":0,"rotation":[0,0,0.70710678,0.70710678]},
                 {"matrix":[2,0,0,0,0,2,0,0,0,0,2,0,5,6,7,1],"mesh":0}])");
    ASSERT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.meshes[0].parts.at(0).triangleCount(), 2u);
    ASSERT_EQ(scene.instances.size(), 3u);
    const glm::dvec4 corner(1, 1, 0, 1);
    const glm::dvec3 expected[] = {{11, -1, 0}, {9, 1, 0}, {7, 8, 7}};
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 moved(scene.instances[i].transform * corner);
        EXPECT_LT(glm::distance(moved, expected[i]), 1e-6) << i;
    }
}

TEST_F(GltfLoader, StripsAndFansBecomeTriangles) {
    const std::vector<float> points = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0};
    const std::string views = view(append(points), 60);
    const auto corners = [&](int mode) {
        const SceneDescription scene =
            load(R"("bufferViews":[)" + views +
                 R"(],"accessors":[{"bufferView":0,"componentType":5126,"count":5,"type":"VEC3"}],
                 "meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":)" +
                 std::to_string(mode) + R"(}]}],"nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}])");
        std::vector<std::array<int, 3>> found;
        if (scene.meshes[0].parts.empty()) return found;
        const MeshPart& part = scene.meshes[0].parts[0];
        for (std::size_t i = 0; i < part.indices.size(); i += 3) {
            std::array<int, 3> triangle;
            for (std::size_t c = 0; c < 3; ++c) {
                const glm::vec3 p = part.positions[part.indices[i + c]];
                triangle[c] = int(p.x) + 2 * int(p.y); // the number the vertex has in `points`
            }
            found.push_back(triangle);
        }
        return found;
    };
    using List = std::vector<std::array<int, 3>>;
    EXPECT_EQ(corners(4), (List{{0, 1, 2}}));
    EXPECT_EQ(corners(5), (List{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}}));
    EXPECT_EQ(corners(6), (List{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
    EXPECT_EQ(corners(1), (List{})); // lines
}

TEST_F(GltfLoader, ScalesNormalisedIntegersAndHonoursStrides) {
    // Per vertex: position as three 16-bit steps and padding, texture coordinate as two bytes.
    const std::vector<int16_t> vertices = {100, -200, 300, 0, int16_t(0x00FF), 0,
                                           1,   2,    3,   0, int16_t(0x33CC), 0,
                                           4,   5,    6,   0, 0,               0};
    const std::string views = R"({"buffer":0,"byteOffset":)" + std::to_string(append(vertices)) +
                              R"(,"byteLength":36,"byteStride":12})";
    const SceneDescription scene = load(
        R"("extensionsUsed":["KHR_mesh_quantization"],
        "extensionsRequired":["KHR_mesh_quantization"],"bufferViews":[)" +
        views + R"(],"accessors":[
        {"bufferView":0,"componentType":5122,"count":3,"type":"VEC3"},
        {"bufferView":0,"byteOffset":8,"componentType":5121,"normalized":true,"count":3,
         "type":"VEC2"}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1}}]}],
        "nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}])");
    const MeshPart& part = scene.meshes.at(0).parts.at(0);
    EXPECT_EQ(part.positions.at(0), glm::vec3(100, -200, 300));
    EXPECT_EQ(part.texCoords.at(0), glm::vec2(1, 0));
    EXPECT_EQ(part.texCoords.at(1), glm::vec2(0.8f, 0.2f));
}

TEST_F(GltfLoader, ReadsMaterialsTexturesCamerasAndLights) {
    const std::vector<uint8_t> pixels = {255, 0, 0, 255, 0, 255, 0, 128}; // two rows, lower first
    const std::vector<uint8_t> png = encodePng(1, 2, 4, pixels);
    const std::vector<float> triangle = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const std::string views = view(append(triangle), 36) + "," + view(append(png), png.size());
    const SceneDescription scene = load(
        R"("extensionsUsed":["KHR_lights_punctual"],"bufferViews":[)" + views +
        R"(],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],
        "images":[{"bufferView":1,"mimeType":"image/png"}],
        "samplers":[{"wrapS":33071,"wrapT":33648,"magFilter":9728}],
        "textures":[{"source":0,"sampler":0},{"source":0}],
        "materials":[{"pbrMetallicRoughness":{"baseColorFactor":[0.1,0.2,0.3,0.4],
            "metallicFactor":0.25,"roughnessFactor":0.75,"baseColorTexture":{"index":0}},
            "emissiveFactor":[1,2,3],"alphaMode":"MASK","alphaCutoff":0.125,"doubleSided":true}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],
        "cameras":[{"type":"perspective","perspective":{"yfov":1.0,"znear":0.1}}],
        "extensions":{"KHR_lights_punctual":{"lights":[
            {"type":"spot","color":[1,0.5,0],"intensity":4,
             "spot":{"innerConeAngle":0.1,"outerConeAngle":0.2}},
            {"type":"directional"},{"type":"point","intensity":2,"range":7}]}},
        "scenes":[{"nodes":[0,1,2,3]}],
        "nodes":[{"mesh":0},{"camera":0,"translation":[1,2,3],
                             "rotation":[0,0.70710678,0,0.70710678]},
            {"translation":[4,5,6],"extensions":{"KHR_lights_punctual":{"light":0}}},
            {"extensions":{"KHR_lights_punctual":{"light":2}}}])");
    ASSERT_EQ(scene.materials.size(), 1u);
    const MaterialDescription& m = scene.materials[0];
    EXPECT_EQ(m.baseColor, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
    EXPECT_EQ(m.metallic, 0.25f);
    EXPECT_EQ(m.roughness, 0.75f);
    EXPECT_EQ(m.emissive, glm::vec3(1, 2, 3));
    EXPECT_EQ(m.alphaMode, AlphaMode::Mask);
    EXPECT_EQ(m.alphaCutoff, 0.125f);
    EXPECT_TRUE(m.doubleSided);
    ASSERT_EQ(m.baseColorTexture, 0);
    ASSERT_EQ(scene.textures.size(), 1u); // the one that nothing uses is not decoded
    EXPECT_EQ(scene.textures[0].wrapS, Wrap::ClampToEdge);
    EXPECT_EQ(scene.textures[0].wrapT, Wrap::MirroredRepeat);
    EXPECT_TRUE(scene.textures[0].nearest);
    const std::vector<uint8_t> fromTop = {0, 255, 0, 128, 255, 0, 0, 255};
    EXPECT_EQ(scene.images.at(0).rgba, fromTop);

    ASSERT_EQ(scene.cameras.size(), 1u);
    EXPECT_EQ(scene.cameras[0].eye, glm::vec3(1, 2, 3));
    EXPECT_LT(glm::distance(scene.cameras[0].direction, glm::vec3(-1, 0, 0)), 1e-6f);
    EXPECT_NEAR(scene.cameras[0].fovDegrees, 57.29578f, 1e-4f);

    ASSERT_EQ(scene.lights.size(), 2u);
    EXPECT_EQ(scene.lights[0].kind, LightKind::Spot);
    EXPECT_EQ(scene.lights[0].position, glm::vec3(4, 5, 6));
    EXPECT_EQ(scene.lights[0].direction, glm::vec3(0, 0, -1));
    EXPECT_EQ(scene.lights[0].radiance, glm::vec3(4, 2, 0));
    EXPECT_FLOAT_EQ(scene.lights[0].outerConeRadians, 0.2f);
    EXPECT_EQ(scene.lights[1].kind, LightKind::Point);
    EXPECT_EQ(scene.lights[1].range, 7.0f);
}

TEST_F(GltfLoader, DeepNodesAreReadAndInfiniteOnesSkipped) {
    const std::vector<float> triangle = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    constexpr int kDepth = 50000;
    std::string nodes;
    for (int i = 0; i < kDepth; ++i) {
        nodes += R"({"translation":[1,0,0],"children":[)" + std::to_string(i + 1) + "]},";
    }
    nodes += R"({"mesh":0},{"mesh":0,"scale":[1e300,1,1]})";
    const SceneDescription scene =
        load(R"("bufferViews":[)" + view(append(triangle), 36) +
             R"(],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],
             "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
             "scenes":[{"nodes":[0,)" +
             std::to_string(kDepth + 1) + R"(]}],"nodes":[)" + nodes + "]");
    ASSERT_EQ(scene.instances.size(), 1u);
    EXPECT_EQ(scene.instances[0].transform[3][0], double(kDepth));
    EXPECT_EQ(scene.skippedInstances, 1u);
}

TEST_F(GltfLoader, PartsThatShareAnAccessorKeepTheirOwnVerticesOnly) {
    std::vector<float> many(3 * 30000, 0.5f);
    many[0] = 7.0f;
    const std::vector<uint32_t> indices = {0, 29999, 5};
    const std::string views = view(append(many), many.size() * 4) + "," + view(append(indices), 12);
    std::string primitives;
    for (int i = 0; i < 200; ++i) {
        primitives += std::string(i ? "," : "") + R"({"attributes":{"POSITION":0},"indices":1})";
    }
    const SceneDescription scene = load(
        R"("bufferViews":[)" + views +
        R"(],"accessors":[{"bufferView":0,"componentType":5126,"count":30000,"type":"VEC3"},
        {"bufferView":1,"componentType":5125,"count":3,"type":"SCALAR"}],
        "meshes":[{"primitives":[)" +
        primitives + R"(]}],"nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}])");
    ASSERT_EQ(scene.meshes[0].parts.size(), 200u);
    for (const MeshPart& part : scene.meshes[0].parts) EXPECT_EQ(part.positions.size(), 3u);
    EXPECT_EQ(scene.meshes[0].parts[0].positions[0].x, 7.0f);
}

} // namespace
} // namespace samples

#endif

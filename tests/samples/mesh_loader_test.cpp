// SPDX-License-Identifier: MIT
#ifdef SAMPLES_HAVE_ASSIMP

#include "samples/common/mesh_loader.h"

#include <gtest/gtest.h>

#include <set>

#include "samples/common/image_file.h"
#include "samples/common/ply_header.h"
#include "tests/samples/temporary_folder.h"

namespace samples {
namespace {

std::size_t triangles(const SceneDescription& scene) {
    std::size_t count = 0;
    for (const MeshDescription& mesh : scene.meshes) {
        for (const MeshPart& part : mesh.parts) count += part.triangleCount();
    }
    return count;
}

TEST(MeshLoader, ReadsObjWithMaterialAndTexture) {
    const test::TemporaryFolder temporary;
    const std::vector<uint8_t> pixels = {255, 0, 0, 0, 0, 255};
    temporary.write("red.png", encodePng(1, 2, 3, pixels));
    temporary.write("scene.mtl",
                    std::string("newmtl shiny\nKd 0.25 0.5 0.75\nNs 98\nmap_Kd red.png\n"));
    const SceneDescription scene = loadMesh(temporary.write(
        "scene.obj", std::string("mtllib scene.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                                 "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl shiny\n"
                                 "f 1/1 2/2 3/3 4/4\n")));
    EXPECT_EQ(triangles(scene), 2u);
    ASSERT_EQ(scene.instances.size(), 1u);
    const MeshPart& part = scene.meshes.at(0).parts.at(0);
    ASSERT_GE(part.material, 0);
    const MaterialDescription& material = scene.materials[std::size_t(part.material)];
    EXPECT_EQ(material.baseColor, glm::vec4(0.25f, 0.5f, 0.75f, 1.0f));
    EXPECT_NEAR(material.roughness, 0.376f, 0.001f); // (2/100)^(1/4)
    ASSERT_EQ(material.baseColorTexture, 0);
    // (0, 0) is the upper left corner here, the lower left one in the file.
    for (std::size_t i = 0; i < part.positions.size(); ++i) {
        EXPECT_EQ(part.texCoords[i],
                  glm::vec2(part.positions[i].x, 1.0f - part.positions[i].y));
    }
}

TEST(MeshLoader, NumbersMayBeginWithTheirPoint) {
    const test::TemporaryFolder temporary;
    const SceneDescription scene = loadMesh(temporary.write(
        "mesh.obj", std::string("v .5 -.25 .0 .0 .0 .0\nv 1 0 .125 1 1 1\nv 0 1 0 1 1 1\n"
                                "vt .5\t.25\nusemtl .name\nf 1/1 2/1 3/1\n")));
    const MeshPart& part = scene.meshes.at(0).parts.at(0);
    EXPECT_EQ(part.positions.at(0), glm::vec3(0.5f, -0.25f, 0));
    EXPECT_EQ(part.positions.at(1), glm::vec3(1, 0, 0.125f));
    EXPECT_EQ(part.texCoords.at(2), glm::vec2(0.5f, 0.75f));
    EXPECT_EQ(part.colors.at(0), glm::vec4(0, 0, 0, 1));
}

TEST(MeshLoader, ReadsPly) {
    const test::TemporaryFolder temporary;
    const SceneDescription scene = loadMesh(temporary.write(
        "mesh.ply", std::string("ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n"
                                "property float y\nproperty float z\nelement face 2\n"
                                "property list uchar int vertex_indices\nend_header\n"
                                "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n")));
    EXPECT_EQ(triangles(scene), 2u);
}

TEST(MeshLoader, ColoursOfVerticesAreSrgb) {
    const test::TemporaryFolder temporary;
    const auto ply = temporary.write(
        "mesh.ply", std::string("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                                "property float y\nproperty float z\nproperty uchar red\n"
                                "property uchar green\nproperty uchar blue\nelement face 1\n"
                                "property list uchar int vertex_indices\nend_header\n"
                                "0 0 0 255 188 10\n1 0 0 255 188 10\n0 1 0 255 188 10\n"
                                "3 0 1 2\n"));
    const auto obj = temporary.write(
        "mesh.obj", std::string("v 0 0 0 1 0.737255 0.039216\nv 1 0 0 1 0.737255 0.039216\n"
                                "v 0 1 0 1 0.737255 0.039216\nf 1 2 3\n"));
    for (const auto& file : {ply, obj}) {
        const SceneDescription scene = loadMesh(file);
        for (const glm::vec4& c : scene.meshes.at(0).parts.at(0).colors) {
            EXPECT_EQ(c.r, 1.0f);
            EXPECT_NEAR(c.g, 0.5028865f, 1e-5f); // IEC 61966-2-1 on either side of its bend
            EXPECT_NEAR(c.b, 0.0030353f, 1e-5f);
        }
        EXPECT_EQ(scene.meshes[0].parts[0].colors.size(), 3u);
    }
}

TEST(MeshLoader, TellsOfMaterialsThatAreMissing) {
    const test::TemporaryFolder temporary;
    const auto path = temporary.write(
        "scene.obj", std::string("mtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
    ASSERT_EQ(loadMesh(path).notes.size(), 1u);
    EXPECT_NE(loadMesh(path).notes[0].find("none.mtl"), std::string::npos);
    temporary.write("none.mtl", std::string("newmtl a\n"));
    EXPECT_TRUE(loadMesh(path).notes.empty());
}

TEST(MeshLoader, KeepsTrianglesWithNumbersThatAreNone) {
    const test::TemporaryFolder temporary;
    const SceneDescription scene = loadMesh(temporary.write(
        "mesh.obj", std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nv inf 1 1\n"
                                "f 1 2 3\nf 1 2 4\nf 5 2 3\n")));
    EXPECT_EQ(triangles(scene), 3u); // the library drops and counts the two
}

TEST(MeshLoader, RefusesMaterialsAndTexturesOfOtherFolders) {
    const test::TemporaryFolder temporary;
    std::filesystem::create_directory(temporary.path() / "inner");
    temporary.write("outer.mtl", std::string("newmtl a\nKd 1 0 0\n"));
    const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n";
    EXPECT_THROW(
        loadMesh(temporary.write("inner/a.obj", "mtllib ../outer.mtl\n" + triangle)),
        LoadError);
    temporary.write("inner/b.mtl", std::string("newmtl a\nmap_Kd ../picture.png\n"));
    EXPECT_THROW(loadMesh(temporary.write("inner/b.obj", "mtllib b.mtl\n" + triangle)), LoadError);
    temporary.write("inner/c.mtl", std::string("newmtl a\nmap_Kd missing.png\n"));
    const SceneDescription scene =
        loadMesh(temporary.write("inner/c.obj", "mtllib c.mtl\n" + triangle));
    EXPECT_EQ(scene.notes.size(), 1u);
}

TEST(PlyHeader, ComparesCountsWithTheSize) {
    const auto check = [](const std::string& text) {
        checkPlyHeader({reinterpret_cast<const uint8_t*>(text.data()), text.size()});
    };
    const auto file = [](const std::string& vertices, const std::string& faces) {
        return "ply\nformat ascii 1.0\nelement vertex " + vertices +
               "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
               "\nproperty list uchar int vertex_indices\nend_header\n"
               "0 0 0\n1 0 0\n0 1 0\n3 0 1 2";
    };
    EXPECT_NO_THROW(check(file("3", "1")));
    EXPECT_THROW(check(file("30", "1")), LoadError);
    EXPECT_THROW(check(file("3", "4000000000")), LoadError);
    EXPECT_THROW(check(file("99999999999999999999", "1")), LoadError);
    EXPECT_THROW(check(file("-1", "1")), LoadError);
    EXPECT_THROW(check("ply\nformat ascii 1.0\n"), LoadError);
    EXPECT_THROW(check("ply\nformat ascii 1.0\nelement vertex 0\nproperty\nend_header\n"),
                 LoadError);
    EXPECT_THROW(check("ply\nformat ascii 1.0\nelement vertex 0\nend_header"), LoadError);
    EXPECT_THROW(check("ply\nformat ascii 1.0\nproperty float x\nend_header\n"), LoadError);
    EXPECT_THROW(check("plx"), LoadError);
}

} // namespace
} // namespace samples

#endif

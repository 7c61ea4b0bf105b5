// SPDX-License-Identifier: MIT
#include "samples/common/tri_loader.h"

#include <gtest/gtest.h>

#include <cstring>

#include "tests/samples/temporary_folder.h"

namespace samples {
namespace {

std::vector<uint8_t> triFile(uint32_t count, const std::vector<float>& floats) {
    std::vector<uint8_t> bytes(sizeof count + floats.size() * sizeof(float));
    std::memcpy(bytes.data(), &count, sizeof count);
    if (!floats.empty()) {
        std::memcpy(bytes.data() + sizeof count, floats.data(), floats.size() * sizeof(float));
    }
    return bytes;
}

class TriLoader : public testing::Test {
protected:
    SceneDescription load(std::span<const uint8_t> bytes) const {
        return loadTri(temporary.write("mesh.tri", bytes));
    }
    test::TemporaryFolder temporary;
};

TEST_F(TriLoader, ReadsTriangles) {
    std::vector<float> floats;
    for (int i = 0; i < 18; ++i) floats.push_back(float(i) * 0.5f);
    const SceneDescription scene = load(triFile(2, floats));
    ASSERT_EQ(scene.meshes.size(), 1u);
    ASSERT_EQ(scene.instances.size(), 1u);
    const MeshPart& part = scene.meshes[0].parts.at(0);
    EXPECT_EQ(part.triangleCount(), 2u);
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(part.positions[i],
                  glm::vec3(float(3 * i), float(3 * i + 1), float(3 * i + 2)) * 0.5f);
    }
}

TEST_F(TriLoader, AnEmptyFileOfTrianglesIsAnEmptyScene) {
    EXPECT_TRUE(load(triFile(0, {})).instances.empty());
}

TEST_F(TriLoader, RefusesCountsThatLie) {
    const std::vector<float> two(18, 1.0f);
    EXPECT_THROW(load(triFile(3, two)), LoadError);
    EXPECT_THROW(load(triFile(1, two)), LoadError);
    EXPECT_THROW(load(triFile(0xFFFFFFFFu, two)), LoadError);
    // 2^32 * 36 bytes would wrap around to the right size in 32 bits.
    EXPECT_THROW(load(triFile(0x40000002u, two)), LoadError);
    const std::vector<uint8_t> good = triFile(2, two);
    for (std::size_t size = 0; size < good.size(); ++size) {
        EXPECT_THROW(load(std::span(good).first(size)), LoadError) << size;
    }
}

} // namespace
} // namespace samples

// SPDX-License-Identifier: MIT
#include "samples/common/confined_folder.h"

#include <gtest/gtest.h>

#include "tests/samples/temporary_folder.h"

namespace samples {
namespace {

namespace fs = std::filesystem;

class ConfinedFolderTest : public testing::Test {
protected:
    void SetUp() override {
        fs::create_directories(temporary.path() / "scene" / "textures");
        temporary.write("secret.bin", std::string("secret"));
        temporary.write("scene/scene.gltf", std::string("{}"));
        temporary.write("scene/near.bin", std::string("near"));
        temporary.write("scene/textures/with space.png", std::string("picture"));
        fs::create_directories(temporary.path() / "scene-beside");
        temporary.write("scene-beside/other.bin", std::string("other"));
        fs::create_symlink(temporary.path() / "secret.bin", temporary.path() / "scene/link.bin");
        fs::create_symlink("near.bin", temporary.path() / "scene/inner.bin");
        fs::create_directory_symlink("../scene-beside", temporary.path() / "scene/beside");
    }
    std::string text(const std::string& name) {
        const std::vector<uint8_t> bytes = folder().read(name);
        return {bytes.begin(), bytes.end()};
    }
    ConfinedFolder folder() const { return ConfinedFolder(temporary.path() / "scene/scene.gltf"); }

    test::TemporaryFolder temporary;
};

TEST_F(ConfinedFolderTest, ReadsFilesInside) {
    EXPECT_EQ(text("near.bin"), "near");
    EXPECT_EQ(text("./near.bin"), "near");
    EXPECT_EQ(text("textures/with space.png"), "picture");
    EXPECT_EQ(text("inner.bin"), "near"); // a link that stays inside
}

TEST_F(ConfinedFolderTest, RefusesWhatLeadsOut) {
    const std::string absolute = (temporary.path() / "secret.bin").string();
    ASSERT_TRUE(std::filesystem::exists(absolute));
    for (const std::string& name :
         {std::string("../secret.bin"), std::string("textures/../../secret.bin"), absolute,
          "file://" + absolute, std::string("http://example.org/a.bin"), std::string("link.bin"),
          std::string("beside/other.bin"), std::string("..\\secret.bin"), std::string(),
          std::string("near.bin\0.png", 13), std::string("textures/..")}) {
        EXPECT_THROW(folder().read(name), RefusedName) << name;
    }
}

TEST_F(ConfinedFolderTest, SaysWhatIsMissing) {
    EXPECT_THROW(folder().read("missing.bin"), LoadError);
    EXPECT_THROW(folder().read("textures"), LoadError);
    try {
        folder().read("missing.bin");
    } catch (const RefusedName&) {
        ADD_FAILURE() << "a missing file is not a refused one";
    } catch (const LoadError& error) {
        EXPECT_NE(std::string(error.what()).find("missing.bin"), std::string::npos);
    }
}

TEST(ReadWholeFile, HasALimitAndWantsRegularFiles) {
    const test::TemporaryFolder temporary;
    const auto file = temporary.write("five", std::string("12345"));
    EXPECT_EQ(readWholeFile(file, 5).size(), 5u);
    EXPECT_THROW(readWholeFile(file, 4), LoadError);
    EXPECT_THROW(readWholeFile(temporary.path(), 100), LoadError);
    EXPECT_THROW(readWholeFile("/dev/zero", 100), LoadError);
    EXPECT_THROW(readWholeFile(temporary.path() / "none", 100), LoadError);
}

} // namespace
} // namespace samples

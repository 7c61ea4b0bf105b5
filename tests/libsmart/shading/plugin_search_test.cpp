// SPDX-License-Identifier: MIT
#include "libsmart/shading/plugin_search.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "libsmart/base/error.h"

namespace smart {
namespace {

namespace fs = std::filesystem;

class PluginSearch : public testing::Test {
protected:
    PluginSearch() {
        char name[] = "/tmp/openrt_search_XXXXXX";
        folder_ = mkdtemp(name);
        for (const char* sub : {"a", "b", "here"}) fs::create_directory(folder_ / sub);
        before_ = fs::current_path();
        fs::current_path(folder_ / "here");
    }
    ~PluginSearch() override {
        fs::current_path(before_);
        fs::remove_all(folder_);
    }
    std::string make(const std::string& name) const {
        std::ofstream(folder_ / name) << "x";
        return (folder_ / name).string();
    }
    std::string find(const std::string& name) const {
        return findShaderLibrary(name, {(folder_ / "a").string(), (folder_ / "b").string()});
    }
    std::string refusal(const std::string& name) const {
        try {
            return "found " + find(name);
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::InvalidValue);
            return error.what();
        }
    }

    fs::path folder_, before_;
};

TEST_F(PluginSearch, ANameWithoutASlashIsLookedForInTheFoldersInOrder) {
    const std::string second = make("b/wood.so");
    EXPECT_EQ(find("wood.so"), second);
    EXPECT_EQ(find("wood"), second);
    const std::string first = make("a/wood.so");
    EXPECT_EQ(find("wood"), first);
    const std::string exact = make("a/wood");
    EXPECT_EQ(find("wood"), exact);
    EXPECT_EQ(find("wood.so"), first);
}

TEST_F(PluginSearch, NeverInTheCurrentFolderByItself) {
    const std::string elsewhere = refusal("wood");
    EXPECT_NE(elsewhere.find("no such shader library in " + folder_.string() + "/a, "),
              std::string::npos)
        << elsewhere;
    make("here/wood.so");
    EXPECT_EQ(refusal("wood"), elsewhere + "; a file here needs a slash: ./wood.so");
    EXPECT_EQ(findShaderLibrary("wood", {"."}), "./wood.so");
    EXPECT_EQ(find("./wood"), "./wood.so");
    EXPECT_NE(refusal("").find("empty"), std::string::npos);
}

TEST_F(PluginSearch, ANameWithASlashIsAPath) {
    const std::string file = make("a/wood.so");
    EXPECT_EQ(find(file), file);
    EXPECT_EQ(find((folder_ / "a/wood").string()), file);
    EXPECT_EQ(find("../a/wood.so"), "../a/wood.so");
    EXPECT_NE(refusal("b/wood").find("b/wood: there is no such file, nor one with .so added"),
              std::string::npos);
}

TEST_F(PluginSearch, AFolderOfTheNameStandsBehindTheLibrary) {
    fs::create_directory(folder_ / "a/wood");
    EXPECT_EQ(find("wood"), (folder_ / "a/wood").string());
    const std::string file = make("a/wood.so");
    EXPECT_EQ(find("wood"), file);
}

TEST_F(PluginSearch, FoldersComeFromTheEnvironmentAndThenTheInstallation) {
    unsetenv("OPENRT_SHADER_PATH");
    const std::vector<std::string> installed = shaderFolders();
    ASSERT_EQ(installed.size(), 1u); // of this program, which holds the code
    EXPECT_EQ(installed[0],
              (fs::canonical("/proc/self/exe").parent_path() / "openrt/shaders").string());
    setenv("OPENRT_SHADER_PATH", ":/one::two:.:", 1);
    EXPECT_EQ(shaderFolders(), (std::vector<std::string>{"/one", "two", ".", installed[0]}));
    unsetenv("OPENRT_SHADER_PATH");
}

} // namespace
} // namespace smart

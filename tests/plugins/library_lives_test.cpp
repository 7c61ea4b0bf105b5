// SPDX-License-Identifier: MIT
// How long shader libraries stay, and that they do not disturb each other or the program.
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cfenv>
#include <chrono>
#include <filesystem>
#include <limits>
#include <thread>

#include "openrt/rts.h"
#include "tests/plugins/good/gate.h"
#include "tests/plugins/loaded_libraries.h"
#include "tests/plugins/picture.h"

using namespace plugin_test;

namespace {

TEST(PluginLives, OneLibraryForAllItsClassesUntilTheLastIsGone) {
    Picture picture;
    const RTuint red = load("Red", "two_halves.so");
    const RTuint blue = load("Blue", "two_halves"); // .so may be left out
    const RTuint again = load("Red", "two_halves.so");
    ASSERT_EQ(rtGetError(), RTenum(RT_NO_ERROR)) << rtGetErrorText();
    EXPECT_TRUE(red != blue && blue != again && red != again);
    rtRemoveShaderClass(red);
    rtRemoveShaderClass(blue);
    EXPECT_TRUE(isLoaded("two_halves.so"));
    rtRemoveShaderClass(again);
    EXPECT_FALSE(isLoaded("two_halves.so"));
}

TEST(PluginLives, AShaderKeepsItsLibraryAndSoDoesAnObject) {
    Picture picture;
    const RTuint green = load("Green", "two_halves.so");
    const RTuint shader = rtGenNewShader();
    const RTuint object = rtNewObject(RT_DEFINE);
    Picture::fill();
    rtEndObject();
    rtRemoveShaderClass(green);
    rtRemoveShader(shader);
    EXPECT_TRUE(isLoaded("two_halves.so"));
    rtInstantiateObject(object);
    rtRender();
    EXPECT_EQ(picture.centre(), (Rgb{0, 0.5f, 0}));
    rtRemoveObject(object);
    rtRender(); // the frame before, which the context keeps for questions, goes
    rtExit();
    EXPECT_FALSE(isLoaded("two_halves.so"));
}

TEST(PluginLives, RemovedWhileAFrameIsBusyWithIt) {
    GateState gate;
    Picture picture;
    const RTuint shaderClass = load("Gate", "gate.so");
    ASSERT_NE(shaderClass, RTuint(RT_INVALID)) << rtGetErrorText();
    const RTuint shader = rtGenNewShader();
    const GateAddress address{&gate};
    rtParameterRaw(rtParameterHandle("state"), &address, sizeof address);
    ASSERT_EQ(rtGetError(), RTenum(RT_NO_ERROR)) << rtGetErrorText();
    Picture::fill();
    rtStartRendering();
    while (gate.entered == 0) std::this_thread::yield();
    rtRemoveShader(shader);
    rtRemoveShaderClass(shaderClass);
    rtRemoveShaderClass(shaderClass);
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_VALUE)); // it is gone for the application
    EXPECT_TRUE(isLoaded("gate.so"));
    EXPECT_EQ(gate.destroyed, 0);
    gate.open = true;
    rtEndRendering();
    EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR)) << rtGetErrorText();
    EXPECT_EQ(picture.centre(), (Rgb{0.25f, 0.5f, 0.75f}));
    EXPECT_EQ(picture.at(0, kSize - 1), (Rgb{0.25f, 0.5f, 0.75f}));
    rtExit();
    EXPECT_EQ(gate.destroyed, 1);
    EXPECT_FALSE(isLoaded("gate.so"));
}

TEST(PluginLives, TheContextEndsWhileAFrameIsBusyWithIt) {
    GateState gate;
    Picture picture;
    load("Gate", "gate.so");
    rtGenNewShader();
    const GateAddress address{&gate};
    rtParameterRaw(rtParameterHandle("state"), &address, sizeof address);
    Picture::fill();
    rtStartRendering();
    while (gate.entered == 0) std::this_thread::yield();
    std::thread opener([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        gate.open = true;
    });
    rtExit();
    opener.join();
    EXPECT_EQ(gate.destroyed, 1);
    EXPECT_FALSE(isLoaded("gate.so"));
}

/// The library's own type of exception, thrown through its C interface, is told though the library
/// has been removed.
TEST(PluginLives, AnExceptionOutlivesTheClassButNotTheLibrary) {
    Picture picture;
    const RTuint shaderClass = load("Faulty", "fault_ShadeThrows.so");
    const RTuint shader = rtGenNewShader();
    ASSERT_EQ(rtGetError(), RTenum(RT_NO_ERROR)) << rtGetErrorText();
    Picture::fill();
    rtStartRendering();
    rtRemoveShader(shader);
    rtRemoveShaderClass(shaderClass);
    rtEndRendering();
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_OPERATION));
    ASSERT_NE(load("Blue", "two_halves.so"), RTuint(RT_INVALID)) << rtGetErrorText();
    rtGenNewShader();
    Picture::fill();
    rtRender();
    EXPECT_EQ(picture.centre(), (Rgb{0, 0, 0.5f}));
    EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR)) << rtGetErrorText();
    rtExit();
    EXPECT_FALSE(isLoaded("fault_ShadeThrows.so"));
}

TEST(PluginLives, EqualNamesInTwoLibrariesDoNotMeet) {
    Picture picture;
    RTuint shaders[2];
    const char* const files[2] = {"bright.so", "dark.so"};
    const char* const parameters[2] = {"bright", "dark"};
    const float expected[2] = {0.75f, 0.25f};
    for (int i = 0; i < 2; ++i) {
        ASSERT_NE(load("SameName", files[i]), RTuint(RT_INVALID)) << rtGetErrorText();
        EXPECT_NE(rtParameterHandle(parameters[i]), RTuint(RT_INVALID)) << parameters[i];
        EXPECT_EQ(rtParameterHandle(parameters[1 - i]), RTuint(RT_INVALID));
        EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_VALUE));
        shaders[i] = rtGenNewShader();
    }
    for (int i = 0; i < 2; ++i) {
        rtBindShader(shaders[i]);
        Picture::square(float(i - 1), float(i));
    }
    rtRender();
    for (int i = 0; i < 2; ++i) {
        const float factor = i == 0 ? 1.0f : expected[i];
        EXPECT_EQ(picture.at(2 + 4 * i, 4), (Rgb{expected[i], factor, expected[i]})) << files[i];
    }
    rtExit();
    EXPECT_FALSE(isLoaded("bright.so"));
    EXPECT_FALSE(isLoaded("dark.so"));
}

TEST(PluginLives, AFileThatWasReplacedIsReadAnewOnceItsClassesAreGone) {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("openrt_" + std::to_string(getpid()));
    std::filesystem::create_directory(folder);
    const std::filesystem::path file = folder / "changing.so";
    for (const char* now : {"bright", "dark"}) {
        std::filesystem::remove(file);
        std::filesystem::copy_file(pluginFile(now) + ".so", file);
        Picture picture;
        ASSERT_NE(rtGenNewShaderClass("SameName", file.c_str()), RTuint(RT_INVALID));
        EXPECT_NE(rtParameterHandle(now), RTuint(RT_INVALID)) << now;
    }
    std::filesystem::remove_all(folder);
}

TEST(PluginLives, LoadingLeavesTheFloatingPointStateAlone) {
    Picture picture;
    volatile float smallest = std::numeric_limits<float>::min();
    std::fenv_t before;
    std::fegetenv(&before);
    void* const byHand = dlopen(pluginFile("hasty.so").c_str(), RTLD_NOW);
    const bool changes = smallest / 2 == 0;
    dlclose(byHand);
    std::fesetenv(&before);
    if (!changes) GTEST_SKIP() << "this compiler's -ffast-math has no code that runs at the start";

    std::fesetround(FE_UPWARD);
    const RTuint loaded = load("Blue", "hasty.so");
    const bool flushed = smallest / 2 == 0;
    const int rounding = std::fegetround();
    std::fesetenv(&before);
    ASSERT_NE(loaded, RTuint(RT_INVALID)) << rtGetErrorText();
    EXPECT_FALSE(flushed);
    EXPECT_EQ(rounding, FE_UPWARD);
}

TEST(PluginSearch, ByNameInTheFoldersOfTheEnvironmentOnly) {
    Picture picture;
    const std::filesystem::path here = std::filesystem::current_path();
    std::filesystem::current_path(TEST_PLUGINS);
    EXPECT_EQ(rtGenNewShaderClass("Blue", "two_halves.so"), RTuint(RT_INVALID));
    EXPECT_NE(std::string(rtGetErrorText()).find("two_halves.so: no such shader library in"),
              std::string::npos)
        << rtGetErrorText();
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_VALUE));
    EXPECT_NE(rtGenNewShaderClass("Blue", "./two_halves.so"), RTuint(RT_INVALID));
    std::filesystem::current_path(here);
    setenv("OPENRT_SHADER_PATH", ":/nowhere:" TEST_PLUGINS, 1);
    EXPECT_NE(rtGenNewShaderClass("Blue", "two_halves"), RTuint(RT_INVALID)) << rtGetErrorText();
    unsetenv("OPENRT_SHADER_PATH");
    EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR));
}

} // namespace

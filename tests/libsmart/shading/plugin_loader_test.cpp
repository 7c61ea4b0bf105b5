// SPDX-License-Identifier: MIT
#include "libsmart/shading/plugin_loader.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "libsmart/base/error.h"
#include "libsmart/shading/shader_registry.h"
#include "tests/libsmart/shading/fake_tracer.h"
#include "tests/plugins/loaded_libraries.h"

namespace smart {
namespace {

using plugin_test::isLoaded;

const std::string kKinds = TEST_PLUGINS "/kinds.so";
const std::string kHalves = TEST_PLUGINS "/two_halves.so";

TEST(PluginLoader, NamesTheClassesAndLetsTheLibraryGo) {
    EXPECT_EQ(shaderClassNames(kKinds),
              (std::vector<std::string>{"Backdrop", "Beam", "Dimmer", "Matt", "Slide"}));
    EXPECT_FALSE(isLoaded("kinds.so"));
    EXPECT_EQ(shaderClassNames(kHalves), (std::vector<std::string>{"Blue", "Green", "Red"}));
}

TEST(PluginLoader, ClassesAreWhatTheirLibrarySays) {
    const ShaderClassPtr matt = loadShaderClass("Matt", kKinds);
    EXPECT_EQ(matt->kind(), RTenum(RT_SURFACE_SHADER));
    ASSERT_EQ(matt->parameterCount(), 3u);
    EXPECT_EQ(matt->parameter(1).scope, RTS_PER_TRIANGLE);
    EXPECT_NE(matt->descriptor().transparency, nullptr);
    EXPECT_EQ(loadShaderClass("Beam", kKinds)->kind(), RTenum(RT_LIGHT_SHADER));
    EXPECT_EQ(loadShaderClass("Backdrop", kKinds)->kind(), RTenum(RT_ENV_SHADER));
    EXPECT_EQ(loadShaderClass("Slide", kKinds)->kind(), RTenum(RT_CAMERA_SHADER));
    EXPECT_EQ(loadShaderClass("Dimmer", kKinds)->kind(), RTenum(RT_RENDERING_OBJECT_SHADER));
}

TEST(PluginLoader, TheSameClassIsTheSameObjectWhileItLives) {
    ShaderClassPtr red = loadShaderClass("Red", kHalves);
    const std::string indirect = TEST_PLUGINS "/../plugins/two_halves.so"; // the same file
    EXPECT_EQ(loadShaderClass("Red", indirect), red);
    EXPECT_NE(loadShaderClass("Green", kHalves), red);
    red.reset();
    EXPECT_FALSE(isLoaded("two_halves.so"));
    EXPECT_NE(loadShaderClass("Red", kHalves), nullptr);
}

TEST(PluginLoader, AShaderObjectKeepsTheCodeLoaded) {
    std::shared_ptr<const ShaderTable> frozen;
    uint32_t index = 0;
    {
        ShaderRegistry registry;
        const auto shader = registry.create(loadShaderClass("Blue", kHalves));
        index = shader->index();
        frozen = registry.freeze();
    }
    EXPECT_TRUE(isLoaded("two_halves.so"));
    test::FakeTracer tracer;
    EXPECT_EQ(tracer.shade(*(*frozen)[index]), (std::array<float, 4>{0, 0, 0.5f, 1}));
    frozen.reset();
    EXPECT_FALSE(isLoaded("two_halves.so"));
}

TEST(PluginLoader, FromManyThreadsAtOnce) {
    std::atomic<int> wrong = 0;
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([&, t] {
            for (int i = 0; i < 25; ++i) {
                const char* const name = (i + t) % 2 ? "Red" : "Blue";
                const ShaderClassPtr loaded = loadShaderClass(name, kHalves);
                wrong += loaded->name() != name;
                if (i % 5 == 0) wrong += loadShaderClass(name, kHalves) != loaded;
                try {
                    loadShaderClass("None", kHalves);
                    ++wrong;
                } catch (const Error&) {
                }
            }
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(wrong, 0);
    EXPECT_FALSE(isLoaded("two_halves.so"));
}

} // namespace
} // namespace smart

// SPDX-License-Identifier: MIT
// What an application can ask about classes and where they come from.
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "openrt/rts.h"
#include "tests/plugins/loaded_libraries.h"
#include "tests/plugins/picture.h"

using namespace plugin_test;

namespace {

TEST(Questions, NamesOfClasses) {
    const Picture context;
    EXPECT_EQ(std::string(rtGetShaderClassNames(pluginFile("kinds").c_str())),
              "Backdrop\nBeam\nDimmer\nMatt\nSlide\n");
    EXPECT_FALSE(isLoaded("kinds.so"));
    const std::string builtIn = rtGetShaderClassNames(nullptr);
    EXPECT_NE(builtIn.find("ConstantShader\n"), std::string::npos);
    EXPECT_NE(builtIn.find("\nPhong\n"), std::string::npos);
    EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR));

    EXPECT_EQ(rtGetShaderClassNames(pluginFile("fault_Version.so").c_str()), nullptr);
    EXPECT_NE(std::string(rtGetErrorText()).find("version 77"), std::string::npos);
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_VALUE));
    EXPECT_EQ(rtGetShaderClassNames(""), nullptr);
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_VALUE));
    rtBegin(RT_TRIANGLES);
    EXPECT_EQ(rtGetShaderClassNames(nullptr), nullptr);
    rtEnd();
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_OPERATION));
}

TEST(Questions, DescriptorsOfClasses) {
    const Picture context;
    const RTuint matt = load("Matt", "kinds.so");
    const RTshaderclass* const c = rtGetShaderClassDescriptor(matt);
    ASSERT_NE(c, nullptr);
    EXPECT_EQ(std::string(c->name), "Matt");
    EXPECT_EQ(c->kind, RTenum(RT_SURFACE_SHADER));
    ASSERT_EQ(c->parameterCount, 3u);
    EXPECT_EQ(std::string(c->parameters[2].name), "heat");
    EXPECT_EQ(c->parameters[2].scope, RTS_PER_VERTEX);
    EXPECT_EQ(c->parameters[2].type, RTS_FLOAT1);
    for (const RTuint unknown : {RTuint(0), matt + 1, RTuint(RT_INVALID)}) {
        EXPECT_EQ(rtGetShaderClassDescriptor(unknown), nullptr);
        EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_VALUE));
    }
}

TEST(Questions, TextsAboutTheLibrary) {
    const Picture context;
    const auto text = [](RTenum name) {
        return std::string(reinterpret_cast<const char*>(rtGetString(name)));
    };
    const std::string sets = text(RT_ISA_NAMES);
    EXPECT_TRUE(sets.ends_with("generic")) << sets; // the last resort
    EXPECT_NE(sets.find(text(RT_ISA)), std::string::npos) << sets;
    setenv("OPENRT_SHADER_PATH", "/one:two", 1);
    EXPECT_EQ(text(RT_SHADER_FOLDERS).find("/one:two:/"), 0u) << text(RT_SHADER_FOLDERS);
    unsetenv("OPENRT_SHADER_PATH");
    const std::string installed = text(RT_SHADER_FOLDERS);
    EXPECT_EQ(installed.find("/one"), std::string::npos);
    EXPECT_TRUE(installed.ends_with("/openrt/shaders")) << installed;
}

/// A handle alone keeps no library, and means nothing for its successor.
TEST(Questions, HandlesOfALibraryThatIsGone) {
    const Picture context;
    const RTuint first = load("Matt", "kinds.so");
    const RTuint color = rtParameterHandle("color");
    rtRemoveShaderClass(first);
    EXPECT_FALSE(isLoaded("kinds.so"));
    rtParameter3f(color, 1, 1, 1);
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_OPERATION));
    load("Matt", "kinds.so");
    rtGenNewShader();
    const RTuint now = rtParameterHandle("color");
    EXPECT_NE(now, color);
    rtParameter3f(color, 1, 1, 1);
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_OPERATION));
    rtParameter3f(now, 1, 1, 1);
    EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR)) << rtGetErrorText();
}

} // namespace

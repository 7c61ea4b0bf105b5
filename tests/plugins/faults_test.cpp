// SPDX-License-Identifier: MIT
// Shader libraries that must be refused: the error, its words, and that nothing else happens.
#include <gtest/gtest.h>

#include <cstdlib>
#include <ostream>
#include <string>

#include "tests/plugins/loaded_libraries.h"
#include "tests/plugins/picture.h"

using namespace plugin_test;

namespace {

enum class Code { MayNotRun, MayRun };

struct Fault {
    const char* name;
    Code code;
    const char* words;
};
std::ostream& operator<<(std::ostream& out, const Fault& fault) { return out << fault.name; }

const Fault kFaults[] = {
    {"Magic", Code::MayNotRun, "no descriptor of a shader library"},
    {"Version", Code::MayNotRun, "version 77 of the shader interface; this library has version 1"},
    {"Revision", Code::MayNotRun, "needs revision"},
    {"Size", Code::MayNotRun, "its descriptor has 24 bytes"},
    {"NoSymbol", Code::MayNotRun, "no data symbol rtsPlugin"},
    {"Function", Code::MayNotRun, "no data symbol rtsPlugin"},
    {"Unresolved", Code::MayNotRun, "isDefinedNowhere"},
    {"Reversed", Code::MayRun, "ends before it starts"},
    {"NoFirst", Code::MayRun, "ends before it starts"},
    {"Empty", Code::MayRun, "has no shader class"},
    {"Huge", Code::MayRun, "more than 4096"},
    {"NullEntry", Code::MayRun, "shader class 1 of its list is NULL"},
    {"SmallEntry", Code::MayRun, "shader class 1 of its list has 8 bytes"},
    {"NothingBehind", Code::MayRun, "neither a descriptor nor a function"},
    {"Nameless", Code::MayRun, "has no name"},
    {"Twins", Code::MayRun, "two shader classes named 'Faulty'"},
    {"DescribeFails", Code::MayRun, "shader class 'Faulty' can not be made"},
    {"DescribeFailsWordily", Code::MayRun, "can not be made: wwwwww"},
    {"DescribeThrows", Code::MayRun, "threw an exception: describe lost its words"},
    {"ConstructFails", Code::MayRun, "its constructor failed"},
    {"ConstructThrows", Code::MayRun, "threw an exception that says nothing"},
    {"ClassVersion", Code::MayRun, "version 99 of the shader interface"},
    {"ClassTooSmall", Code::MayRun, "descriptor of 16 bytes"},
};

class Faults : public testing::TestWithParam<Fault> {
protected:
    Faults() { unsetenv("OPENRT_TEST_CODE_RAN"); }
    static bool codeRan() { return std::getenv("OPENRT_TEST_CODE_RAN") != nullptr; }
};

TEST_P(Faults, AreRefusedAndLeaveNothing) {
    const Fault& fault = GetParam();
    const std::string file = std::string("fault_") + fault.name + ".so";
    Picture picture;
    const RTuint old = rtGenNewShaderClass("ConstantShader", nullptr);
    const RTuint shader = rtGenNewShader();
    rtParameter3f(rtParameterHandle("value"), 0.25f, 0.5f, 1.0f);

    EXPECT_EQ(load("Faulty", file), RTuint(RT_INVALID));
    const std::string text = rtGetErrorText();
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_VALUE));
    EXPECT_NE(text.find(file), std::string::npos) << text;
    EXPECT_NE(text.find(fault.words), std::string::npos) << text;
    if (fault.code == Code::MayNotRun) {
        EXPECT_FALSE(codeRan());
    }
    EXPECT_FALSE(isLoaded(file));

    RTint bound = 0;
    rtGetIntegerv(RT_SHADER_CLASS_BINDING, &bound);
    EXPECT_EQ(RTuint(bound), old);
    rtGetIntegerv(RT_SHADER_BINDING, &bound);
    EXPECT_EQ(RTuint(bound), shader);
    Picture::fill();
    rtRender();
    EXPECT_EQ(picture.centre(), (Rgb{0.25f, 0.5f, 1.0f}));

    ASSERT_NE(load("Blue", "two_halves.so"), RTuint(RT_INVALID)) << rtGetErrorText();
    rtGenNewShader();
    Picture::fill();
    rtRender();
    EXPECT_EQ(picture.centre(), (Rgb{0, 0, 0.5f}));
    EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR));
}

INSTANTIATE_TEST_SUITE_P(All, Faults, testing::ValuesIn(kFaults),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_F(Faults, TheSameLibraryWithoutAFaultIsLoadedAndItsCodeRuns) {
    Picture picture;
    ASSERT_NE(load("Faulty", "fault_None.so"), RTuint(RT_INVALID)) << rtGetErrorText();
    EXPECT_TRUE(codeRan());
    EXPECT_TRUE(isLoaded("fault_None.so"));
    rtGenNewShader();
    Picture::fill();
    rtRender();
    EXPECT_EQ(picture.centre(), (Rgb{0.5f, 0.5f, 0.5f}));
}

struct Refused {
    const char* className;
    const char* words;
};

TEST(ThrowingClasses, SayWhatTheyThrewAndTheirNeighbourWorks) {
    const Refused kRefused[] = {
        {"OutOfChalk", "'OutOfChalk' can not be made: out of chalk"},
        {"NoParameters", "'NoParameters' can not be made: no parameters today"},
        {"Wordless", "'Wordless' can not be made: an exception that says nothing"},
        {"TwoOfOneName", "two parameters are named 'a'"},
        {"Missing", "no shader class 'Missing'; it has Fine, NoParameters, OutOfChalk, "
                    "TwoOfOneName, Wordless"},
        {"", "no shader class ''"},
    };
    Picture picture;
    for (const Refused& refused : kRefused) {
        EXPECT_EQ(load(refused.className, "throwing.so"), RTuint(RT_INVALID));
        const std::string text = rtGetErrorText();
        EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_VALUE));
        EXPECT_NE(text.find(refused.words), std::string::npos) << text;
    }
    EXPECT_FALSE(isLoaded("throwing.so"));
    ASSERT_NE(load("Fine", "throwing.so"), RTuint(RT_INVALID)) << rtGetErrorText();
    rtGenNewShader();
    Picture::fill();
    rtRender();
    EXPECT_EQ(picture.centre(), (Rgb{1, 0, 0}));
}

TEST(Refusal, OfAnotherNameOrPlace) {
    Picture picture;
    EXPECT_EQ(rtGenNewShaderClass(nullptr, pluginFile("two_halves.so").c_str()),
              RTuint(RT_INVALID));
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_VALUE));
    EXPECT_EQ(rtGenNewShaderClass("Blue", ""), RTuint(RT_INVALID));
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_VALUE));
    EXPECT_EQ(rtGenNewShaderClass("Blue", "/nowhere/at/all.so"), RTuint(RT_INVALID));
    EXPECT_NE(std::string(rtGetErrorText()).find("/nowhere/at/all.so"), std::string::npos);
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_VALUE));
    rtBegin(RT_TRIANGLES);
    EXPECT_EQ(load("Blue", "two_halves.so"), RTuint(RT_INVALID));
    rtEnd();
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_OPERATION));
    EXPECT_FALSE(isLoaded("two_halves.so"));
}

} // namespace

// SPDX-License-Identifier: MIT
#include "compat/rtut/options.h"

#include <gtest/gtest.h>

#include <vector>

namespace {

using namespace rtut;

struct Parsed {
    Options options;
    std::string problem;
    std::vector<std::string> left;
};

Parsed parse(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "program");
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    int argc = int(argv.size());
    argv.push_back(nullptr);
    Parsed result;
    result.options = takeArguments(&argc, argv.data(), result.problem);
    for (int i = 1; i < argc; ++i) result.left.emplace_back(argv[std::size_t(i)]);
    EXPECT_EQ(argv[std::size_t(argc)], nullptr);
    return result;
}

TEST(Options, areTakenOut) {
    const Parsed p = parse({"a", "--rt-offscreen", "3", "b", "--rt-output", "f%03d.png",
                            "--rt-size", "64x48", "-iconic", "-display", ":0", "--rt-threads",
                            "2"});
    EXPECT_EQ(p.problem, "");
    EXPECT_EQ(p.options.offscreenFrames, 3);
    EXPECT_EQ(p.options.output, "f%03d.png");
    ASSERT_TRUE(p.options.size);
    EXPECT_EQ(p.options.size->width, 64);
    EXPECT_EQ(p.options.size->height, 48);
    EXPECT_EQ(p.left, (std::vector<std::string>{"a", "b", "--rt-threads", "2"}));
}

TEST(Options, geometriesAreThoseOfX) {
    Parsed p = parse({"-geometry", "320x200"});
    ASSERT_TRUE(p.options.initialSize);
    EXPECT_EQ(p.options.initialSize->height, 200);
    p = parse({"-geometry", "320x200+10+20"});
    ASSERT_TRUE(p.options.initialPlace);
    EXPECT_EQ(p.options.initialPlace->x, 10);
    EXPECT_EQ(p.options.initialPlace->y, 20);
    p = parse({"-geometry", "+7-8"});
    EXPECT_EQ(p.problem, "");
    EXPECT_FALSE(p.options.initialSize);
    EXPECT_EQ(p.options.initialPlace->y, -8);
}

TEST(Options, wrongOnesAreTold) {
    const std::vector<std::vector<std::string>> wrong = {
        {"--rt-offscreen"},
        {"--rt-offscreen", ""},
        {"--rt-offscreen", "0"},
        {"--rt-offscreen", "-1"},
        {"--rt-offscreen", "3x"},
        {"--rt-offscreen", "99999999999999999999"},
        {"--rt-size", "64"},
        {"--rt-size", "0x5"},
        {"--rt-size", "64x48x3"},
        {"--rt-size", "-4x4"},
        {"--rt-size", "99999x99999"},
        {"--rt-size"},
        {"-geometry", "bogus"},
        {"-geometry", "0x0"},
        {"--rt-offscreen", "2", "--rt-output", ""},
        {"--rt-offscreen", "2", "--rt-output", "frame.png"},
        {"--rt-offscreen", "2", "--rt-output", "%d%d.png"},
        {"--rt-offscreen", "2", "--rt-output", "%s.png"},
        {"--rt-offscreen", "2", "--rt-output", "%n.png"},
        {"--rt-offscreen", "2", "--rt-output", "%"},
        {"--rt-offscreen", "2", "--rt-output", "%99999d"},
        {"--rt-output", "f%d.png"},
    };
    for (const auto& arguments : wrong) EXPECT_NE(parse(arguments).problem, "") << arguments[0];
    EXPECT_EQ(parse({"--rt-offscreen", "1", "--rt-output", "frame.png"}).problem, "");
    EXPECT_EQ(parse({}).problem, "");
}

TEST(Options, nullIsFine) {
    std::string problem;
    EXPECT_EQ(takeArguments(nullptr, nullptr, problem).offscreenFrames, 0);
    EXPECT_EQ(problem, "");
}

TEST(FrameFiles, areNumberedAsPrintfWould) {
    EXPECT_EQ(frameFile("frame%03d.png", 7), "frame007.png");
    EXPECT_EQ(frameFile("frame%d.png", 1234), "frame1234.png");
    EXPECT_EQ(frameFile("%3d", 5), "  5");
    EXPECT_EQ(frameFile("100%%_%02d", 5), "100%_05");
    EXPECT_EQ(frameFile("one.png", 0), "one.png");
}

} // namespace

// SPDX-License-Identifier: MIT
#include "compat/recorder/display_list.h"

#include <gtest/gtest.h>

#include <string>

namespace smart::compat {
namespace {

/// One character a call: b, B begin filled and other primitives, e end, v vertex, n, c, t, u the
/// attributes, m an attribute call, x any other call. Of the segments: runs in brackets.
std::string segmentsOf(const std::string& calls) {
    CallStream stream;
    for (const char call : calls) {
        switch (call) {
        case 'b': stream.call(ListOp::BeginFilled, {}); break;
        case 'B': stream.call(ListOp::BeginOther, {}); break;
        case 'e': stream.call(ListOp::End, {}); break;
        case 'v': stream.vertex({1, 2, 3, 1}); break;
        case 'n': stream.normal({0, 0, 1}); break;
        case 'c': stream.color({1, 1, 1, 1}); break;
        case 't': stream.texCoord({0, 0, 0, 1}, 0); break;
        case 'u': stream.texCoord({0.5f, 0.25f, 0, 1}, 2); break;
        case 'm': stream.call(ListOp::Attribute, {}); break;
        default: stream.call(ListOp::Call, {}); break;
        }
    }
    DisplayList list(std::move(stream));
    std::string text;
    for (const ListSegment& segment : list.segments()) {
        const std::string part =
            calls.substr(segment.begin.op, segment.end.op - segment.begin.op);
        text += segment.isRun ? "[" + part + "]" : part;
    }
    return text;
}

TEST(DisplayList, RunsAreLongest) {
    EXPECT_EQ(segmentsOf("cbvvvecnbnvvvec"), "[cbvvvecnbnvvvec]");
    EXPECT_EQ(segmentsOf("xbvvvexcbvvve"), "x[bvvve]x[cbvvve]");
    EXPECT_EQ(segmentsOf("mbmvvve"), "[mbmvvve]");
    EXPECT_EQ(segmentsOf("ubtvuvvex"), "[ubtvuvve]x");
    EXPECT_EQ(segmentsOf(""), "");
}

TEST(DisplayList, WhatIsNoRunIsReplayedCallByCall) {
    EXPECT_EQ(segmentsOf("cnt"), "cnt");
    EXPECT_EQ(segmentsOf("cxnxt"), "cxnxt");
    EXPECT_EQ(segmentsOf("bvvvecBvve"), "[bvvvec]Bvve");
    EXPECT_EQ(segmentsOf("vvv"), "vvv");
    EXPECT_EQ(segmentsOf("vvve"), "vvve");
    EXPECT_EQ(segmentsOf("bvvv"), "bvvv");
    EXPECT_EQ(segmentsOf("bvvvebvv"), "[bvvve]bvv");
    EXPECT_EQ(segmentsOf("bvxvve"), "bvxvve");
    EXPECT_EQ(segmentsOf("bvvvebvxvvebvvve"), "[bvvve]bvxvve[bvvve]");
    EXPECT_EQ(segmentsOf("bvbvve"), "bvbvve");
    EXPECT_EQ(segmentsOf("ebvvve"), "e[bvvve]");
    EXPECT_EQ(segmentsOf("bvvveebvvve"), "[bvvve]e[bvvve]");
}

TEST(DisplayList, WhatARunLeaves) {
    CallStream stream;
    const auto material = [&](uint64_t key) {
        stream.call(ListOp::Attribute, {"material", nullptr, key});
    };
    stream.color({1, 0, 0, 1});
    material(7);
    stream.call(ListOp::BeginFilled, {});
    material(8);
    material(7);
    stream.vertex({0, 0, 0, 1});
    stream.color({0, 1, 0, 1});
    stream.normal({1, 0, 0});
    stream.texCoord({1, 2, 0, 1}, 2);
    stream.texCoord({3, 4, 0, 1}, 2);
    material(9);
    material(8);
    stream.call(ListOp::End, {});
    DisplayList list(std::move(stream));
    ASSERT_EQ(list.segments().size(), 1u);
    const ListSegment& run = list.segments()[0];
    EXPECT_EQ(run.color, glm::vec4(0, 1, 0, 1));
    EXPECT_EQ(run.normal, glm::vec3(1, 0, 0));
    EXPECT_EQ(run.texCoords[0], std::nullopt);
    EXPECT_EQ(run.texCoords[1], std::nullopt);
    EXPECT_EQ(run.texCoords[2], glm::vec4(3, 4, 0, 1));
    std::string keys;
    for (const std::size_t call : run.attributeCalls)
        keys += std::to_string(list.calls().call(call).attribute);
    EXPECT_EQ(keys, "798"); // the last of each, in their order
}

TEST(DisplayList, ArgumentsComeBackAsTheyWere) {
    const glm::dvec4 positions[] = {{1, -2, 0.5, 1},
                                    {0.1, 1e300, -0.0, 1},
                                    {1, 2, 3, 0.25},
                                    {0x1p-1074, 16777217.0, 3, 1}};
    CallStream stream;
    for (const glm::dvec4& position : positions) {
        stream.vertex(position);
        stream.color({0.1f, 0.2f, 0.3f, 0.4f});
    }
    CallStream::Position at;
    for (const glm::dvec4& position : positions) {
        EXPECT_EQ(stream.vertexAt(at), position);
        stream.advance(at);
        EXPECT_EQ(stream.vec4At(at), glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
        stream.advance(at);
    }
    EXPECT_EQ(at.op, stream.end().op);
    EXPECT_EQ(at.word, stream.end().word);
}

} // namespace
} // namespace smart::compat

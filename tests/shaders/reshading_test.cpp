// SPDX-License-Identifier: MIT
// Instances of one model with other shaders: the right pixels, and no model built anew.
#include <string>
#include <vector>

#include "tests/shaders/shader_picture.h"

namespace smart::test {
namespace {

using namespace openrt;

/// Each shader of a test shows a number of its own, in red.
class Reshading : public ShaderPicture {
protected:
    static RTuint numbered(int number) { return constant(Color(float(number), 0, 0)); }

    /// An object of some columns, each with its shader.
    static RTuint columns(const std::vector<RTuint>& shaders, int first) {
        const RTuint object = rtNewObject(RT_DEFINE);
        for (std::size_t i = 0; i < shaders.size(); ++i) {
            const int x = first + int(i);
            rectangle(shaders[i], x, 0, x + 1, 16, 0);
        }
        rtEndObject();
        return object;
    }
    static std::vector<RTint> shadersOf(RTuint object) {
        RTint count = 0;
        rtGetObjectiv(object, RT_OBJECT_SHADER_COUNT, &count);
        std::vector<RTint> ids(std::size_t(count) + 1);
        rtGetObjectiv(object, RT_OBJECT_SHADERS, ids.data());
        ids.pop_back();
        return ids;
    }
    /// The numbers in a row of the picture, from its first column on.
    std::vector<int> numbers(std::size_t count) {
        const SmallPicture picture = render();
        std::vector<int> all;
        for (std::size_t x = 0; x < count; ++x) all.push_back(int(picture.at(int(x), 7)[0]));
        return all;
    }
    using Ids = std::vector<RTuint>;
    using Row = std::vector<int>;
};

TEST_F(Reshading, OneShaderOrASetStandsInForThoseOfTheObject) {
    const RTuint one = numbered(1), two = numbered(2), three = numbered(3), nine = numbered(9);
    const RTuint object = columns({two, one, two, three}, 0);
    const auto used = shadersOf(object);
    ASSERT_EQ(used, (std::vector<RTint>{RTint(two), RTint(one), RTint(three)}));
    const int built = statistic(RT_STAT_MODELS_BUILT);

    rtInstantiateObject(object);
    EXPECT_EQ(numbers(4), (Row{2, 1, 2, 3}));
    rtInstantiateObjectShader(object, nine);
    EXPECT_EQ(numbers(4), (Row{9, 9, 9, 9}));
    const Ids all{nine, two, one}, some{0, nine}, none{0, 0, 0};
    rtInstantiateObjectShaders(object, 3, all.data());
    EXPECT_EQ(numbers(4), (Row{9, 2, 9, 1}));
    rtInstantiateObjectShaders(object, 2, some.data());
    EXPECT_EQ(numbers(4), (Row{2, 9, 2, 3})) << "0, and what is left out, keep the object's own";
    rtInstantiateObjectShaders(object, 3, none.data());
    EXPECT_EQ(numbers(4), (Row{2, 1, 2, 3}));
    rtInstantiateObjectShaders(object, 0, nullptr);
    EXPECT_EQ(numbers(4), (Row{2, 1, 2, 3}));
    // A set that exchanges two shaders replaces each once.
    const Ids exchanged{one, two};
    rtInstantiateObjectShaders(object, 2, exchanged.data());
    EXPECT_EQ(numbers(4), (Row{1, 2, 1, 3}));
    EXPECT_EQ(statistic(RT_STAT_MODELS_BUILT), built) << "nothing was copied or built";
    expectNoError();
}

TEST_F(Reshading, ManyInstancesShareOneModel) {
    const RTuint one = numbered(1), two = numbered(2);
    const RTuint object = columns({one, two}, 0);
    rtInstantiateObject(object);
    render();
    const int triangles = statistic(RT_STAT_TRIANGLES), built = statistic(RT_STAT_MODELS_BUILT);
    Row expected;
    for (int i = 0; i < 8; ++i) {
        const Ids set{numbered(10 + i), numbered(20 + i)};
        rtPushMatrix();
        rtTranslatef(float(2 * i) * 2 / kPictureSize, 0, 0);
        rtInstantiateObjectShaders(object, 2, set.data());
        rtPopMatrix();
        expected.push_back(10 + i);
        expected.push_back(20 + i);
        // Forgetting the ids does not forget the shaders.
        for (const RTuint shader : set) rtRemoveShader(shader);
    }
    EXPECT_EQ(numbers(16), expected);
    EXPECT_EQ(statistic(RT_STAT_TRIANGLES), triangles);
    EXPECT_EQ(statistic(RT_STAT_MODELS_BUILT), built);
    expectNoError();
}

TEST_F(Reshading, NestedObjectsInheritTheReplacement) {
    const RTuint one = numbered(1), two = numbered(2), three = numbered(3), four = numbered(4);
    const RTuint seven = numbered(7), eight = numbered(8);
    const RTuint inner = columns({one, two}, 2);
    const RTuint middle = rtNewObject(RT_DEFINE);
    rectangle(two, 4, 0, 5, 16, 0);
    rtInstantiateObject(inner);
    rtEndObject();
    const RTuint outer = rtNewObject(RT_DEFINE);
    rectangle(three, 0, 0, 1, 16, 0);
    rtInstantiateObject(middle);
    rectangle(four, 1, 0, 2, 16, 0);
    rtEndObject();
    const auto used = shadersOf(outer);
    EXPECT_EQ(used.size(), 4u);
    const auto place = [&](RTuint shader) {
        for (std::size_t i = 0; i < used.size(); ++i)
            if (used[i] == RTint(shader)) return i;
        return used.size();
    };
    rtInstantiateObject(outer);
    EXPECT_EQ(numbers(5), (Row{3, 4, 1, 2, 2}));
    Ids set(4, 0);
    ASSERT_LT(place(two), 4u);
    set[place(two)] = seven;
    rtInstantiateObjectShaders(outer, 4, set.data());
    EXPECT_EQ(numbers(5), (Row{3, 4, 1, 7, 7})) << "two, wherever it is";
    set[place(three)] = eight;
    rtInstantiateObjectShaders(outer, 4, set.data());
    EXPECT_EQ(numbers(5), (Row{8, 4, 1, 7, 7}));
    rtInstantiateObjectShader(outer, eight);
    EXPECT_EQ(numbers(5), (Row{8, 8, 8, 8, 8}));
    expectNoError();
}

TEST_F(Reshading, ReplacementsOfSeveralLevelsFollowEachOther) {
    const RTuint one = numbered(1), two = numbered(2), three = numbered(3), nine = numbered(9);
    const RTuint inner = columns({one, two}, 0);
    const RTuint outer = rtNewObject(RT_DEFINE);
    const Ids byThree{three}; // one becomes three
    rtInstantiateObjectShaders(inner, 1, byThree.data());
    rtEndObject();
    EXPECT_EQ(shadersOf(outer), (std::vector<RTint>{RTint(three), RTint(two)}))
        << "what the object shows is what can be replaced";
    rtInstantiateObject(outer);
    EXPECT_EQ(numbers(2), (Row{3, 2}));
    const Ids set{nine};
    rtInstantiateObjectShaders(outer, 1, set.data());
    EXPECT_EQ(numbers(2), (Row{9, 2}));
    const Ids last{0, nine};
    rtInstantiateObjectShaders(outer, 2, last.data());
    EXPECT_EQ(numbers(2), (Row{3, 9}));
    expectNoError();
}

/// Shows a number per vertex and one per triangle.
struct Annotated {
    struct VertexParam {
        float vertex = 5;
    };
    struct TriangleParam {
        float triangle = 6;
    };
    float scale = 1;
    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<float>("scale", PER_SHADER, offsetof(Annotated, scale));
        r.registerParam<float>("vertex", PER_VERTEX, offsetof(VertexParam, vertex));
        r.registerParam<float>("triangle", PER_TRIANGLE, offsetof(TriangleParam, triangle));
    }
    void shade(TraceContext& c) const {
        c.setRadiance(Color(scale * c.vertexParam<VertexParam>().vertex,
                            scale * c.triangleParam<TriangleParam>().triangle, 0));
    }
};

TEST_F(Reshading, ParametersOfVerticesStayWithTheirClass) {
    const RTuint plain = numbered(1);
    const RTuint first = own<Annotated>("Annotated");
    const RTuint second = rtGenNewShader(); // of the same class
    set("scale", 10.0f);
    rtBindShader(first);
    set("vertex", 2.0f);
    set("triangle", 3.0f);
    const RTuint object = columns({first, plain}, 0);
    const auto colors = [&] {
        const SmallPicture picture = render();
        return std::vector<float>{picture.at(0, 3)[0], picture.at(0, 3)[1], picture.at(1, 3)[0],
                                  picture.at(1, 3)[1]};
    };
    rtInstantiateObject(object);
    EXPECT_EQ(colors(), (std::vector<float>{2, 3, 1, 0}));
    rtInstantiateObjectShader(object, second);
    EXPECT_EQ(colors(), (std::vector<float>{20, 30, 50, 60}))
        << "the same class reads what its triangles were given, another's have the defaults";
    rtInstantiateObjectShader(object, plain);
    EXPECT_EQ(colors(), (std::vector<float>{1, 0, 1, 0}));
    expectReported(0);
}

TEST_F(Reshading, AWholeSceneIsReshadedAsOneObject) {
    // A floor, walls and a hundred small objects, under one id.
    const RTuint floor = numbered(1), wall = numbered(2), thing = numbered(3);
    const RTuint small = columns({thing}, 0);
    const RTuint scene = rtNewObject(RT_DEFINE);
    rectangle(floor, 0, 0, 16, 8, -1);
    rectangle(wall, 0, 8, 16, 16, -1);
    for (int i = 0; i < 100; ++i) {
        rtPushMatrix();
        rtTranslatef(float(i % 4) * 8 / kPictureSize, float(i) * 0.001f, float(i) * 0.001f);
        rtInstantiateObject(small);
        rtPopMatrix();
    }
    rtEndObject();
    rtInstantiateObject(scene);
    const SmallPicture before = render();
    const int triangles = statistic(RT_STAT_TRIANGLES), built = statistic(RT_STAT_MODELS_BUILT);
    const Ids set{numbered(11), numbered(12), numbered(13)};
    rtInstantiateObjectShaders(scene, 3, set.data());
    const SmallPicture after = render();
    for (const auto& [x, y] : pixelsWhere([](int, int) { return true; })) {
        EXPECT_GE(before.at(x, y)[0], 1);
        EXPECT_EQ(after.at(x, y)[0], before.at(x, y)[0] + 10);
    }
    EXPECT_EQ(statistic(RT_STAT_TRIANGLES), triangles);
    EXPECT_EQ(statistic(RT_STAT_MODELS_BUILT), built);
    expectNoError();
}

TEST_F(Reshading, WrongCallsChangeNothing) {
    const RTuint one = numbered(1), two = numbered(2), light = builtin("PointLight");
    const RTuint object = columns({one}, 0);
    const Ids three{two, two, two}, lights{light}, unknown{12345};
    const auto refused = [&](RTenum code, const auto& call) {
        call();
        EXPECT_EQ(rtGetError(), code) << rtGetErrorText();
    };
    refused(RT_INVALID_VALUE, [&] { rtInstantiateObjectShaders(object, 3, three.data()); });
    refused(RT_INVALID_VALUE, [&] { rtInstantiateObjectShaders(object, -1, three.data()); });
    refused(RT_INVALID_VALUE, [&] { rtInstantiateObjectShaders(object, 1, nullptr); });
    refused(RT_INVALID_VALUE, [&] { rtInstantiateObjectShaders(object, 1, unknown.data()); });
    refused(RT_INVALID_OPERATION, [&] { rtInstantiateObjectShaders(object, 1, lights.data()); });
    refused(RT_INVALID_VALUE, [&] { rtInstantiateObjectShaders(999, 1, three.data()); });
    refused(RT_INVALID_VALUE, [&] { rtInstantiateObjectShader(999, two); });
    refused(RT_INVALID_VALUE, [&] { rtInstantiateObjectShader(object, 12345); });
    refused(RT_INVALID_OPERATION, [&] { rtInstantiateObjectShader(object, light); });
    EXPECT_EQ(numbers(2), (Row{0, 0})) << "no instance was made";
    expectNoError();
}

} // namespace
} // namespace smart::test

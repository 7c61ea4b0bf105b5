// SPDX-License-Identifier: MIT
// Display lists against the same calls made directly, and against objects of the same calls.
#include <cmath>
#include <vector>

#include "tests/api/float_picture.h"

namespace {

/// Some of each primitive and attribute, in front of the viewer.
void drawShapes() {
    rtBegin(RT_TRIANGLE_STRIP);
    for (int i = 0; i < 6; ++i) {
        rtColor3f(0.25f * float(i % 4), 0.5f, 1.0f);
        rtVertex3f(-0.75f + 0.25f * float(i), i % 2 ? 0.75f : -0.5f, -2.0f - 0.25f * float(i));
    }
    rtEnd();
    rtNormal3f(0, 0, 1);
    rtBegin(RT_QUADS);
    rtVertex2f(-0.5f, -0.5f);
    rtVertex3d(1.5, -0.5, -4.0);
    rtVertex4f(3.0f, 2.0f, -8.0f, 2.0f);
    rtColor4f(1, 0.5f, 0, 1);
    rtVertex3i(-1, 1, -4);
    rtEnd();
}

class DisplayLists : public FloatPicture {
protected:
    static RTuint newList(const std::function<void()>& calls) {
        const RTuint list = rtGenLists(1);
        rtNewList(list, RT_COMPILE);
        calls();
        rtEndList();
        return list;
    }
};

TEST_F(DisplayLists, ToTheBitWhatTheCallsDraw) {
    // Moved by powers of two, coordinates are the same in the list's space and in the eye's.
    const Pixels direct = pictureOf([] {
        drawShapes();
        rtTranslatef(0.5f, 0.25f, 0.5f);
        drawShapes();
    });
    const RTuint list = newList(drawShapes);
    const Pixels called = pictureOf([list] {
        rtCallList(list);
        rtTranslatef(0.5f, 0.25f, 0.5f);
        rtCallList(list);
    });
    EXPECT_EQ(called, direct);
    EXPECT_NE(pictureOf([list] { rtCallList(list); }), direct);
}

TEST_F(DisplayLists, ToTheBitWhatAnObjectIs) {
    const RTuint object = rtNewObject(RT_DEFINE);
    drawShapes();
    rtEndObject();
    const RTuint list = newList(drawShapes);
    const auto place = [](const std::function<void()>& draw) {
        rtTranslatef(0.1f, 0.2f, -1);
        rtRotatef(33, 1, 2, 3);
        rtScalef(0.7f, 1.1f, 0.9f);
        draw();
    };
    const Pixels instance = pictureOf([&] { place([&] { rtInstantiateObject(object); }); });
    EXPECT_EQ(pictureOf([&] { place([&] { rtCallList(list); }); }), instance);
}

TEST_F(DisplayLists, CompiledAndExecuted) {
    const Pixels direct = pictureOf(drawShapes);
    rtColor3f(1, 1, 1);
    const Pixels executed = pictureOf([] {
        rtNewList(1, RT_COMPILE_AND_EXECUTE);
        drawShapes();
        rtEndList();
    });
    EXPECT_EQ(executed, direct);
    EXPECT_EQ(pictureOf([] { rtCallList(1); }), direct);
}

TEST_F(DisplayLists, OneInstanceOfOneModel) {
    const RTuint list = newList(drawShapes);
    pictureOf([list] { rtCallList(list); });
    EXPECT_EQ(value(RT_STAT_INSTANCES), 1);
    const RTint built = value(RT_STAT_MODELS_BUILT);
    pictureOf([list] {
        for (int i = 0; i < 5; ++i) {
            rtTranslatef(0.1f, 0, 0);
            rtColor3f(0.1f * float(i), 1, 1);
            rtCallList(list);
        }
    });
    EXPECT_EQ(value(RT_STAT_INSTANCES), 5);
    EXPECT_EQ(value(RT_STAT_MODELS_BUILT), built);
}

TEST_F(DisplayLists, ColourOfTheMomentWhereTheListSetsNone) {
    const auto quad = [] {
        rtBegin(RT_QUADS);
        rtVertex3f(-1, -1, -2);
        rtVertex3f(1, -1, -2);
        rtVertex3f(1, 1, -2);
        rtVertex3f(-1, 1, -2);
        rtEnd();
    };
    const RTuint list = newList(quad);
    for (const float red : {0.125f, 0.5f}) {
        const Pixels picture = pictureOf([&] {
            rtColor3f(red, 0.5f, 0.25f);
            rtCallList(list);
        });
        EXPECT_EQ(picture[4 * (kSize * kSize / 2 + kSize / 2)], red);
    }
}

TEST_F(DisplayLists, MaterialsOfTheMomentWhereTheListSetsOthers) {
    const auto lit = [](float emission, const std::function<void()>& draw) {
        const float light[4] = {emission, 0, 0, 1};
        rtMaterialfv(RT_FRONT_AND_BACK, RT_EMISSION, light);
        draw();
    };
    const auto draw = [] {
        const float ambient[4] = {0, 1, 0, 1};
        rtMaterialfv(RT_FRONT_AND_BACK, RT_AMBIENT, ambient);
        drawShapes();
    };
    rtEnable(RT_LIGHTING);
    const RTuint list = newList(draw);
    for (const float emission : {0.5f, 0.125f, 0.5f}) {
        const Pixels direct = pictureOf([&] { lit(emission, draw); });
        EXPECT_EQ(pictureOf([&] { lit(emission, [list] { rtCallList(list); }); }), direct);
    }
}

TEST_F(DisplayLists, FlattenedGeometryIsDrawn) {
    const auto flat = [](const std::function<void()>& draw) {
        rtTranslatef(0, 0, -3);
        rtScalef(1, 1, 0);
        draw();
    };
    const Pixels direct = pictureOf([&] { flat(drawShapes); });
    const RTuint list = newList(drawShapes);
    EXPECT_EQ(pictureOf([&] { flat([list] { rtCallList(list); }); }), direct);
}

TEST_F(DisplayLists, ProjectedGeometryIsDrawn) {
    const float shadow[16] = {2, 0, 0, 0, 0, 2, 0, 0, 0.25f, 0, 2, 0.125f, 0, 0, 0, 2};
    const auto projected = [&](const std::function<void()>& draw) {
        rtMultMatrixf(shadow);
        draw();
    };
    const Pixels direct = pictureOf([&] { projected(drawShapes); });
    const RTuint list = newList(drawShapes);
    EXPECT_EQ(pictureOf([&] { projected([list] { rtCallList(list); }); }), direct);
}

TEST_F(DisplayLists, PointsLinesAndEdgesOfPolygons) {
    const auto draw = [] {
        drawShapes();
        rtColor3f(1, 1, 0);
        rtBegin(RT_LINE_STRIP);
        for (int i = 0; i < 8; ++i) rtVertex3f(float(i % 3) - 1, float(i % 5) - 2, -3);
        rtEnd();
        rtBegin(RT_TRIANGLES);
        rtVertex3f(-1, -1, -2);
        rtVertex3f(1, -1, -2);
        rtVertex3f(0, 1, -2);
        rtEnd();
    };
    rtLineWidth(3);
    const RTuint list = newList(draw);
    for (const RTenum mode : {RT_FILL, RT_LINE}) {
        rtPolygonMode(RT_FRONT_AND_BACK, mode);
        const Pixels direct = pictureOf(draw);
        EXPECT_EQ(pictureOf([list] { rtCallList(list); }), direct);
    }
}

TEST_F(DisplayLists, InAnObjectItIsPartOfIt) {
    const RTuint list = newList(drawShapes);
    const RTuint object = rtNewObject(RT_DEFINE);
    rtCallList(list);
    rtEndObject();
    const Pixels direct = pictureOf(drawShapes);
    EXPECT_EQ(pictureOf([object] { rtInstantiateObject(object); }), direct);
}

TEST_F(DisplayLists, BeginInOneListEndInAnother) {
    const RTuint begin = newList([] { rtBegin(RT_QUADS); });
    const RTuint half = newList([] {
        rtVertex3f(-1, -1, -2);
        rtColor3f(1, 0, 0);
        rtVertex3f(1, -1, -2);
    });
    const RTuint rest = newList([] {
        rtVertex3f(1, 1, -2);
        rtVertex3f(-1, 1, -2);
        rtEnd();
    });
    const Pixels direct = pictureOf([] {
        rtBegin(RT_QUADS);
        rtVertex3f(-1, -1, -2);
        rtColor3f(1, 0, 0);
        rtVertex3f(1, -1, -2);
        rtVertex3f(1, 1, -2);
        rtVertex3f(-1, 1, -2);
        rtEnd();
    });
    EXPECT_EQ(pictureOf([&] {
                  rtCallList(begin);
                  rtCallList(half);
                  rtCallList(rest);
              }),
              direct);
}

TEST_F(DisplayLists, ShaderOfTheMoment) {
    const RTuint list = newList(drawShapes);
    const auto shader = [](float red) {
        rtGenNewShaderClass("ConstantShader", nullptr);
        const RTuint made = rtGenNewShader();
        rtParameter3f(rtParameterHandle("value"), red, 0, 0);
        return made;
    };
    const RTuint shaders[] = {shader(0.25f), shader(0.75f)};
    ASSERT_EQ(rtGetError(), unsigned(RT_NO_ERROR)) << rtGetErrorText();
    for (const RTuint bound : shaders) {
        rtBindShader(bound);
        const Pixels direct = pictureOf(drawShapes);
        EXPECT_EQ(pictureOf([list] { rtCallList(list); }), direct);
    }
    const RTint built = value(RT_STAT_MODELS_BUILT);
    const Pixels both = pictureOf([&] {
        for (const RTuint bound : shaders) {
            rtBindShader(bound);
            rtCallList(list);
            rtTranslatef(0.5f, 0.5f, 0);
        }
    });
    EXPECT_EQ(value(RT_STAT_MODELS_BUILT), built);
    const RTuint binding = newList([&] {
        rtBindShader(shaders[0]);
        rtCallList(list);
        rtTranslatef(0.5f, 0.5f, 0);
        rtBindShader(shaders[1]);
        rtCallList(list);
    });
    rtBindShader(0);
    EXPECT_EQ(pictureOf([binding] { rtCallList(binding); }), both);
    EXPECT_EQ(RTuint(value(RT_SHADER_BINDING)), shaders[1]);
}

TEST_F(DisplayLists, ObjectsInLists) {
    const RTuint object = rtNewObject(RT_DEFINE);
    drawShapes();
    rtEndObject();
    const RTuint list = newList([object] {
        rtTranslatef(0, 0, -1);
        rtInstantiateObject(object);
    });
    const Pixels direct = pictureOf([object] {
        rtTranslatef(0, 0, -1);
        rtInstantiateObject(object);
    });
    EXPECT_EQ(pictureOf([list] { rtCallList(list); }), direct);
}

TEST_F(DisplayLists, NoObjectsInListsNorListsInObjects) {
    rtNewList(1, RT_COMPILE);
    EXPECT_EQ(rtNewObject(RT_DEFINE), RT_INVALID);
    expectError(RT_INVALID_OPERATION);
    rtReplaceObject(1);
    expectError(RT_INVALID_OPERATION);
    rtEndList();
    rtNewObject(RT_DEFINE);
    rtNewList(2, RT_COMPILE);
    expectError(RT_INVALID_OPERATION);
    rtEndList();
    expectError(RT_INVALID_OPERATION);
    rtEndObject();
    EXPECT_EQ(rtIsList(2), RT_FALSE);
    expectError(RT_NO_ERROR);
}

TEST_F(DisplayLists, PointersAreReadWhenTheListIsCompiled) {
    unsigned char names[] = {7};
    RTuint object[] = {0};
    const RTuint list = newList([&] {
        rtCallLists(1, RT_UNSIGNED_BYTE, names);
        rtInstantiateObjectShaders(1, 1, object);
        rtCallLists(1, RT_UNSIGNED_BYTE, nullptr);
    });
    rtNewList(7, RT_COMPILE);
    rtTranslatef(1, 0, 0);
    rtEndList();
    names[0] = 99;
    expectError(RT_NO_ERROR);
    rtCallList(list);
    expectError(RT_INVALID_VALUE); // no such object, and no names
    float matrix[16];
    rtGetFloatv(RT_MODELVIEW_MATRIX, matrix);
    EXPECT_EQ(matrix[12], 1.0f);
}

TEST_F(DisplayLists, ViewportAndClearColorAreKept) {
    rtViewport(1, 2, 3, 4);
    rtClearColor(0.25f, 0, 0, 0);
    rtNewList(1, RT_COMPILE);
    rtViewport(5, 6, 7, 8);
    rtViewport(5, 6, -7, 8);
    rtClearColor(0.5f, 0, 0, 0);
    rtEndList();
    const auto expect = [](RTint x, RTfloat red) {
        RTint viewport[4];
        RTfloat color[4];
        rtGetIntegerv(RT_VIEWPORT, viewport);
        rtGetFloatv(RT_COLOR_CLEAR_VALUE, color);
        EXPECT_EQ(viewport[0], x);
        EXPECT_EQ(color[0], red);
    };
    expectError(RT_NO_ERROR);
    expect(1, 0.25f);
    rtCallList(1);
    expectError(RT_INVALID_VALUE);
    expect(5, 0.5f);
}

TEST_F(DisplayLists, ListsThatMultiplyComeToAnEnd) {
    const RTuint first = rtGenLists(70);
    for (RTuint i = 0; i < 70; ++i) {
        rtNewList(first + i, RT_COMPILE);
        rtCallList(first + i);
        rtCallList(first + i + 1);
        rtEndList();
    }
    rtCallList(first);
    EXPECT_EQ(rtGetError(), unsigned(RT_INVALID_OPERATION));
    rtCallList(first + 200);
    rtTranslatef(0, 0, 0);
    EXPECT_EQ(rtGetError(), unsigned(RT_NO_ERROR));
}

TEST_F(DisplayLists, TenThousandCalls) {
    const RTuint step = newList([] { rtTranslatef(0.5f, 0, 0); });
    const RTuint many = newList([step] {
        for (int i = 0; i < 5000; ++i) {
            rtCallList(step);
            rtTranslatef(0, 0.25f, 0);
        }
    });
    rtCallList(many);
    float matrix[16];
    rtGetFloatv(RT_MODELVIEW_MATRIX, matrix);
    EXPECT_EQ(matrix[12], 2500.0f);
    EXPECT_EQ(matrix[13], 1250.0f);
}

TEST_F(DisplayLists, HugeRangesOfNames) {
    EXPECT_EQ(rtGenLists(0x7FFFFFFF), 1u);
    EXPECT_EQ(rtGenLists(0x7FFFFFFF), 0x80000000u);
    EXPECT_EQ(rtGenLists(0x7FFFFFFF), 0u);
    EXPECT_EQ(rtIsList(0xFFFFFFFEu), RT_TRUE);
    rtDeleteLists(2, 0x7FFFFFFF);
    EXPECT_EQ(rtIsList(2), RT_FALSE);
    EXPECT_EQ(rtIsList(1), RT_TRUE);
    expectError(RT_NO_ERROR);
}

RTuint listOfListener;
std::vector<int> heard;
void RTAPIENTRY listener(RTenum, const char*, const char*, void*) {
    heard.push_back(1);
    rtDeleteLists(listOfListener, 1);
    rtNewList(listOfListener, RT_COMPILE);
    rtTranslatef(100, 0, 0);
    rtEndList();
}

TEST_F(DisplayLists, DeletedAndReplacedWhileItIsCalled) {
    heard.clear();
    listOfListener = newList([] {
        rtTranslatef(1, 0, 0);
        rtMatrixMode(77);
        rtTranslatef(1, 0, 0);
        drawShapes();
    });
    rtErrorCallback(listener, nullptr);
    rtCallList(listOfListener);
    rtErrorCallback(nullptr, nullptr);
    EXPECT_EQ(heard.size(), 1u);
    float matrix[16];
    rtGetFloatv(RT_MODELVIEW_MATRIX, matrix);
    EXPECT_EQ(matrix[12], 2.0f); // the old list to its end
    expectError(RT_INVALID_ENUM);
    rtCallList(listOfListener);
    rtGetFloatv(RT_MODELVIEW_MATRIX, matrix);
    EXPECT_EQ(matrix[12], 102.0f);
}

void RTAPIENTRY endingListener(RTenum, const char*, const char*, void*) {
    rtExit();
}

TEST_F(DisplayLists, LibraryEndedWhileAListIsCalled) {
    const RTuint list = newList([] {
        rtMatrixMode(77);
        drawShapes();
        rtTranslatef(1, 0, 0);
    });
    rtErrorCallback(endingListener, nullptr);
    rtCallList(list);
    rtTranslatef(1, 0, 0); // no context any more
    EXPECT_EQ(rtGetError(), unsigned(RT_INVALID_OPERATION));
}

TEST_F(DisplayLists, CallsWithErrorsAreTheOnlyOnesThatDoNothing) {
    const RTuint list = newList([] {
        rtBegin(RT_TRIANGLES);
        rtMatrixMode(RT_PROJECTION); // not legal here
        rtVertex3f(-1, -1, -2);
        rtVertex3f(1, -1, -2);
        rtVertex3f(0, 1, -2);
        rtEnd();
    });
    rtCallList(list);
    expectError(RT_INVALID_OPERATION);
    EXPECT_EQ(value(RT_MATRIX_MODE), RT_MODELVIEW);
    rtRender();
    EXPECT_GT(drawn(), kSize);
}

TEST_F(DisplayLists, ValuesThatNoParameterHasAreNotRead) {
    const RTuint list = rtGenLists(1);
    const RTuint value = 0;
    rtNewList(list, RT_COMPILE);
    rtParameterRaw(1, &value, 0xFFFFFFFFu);
    rtEndList();
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_OPERATION));
}

TEST_F(DisplayLists, AnErrorCallbackMayEndTheContextBetweenTwoLists) {
    const RTcontext own = rtGetCurrentContext(), other = rtCreateContext();
    rtMakeCurrent(other);
    rtNewList(1, RT_COMPILE);
    rtEnd();
    rtEndList();
    rtErrorCallback([](RTenum, const char*, const char*,
                       void*) { rtDestroyContext(rtGetCurrentContext()); },
                    nullptr);
    const RTuint names[] = {1, 1};
    rtCallLists(2, RT_UNSIGNED_INT, names);
    EXPECT_EQ(rtGetCurrentContext(), nullptr);
    rtMakeCurrent(own);
}

} // namespace

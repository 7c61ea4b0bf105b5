// SPDX-License-Identifier: MIT
// Vertex arrays and rectangles against the same elements in immediate mode.
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <type_traits>
#include <vector>

#include "tests/api/float_picture.h"

namespace {

constexpr int kCount = 12;

/// Some points in front of the viewer; whole numbers, as types without fractions have them.
int coordinate(int element, int k) {
    const int values[3] = {(element * 5) % 7 - 3, (element * 3) % 7 - 3, -3 - element % 4};
    return k < 3 ? values[k] : 1;
}

/// The colour component that all types hold nearly: 0 or the largest.
template <class T>
T component(int element, int k) {
    const bool on = ((element + k) % 3) != 0;
    if (!on) return T(0);
    if constexpr (std::is_floating_point_v<T>)
        return T(1);
    else
        return std::numeric_limits<T>::max();
}

/// As OpenGL 1.5 maps it (table 2.6).
template <class T>
double scaled(T value) {
    if constexpr (std::is_floating_point_v<T>) return double(value);
    if constexpr (std::is_unsigned_v<T>)
        return double(value) / double(std::numeric_limits<T>::max());
    return (2.0 * double(value) + 1) / double(std::numeric_limits<std::make_unsigned_t<
               std::conditional_t<std::is_integral_v<T>, T, int>>>::max());
}

template <class T>
constexpr RTenum typeOf() {
    if constexpr (std::is_same_v<T, int8_t>) return RT_BYTE;
    if constexpr (std::is_same_v<T, uint8_t>) return RT_UNSIGNED_BYTE;
    if constexpr (std::is_same_v<T, int16_t>) return RT_SHORT;
    if constexpr (std::is_same_v<T, uint16_t>) return RT_UNSIGNED_SHORT;
    if constexpr (std::is_same_v<T, int32_t>) return RT_INT;
    if constexpr (std::is_same_v<T, uint32_t>) return RT_UNSIGNED_INT;
    if constexpr (std::is_same_v<T, float>) return RT_FLOAT;
    return RT_DOUBLE;
}

class VertexArrays : public FloatPicture {
protected:
    /// Elements of n components, `gap` bytes apart.
    template <class T, class Value>
    static std::vector<std::byte> packed(int n, int gap, const Value& value) {
        std::vector<std::byte> bytes;
        for (int element = 0; element < kCount; ++element) {
            for (int k = 0; k < n; ++k) {
                const T v = T(value(element, k));
                const auto* const from = reinterpret_cast<const std::byte*>(&v);
                bytes.insert(bytes.end(), from, from + sizeof v);
            }
            bytes.resize(bytes.size() + std::size_t(gap), std::byte(0xAB));
        }
        return bytes;
    }
    /// The same in immediate mode.
    static void drawDirectly(RTenum mode, int n, const std::vector<unsigned>& elements,
                             const std::function<void(int)>& attributes) {
        rtBegin(mode);
        for (const unsigned element : elements) {
            attributes(int(element));
            const auto at = [&](int k) { return double(coordinate(int(element), k)); };
            rtVertex4d(at(0), at(1), n > 2 ? at(2) : 0, 1);
        }
        rtEnd();
    }
    template <class T>
    void testVertices(int n, int gap) {
        const auto bytes = packed<T>(n, gap, coordinate);
        const Pixels direct = pictureOf([&] {
            rtTranslatef(0, 0, -2);
            drawDirectly(RT_TRIANGLES, n, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}, [](int) {});
        });
        rtVertexPointer(n, typeOf<T>(), gap ? int(sizeof(T)) * n + gap : 0, bytes.data());
        rtEnableClientState(RT_VERTEX_ARRAY);
        EXPECT_EQ(pictureOf([&] {
                      rtTranslatef(0, 0, -2);
                      rtDrawArrays(RT_TRIANGLES, 0, kCount);
                  }),
                  direct);
        rtDisableClientState(RT_VERTEX_ARRAY);
    }
    template <class T>
    void testColors(int n, int gap) {
        const auto colors = packed<T>(n, gap, component<T>);
        const auto vertices = packed<float>(3, 0, coordinate);
        const Pixels direct = pictureOf([&] {
            drawDirectly(RT_TRIANGLES, 3, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}, [&](int e) {
                const auto at = [&](int k) { return float(scaled(component<T>(e, k))); };
                rtColor4f(at(0), at(1), at(2), n > 3 ? at(3) : 1);
            });
        });
        rtVertexPointer(3, RT_FLOAT, 0, vertices.data());
        rtColorPointer(n, typeOf<T>(), gap ? int(sizeof(T)) * n + gap : 0, colors.data());
        rtEnableClientState(RT_VERTEX_ARRAY);
        rtEnableClientState(RT_COLOR_ARRAY);
        EXPECT_EQ(pictureOf([] { rtDrawArrays(RT_TRIANGLES, 0, kCount); }), direct);
        rtDisableClientState(RT_COLOR_ARRAY);
        rtDisableClientState(RT_VERTEX_ARRAY);
    }
};

TEST_F(VertexArrays, VerticesOfAllTypes) {
    for (const int gap : {0, 5}) {
        for (const int n : {2, 3, 4}) {
            testVertices<int16_t>(n, gap);
            testVertices<int32_t>(n, gap);
            testVertices<float>(n, gap);
            testVertices<double>(n, gap);
        }
    }
}

TEST_F(VertexArrays, ColoursOfAllTypes) {
    for (const int gap : {0, 3}) {
        for (const int n : {3, 4}) {
            testColors<int8_t>(n, gap);
            testColors<uint8_t>(n, gap);
            testColors<int16_t>(n, gap);
            testColors<uint16_t>(n, gap);
            testColors<int32_t>(n, gap);
            testColors<uint32_t>(n, gap);
            testColors<float>(n, gap);
            testColors<double>(n, gap);
        }
    }
}

TEST_F(VertexArrays, IndicesOfAllTypesAndAllPrimitives) {
    const std::vector<unsigned> elements = {3, 1, 4, 1, 5, 9, 2, 6, 5, 3, 0, 11};
    const auto vertices = packed<float>(3, 0, coordinate);
    rtVertexPointer(3, RT_FLOAT, 0, vertices.data());
    rtEnableClientState(RT_VERTEX_ARRAY);
    const std::vector<uint8_t> bytes(elements.begin(), elements.end());
    const std::vector<uint16_t> shorts(elements.begin(), elements.end());
    for (const RTenum mode : {RT_TRIANGLES, RT_TRIANGLE_STRIP, RT_TRIANGLE_FAN, RT_QUADS,
                              RT_QUAD_STRIP, RT_POLYGON}) {
        const Pixels direct =
            pictureOf([&] { drawDirectly(mode, 3, elements, [](int) {}); });
        const RTsizei n = RTsizei(elements.size());
        EXPECT_EQ(pictureOf([&] { rtDrawElements(mode, n, RT_UNSIGNED_INT, elements.data()); }),
                  direct);
        EXPECT_EQ(pictureOf([&] { rtDrawElements(mode, n, RT_UNSIGNED_BYTE, bytes.data()); }),
                  direct);
        EXPECT_EQ(pictureOf([&] {
                      rtDrawRangeElements(mode, 0, 11, n, RT_UNSIGNED_SHORT, shorts.data());
                  }),
                  direct);
        EXPECT_EQ(pictureOf([&] {
                      rtBegin(mode);
                      for (const unsigned element : elements) rtArrayElement(int(element));
                      rtEnd();
                  }),
                  direct);
    }
}

TEST_F(VertexArrays, SeveralDrawingsInOneCall) {
    const auto vertices = packed<float>(3, 0, coordinate);
    rtVertexPointer(3, RT_FLOAT, 0, vertices.data());
    rtEnableClientState(RT_VERTEX_ARRAY);
    const RTint first[] = {0, 7, 3};
    const RTsizei count[] = {6, 0, 3};
    const Pixels direct = pictureOf([] {
        rtDrawArrays(RT_TRIANGLES, 0, 6);
        rtDrawArrays(RT_TRIANGLES, 3, 3);
    });
    EXPECT_EQ(pictureOf([&] { rtMultiDrawArrays(RT_TRIANGLES, first, count, 3); }), direct);
    const RTubyte a[] = {0, 1, 2, 3, 4, 5}, b[] = {3, 4, 5};
    const void* const indices[] = {a, nullptr, b};
    EXPECT_EQ(pictureOf([&] {
                  rtMultiDrawElements(RT_TRIANGLES, count, RT_UNSIGNED_BYTE, indices, 3);
              }),
              direct);
}

TEST_F(VertexArrays, WrongDrawingsDrawNothing) {
    const auto vertices = packed<float>(3, 0, coordinate);
    const auto colors = packed<float>(4, 0, component<float>);
    rtVertexPointer(3, RT_FLOAT, 0, vertices.data());
    rtColorPointer(4, RT_FLOAT, 0, colors.data());
    rtEnableClientState(RT_VERTEX_ARRAY);
    rtEnableClientState(RT_COLOR_ARRAY);
    rtColor4f(0.125f, 0.25f, 0.5f, 0.75f);
    const RTubyte indices[] = {0, 1, 2};
    RTuint buffer;
    rtGenBuffers(1, &buffer);
    rtBindBuffer(RT_ELEMENT_ARRAY_BUFFER, buffer);
    rtBufferData(RT_ELEMENT_ARRAY_BUFFER, sizeof indices, indices, RT_STATIC_DRAW);
    rtBindShader(0);
    const auto expectNothing = [&](RTenum error, const std::function<void()>& draw) {
        draw();
        expectError(error);
        rtRender();
        EXPECT_EQ(value(RT_STAT_TRIANGLES), 0);
        float color[4];
        rtGetFloatv(RT_CURRENT_COLOR, color);
        EXPECT_EQ(color[0], 0.125f);
    };
    const auto ranges = [](RTenum mode, std::vector<RTint> first, std::vector<RTsizei> count) {
        rtMultiDrawArrays(mode, first.data(), count.data(), RTsizei(first.size()));
    };
    const auto indexed = [](RTenum mode, std::vector<RTsizei> count, RTenum type) {
        const std::vector<const void*> at(count.size());
        rtMultiDrawElements(mode, count.data(), type, at.data(), RTsizei(count.size()));
    };
    expectNothing(RT_INVALID_VALUE, [&] { ranges(RT_TRIANGLES, {0, 0}, {3, -5}); });
    expectNothing(RT_INVALID_VALUE, [&] { ranges(RT_TRIANGLES, {0, -1}, {3, 0}); });
    expectNothing(RT_INVALID_ENUM, [&] { ranges(12345, {0}, {0}); });
    expectNothing(RT_INVALID_ENUM, [&] { ranges(12345, {}, {}); });
    expectNothing(RT_INVALID_VALUE, [&] { indexed(RT_TRIANGLES, {3, -1}, RT_UNSIGNED_BYTE); });
    expectNothing(RT_INVALID_OPERATION, [&] { indexed(RT_TRIANGLES, {3, 4}, RT_UNSIGNED_BYTE); });
    expectNothing(RT_INVALID_ENUM, [&] { indexed(12345, {0}, RT_UNSIGNED_BYTE); });
    expectNothing(RT_INVALID_ENUM, [&] { indexed(RT_TRIANGLES, {0}, RT_FLOAT); });
    expectNothing(RT_NO_ERROR, [&] { ranges(RT_TRIANGLES, {0, 0}, {0, 0}); });

    // What rtVertex would refuse.
    rtGenNewShaderClass("PointLight", nullptr);
    const RTuint light = rtGenNewShader();
    const auto withLight = [&](const std::function<void()>& draw) {
        rtBindShader(light);
        draw();
        rtBindShader(0);
    };
    for (const auto& draw : std::vector<std::function<void()>>{
             [] { rtDrawArrays(RT_TRIANGLES, 0, 3); },
             [&] { indexed(RT_TRIANGLES, {3}, RT_UNSIGNED_BYTE); },
             [] { rtRectf(-1, -1, 1, 1); }})
        expectNothing(RT_INVALID_OPERATION, [&] { withLight(draw); });
    rtNewList(1, RT_COMPILE); // may be called with another one
    withLight([] { rtDrawArrays(RT_TRIANGLES, 0, 3); });
    rtEndList();
    expectError(RT_NO_ERROR);
    rtDeleteBuffers(1, &buffer);
}

TEST_F(VertexArrays, InBuffers) {
    const auto vertices = packed<double>(3, 8, coordinate);
    const auto colors = packed<uint8_t>(4, 0, component<uint8_t>);
    const RTushort indices[] = {9, 9, 0, 1, 2, 3, 4, 5};
    rtVertexPointer(3, RT_DOUBLE, 32, vertices.data());
    rtColorPointer(4, RT_UNSIGNED_BYTE, 0, colors.data());
    rtEnableClientState(RT_VERTEX_ARRAY);
    rtEnableClientState(RT_COLOR_ARRAY);
    const Pixels direct =
        pictureOf([&] { rtDrawElements(RT_TRIANGLES, 6, RT_UNSIGNED_SHORT, indices + 2); });

    RTuint names[2];
    rtGenBuffers(2, names);
    rtBindBuffer(RT_ARRAY_BUFFER, names[0]);
    std::vector<std::byte> both(24);
    both.insert(both.end(), vertices.begin(), vertices.end());
    const auto colorsAt = both.size();
    both.insert(both.end(), colors.begin(), colors.end());
    rtBufferData(RT_ARRAY_BUFFER, RTsizeiptr(both.size()), both.data(), RT_STATIC_DRAW);
    rtVertexPointer(3, RT_DOUBLE, 32, reinterpret_cast<const void*>(24));
    rtColorPointer(4, RT_UNSIGNED_BYTE, 0, reinterpret_cast<const void*>(colorsAt));
    rtBindBuffer(RT_ARRAY_BUFFER, 0);
    rtBindBuffer(RT_ELEMENT_ARRAY_BUFFER, names[1]);
    rtBufferData(RT_ELEMENT_ARRAY_BUFFER, sizeof indices, nullptr, RT_STREAM_DRAW);
    void* const mapped = rtMapBuffer(RT_ELEMENT_ARRAY_BUFFER, RT_WRITE_ONLY);
    ASSERT_NE(mapped, nullptr);
    std::memcpy(mapped, indices, sizeof indices);
    const auto draw = [] {
        rtDrawElements(RT_TRIANGLES, 6, RT_UNSIGNED_SHORT, reinterpret_cast<const void*>(4));
    };
    draw();
    expectError(RT_INVALID_OPERATION); // mapped
    EXPECT_EQ(rtUnmapBuffer(RT_ELEMENT_ARRAY_BUFFER), RT_TRUE);
    EXPECT_EQ(pictureOf(draw), direct);

    // Nothing is read behind a buffer's end.
    rtDrawElements(RT_TRIANGLES, 7, RT_UNSIGNED_SHORT, reinterpret_cast<const void*>(4));
    expectError(RT_INVALID_OPERATION);
    rtDrawElements(RT_TRIANGLES, 3, RT_UNSIGNED_SHORT, reinterpret_cast<const void*>(4000));
    expectError(RT_INVALID_OPERATION);
    rtDrawArrays(RT_TRIANGLES, 0, kCount + 1);
    expectError(RT_INVALID_OPERATION);
    rtDrawArrays(RT_TRIANGLES, 0x7FFFFFFF, 0x7FFFFFFF);
    expectError(RT_INVALID_OPERATION);
    rtDeleteBuffers(2, names);
    rtDrawArrays(RT_TRIANGLES, 0, 3); // the arrays lost their buffer
    expectError(RT_INVALID_OPERATION);
}

TEST_F(VertexArrays, InDisplayLists) {
    auto vertices = packed<float>(3, 0, coordinate);
    auto colors = packed<float>(3, 0, component<float>);
    rtVertexPointer(3, RT_FLOAT, 0, vertices.data());
    rtColorPointer(3, RT_FLOAT, 0, colors.data());
    rtEnableClientState(RT_VERTEX_ARRAY);
    rtEnableClientState(RT_COLOR_ARRAY);
    const RTubyte indices[] = {0, 1, 2, 3, 4, 5};
    const auto draw = [&] {
        rtDrawArrays(RT_TRIANGLES, 6, 6);
        rtDrawElements(RT_TRIANGLES, 6, RT_UNSIGNED_BYTE, indices);
        rtRectf(-1, -1, 1, 1);
    };
    const Pixels direct = pictureOf([&] {
        rtTranslatef(0, 0, -2);
        draw();
    });
    rtNewList(1, RT_COMPILE);
    draw();
    rtEndList();
    vertices.assign(vertices.size(), std::byte(0));
    colors.assign(colors.size(), std::byte(0));
    const Pixels called = pictureOf([] {
        rtTranslatef(0, 0, -2);
        rtCallList(1);
    });
    EXPECT_EQ(value(RT_STAT_INSTANCES), 1);
    // The rectangle takes the colour that the array left in the list, and found in the other case.
    std::size_t differing = 0;
    for (std::size_t i = 0; i < called.size(); ++i) differing += called[i] != direct[i];
    EXPECT_LT(differing, called.size() / 2);
    rtDisableClientState(RT_VERTEX_ARRAY);
    rtDisableClientState(RT_COLOR_ARRAY);
}

TEST_F(VertexArrays, CurrentValuesStayAsTheyWere) {
    const auto vertices = packed<float>(3, 0, coordinate);
    const auto colors = packed<float>(4, 0, component<float>);
    rtVertexPointer(3, RT_FLOAT, 0, vertices.data());
    rtColorPointer(4, RT_FLOAT, 0, colors.data());
    rtEnableClientState(RT_VERTEX_ARRAY);
    rtEnableClientState(RT_COLOR_ARRAY);
    rtColor4f(0.125f, 0.25f, 0.5f, 0.75f);
    rtDrawArrays(RT_TRIANGLES, 0, kCount);
    float color[4];
    rtGetFloatv(RT_CURRENT_COLOR, color);
    EXPECT_EQ(color[0], 0.125f);
    EXPECT_EQ(color[3], 0.75f);
}

TEST_F(VertexArrays, ArraysWithoutMemoryAreRefused) {
    rtVertexPointer(3, RT_FLOAT, 0, nullptr);
    rtEnableClientState(RT_VERTEX_ARRAY);
    rtDrawArrays(RT_TRIANGLES, 0, 3);
    expectError(RT_INVALID_OPERATION);
    rtArrayElement(0);
    expectError(RT_INVALID_OPERATION);
    rtDisableClientState(RT_VERTEX_ARRAY);
    rtDrawArrays(RT_TRIANGLES, 0, 3); // nothing to draw
    expectError(RT_NO_ERROR);
}

TEST_F(VertexArrays, Rectangles) {
    const Pixels direct = pictureOf([] {
        rtTranslatef(0, 0, -2);
        rtBegin(RT_POLYGON);
        rtVertex2i(-1, -2);
        rtVertex2i(1, -2);
        rtVertex2i(1, 1);
        rtVertex2i(-1, 1);
        rtEnd();
    });
    const RTshort s[] = {-1, -2, 1, 1};
    const RTint i[] = {-1, -2, 1, 1};
    const RTfloat f[] = {-1, -2, 1, 1};
    const RTdouble d[] = {-1, -2, 1, 1};
    const std::function<void()> rectangles[] = {
        [] { rtRects(-1, -2, 1, 1); }, [] { rtRecti(-1, -2, 1, 1); },
        [] { rtRectf(-1, -2, 1, 1); }, [] { rtRectd(-1, -2, 1, 1); },
        [&] { rtRectsv(s, s + 2); },   [&] { rtRectiv(i, i + 2); },
        [&] { rtRectfv(f, f + 2); },   [&] { rtRectdv(d, d + 2); }};
    for (const auto& rectangle : rectangles)
        EXPECT_EQ(pictureOf([&] {
                      rtTranslatef(0, 0, -2);
                      rectangle();
                  }),
                  direct);
    rtBegin(RT_TRIANGLES);
    rtRectf(0, 0, 1, 1);
    rtEnd();
    expectError(RT_INVALID_OPERATION);
    rtRectfv(f, nullptr);
    expectError(RT_INVALID_VALUE);
}

} // namespace

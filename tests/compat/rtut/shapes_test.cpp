// SPDX-License-Identifier: MIT
// The shapes of rtut: closed, of the volume and area that geometry says, normals outwards. The
// sources of the shapes are compiled into this program, which defines what they draw with.
#include <gtest/gtest.h>
#include <openrt/rt.h>
#include <openrt/rtu.h>
#include <openrt/rtut.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <vector>

namespace {

using Point = std::array<double, 3>;

struct Triangle {
    Point corners[3], normals[3];
};
struct Drawing {
    std::vector<Triangle> triangles;
    std::vector<std::pair<Point, Point>> lines;
    double lowest[3] = {1e9, 1e9, 1e9}, highest[3] = {-1e9, -1e9, -1e9};

    RTenum mode = 0;
    Point normal{0, 0, 1};
    std::vector<Point> run, runNormals;

    void add(std::size_t a, std::size_t b, std::size_t c) {
        triangles.push_back(
            {{run[a], run[b], run[c]}, {runNormals[a], runNormals[b], runNormals[c]}});
    }
    void end() {
        const std::size_t n = run.size();
        if (mode == RT_LINE_LOOP || mode == RT_LINE_STRIP) {
            for (std::size_t i = 0; i + 1 < n; ++i) lines.push_back({run[i], run[i + 1]});
            if (mode == RT_LINE_LOOP) lines.push_back({run[n - 1], run[0]});
        } else if (mode == RT_TRIANGLES) {
            for (std::size_t i = 0; i + 2 < n; i += 3) add(i, i + 1, i + 2);
        } else if (mode == RT_TRIANGLE_FAN) {
            for (std::size_t i = 0; i + 2 < n; ++i) add(0, i + 1, i + 2);
        } else if (mode == RT_QUADS) {
            for (std::size_t i = 0; i + 3 < n; i += 4) add(i, i + 1, i + 2), add(i, i + 2, i + 3);
        } else if (mode == RT_QUAD_STRIP) {
            for (std::size_t i = 0; i + 3 < n; i += 2)
                add(i, i + 1, i + 3), add(i, i + 3, i + 2);
        }
        run.clear();
        runNormals.clear();
    }
};
Drawing drawing;

/// What shapes may change while they draw.
struct State {
    RTenum polygonModes[2] = {RT_FILL, RT_POINT};
    bool normalizes = false;
    bool operator==(const State&) const = default;
};
constexpr std::size_t kMostAttributes = 3;
State state;
State pushed[kMostAttributes];
std::size_t depth;
int attributeErrors, pushes;
RTint objectIndex; ///< of the object that is being defined
bool isInPrimitive;

Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Point cross(const Point& a, const Point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

} // namespace

extern "C" {

void RTAPIENTRY rtBegin(RTenum mode) { drawing.mode = mode; }
void RTAPIENTRY rtEnd(void) { drawing.end(); }
void RTAPIENTRY rtVertex3d(RTdouble x, RTdouble y, RTdouble z) {
    const Point point{x, y, z};
    drawing.run.push_back(point);
    drawing.runNormals.push_back(drawing.normal);
    for (std::size_t k = 0; k < 3; ++k) {
        drawing.lowest[k] = std::min(drawing.lowest[k], point[k]);
        drawing.highest[k] = std::max(drawing.highest[k], point[k]);
    }
}
void RTAPIENTRY rtNormal3d(RTdouble x, RTdouble y, RTdouble z) { drawing.normal = {x, y, z}; }
void RTAPIENTRY rtNormal3f(RTfloat x, RTfloat y, RTfloat z) { drawing.normal = {x, y, z}; }
void RTAPIENTRY rtTexCoord2d(RTdouble, RTdouble) {}
void RTAPIENTRY rtPushAttrib(RTbitfield) {
    ++pushes;
    if (depth < kMostAttributes)
        pushed[depth++] = state;
    else
        ++attributeErrors;
}
void RTAPIENTRY rtPopAttrib(void) {
    if (depth > 0)
        state = pushed[--depth];
    else
        ++attributeErrors;
}
void RTAPIENTRY rtEnable(RTenum) { state.normalizes = true; }
void RTAPIENTRY rtDisable(RTenum) { state.normalizes = false; }
RTboolean RTAPIENTRY rtIsEnabled(RTenum) { return state.normalizes; }
void RTAPIENTRY rtPolygonMode(RTenum face, RTenum mode) {
    if (face != RT_BACK) state.polygonModes[0] = mode;
    if (face != RT_FRONT) state.polygonModes[1] = mode;
}
void RTAPIENTRY rtGetIntegerv(RTenum name, RTint* values) {
    if (isInPrimitive) return;
    if (name == RT_ATTRIB_STACK_DEPTH) *values = RTint(depth);
    if (name == RT_MAX_ATTRIB_STACK_DEPTH) *values = RTint(kMostAttributes);
    if (name == RT_POLYGON_MODE) std::copy_n(state.polygonModes, 2, values);
    if (name == RT_OBJECT_INDEX) *values = objectIndex;
}
// Sphere and cone are quadrics, which have a test of their own.
RTUquadric* RTAPIENTRY rtuNewQuadric(void) { return nullptr; }
void RTAPIENTRY rtuDeleteQuadric(RTUquadric*) {}
void RTAPIENTRY rtuQuadricDrawStyle(RTUquadric*, RTenum) {}
void RTAPIENTRY rtuSphere(RTUquadric*, RTdouble, RTint, RTint) {}
void RTAPIENTRY rtuCylinder(RTUquadric*, RTdouble, RTdouble, RTdouble, RTint, RTint) {}

} // extern "C"

namespace {

Drawing drawn(const std::function<void()>& shape) {
    drawing = Drawing();
    shape();
    return drawing;
}

double volumeOf(const Drawing& d) {
    double sum = 0;
    for (const Triangle& t : d.triangles)
        sum += dot(t.corners[0], cross(t.corners[1], t.corners[2])) / 6;
    return sum;
}
double areaOf(const Drawing& d) {
    double sum = 0;
    for (const Triangle& t : d.triangles) {
        const Point n = cross(minus(t.corners[1], t.corners[0]), minus(t.corners[2], t.corners[0]));
        sum += std::sqrt(dot(n, n)) / 2;
    }
    return sum;
}

using Edge = std::pair<std::array<long, 3>, std::array<long, 3>>;
std::array<long, 3> rounded(const Point& p) {
    return {std::lround(p[0] * 1e6), std::lround(p[1] * 1e6), std::lround(p[2] * 1e6)};
}
/// Edges that do not have as many triangles on one side as on the other.
int openEdges(const Drawing& d) {
    std::map<Edge, int> balance;
    for (const Triangle& t : d.triangles)
        for (int k = 0; k < 3; ++k) {
            const auto a = rounded(t.corners[k]), b = rounded(t.corners[(k + 1) % 3]);
            if (a == b) continue;
            ++balance[{a, b}];
            --balance[{b, a}];
        }
    return int(std::count_if(balance.begin(), balance.end(),
                             [](const auto& entry) { return entry.second != 0; }));
}
/// The smallest cosine between a corner's normal and its triangle's; normals have length 1.
double worstNormal(const Drawing& d, double winding) {
    double worst = 1;
    for (const Triangle& t : d.triangles) {
        Point n = cross(minus(t.corners[1], t.corners[0]), minus(t.corners[2], t.corners[0]));
        const double length = std::sqrt(dot(n, n));
        if (length < 1e-12) continue;
        for (const Point& normal : t.normals) {
            EXPECT_NEAR(dot(normal, normal), 1, 1e-6);
            worst = std::min(worst, winding * dot(n, normal) / length);
        }
    }
    return worst;
}

struct Solid {
    const char* name;
    void (*draw)();
    std::size_t triangles;
    double volume, area, radius;
};
const double kRoot2 = std::sqrt(2.0), kRoot3 = std::sqrt(3.0), kRoot5 = std::sqrt(5.0);

class Polyhedra : public testing::TestWithParam<Solid> {};

TEST_P(Polyhedra, areClosedAndAsLargeAsGeometrySays) {
    const Solid& solid = GetParam();
    const Drawing d = drawn(solid.draw);
    EXPECT_EQ(d.triangles.size(), solid.triangles);
    EXPECT_EQ(openEdges(d), 0);
    EXPECT_NEAR(volumeOf(d), solid.volume, 1e-9 * solid.volume);
    EXPECT_NEAR(areaOf(d), solid.area, 1e-9 * solid.area);
    EXPECT_GT(worstNormal(d, 1), 1 - 1e-9);
    for (const Triangle& t : d.triangles)
        for (const Point& corner : t.corners)
            EXPECT_NEAR(std::sqrt(dot(corner, corner)), solid.radius, 1e-9);
}

TEST(PolyhedraControls, aMissingFaceIsSeen) {
    Drawing d = drawn(rtutSolidIcosahedron);
    d.triangles.pop_back();
    EXPECT_EQ(openEdges(d), 6);
    Drawing turned = drawn(rtutSolidIcosahedron);
    std::swap(turned.triangles[3].corners[0], turned.triangles[3].corners[1]);
    EXPECT_NE(openEdges(turned), 0);
    EXPECT_LT(worstNormal(turned, 1), 0);
}

/// Edge lengths from the circumscribed radii.
double tetrahedronEdge() { return 3 / std::sqrt(3.0 / 8); }
double icosahedronEdge() { return 1 / (std::sqrt(10 + 2 * kRoot5) / 4); }
double dodecahedronEdge() { return kRoot3 / (kRoot3 * (1 + kRoot5) / 4); }

INSTANTIATE_TEST_SUITE_P(
    Shapes, Polyhedra,
    testing::Values(
        Solid{"cube", [] { rtutSolidCube(3); }, 12, 27, 54, 1.5 * kRoot3},
        Solid{"tetrahedron", rtutSolidTetrahedron, 4, std::pow(tetrahedronEdge(), 3) / (6 * kRoot2),
              kRoot3 * std::pow(tetrahedronEdge(), 2), 3},
        Solid{"octahedron", rtutSolidOctahedron, 8, 4.0 / 3, 4 * kRoot3, 1},
        Solid{"dodecahedron", rtutSolidDodecahedron, 36,
              (15 + 7 * kRoot5) / 4 * std::pow(dodecahedronEdge(), 3),
              3 * std::sqrt(25 + 10 * kRoot5) * std::pow(dodecahedronEdge(), 2), kRoot3},
        Solid{"icosahedron", rtutSolidIcosahedron, 20,
              5 * (3 + kRoot5) / 12 * std::pow(icosahedronEdge(), 3),
              5 * kRoot3 * std::pow(icosahedronEdge(), 2), 1}),
    [](const auto& solid) { return solid.param.name; });

TEST(Shapes, wirePolyhedraHaveEveryEdgeTwice) {
    const std::pair<void (*)(), std::size_t> shapes[] = {{rtutWireTetrahedron, 6},
                                                         {rtutWireOctahedron, 12},
                                                         {rtutWireDodecahedron, 30},
                                                         {rtutWireIcosahedron, 30},
                                                         {[] { rtutWireCube(1); }, 12}};
    for (const auto& [draw, edges] : shapes) EXPECT_EQ(drawn(draw).lines.size(), 2 * edges);
}

TEST(Shapes, aTorusIsClosedAndNearlyAsLargeAsAPerfectOne) {
    const Drawing d = drawn([] { rtutSolidTorus(0.5, 2, 60, 90); });
    EXPECT_EQ(d.triangles.size(), 60u * 90 * 2);
    EXPECT_EQ(openEdges(d), 0);
    const double pi = 3.14159265358979323846;
    EXPECT_NEAR(volumeOf(d), 2 * pi * pi * 2 * 0.25, 0.03);
    EXPECT_NEAR(areaOf(d), 4 * pi * pi * 2 * 0.5, 0.05);
    EXPECT_GT(worstNormal(d, 1), 0.99);
    for (const Triangle& t : d.triangles)
        for (const Point& p : t.corners)
            EXPECT_NEAR(std::hypot(std::hypot(p[0], p[1]) - 2, p[2]), 0.5, 1e-12);
}

TEST(Shapes, aTorusOfNoOrManySidesDoesNotHang) {
    EXPECT_TRUE(drawn([] { rtutSolidTorus(1, 2, 0, 5); }).triangles.empty());
    EXPECT_TRUE(drawn([] { rtutSolidTorus(1, 2, 5, -1); }).triangles.empty());
    EXPECT_EQ(drawn([] { rtutSolidTorus(1, 2, 1, 2147483647); }).triangles.size(), 2u * 4096);
}

TEST(Shapes, leaveTheAttributesAndTheirStackAsTheyWere) {
    for (std::size_t before = 0; before <= kMostAttributes; ++before)
        for (const bool normalizes : {false, true})
            for (void (*const draw)() : {+[] { rtutWireTorus(1, 2, 4, 4); },
                                         +[] { rtutWireTeapot(1); }, +[] { rtutSolidTeapot(1); }}) {
                const State kept{{RT_FILL, RT_POINT}, normalizes};
                state = kept;
                depth = before;
                attributeErrors = pushes = 0;
                draw();
                EXPECT_EQ(state, kept) << before;
                EXPECT_EQ(depth, before);
                EXPECT_EQ(attributeErrors, 0);
                EXPECT_EQ(pushes, before < kMostAttributes); // display lists need it
            }
}

TEST(Shapes, theTeapotOfAnObjectTouchesNoState) {
    state = {{RT_FILL, RT_POINT}, false};
    attributeErrors = pushes = 0;
    objectIndex = 5;
    const Drawing inObject = drawn([] { rtutSolidTeapot(2); });
    objectIndex = 0;
    EXPECT_EQ(pushes, 0);
    EXPECT_EQ(inObject.triangles.size(), 32u * 14 * 14 * 2);
    drawn([] { rtutSolidTeapot(2); });
    EXPECT_EQ(pushes, 1);
}

TEST(Shapes, inAPrimitiveNothingIsDrawn) {
    void (*const shapes[])() = {[] { rtutSolidCube(1); },
                                [] { rtutWireTorus(1, 2, 5, 5); },
                                [] { rtutSolidTorus(1, 2, 5, 5); },
                                rtutSolidDodecahedron,
                                rtutWireOctahedron,
                                [] { rtutSolidTeapot(1); },
                                [] { rtutWireTeapot(1); }};
    for (void (*const shape)() : shapes) {
        const auto count = [&] {
            const Drawing d = drawn(shape);
            return d.triangles.size() + d.lines.size();
        };
        EXPECT_GT(count(), 0u);
        isInPrimitive = true;
        EXPECT_EQ(count(), 0u);
        isInPrimitive = false;
    }
}

TEST(Shapes, theTeapotIsNewells) {
    const Drawing d = drawn([] { rtutSolidTeapot(2); });
    EXPECT_EQ(d.triangles.size(), 32u * 14 * 14 * 2);
    // Newell's box in units of half the size: x from the handle's -3 to the spout's tip, y from
    // the bottom to the lid's knob, about 1.5.
    EXPECT_NEAR(d.lowest[1], -1.5, 1e-9);
    EXPECT_NEAR(d.highest[1], 3.15 - 1.5, 1e-9);
    EXPECT_NEAR(d.lowest[2], -2, 1e-2);
    EXPECT_NEAR(d.highest[2], 2, 1e-2);
    EXPECT_NEAR(d.lowest[0], -3, 1e-9);
    EXPECT_GT(d.highest[0], 3.2);
    EXPECT_LT(d.highest[0], 3.525);
}

TEST(Shapes, theTeapotIsClockwiseWithNormalsOutwards) {
    const Drawing d = drawn([] { rtutSolidTeapot(1); });
    EXPECT_GT(worstNormal(d, -1), 0.2);
    // The body's normals lead away from its axis.
    int outwards = 0, body = 0;
    for (std::size_t i = 4 * 392; i < 8 * 392; ++i) // the first patches of the body
        for (int k = 0; k < 3; ++k) {
            const Point& p = d.triangles[i].corners[k];
            ++body;
            outwards += dot({p[0], 0, p[2]}, d.triangles[i].normals[k]) > 0;
        }
    EXPECT_EQ(outwards, body);
}

TEST(Shapes, theTeapotsBodyIsTheSurfaceOfRevolutionOfItsProfile) {
    // At the seam between the two patches of the body the radius is 2: the quarter circles reach
    // it at their ends and 2 * (0.75 * (1 + 0.56) + ...) in the middle, as Bezier says.
    const Drawing d = drawn([] { rtutSolidTeapot(2); });
    const double middle = 2 * (0.125 + 0.375 * 1 + 0.375 * 0.56);
    double nearest = 1e9;
    for (std::size_t i = 4 * 392; i < 8 * 392; ++i)
        for (const Point& p : d.triangles[i].corners)
            if (std::fabs(p[1] - (0.9 - 1.5)) < 1e-9 && std::fabs(p[0] - p[2]) < 1e-9 && p[0] > 0)
                nearest = std::min(nearest, std::fabs(p[0] - middle));
    EXPECT_LT(nearest, 1e-9);
}

TEST(Shapes, theTeapotIsSymmetricAndSeamless) {
    const Drawing d = drawn([] { rtutSolidTeapot(1); });
    std::map<std::array<long, 3>, int> corners;
    for (const Triangle& t : d.triangles)
        for (const Point& p : t.corners) ++corners[rounded(p)];
    const auto isThere = [&](const std::array<long, 3>& p) {
        for (int i = 0; i < 27; ++i) // what was rounded may differ by one
            if (corners.contains({p[0] + i % 3 - 1, p[1] + i / 3 % 3 - 1, p[2] + i / 9 - 1}))
                return true;
        return false;
    };
    for (const auto& [p, count] : corners) ASSERT_TRUE(isThere({p[0], p[1], -p[2]}));
    EXPECT_FALSE(isThere({0, 0, 0})) << "control";
    // Open are only the rim and the ends of handle and spout, all on the planes of symmetry or in
    // the body; a seam between patches would add hundreds.
    EXPECT_LT(openEdges(d), 2 * 14 * 20);
}

} // namespace

// SPDX-License-Identifier: MIT
// Tessellation against winding numbers computed by counting, and against GLU's areas.
#include <GL/glu.h>
#include <gtest/gtest.h>
#include <openrt/rt.h>
#include <openrt/rtu.h>

#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace {

using Point = std::array<double, 3>;
using Contour = std::vector<Point>;
using Polygon = std::vector<Contour>;

/// What the callbacks got; vertices are points.
struct Result {
    std::vector<std::array<Point, 3>> triangles;
    std::vector<Contour> loops;
    std::vector<bool> edgeFlags; ///< of each corner of the triangles
    std::vector<RTenum> errors;
    int combined = 0;
    double weightError = 0;

    RTenum mode = 0;
    Contour run;
    bool flag = true;
    std::vector<bool> runFlags;
    std::deque<Point> made;

    void end() {
        const bool fan = mode == RT_TRIANGLE_FAN || mode == GL_TRIANGLE_FAN;
        const bool strip = mode == GL_TRIANGLE_STRIP;
        if (mode == RT_LINE_LOOP || mode == GL_LINE_LOOP) {
            loops.push_back(run);
        } else {
            const std::size_t step = fan || strip ? 1 : 3;
            for (std::size_t i = 0; i + 2 < run.size(); i += step) {
                if (fan)
                    triangles.push_back({run[0], run[i + 1], run[i + 2]});
                else if (strip && i % 2)
                    triangles.push_back({run[i + 1], run[i], run[i + 2]});
                else
                    triangles.push_back({run[i], run[i + 1], run[i + 2]});
            }
            edgeFlags.insert(edgeFlags.end(), runFlags.begin(), runFlags.end());
        }
        run.clear();
        runFlags.clear();
    }
};

extern "C" {
void onBegin(unsigned mode, void* data) { static_cast<Result*>(data)->mode = mode; }
void onFlag(unsigned char flag, void* data) { static_cast<Result*>(data)->flag = flag != 0; }
void onVertex(void* vertex, void* data) {
    auto& result = *static_cast<Result*>(data);
    result.run.push_back(*static_cast<Point*>(vertex));
    result.runFlags.push_back(result.flag);
}
void onEnd(void* data) { static_cast<Result*>(data)->end(); }
void onCombine(double* location, void** from, float* weights, void** out, void* data) {
    auto& result = *static_cast<Result*>(data);
    ++result.combined;
    Point sum{};
    for (int i = 0; i < 4 && from[i]; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            sum[k] += double(weights[i]) * (*static_cast<Point*>(from[i]))[k];
    for (std::size_t k = 0; k < 3; ++k)
        result.weightError = std::max(result.weightError, std::fabs(sum[k] - location[k]));
    result.made.push_back({location[0], location[1], location[2]});
    *out = &result.made.back();
}
void onError(unsigned error, void* data) { static_cast<Result*>(data)->errors.push_back(error); }
}

struct Wanted {
    RTenum rule = RTU_TESS_WINDING_ODD;
    bool boundaryOnly = false, edgeFlags = false, combine = true;
    Point normal{};
};

template <class Function>
RTUfuncptr asFunction(Function* function) {
    return reinterpret_cast<RTUfuncptr>(function);
}

Result tessellate(Polygon& polygon, const Wanted& wanted) {
    Result result;
    RTUtesselator* tess = rtuNewTess();
    rtuTessCallback(tess, RTU_TESS_BEGIN_DATA, asFunction(&onBegin));
    rtuTessCallback(tess, RTU_TESS_VERTEX_DATA, asFunction(&onVertex));
    rtuTessCallback(tess, RTU_TESS_END_DATA, asFunction(&onEnd));
    rtuTessCallback(tess, RTU_TESS_ERROR_DATA, asFunction(&onError));
    if (wanted.combine) rtuTessCallback(tess, RTU_TESS_COMBINE_DATA, asFunction(&onCombine));
    if (wanted.edgeFlags) rtuTessCallback(tess, RTU_TESS_EDGE_FLAG_DATA, asFunction(&onFlag));
    rtuTessProperty(tess, RTU_TESS_WINDING_RULE, wanted.rule);
    rtuTessProperty(tess, RTU_TESS_BOUNDARY_ONLY, wanted.boundaryOnly);
    rtuTessNormal(tess, wanted.normal[0], wanted.normal[1], wanted.normal[2]);
    rtuTessBeginPolygon(tess, &result);
    for (Contour& contour : polygon) {
        rtuTessBeginContour(tess);
        for (Point& point : contour) rtuTessVertex(tess, point.data(), &point);
        rtuTessEndContour(tess);
    }
    rtuTessEndPolygon(tess);
    rtuDeleteTess(tess);
    return result;
}

Result tessellateWithGlu(Polygon& polygon, const Wanted& wanted) {
    Result result;
    GLUtesselator* tess = gluNewTess();
    const auto set = [&](GLenum which, auto* function) {
        gluTessCallback(tess, which, reinterpret_cast<_GLUfuncptr>(function));
    };
    set(GLU_TESS_BEGIN_DATA, &onBegin);
    set(GLU_TESS_VERTEX_DATA, &onVertex);
    set(GLU_TESS_END_DATA, &onEnd);
    set(GLU_TESS_ERROR_DATA, &onError);
    set(GLU_TESS_COMBINE_DATA, &onCombine);
    gluTessProperty(tess, GLU_TESS_WINDING_RULE, wanted.rule);
    gluTessProperty(tess, GLU_TESS_BOUNDARY_ONLY, wanted.boundaryOnly);
    gluTessNormal(tess, wanted.normal[0], wanted.normal[1], wanted.normal[2]);
    gluTessBeginPolygon(tess, &result);
    for (Contour& contour : polygon) {
        gluTessBeginContour(tess);
        for (Point& point : contour) gluTessVertex(tess, point.data(), &point);
        gluTessEndContour(tess);
    }
    gluTessEndPolygon(tess);
    gluDeleteTess(tess);
    return result;
}

double cross(const Point& a, const Point& b, const Point& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}
double areaOf(const Result& result) {
    double area = 0;
    for (const auto& t : result.triangles) area += cross(t[0], t[1], t[2]) / 2;
    for (const Contour& loop : result.loops)
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Point &a = loop[i], &b = loop[(i + 1) % loop.size()];
            area += (a[0] * b[1] - a[1] * b[0]) / 2;
        }
    return area;
}

int windingAt(const Polygon& polygon, double x, double y) {
    int winding = 0;
    for (const Contour& contour : polygon)
        for (std::size_t i = 0; i < contour.size(); ++i) {
            const Point &a = contour[i], &b = contour[(i + 1) % contour.size()];
            if ((a[1] <= y) == (b[1] <= y)) continue;
            const double at = a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
            if (at > x) winding += b[1] > a[1] ? 1 : -1;
        }
    return winding;
}
bool isInside(RTenum rule, int winding) {
    switch (rule) {
    case RTU_TESS_WINDING_NONZERO: return winding != 0;
    case RTU_TESS_WINDING_POSITIVE: return winding > 0;
    case RTU_TESS_WINDING_NEGATIVE: return winding < 0;
    case RTU_TESS_WINDING_ABS_GEQ_TWO: return winding > 1 || winding < -1;
    default: return winding & 1;
    }
}

/// How many of the points in [-1,1] squared are not covered exactly as often as they should be.
int wrongPoints(const Polygon& polygon, const Result& result, RTenum rule, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(-1, 1);
    int wrong = 0;
    for (int i = 0; i < 400; ++i) {
        const Point p{place(random), place(random), 0};
        int covered = 0;
        bool onEdge = false;
        for (const auto& t : result.triangles) {
            const double sides[3] = {cross(t[0], t[1], p), cross(t[1], t[2], p),
                                     cross(t[2], t[0], p)};
            for (const double side : sides) onEdge = onEdge || std::fabs(side) < 1e-7;
            covered += sides[0] > 0 && sides[1] > 0 && sides[2] > 0;
        }
        const int expected = isInside(rule, windingAt(polygon, p[0], p[1]));
        wrong += !onEdge && covered != expected;
    }
    return wrong;
}

constexpr RTenum kRules[] = {RTU_TESS_WINDING_ODD, RTU_TESS_WINDING_NONZERO,
                             RTU_TESS_WINDING_POSITIVE, RTU_TESS_WINDING_NEGATIVE,
                             RTU_TESS_WINDING_ABS_GEQ_TWO};

struct Tessellation : testing::Test {
    void SetUp() override { rtInit(nullptr, nullptr); }
    void TearDown() override { rtExit(); }
};

const Polygon kSquareWithHole = {{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}},
                                 {{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}, {-0.5, 0.5, 0}}};

TEST_F(Tessellation, aConvexContourIsAFanFromItsFirstVertex) {
    Polygon polygon = {{{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {1, 2, 0}}};
    const Result rt = tessellate(polygon, {}), gl = tessellateWithGlu(polygon, {});
    EXPECT_EQ(rt.triangles, gl.triangles);
    EXPECT_EQ(rt.mode, RTenum(RT_TRIANGLE_FAN));
    std::reverse(polygon[0].begin(), polygon[0].end());
    Wanted wanted;
    wanted.normal = {0, 0, 1};
    EXPECT_EQ(tessellate(polygon, wanted).triangles, tessellateWithGlu(polygon, wanted).triangles);
}

TEST_F(Tessellation, aHoleIsLeftOut) {
    Polygon polygon = kSquareWithHole;
    const Result result = tessellate(polygon, {});
    EXPECT_TRUE(result.errors.empty());
    EXPECT_EQ(result.combined, 0);
    EXPECT_DOUBLE_EQ(areaOf(result), 3);
    EXPECT_EQ(result.triangles.size(), 8u);
    EXPECT_EQ(wrongPoints(polygon, result, RTU_TESS_WINDING_ODD, 1), 0);
}

TEST_F(Tessellation, randomPolygonsAreCoveredByTheirWindingNumber) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-1, 1);
    for (unsigned round = 0; round < 60; ++round) {
        Polygon polygon(1 + round % 3);
        for (Contour& contour : polygon)
            for (unsigned i = 0; i < 3 + round % 17; ++i)
                contour.push_back({place(random), place(random), 0});
        Wanted wanted;
        wanted.normal = {0, 0, 1};
        wanted.rule = kRules[round % 5];
        const Result result = tessellate(polygon, wanted);
        ASSERT_TRUE(result.errors.empty());
        ASSERT_EQ(wrongPoints(polygon, result, wanted.rule, round), 0) << "round " << round;
        EXPECT_NEAR(areaOf(result), areaOf(tessellateWithGlu(polygon, wanted)), 1e-6);
        EXPECT_LT(result.weightError, 1e-6);
        wanted.boundaryOnly = true;
        const Result boundary = tessellate(polygon, wanted);
        EXPECT_NEAR(areaOf(boundary), areaOf(result), 1e-9);
        EXPECT_TRUE(boundary.triangles.empty());
    }
}

// Vertices on a coarse lattice: coincident vertices, edges through vertices, overlapping edges.
// GLU itself errs on some of these; where it does not, the areas agree.
TEST_F(Tessellation, degeneratePolygonsToo) {
    std::mt19937 random(4);
    std::uniform_int_distribution<int> place(-4, 4);
    int comparable = 0;
    for (unsigned round = 0; round < 150; ++round) {
        Polygon polygon(1 + round % 3);
        for (Contour& contour : polygon)
            for (unsigned i = 0; i < 3 + round % 13; ++i)
                contour.push_back({place(random) / 4.0, place(random) / 4.0, 0});
        Wanted wanted;
        wanted.normal = {0, 0, 1};
        wanted.rule = kRules[round % 5];
        const Result result = tessellate(polygon, wanted);
        ASSERT_TRUE(result.errors.empty());
        ASSERT_EQ(wrongPoints(polygon, result, wanted.rule, round), 0) << "round " << round;
        const Result glu = tessellateWithGlu(polygon, wanted);
        if (wrongPoints(polygon, glu, wanted.rule, round) != 0) continue;
        ++comparable;
        EXPECT_NEAR(areaOf(result), areaOf(glu), 1e-6) << "round " << round;
    }
    EXPECT_GT(comparable, 120);
}

TEST_F(Tessellation, theCheckOfCoverageSeesAMissingTriangle) {
    Polygon polygon = kSquareWithHole;
    Result result = tessellate(polygon, {});
    result.triangles.pop_back();
    EXPECT_GT(wrongPoints(polygon, result, RTU_TESS_WINDING_ODD, 1), 0);
}

TEST_F(Tessellation, edgeFlagsMarkTheBoundary) {
    Polygon polygon = kSquareWithHole;
    Wanted wanted;
    wanted.edgeFlags = true;
    const Result result = tessellate(polygon, wanted);
    ASSERT_EQ(result.edgeFlags.size(), result.triangles.size() * 3);
    double length = 0;
    for (std::size_t i = 0; i < result.edgeFlags.size(); ++i) {
        const Point &a = result.triangles[i / 3][i % 3], &b = result.triangles[i / 3][(i + 1) % 3];
        if (result.edgeFlags[i]) length += std::hypot(b[0] - a[0], b[1] - a[1]);
    }
    EXPECT_DOUBLE_EQ(length, 8 + 4);
}

TEST_F(Tessellation, aPolygonInSpaceLooksTowardsItsNormal) {
    // Tilted: z = x + 2 y, so that its normal is along (-1, -2, 1).
    Polygon polygon = kSquareWithHole;
    for (Contour& contour : polygon)
        for (Point& p : contour) p[2] = p[0] + 2 * p[1];
    const Result result = tessellate(polygon, {});
    EXPECT_DOUBLE_EQ(areaOf(result), 3);
    Wanted wanted;
    wanted.normal = {1, 2, -1};
    EXPECT_DOUBLE_EQ(areaOf(tessellate(polygon, wanted)), -3);
}

TEST_F(Tessellation, aCrossingNeedsACombineCallback) {
    Polygon bow = {{{-1, -1, 0}, {1, 1, 0}, {1, -1, 0}, {-1, 1, 0}}};
    Wanted wanted;
    EXPECT_EQ(tessellate(bow, wanted).combined, 1);
    wanted.combine = false;
    const Result result = tessellate(bow, wanted);
    ASSERT_EQ(result.errors.size(), 1u);
    EXPECT_EQ(result.errors[0], RTenum(RTU_TESS_NEED_COMBINE_CALLBACK));
    EXPECT_TRUE(result.triangles.empty());
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_OPERATION));
}

TEST_F(Tessellation, callsLeftOutAreToldAndMadeUpFor) {
    Result result;
    Point points[3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    RTUtesselator* tess = rtuNewTess();
    rtuTessCallback(tess, RTU_TESS_VERTEX_DATA, asFunction(&onVertex));
    rtuTessCallback(tess, RTU_TESS_ERROR_DATA, asFunction(&onError));
    rtuTessBeginPolygon(tess, &result);
    for (Point& point : points) rtuTessVertex(tess, point.data(), &point); // no contour
    rtuTessEndPolygon(tess);                                               // still in it
    EXPECT_EQ(result.errors, (std::vector<RTenum>{RTU_TESS_MISSING_BEGIN_CONTOUR,
                                                  RTU_TESS_MISSING_END_CONTOUR}));
    EXPECT_EQ(result.run.size(), 3u);
    rtuTessCallback(tess, RTU_TESS_ERROR_DATA, nullptr); // there is no polygon whose data it had
    rtuTessVertex(tess, points[0].data(), nullptr);
    rtuTessBeginPolygon(tess, &result);
    rtuDeleteTess(tess);
    EXPECT_NE(rtGetError(), RTenum(RT_NO_ERROR));
}

TEST_F(Tessellation, oldNamesDrawTheSame) {
    Polygon polygon = kSquareWithHole;
    static Result* current;
    Result result;
    current = &result;
    RTUtesselator* tess = rtuNewTess();
    rtuTessCallback(tess, RTU_BEGIN, asFunction(+[](RTenum mode) { current->mode = mode; }));
    rtuTessCallback(tess, RTU_VERTEX, asFunction(+[](void* v) { onVertex(v, current); }));
    rtuTessCallback(tess, RTU_END, asFunction(+[] { current->end(); }));
    rtuBeginPolygon(tess);
    for (Point& point : polygon[0]) rtuTessVertex(tess, point.data(), &point);
    rtuNextContour(tess, RTU_INTERIOR);
    for (Point& point : polygon[1]) rtuTessVertex(tess, point.data(), &point);
    rtuEndPolygon(tess);
    rtuDeleteTess(tess);
    EXPECT_DOUBLE_EQ(areaOf(result), 3);
}

TEST_F(Tessellation, noInputIsTooBad) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double huge = std::numeric_limits<double>::max();
    const double values[] = {0, -1, 1, nan, huge, -huge, 1e150, 1e-300, 1e-160,
                             std::numeric_limits<double>::infinity()};
    std::mt19937 random(5);
    for (int round = 0; round < 300; ++round) {
        Polygon polygon(unsigned(round) % 3);
        for (Contour& contour : polygon)
            for (unsigned i = 0; i < random() % 8; ++i)
                contour.push_back(
                    {values[random() % 10], values[random() % 10], values[random() % 10]});
        Wanted wanted;
        wanted.rule = kRules[round % 5];
        wanted.boundaryOnly = round % 2;
        tessellate(polygon, wanted);
    }
    rtuTessVertex(nullptr, nullptr, nullptr);
    rtuTessBeginPolygon(nullptr, nullptr);
    rtuTessEndPolygon(nullptr);
    rtuDeleteTess(nullptr);
    RTUtesselator* tess = rtuNewTess();
    rtuTessVertex(tess, nullptr, nullptr);
    rtuTessCallback(tess, 12345, nullptr);
    rtuTessProperty(tess, RTU_TESS_WINDING_RULE, nan);
    rtuTessProperty(tess, RTU_TESS_TOLERANCE, 2);
    rtuTessProperty(tess, 12345, 0);
    rtuGetTessProperty(tess, RTU_TESS_TOLERANCE, nullptr);
    double value = 0;
    rtuGetTessProperty(tess, RTU_TESS_WINDING_RULE, &value);
    EXPECT_EQ(value, RTU_TESS_WINDING_ODD);
    rtuDeleteTess(tess);
}

TEST_F(Tessellation, errorsNameTheFunctionThatWasCalled) {
    std::vector<std::string> names;
    rtErrorCallback(
        [](RTenum, const char* function, const char*, void* user) {
            static_cast<std::vector<std::string>*>(user)->emplace_back(function);
        },
        &names);
    RTUtesselator* tess = rtuNewTess();
    rtuTessEndContour(tess); // two calls are missing
    rtuTessBeginPolygon(tess, nullptr);
    rtuTessCallback(tess, 12345, nullptr);
    rtuDeleteTess(tess);
    EXPECT_EQ(names, (std::vector<std::string>{"rtuTessEndContour", "rtuTessEndContour",
                                               "rtuTessBeginPolygon", "rtuTessCallback",
                                               "rtuDeleteTess"}));
}

TEST_F(Tessellation, thousandsOfVertices) {
    // A comb with 3000 teeth, and a star of 301 points that crosses itself.
    Polygon comb(1), star(1);
    for (int i = 0; i < 3000; ++i) {
        comb[0].push_back({-1 + i / 1500.0, -1, 0});
        comb[0].push_back({-1 + (i + 0.5) / 1500.0, 0.9 - (i % 7) * 0.1, 0});
    }
    comb[0].push_back({1, -1, 0});
    comb[0].push_back({1, -2, 0});
    comb[0].push_back({-1, -2, 0});
    Result result = tessellate(comb, {});
    EXPECT_TRUE(result.errors.empty());
    EXPECT_NEAR(areaOf(result), areaOf(tessellateWithGlu(comb, {})), 1e-6);
    for (int i = 0; i < 301; ++i) {
        const double angle = 2 * 3.14159265358979 * ((i * 20) % 301) / 301;
        star[0].push_back({std::cos(angle), std::sin(angle), 0});
    }
    result = tessellate(star, {});
    EXPECT_TRUE(result.errors.empty());
    EXPECT_EQ(wrongPoints(star, result, RTU_TESS_WINDING_ODD, 9), 0);
}

} // namespace

// SPDX-License-Identifier: MIT
// rtUpdateObject and rtObjectHint: after every step what rays meet is what a search through all
// triangles in double finds, for every build quality, built at once or when the first ray comes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "openrt/rt.h"

namespace {

using Vertex = std::array<float, 3>;
using Corners = std::array<std::size_t, 3>;

using Pixels = std::vector<RTubyte>; ///< RT_RGBA_8

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

std::vector<Corners> trianglesOf(RTenum mode, std::size_t vertices) {
    std::vector<Corners> result;
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) { result.push_back({a, b, c}); };
    if (mode == RT_TRIANGLES)
        for (std::size_t i = 0; i + 2 < vertices; i += 3) add(i, i + 1, i + 2);
    if (mode == RT_TRIANGLE_STRIP)
        for (std::size_t i = 0; i + 2 < vertices; ++i)
            i % 2 ? add(i + 1, i, i + 2) : add(i, i + 1, i + 2);
    if (mode == RT_TRIANGLE_FAN || mode == RT_POLYGON)
        for (std::size_t i = 1; i + 1 < vertices; ++i) add(0, i, i + 1);
    if (mode == RT_QUADS)
        for (std::size_t i = 0; i + 3 < vertices; i += 4) {
            add(i, i + 1, i + 2);
            add(i, i + 2, i + 3);
        }
    if (mode == RT_QUAD_STRIP)
        for (std::size_t i = 0; i + 3 < vertices; i += 2) {
            add(i, i + 1, i + 3);
            add(i, i + 3, i + 2);
        }
    return result;
}

/// What an object consists of, as the application knows it.
struct Mesh {
    std::vector<Vertex> vertices;
    std::vector<Corners> triangles;

    void append(RTenum mode, const std::vector<Vertex>& more) {
        for (Corners corners : trianglesOf(mode, more.size())) {
            for (std::size_t& corner : corners) corner += vertices.size();
            triangles.push_back(corners);
        }
        vertices.insert(vertices.end(), more.begin(), more.end());
        rtBegin(mode);
        for (const Vertex& v : more) rtVertex3f(v[0], v[1], v[2]);
        rtEnd();
    }
};

struct Found {
    double t = std::numeric_limits<double>::infinity();
    RTuint primitive = RT_INVALID;
    bool clear = true; ///< not so near an edge, or another hit, that rounding could decide
};

/// Moeller and Trumbore's test in double, of every triangle.
Found searchAll(const Mesh& mesh, const RTray& ray) {
    Found found;
    double second = found.t;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        double e1[3], e2[3], s[3], p[3], q[3];
        bool finite = true;
        const Vertex &a = mesh.vertices[mesh.triangles[i][0]],
                     &b = mesh.vertices[mesh.triangles[i][1]],
                     &c = mesh.vertices[mesh.triangles[i][2]];
        for (std::size_t k = 0; k < 3; ++k) {
            e1[k] = double(b[k]) - a[k];
            e2[k] = double(c[k]) - a[k];
            s[k] = double(ray.origin[k]) - a[k];
            finite &= std::isfinite(e1[k]) && std::isfinite(e2[k]) && std::isfinite(s[k]);
        }
        if (!finite) continue;
        const float* d = ray.direction;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
            p[k] = d[l] * e2[m] - d[m] * e2[l];
            q[k] = s[l] * e1[m] - s[m] * e1[l];
        }
        const double det = e1[0] * p[0] + e1[1] * p[1] + e1[2] * p[2];
        if (std::fabs(det) < 1e-12) continue;
        const double u = (s[0] * p[0] + s[1] * p[1] + s[2] * p[2]) / det;
        const double v = (d[0] * q[0] + d[1] * q[1] + d[2] * q[2]) / det;
        const double t = (e2[0] * q[0] + e2[1] * q[1] + e2[2] * q[2]) / det;
        const double least = std::min({u, v, 1 - u - v});
        if (least < -1e-4 || t < 0) continue;
        if (least < 1e-4 && t < found.t) found.clear = false;
        if (least < 0) continue;
        if (t < found.t) {
            second = found.t;
            found.t = t;
            found.primitive = RTuint(i);
        } else {
            second = std::min(second, t);
        }
    }
    if (second - found.t < 1e-4) found.clear = false;
    return found;
}

class UpdateObject : public ::testing::TestWithParam<std::tuple<RTenum, RTenum>> {
protected:
    void SetUp() override {
        context_ = rtCreateContext();
        rtMakeCurrent(context_);
        rtThreads(2);
        rtObjectHint(RT_BUILD_QUALITY, std::get<0>(GetParam()));
        rtObjectHint(RT_LAZY_BUILD, std::get<1>(GetParam()));
    }
    void TearDown() override {
        EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR)) << rtGetErrorText();
        rtDestroyContext(context_);
    }

    Vertex somewhere() {
        std::uniform_real_distribution<float> place(-1, 1);
        return {place(random_), place(random_), place(random_)};
    }
    std::vector<Vertex> somewhere(std::size_t count) {
        std::vector<Vertex> result(count);
        for (Vertex& v : result) v = somewhere();
        return result;
    }
    /// Object 1 of every kind of primitive; the mesh has incomplete ones too.
    RTuint define(Mesh& mesh) {
        const RTuint object = rtNewObject(RT_DEFINE);
        mesh.append(RT_TRIANGLES, somewhere(32));
        mesh.append(RT_TRIANGLE_STRIP, somewhere(17));
        mesh.append(RT_TRIANGLE_FAN, somewhere(9));
        mesh.append(RT_QUADS, somewhere(21));
        mesh.append(RT_QUAD_STRIP, somewhere(13));
        mesh.append(RT_POLYGON, somewhere(6));
        rtEndObject();
        return object;
    }
    void update(RTuint object, Mesh& mesh, RTuint first, const std::vector<Vertex>& to) {
        std::copy(to.begin(), to.end(), mesh.vertices.begin() + first);
        rtUpdateObject(object, first, RTsizei(to.size()), to.data()->data());
    }
    std::vector<RTray> rays(std::size_t count) {
        std::vector<RTray> result(count);
        for (RTray& ray : result) {
            const Vertex from = somewhere(), to = somewhere();
            for (std::size_t k = 0; k < 3; ++k) {
                ray.origin[k] = 2 * from[k];
                ray.direction[k] = to[k] - ray.origin[k];
            }
            ray.tnear = 0;
            ray.tfar = kInfinity;
        }
        return result;
    }
    static std::vector<RThit> trace(RTuint scene, const std::vector<RTray>& rays, RTenum how) {
        std::vector<RThit> hits(rays.size());
        rtIntersect(scene, rays.data(), hits.data(), RTsizei(rays.size()), how);
        return hits;
    }
    /// The scene of one instance against the mesh.
    void expectMesh(RTuint scene, const Mesh& mesh, std::size_t count = 400) {
        const std::vector<RTray> all = rays(count);
        std::size_t clear = 0, hit = 0;
        for (const RTenum how : {RT_COHERENT, RT_INCOHERENT}) {
            const std::vector<RThit> hits = trace(scene, all, how);
            for (std::size_t i = 0; i < all.size(); ++i) {
                const Found expected = searchAll(mesh, all[i]);
                if (!expected.clear) continue;
                ++clear;
                hit += expected.primitive != RT_INVALID;
                ASSERT_EQ(hits[i].primitive, expected.primitive) << "ray " << i;
                if (expected.primitive != RT_INVALID) {
                    ASSERT_NEAR(hits[i].t, expected.t, 1e-5 * (1 + expected.t));
                }
            }
        }
        EXPECT_GT(clear, count) << "the search must have something to say";
        EXPECT_GT(hit, count / 20);
    }
    static RTuint sceneOf(RTuint object) {
        rtInstantiateObject(object);
        const RTuint scene = rtCompileScene();
        rtBindScene(rtGenScene());
        return scene;
    }
    void expectObject(RTuint object, const Mesh& mesh) {
        const RTuint scene = sceneOf(object);
        expectMesh(scene, mesh);
        rtReleaseScene(scene);
    }

    std::mt19937 random_{7};
    RTcontext context_ = nullptr;
};

TEST_P(UpdateObject, EveryStepIsWhatASearchThroughAllTrianglesFinds) {
    Mesh mesh;
    const RTuint object = define(mesh);
    expectObject(object, mesh);
    const RTuint all = RTuint(mesh.vertices.size());
    update(object, mesh, 0, somewhere(all));
    expectObject(object, mesh);
    for (int step = 0; step < 6; ++step) { // small moves of everything
        std::vector<Vertex> to = mesh.vertices;
        for (Vertex& v : to)
            for (float& x : v) x += 0.05f * somewhere()[0];
        update(object, mesh, 0, to);
        expectObject(object, mesh);
    }
    for (int step = 0; step < 6; ++step) { // large moves of a part
        const RTuint first = RTuint(random_() % all);
        update(object, mesh, first, somewhere(std::min<std::size_t>(all - first, 20)));
        expectObject(object, mesh);
    }
    update(object, mesh, all - 1, somewhere(1));
    expectObject(object, mesh);
    rtUpdateObject(object, all, 0, nullptr);
    expectObject(object, mesh);
}

TEST_P(UpdateObject, DroppedTrianglesKeepTheirNumbersAndComeBack) {
    Mesh mesh;
    const RTuint object = define(mesh);
    const std::vector<Vertex> start = mesh.vertices;
    const auto dropped = [&] {
        RTubyte pixel[4];
        rtSetFrameBuffer(pixel, 1, 1, RT_RGBA_8);
        rtInstantiateObject(object);
        rtRender();
        RTint count = 0;
        rtGetIntegerv(RT_STAT_DROPPED_TRIANGLES, &count);
        return count;
    };
    EXPECT_EQ(dropped(), 0);
    update(object, mesh, 0, {{kNan, 0, 0}});
    expectObject(object, mesh);
    EXPECT_EQ(dropped(), 1);
    update(object, mesh, 4, {{0, -kInfinity, 0}});
    update(object, mesh, 7, {start[6]}); // no area
    expectObject(object, mesh);
    EXPECT_EQ(dropped(), 3);
    // Others move while those are dropped.
    update(object, mesh, 9, somewhere(20));
    expectObject(object, mesh);
    EXPECT_EQ(dropped(), 3);
    update(object, mesh, 0, {start[0]});
    EXPECT_EQ(dropped(), 2);
    expectObject(object, mesh);
    // All at one point, and back.
    update(object, mesh, 0, std::vector<Vertex>(start.size(), Vertex{1, 2, 3}));
    EXPECT_EQ(dropped(), RTint(mesh.triangles.size()));
    update(object, mesh, 0, start);
    EXPECT_EQ(dropped(), 0);
    expectObject(object, mesh);
    // Not finite all of them, and back.
    update(object, mesh, 0, std::vector<Vertex>(start.size(), Vertex{kNan, kNan, kInfinity}));
    EXPECT_EQ(dropped(), RTint(mesh.triangles.size()));
    update(object, mesh, 0, start);
    expectObject(object, mesh);
}

TEST_P(UpdateObject, ScenesAndNestingObjectsKeepTheOldModel) {
    Mesh mesh;
    const RTuint object = define(mesh);
    const RTuint outer = rtNewObject(RT_DEFINE);
    rtInstantiateObject(object);
    rtEndObject();
    const RTuint oldScene = sceneOf(object), nesting = sceneOf(outer);
    rtInstantiateObject(object); // given already
    const Mesh old = mesh;
    update(object, mesh, 0, somewhere(mesh.vertices.size()));
    const RTuint given = rtCompileScene();
    rtBindScene(rtGenScene());
    for (const RTuint scene : {oldScene, nesting, given}) expectMesh(scene, old);
    const RTuint newScene = sceneOf(object);
    expectMesh(newScene, mesh);
    rtRemoveObject(object);
    expectMesh(oldScene, old);
    expectMesh(newScene, mesh);
    for (const RTuint scene : {oldScene, nesting, given, newScene}) rtReleaseScene(scene);
}

TEST_P(UpdateObject, EqualsTheSameObjectDefinedAnewToTheBit) {
    Mesh mesh;
    const RTuint object = define(mesh);
    update(object, mesh, 3, somewhere(mesh.vertices.size() - 5));
    const RTuint again = rtNewObject(RT_DEFINE);
    rtBegin(RT_TRIANGLES);
    for (const Corners& corners : mesh.triangles)
        for (const std::size_t corner : corners) rtVertex3fv(mesh.vertices[corner].data());
    rtEnd();
    rtEndObject();
    const RTuint a = sceneOf(object), b = sceneOf(again);
    const std::vector<RTray> all = rays(600);
    for (const RTenum how : {RT_COHERENT, RT_INCOHERENT}) {
        const std::vector<RThit> x = trace(a, all, how), y = trace(b, all, how);
        for (std::size_t i = 0; i < all.size(); ++i) {
            EXPECT_EQ(x[i].t, y[i].t);
            EXPECT_EQ(x[i].u, y[i].u);
            EXPECT_EQ(x[i].v, y[i].v);
            EXPECT_EQ(x[i].primitive, y[i].primitive);
            for (int k = 0; k < 3; ++k) EXPECT_EQ(x[i].normal[k], y[i].normal[k]);
        }
    }
}

TEST_P(UpdateObject, FramesUnderWayShowTheStateAtTheirStart) {
    constexpr int kSize = 48, kFrames = 6;
    Mesh mesh;
    const RTuint object = define(mesh);
    std::vector<std::vector<Vertex>> states;
    for (int i = 0; i < kFrames; ++i) states.push_back(somewhere(mesh.vertices.size()));
    const auto draw = [&](int i, Pixels& to) {
        rtUpdateObject(object, 0, RTsizei(states[0].size()), states[std::size_t(i)][0].data());
        rtSetFrameBuffer(to.data(), kSize, kSize, RT_RGBA_8);
        rtInstantiateObject(object);
    };
    std::vector<Pixels> blocking, queued;
    for (int i = 0; i < kFrames; ++i) {
        blocking.emplace_back(4 * kSize * kSize);
        draw(i, blocking.back());
        rtRender();
    }
    rtFrameDepth(kFrames);
    std::vector<RTuint> frames;
    for (int i = 0; i < kFrames; ++i) {
        queued.emplace_back(4 * kSize * kSize);
        draw(i, queued.back());
        frames.push_back(rtQueueFrame());
    }
    update(object, mesh, 0, somewhere(mesh.vertices.size()));
    rtRemoveObject(object);
    for (const RTuint frame : frames) EXPECT_TRUE(rtWaitFrame(frame));
    for (std::size_t i = 0; i < kFrames; ++i) {
        EXPECT_EQ(queued[i], blocking[i]) << i;
        if (i > 0) {
            EXPECT_NE(blocking[i], blocking[i - 1]) << "control: the states differ";
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Hints, UpdateObject,
    ::testing::Combine(::testing::Values(RTenum(RT_NICEST), RTenum(RT_DONT_CARE),
                                         RTenum(RT_FASTEST), RTenum(RT_KD_TREE)),
                       ::testing::Values(RTenum(RT_FALSE), RTenum(RT_TRUE))),
    [](const auto& hints) {
        const RTenum quality = std::get<0>(hints.param);
        return std::string(quality == RT_NICEST    ? "Nicest"
                           : quality == RT_FASTEST ? "Fastest"
                           : quality == RT_KD_TREE ? "KdTree"
                                                   : "DontCare") +
               (std::get<1>(hints.param) == RT_TRUE ? "Lazy" : "AtOnce");
    });

TEST(UpdateObjectAttributes, NormalsAndTextureCoordinatesStay) {
    const RTcontext context = rtCreateContext();
    rtMakeCurrent(context);
    const RTuint object = rtNewObject(RT_DEFINE);
    rtBegin(RT_TRIANGLES);
    const float at[3][2] = {{-4, -4}, {4, -4}, {0, 4}};
    for (int i = 0; i < 3; ++i) {
        rtColor3f(i == 0, i == 1, i == 2);
        rtVertex3f(at[i][0] + 100, at[i][1], -5);
    }
    rtEnd();
    rtEndObject();
    const auto picture = [&] {
        Pixels pixels(4 * 16 * 16);
        rtSetFrameBuffer(pixels.data(), 16, 16, RT_RGBA_8);
        rtMatrixMode(RT_PROJECTION);
        rtLoadIdentity();
        rtFrustum(-1, 1, -1, 1, 1, 10);
        rtMatrixMode(RT_MODELVIEW);
        rtInstantiateObject(object);
        rtRender();
        return pixels;
    };
    const Pixels before = picture();
    float to[9];
    for (int i = 0; i < 3; ++i) {
        to[3 * i] = at[i][0];
        to[3 * i + 1] = at[i][1];
        to[3 * i + 2] = -5;
    }
    rtUpdateObject(object, 0, 3, to);
    const Pixels after = picture();
    EXPECT_NE(before, after);
    for (std::size_t k = 0; k < 3; ++k) // all three colours mix in the middle
        EXPECT_GT(after[4 * (7 * 16 + 8) + k], 10u);
    EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR));
    rtDestroyContext(context);
}

TEST(UpdateObjectErrors, AreRecordedAndChangeNothing) {
    const RTcontext other = rtCreateContext(), context = rtCreateContext();
    rtMakeCurrent(context);
    const auto makeObject = [] {
        const RTuint object = rtNewObject(RT_DEFINE);
        rtBegin(RT_TRIANGLES);
        rtVertex3f(-1, -1, 0);
        rtVertex3f(1, -1, 0);
        rtVertex3f(0, 1, 0);
        rtVertex3f(5, 5, 5); // of no triangle, but given
        rtEnd();
        rtEndObject();
        return object;
    };
    const RTuint object = makeObject();
    const float away[12] = {9, 9, 9, 8, 9, 9, 9, 8, 9, 9, 9, 9};
    const auto expect = [&](RTenum code, RTuint id, RTuint first, RTsizei count,
                            const float* xyz) {
        rtUpdateObject(id, first, count, xyz);
        EXPECT_EQ(rtGetError(), code) << id << " " << first << " " << count;
    };
    expect(RT_INVALID_VALUE, object, 0, 5, away);
    expect(RT_INVALID_VALUE, object, 4, 1, away);
    expect(RT_INVALID_VALUE, object, 0xFFFFFFFFu, 2, away);
    expect(RT_INVALID_VALUE, object, 2, 0x7FFFFFFF, away);
    expect(RT_INVALID_VALUE, object, 0, -1, away);
    expect(RT_INVALID_VALUE, object, 0, 3, nullptr);
    expect(RT_INVALID_VALUE, object + 1, 0, 3, away);
    expect(RT_INVALID_VALUE, 0, 0, 3, away);
    expect(RT_NO_ERROR, object, 4, 0, nullptr);
    rtBegin(RT_TRIANGLES);
    rtUpdateObject(object, 0, 3, away);
    rtEnd();
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_OPERATION));
    const RTuint open = rtNewObject(RT_DEFINE);
    expect(RT_INVALID_OPERATION, object, 0, 3, away);
    expect(RT_INVALID_OPERATION, open, 0, 3, away);
    rtEndObject();
    rtMakeCurrent(other);
    expect(RT_INVALID_VALUE, object, 0, 3, away);
    rtMakeCurrent(context);

    rtInstantiateObject(object);
    const RTuint scene = rtCompileScene();
    const RTray ray = {{0, 0, 5}, 0, {0, 0, -1}, 100};
    RThit hit;
    rtIntersect(scene, &ray, &hit, 1, RT_INCOHERENT);
    EXPECT_EQ(hit.t, 5);
    expect(RT_NO_ERROR, object, 0, 4, away);
    rtRemoveObject(object);
    expect(RT_INVALID_VALUE, object, 0, 3, away);
    rtReleaseScene(scene);
    rtDestroyContext(context);
    rtDestroyContext(other);
}

} // namespace

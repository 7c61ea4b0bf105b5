// SPDX-License-Identifier: MIT
// Rays from shaders, in frames: they do not meet the surface that they leave, and do not pass
// through one that is closed, at any scale, instanced or not. No shader here has an epsilon.
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "tests/shaders/shader_picture.h"

namespace smart::test {
namespace {

using namespace openrt;

/// Where a scene of about unit size is put.
struct Placement {
    double scale;
    bool instanced; ///< the object itself has another scale, and is turned
    double offset;  ///< along (1, 1, 1), in units of the scene's size
};

const Placement kPlacements[] = {
    {1e-6, false, 0}, {1e-6, true, 0},   {1e-3, false, 0}, {1, false, 0},  {1, true, 0},
    {1, false, 1000}, {1, true, 1000},   {1e3, true, 3},   {1e6, false, 0}, {1e6, true, 0},
};

std::string nameOf(const Placement& p) {
    return std::to_string(std::log10(p.scale)) + (p.instanced ? ", instanced, " : ", ") +
           std::to_string(p.offset);
}

/// Rays straight on from the camera's origin; placed by the test.
struct Camera {
    Vec3 origin, ahead, right, up;
    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<Vec3>("origin", PER_SHADER, offsetof(Camera, origin));
        r.registerParam<Vec3>("ahead", PER_SHADER, offsetof(Camera, ahead));
        r.registerParam<Vec3>("right", PER_SHADER, offsetof(Camera, right));
        r.registerParam<Vec3>("up", PER_SHADER, offsetof(Camera, up));
    }
    void initPrimaryRay(float x, float y, TraceContext& c) const {
        c.setRay(origin, ahead + right * (2 * x - 1) + up * (2 * y - 1));
    }
};
struct White {
    static constexpr ShaderKind kind = ShaderKind::Environment;
    void shade(TraceContext& c) const { c.setRadiance(Color(1.0f)); }
};
/// Share of 32 rays over the surface that come back with light.
struct Gatherer {
    float skipped = 0; ///< what counts for rays too near to the triangle's plane to be sent
    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<float>("skipped", PER_SHADER, offsetof(Gatherer, skipped));
    }
    void shade(TraceContext& c) const {
        const Vec3 normal = c.facingGeometricNormal();
        Color sum;
        for (int i = 0; i < 32; ++i) {
            Vec3 d{2 * c.random() - 1, 2 * c.random() - 1, 2 * c.random() - 1};
            d = normalize(d);
            if (dot(d, normal) < 0) d = -d;
            sum += dot(d, normal) > 1e-3f ? c.trace(c.position(), d, 1) : Color(skipped);
        }
        c.setRadiance(sum / 32);
    }
};
/// What of the light arrives at each point over the triangle's plane, whatever the shading normal.
struct Lit {
    void shade(TraceContext& c) const {
        Color sum;
        for (RTuint i = 0; i < c.lightCount(); ++i) {
            LightSample l{};
            if (!c.illuminate(i, l)) continue;
            if (dot(l.direction, c.facingGeometricNormal()) > 1e-3f)
                sum += c.shadow(c.position(), l.direction, l.distance) * l.radiance;
            else
                sum += l.radiance; // not asked here
        }
        c.setRadiance(sum);
    }
};

struct Triangle3 {
    std::array<Vec3, 3> corner;
};

std::vector<Triangle3> box(float size) {
    const auto corner = [&](int i) {
        return Vec3(i & 1 ? size : -size, i & 2 ? size : -size, i & 4 ? size : -size);
    };
    const int sides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 4, 6, 2},
                             {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}};
    std::vector<Triangle3> all;
    for (const auto& s : sides) {
        all.push_back({{corner(s[0]), corner(s[1]), corner(s[2])}});
        all.push_back({{corner(s[0]), corner(s[2]), corner(s[3])}});
    }
    return all;
}

/// A ball of 512 triangles, vertices shared exactly.
std::vector<Triangle3> ball(float radius) {
    const Vec3 o[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    std::vector<Triangle3> all;
    for (const int x : {0, 1})
        for (const int y : {2, 3})
            for (const int z : {4, 5}) {
                const bool turned = (x + y + z) % 2 == 1;
                all.push_back({{o[x], turned ? o[z] : o[y], turned ? o[y] : o[z]}});
            }
    for (int level = 0; level < 3; ++level) {
        std::vector<Triangle3> finer;
        for (const auto& [c] : all) {
            const Vec3 a = normalize(c[0] + c[1]), b = normalize(c[1] + c[2]),
                       d = normalize(c[2] + c[0]);
            finer.insert(finer.end(),
                         {{{c[0], a, d}}, {{a, c[1], b}}, {{d, b, c[2]}}, {{a, b, d}}});
        }
        all = finer;
    }
    for (auto& t : all)
        for (Vec3& v : t.corner) v *= radius;
    return all;
}

/// A field of 24 x 24 squares with gentle hills.
std::vector<Triangle3> field(float height) {
    const auto at = [&](int i, int j) {
        const float x = float(i) / 12 - 1, y = float(j) / 12 - 1;
        return Vec3(x, y, height * std::sin(9 * x) * std::cos(7 * y));
    };
    std::vector<Triangle3> all;
    for (int i = 0; i < 24; ++i)
        for (int j = 0; j < 24; ++j) {
            all.push_back({{at(i, j), at(i + 1, j), at(i + 1, j + 1)}});
            all.push_back({{at(i, j), at(i + 1, j + 1), at(i, j + 1)}});
        }
    return all;
}

class SpawnedRays : public ShaderPicture {
protected:
    /// Gives the frame the triangles, with one shader, where the placement says.
    static void place(const std::vector<Triangle3>& triangles, RTuint shader,
                      const Placement& placement) {
        const double scale = placement.scale, inner = placement.instanced ? 0.37 : 1;
        rtPushMatrix();
        const double o = placement.offset * scale;
        rtTranslated(o, o, o);
        rtScaled(scale / inner, scale / inner, scale / inner);
        rtBindShader(shader);
        RTuint object = 0;
        if (placement.instanced) {
            rtRotated(123, 0.3, -0.5, 0.8);
            object = rtNewObject(RT_DEFINE);
        }
        rtPushMatrix();
        rtScaled(inner, inner, inner);
        if (placement.instanced) rtRotated(-123, 0.3, -0.5, 0.8); // back to where it was
        rtBegin(RT_TRIANGLES);
        for (const auto& [corner] : triangles) {
            const Vec3 normal =
                normalize(cross(corner[1] - corner[0], corner[2] - corner[0]));
            rtNormal(normal);
            for (const Vec3& v : corner) rtVertex(v);
        }
        rtEnd();
        rtPopMatrix();
        if (placement.instanced) {
            rtEndObject();
            rtInstantiateObject(object);
            rtRemoveObject(object);
        }
        rtPopMatrix();
    }
    /// A camera at a point of the placed scene.
    static void look(RTuint camera, const Vec3& from, const Vec3& ahead, const Vec3& right,
                     const Vec3& up, const Placement& placement) {
        rtBindShader(camera);
        const float s = float(placement.scale), o = float(placement.offset * placement.scale);
        set("origin", from * s + Vec3(o, o, o));
        set("ahead", ahead);
        set("right", right);
        set("up", up);
        rtUseCamera(camera);
    }
    static void lookAround(RTuint camera, int view, const Placement& placement) {
        const Vec3 from{0.11f, -0.07f, 0.05f};
        const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
        if (view == 0) look(camera, from, -z, x, y, placement);
        if (view == 1) look(camera, from, x, z, y, placement);
    }
};

/// How many pixels have something else than the value in their first channel.
int pixelsNot(float value, const SmallPicture& picture) {
    return int(pixelsWhere([&](int x, int y) {
                   return !(std::fabs(picture.at(x, y)[0] - value) <= 1e-5f);
               }).size());
}

TEST_F(SpawnedRays, NothingLeavesAClosedBody) {
    // Bright outside, no light inside: what is not black has leaked.
    const RTuint camera = own<Camera>("Camera"), environment = own<White>("White");
    const RTuint mirror = builtin("MirrorShader"), gatherer = own<Gatherer>("Gatherer");
    rtRecursionLimit(6);
    const std::vector<Triangle3> bodies[] = {box(1), ball(1)};
    for (const Placement& placement : kPlacements) {
        SCOPED_TRACE(nameOf(placement));
        for (const auto& body : bodies) {
            SCOPED_TRACE(body.size());
            for (const RTuint shader : {mirror, gatherer}) {
                SCOPED_TRACE(shader == mirror ? "mirrors" : "diffuse");
                rtRecursionLimit(shader == mirror ? 6 : 1);
                for (int view = 0; view < 2; ++view) {
                    rtUseEnvironmentShader(environment);
                    lookAround(camera, view, placement);
                    place(body, shader, placement);
                    EXPECT_EQ(pixelsNot(0, render()), 0);
                    expectReported(0);
                }
            }
        }
    }
    // The control: through a hole in the box the light does get in.
    std::vector<Triangle3> open = box(1);
    open.erase(open.begin());
    rtUseEnvironmentShader(environment);
    lookAround(camera, 1, kPlacements[3]);
    place(open, gatherer, kPlacements[3]);
    EXPECT_GT(pixelsNot(0, render()), 20);
}

TEST_F(SpawnedRays, NoSurfaceShadowsOrMirrorsItself) {
    // From outside a convex body nothing is in the way of any light over a triangle's plane, and
    // a mirrored ray meets nothing.
    const RTuint camera = own<Camera>("Camera"), environment = own<White>("White");
    const RTuint mirror = builtin("MirrorShader"), lit = own<Lit>("Lit");
    const RTuint gatherer = own<Gatherer>("Gatherer");
    set("skipped", 1.0f);
    std::vector<RTuint> suns;
    for (const Vec3& d : {Vec3(0, 0, -1), Vec3(-1, 0, -0.002f), Vec3(0.3f, -1, -0.01f),
                          Vec3(0.5f, 0.7f, 0.3f)}) {
        suns.push_back(builtin("DirectionalLight"));
        set("direction", d);
        set("radiance", Color(0.25f));
    }
    const std::vector<Triangle3> bodies[] = {box(0.8f), ball(0.9f), field(0)};
    for (const Placement& placement : kPlacements) {
        SCOPED_TRACE(nameOf(placement));
        for (const auto& body : bodies) {
            SCOPED_TRACE(body.size());
            for (const RTuint shader : {mirror, lit, gatherer}) {
                SCOPED_TRACE(shader == mirror ? "mirror" : shader == lit ? "lit" : "gatherer");
                rtUseEnvironmentShader(environment);
                for (const RTuint sun : suns) rtUseLight(sun);
                look(camera, {0.3f, -0.4f, 3}, {-0.1f, 0.13f, -1}, {0.35f, 0, 0}, {0, 0.35f, 0},
                     placement);
                place(body, shader, placement);
                EXPECT_EQ(pixelsNot(1, render()), 0);
                expectReported(0);
            }
        }
    }
    // The control: something in between does shadow.
    rtUseEnvironmentShader(environment);
    rtUseLight(suns[0]);
    look(camera, {0.3f, -0.4f, 3}, {-0.1f, 0.13f, -1}, {0.35f, 0, 0}, {0, 0.35f, 0},
         kPlacements[3]);
    place(field(0), lit, kPlacements[3]);
    rtTranslatef(0, 0, 5);
    place(box(0.5f), lit, kPlacements[3]);
    EXPECT_GT(pixelsNot(0.25f, render()), 10);
}

TEST_F(SpawnedRays, AGrazedFloorUnderALampHasNoAcne) {
    // A floor seen and lit at small angles, against radiance * cosine / distance^2.
    const RTuint camera = own<Camera>("Camera"), phong = builtin("Phong");
    set("diffuse", Color(1.0f));
    const RTuint lamp = builtin("PointLight");
    for (const Placement& placement : kPlacements) {
        if (placement.offset > 10) continue; // there the lamp's height is rounded away
        SCOPED_TRACE(nameOf(placement));
        const double s = placement.scale, o = placement.offset * s;
        rtBindShader(lamp);
        const Vec3 lampAt{0.2f, 0.9f, 0.01f}; // a hundredth of the floor's size over it
        set("position", Vec3(float(lampAt.x * s + o), float(lampAt.y * s + o),
                             float(lampAt.z * s + o)));
        set("radiance", Color(float(s * s)));
        rtUseLight(lamp);
        const Vec3 eye{0, -1.5f, 0.05f};
        look(camera, eye, {0, 1, -0.05f}, {0.3f, 0, 0}, {0, 0, 0.02f}, placement);
        place(field(0), phong, placement);
        const SmallPicture picture = render();
        expectReported(0);
        int compared = 0;
        for (const auto& [x, y] : pixelsWhere([](int, int) { return true; })) {
            const double u = (x + 0.5) / 8 - 1, v = (y + 0.5) / 8 - 1;
            const double dx = 0.3 * u, dy = 1, dz = double(-0.05f) + double(0.02f) * v;
            const double t = -double(eye.z) / dz;
            const double px = t * dx * double(0.3f) / 0.3, py = double(eye.y) + t * dy;
            if (std::fabs(px) > 0.99 || std::fabs(py) > 0.99) continue;
            const double lx = double(lampAt.x) - px, ly = double(lampAt.y) - py, lz = lampAt.z;
            const double squared = lx * lx + ly * ly + lz * lz;
            const double expected = lz / std::sqrt(squared) / squared;
            EXPECT_NEAR(picture.at(x, y)[0] / expected, 1, 2e-3) << x << ", " << y;
            ++compared;
        }
        EXPECT_GT(compared, 100);
    }
}

/// Lets through what it is told.
struct Pane {
    Color passes{1.0f};
    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<Color>("passes", PER_SHADER, offsetof(Pane, passes));
    }
    void shade(TraceContext& c) const {
        c.setRadiance(passes * c.trace(c.position(), c.rayDirection(), passes.largest()));
    }
    Color transparency(TraceContext&) const { return passes; }
};

TEST_F(SpawnedRays, LightThroughPanesIsTheProductOfTheirTransparencies) {
    const RTuint sun = builtin("DirectionalLight");
    set("direction", Vec3(0, 0.4f, -1));
    const RTuint floor = builtin("Phong");
    set("diffuse", Color(1.0f));
    const auto passes = [](int i) {
        const float values[] = {0.5f, 1.0f, 0.75f, 0.25f, 0.875f};
        return Color(values[i % 5], values[(i + 1) % 5], values[(i + 2) % 5]);
    };
    const auto pane = [&](int i) {
        const RTuint shader = own<Pane>("Pane");
        set("passes", passes(i));
        return shader;
    };
    const auto scene = [&](const std::vector<int>& panes, double apart, bool objects) {
        rtUseLight(sun);
        rectangle(floor, -64, -64, 80, 80, 0);
        for (std::size_t i = 0; i < panes.size(); ++i) {
            const RTuint shader = pane(panes[i]);
            const RTuint object = objects ? rtNewObject(RT_DEFINE) : 0;
            // Behind the eye: rays start at z = 10.
            rectangle(shader, -640, -640, 656, 656, float(20 + apart * double(i)));
            if (objects) {
                rtEndObject();
                rtInstantiateObject(object);
            }
        }
        return render();
    };
    const SmallPicture open = scene({}, 1, false);
    const auto product = [&](const std::vector<int>& panes) {
        Color all(1.0f);
        for (const int p : panes) all *= passes(p);
        return all;
    };
    const auto check = [&](const std::vector<int>& panes, double apart, bool objects,
                           const Color& expected) {
        const SmallPicture picture = scene(panes, apart, objects);
        const auto near = [](float a, float b) { return std::fabs(a - b) <= 1e-6f * b; };
        const PixelSet wrong = pixelsWhere([&](int x, int y) {
            const float *p = picture.at(x, y), *o = open.at(x, y);
            return !near(p[0], o[0] * expected.r) || !near(p[1], o[1] * expected.g) ||
                   !near(p[2], o[2] * expected.b);
        });
        EXPECT_EQ(wrong.size(), 0u) << panes.size() << " panes, " << apart << " apart: "
                                    << picture.at(5, 5)[0] / open.at(5, 5)[0];
        expectReported(0);
    };
    EXPECT_GT(open.at(3, 3)[0], 0.5f);
    for (const bool objects : {false, true})
        for (const auto& panes : {std::vector<int>{0}, {0, 1, 2}, {2, 1, 0}, {2, 1, 0, 4, 3, 0, 1},
                                  std::vector<int>(40, 2)})
            for (const double apart : {1.0, 0.01, 2e-4}) // down to a hundred thousandth of the way
                check(panes, apart, objects, product(panes));
    // In the very same place one is seen and counts: the first that was given.
    check({0, 3}, 0, true, passes(0));
    check({3, 0, 1}, 0, true, passes(3));
    // An opaque one between them.
    rtUseLight(sun);
    rectangle(floor, -64, -64, 80, 80, 0);
    rectangle(pane(0), -640, -640, 656, 656, 20);
    rectangle(floor, -640, -640, 656, 656, 21);
    rectangle(pane(0), -640, -640, 656, 656, 22);
    EXPECT_EQ(pixelsNot(0, render()), 0);
}

} // namespace
} // namespace smart::test

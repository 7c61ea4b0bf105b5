// SPDX-License-Identifier: MIT
// The shader libraries of samples/shaders: they load, and show what their texts say, against
// closed forms where there are.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "tests/shaders/shader_picture.h"

namespace smart::test {
namespace {

using namespace openrt;

constexpr double kPi = 3.14159265358979323846;

struct White {
    static constexpr ShaderKind kind = ShaderKind::Environment;
    void shade(TraceContext& c) const { c.setRadiance(Color(1.0f)); }
};
/// Shows a direction as a colour.
struct Compass {
    static constexpr ShaderKind kind = ShaderKind::Environment;
    void shade(TraceContext& c) const {
        const Vec3 d = c.rayDirection();
        c.setRadiance({d.x, d.y, d.z});
    }
};
/// One ray a pixel, one pixel at a time: surfaces shade points, not packets.
struct OneByOne {
    Color renderPixel(PixelContext& p) const {
        const Vec4 seen = p.trace(p.samplePosition(0, 1));
        p.setAlpha(seen.w);
        return {seen.x, seen.y, seen.z};
    }
};

class SampleShaders : public ShaderPicture {
protected:
    static RTuint sample(const char* library, const char* name) {
        const std::string path = std::string(OPENRT_TEST_SHADER_FOLDER) + "/" + library + ".so";
        EXPECT_NE(rtGenNewShaderClass(name, path.c_str()), RT_INVALID) << rtGetErrorText();
        return rtGenNewShader();
    }
    static RTuint sun(const Vec3& direction, float radiance) {
        const RTuint light = builtin("DirectionalLight");
        set("direction", direction);
        set("radiance", Color(radiance));
        return light;
    }
    /// With flat triangles, or normals as round as the ball.
    static void ball(RTuint shader, double radius, bool smooth) {
        constexpr int kStacks = 24, kSlices = 48;
        const auto at = [&](int i, int j) {
            const double a = kPi * i / kStacks, b = 2 * kPi * j / kSlices;
            return Vec3(float(std::sin(a) * std::sin(b)), float(std::cos(a)),
                        float(std::sin(a) * std::cos(b)));
        };
        rtBindShader(shader);
        rtBegin(RT_TRIANGLES);
        for (int i = 0; i < kStacks; ++i)
            for (int j = 0; j < kSlices; ++j) {
                const Vec3 p[4] = {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
                for (const auto& triangle : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
                    const Vec3 flat = p[0] + p[1] + p[2] + p[3];
                    const Vec3 normal = cross(p[triangle[1]] - p[triangle[0]],
                                              p[triangle[2]] - p[triangle[0]]);
                    for (const int corner : triangle) {
                        rtNormal(smooth ? p[corner] : length(normal) > 0 ? normal : flat);
                        rtVertex(p[corner] * float(radius));
                    }
                }
            }
        rtEnd();
    }
    static bool isFinite(const SmallPicture& picture) {
        return std::ranges::all_of(picture.values, [](float v) { return std::isfinite(v); });
    }
};

TEST_F(SampleShaders, EachLoadsAndRenders) {
    enum Kind { kSurface, kLight, kEnvironment, kCamera, kObject };
    struct Each {
        const char *library, *name;
        Kind kind;
    };
    const Each all[] = {{"wood", "Wood", kSurface},
                        {"checker", "Checker", kSurface},
                        {"marble", "Marble", kSurface},
                        {"glass", "Glass", kSurface},
                        {"toon", "Toon", kSurface},
                        {"heat", "Heat", kSurface},
                        {"area_light", "AreaLight", kLight},
                        {"sky", "Sky", kEnvironment},
                        {"fisheye", "Fisheye", kCamera},
                        {"ambient_occlusion", "AmbientOcclusion", kObject},
                        {"path_tracer", "PathTracer", kObject},
                        {"path_tracer", "Matte", kSurface},
                        {"path_tracer", "Metal", kSurface},
                        {"path_tracer", "Emitter", kSurface}};
    const RTuint phong = builtin("Phong"), light = sun({0.3f, -0.4f, -1}, 0.5f);
    const RTuint white = own<White>("White");
    for (const Each& each : all) {
        SCOPED_TRACE(each.name);
        const RTuint shader = sample(each.library, each.name);
        rtUseLight(each.kind == kLight ? shader : light);
        rtUseEnvironmentShader(each.kind == kEnvironment ? shader : white);
        if (each.kind == kCamera) {
            set("origin", Vec3(0, 0, 3));
            rtUseCamera(shader);
        }
        if (each.kind == kObject) rtUseRenderingObject(shader);
        ball(each.kind == kSurface ? shader : phong, 0.8, true);
        EXPECT_TRUE(isFinite(render()));
        expectReported(0);
        EXPECT_FALSE(blackPixels(shown()).size() == kPictureSize * kPictureSize);
    }
}

TEST_F(SampleShaders, HeatIsInterpolatedAndMarked) {
    sample("heat", "Heat");
    set("low", -1.0f);
    set("high", 2.0f);
    set("marked", Color(0, 0, 1));
    const RTuint heat = rtParameterHandle("heat"), mark = rtParameterHandle("mark");
    rtBegin(RT_QUADS);
    for (int lower = 1; lower >= 0; --lower)
        for (int corner = 0; corner < 4; ++corner) {
            const bool right = corner == 1 || corner == 2, top = corner >= 2;
            rtParameter1i(mark, lower);
            rtParameter1f(heat, right ? 2.0f : -1.0f);
            rtVertex2f(right ? 1.0f : -1.0f, (lower ? -1.0f : 0.0f) + (top ? 1.0f : 0.0f));
        }
    rtEnd();
    const SmallPicture picture = render();
    for (int x = 0; x < kPictureSize; ++x) {
        const double share = (x + 0.5) / kPictureSize;
        for (int k = 0; k < 3; ++k) {
            const double plain = std::clamp(3 * share - k, 0.0, 1.0);
            EXPECT_NEAR(picture.at(x, 12)[k], plain, 1e-5);
            EXPECT_NEAR(picture.at(x, 4)[k], (plain + (k == 2)) / 2, 1e-5);
        }
    }
    expectReported(0);
}

TEST_F(SampleShaders, TheFisheyeIsEquidistant) {
    const RTuint compass = own<Compass>("Compass");
    for (const float degrees : {90.0f, 180.0f, 260.0f}) {
        const RTuint camera = sample("fisheye", "Fisheye");
        set("fieldOfView", degrees);
        set("direction", Vec3(0, 0, -7));
        rtUseCamera(camera);
        rtUseEnvironmentShader(compass);
        const SmallPicture picture = render();
        expectReported(0);
        for (const auto& [x, y] : pixelsWhere([](int, int) { return true; })) {
            const double u = (x + 0.5) / 8 - 1, v = (y + 0.5) / 8 - 1;
            const double angle = std::min(std::hypot(u, v) * degrees / 2, 180.0) * kPi / 180;
            const double around = std::atan2(v, u);
            const double expected[3] = {std::sin(angle) * std::cos(around),
                                        std::sin(angle) * std::sin(around), -std::cos(angle)};
            for (int k = 0; k < 3; ++k) EXPECT_NEAR(picture.at(x, y)[k], expected[k], 1e-5);
        }
    }
}

TEST_F(SampleShaders, TheAreaLightSendsWhatTheIntegralSays) {
    const RTuint light = sample("area_light", "AreaLight");
    set("corner", Vec3(-0.5f, -0.25f, 1));
    set("edge1", Vec3(0, 0.5f, 0)); // turned so that it shines along -z
    set("edge2", Vec3(1, 0, 0));
    set("radiance", Color(2.0f));
    set("cells", 16);
    const RTuint floor = builtin("DiffuseShader");
    rtUseLight(light);
    rectangle(floor, 0, 0, 16, 16, 0);
    const SmallPicture picture = render();
    expectReported(0);
    for (const auto& [x, y] : pixelsWhere([](int a, int b) { return a % 3 == 0 && b % 5 == 0; })) {
        const double px = (x + 0.5) / 8 - 1, py = (y + 0.5) / 8 - 1;
        constexpr int kSteps = 200;
        double sum = 0;
        for (int i = 0; i < kSteps; ++i)
            for (int j = 0; j < kSteps; ++j) {
                const double dx = -0.5 + (i + 0.5) / kSteps - px;
                const double dy = -0.25 + 0.5 * (j + 0.5) / kSteps - py;
                const double squared = dx * dx + dy * dy + 1;
                sum += 1 / (squared * squared); // both cosines are 1 / distance
            }
        const double expected = 2 * 0.5 * sum / (kSteps * kSteps) / kPi;
        EXPECT_NEAR(picture.at(x, y)[0] / expected, 1, 0.01) << x << ", " << y;
    }
    // Nothing behind it.
    rtUseLight(light);
    rectangle(floor, 0, 0, 16, 16, 1.5f);
    EXPECT_EQ(render().at(8, 8)[0], 0);
}

TEST_F(SampleShaders, OcclusionIsTheShareOfTheSkyThatIsHidden) {
    const RTuint object = sample("ambient_occlusion", "AmbientOcclusion");
    set("rays", 200);
    const RTuint floor = builtin("Phong");
    rtUseRenderingObject(object);
    rectangle(floor, 0, 0, 16, 16, 0);
    const SmallPicture open = render();
    for (const auto& [x, y] : pixelsWhere([](int, int) { return true; }))
        EXPECT_EQ(open.at(x, y)[0], 1);

    // A wall along x = -1, as good as endless: it hides (1 - d / sqrt(d^2 + h^2)) / 2 = 1/2.
    rtUseRenderingObject(object);
    rectangle(floor, 0, 0, 16, 16, 0);
    rtBegin(RT_QUADS);
    for (const auto& [y, z] : {std::pair{-1e4f, 0.0f}, {1e4f, 0.0f}, {1e4f, 1e4f}, {-1e4f, 1e4f}})
        rtVertex3f(-1, y, z);
    rtEnd();
    const SmallPicture walled = render();
    double mean = 0;
    for (const auto& [x, y] : pixelsWhere([](int, int) { return true; }))
        mean += walled.at(x, y)[0] / double(kPictureSize * kPictureSize);
    EXPECT_NEAR(mean, 0.5, 0.01); // 51,200 rays: a standard deviation of 0.0022
    expectReported(0);
}

TEST_F(SampleShaders, TheSkysZenithIsPreethams) {
    const RTuint camera = builtin("Orthographic");
    set("direction", Vec3(0, 1, 0));
    for (const double turbidity : {2.0, 4.0, 6.0})
        for (const double theta : {0.3, 0.8, 1.2}) {
            const RTuint sky = sample("sky", "Sky");
            set("sun", Vec3(float(std::sin(theta)), float(std::cos(theta)), 0));
            set("turbidity", turbidity);
            set("scale", 1.0f);
            rtUseCamera(camera);
            rtUseEnvironmentShader(sky);
            const SmallPicture picture = render();
            const float* p = picture.at(8, 8);
            const double t = turbidity, s = theta;
            const double chi = (4.0 / 9 - t / 120) * (kPi - 2 * s);
            const double luminance = (4.0453 * t - 4.9710) * std::tan(chi) - 0.2155 * t + 2.4192;
            const double powers[4] = {s * s * s, s * s, s, 1};
            const auto zenith = [&](const double (&m)[3][4]) {
                double sum = 0;
                for (int row = 0; row < 3; ++row)
                    for (int k = 0; k < 4; ++k) sum += std::pow(t, 2 - row) * m[row][k] * powers[k];
                return sum;
            };
            const double x = zenith({{0.00166, -0.00375, 0.00209, 0},
                                     {-0.02903, 0.06377, -0.03202, 0.00394},
                                     {0.11693, -0.21196, 0.06052, 0.25886}});
            const double y = zenith({{0.00275, -0.00610, 0.00317, 0},
                                     {-0.04214, 0.08970, -0.04153, 0.00516},
                                     {0.15346, -0.26756, 0.06670, 0.26688}});
            // What the colour shown has, by sRGB's primaries and white.
            const double bigX = 0.4124 * p[0] + 0.3576 * p[1] + 0.1805 * p[2];
            const double bigY = 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2];
            const double bigZ = 0.0193 * p[0] + 0.1192 * p[1] + 0.9505 * p[2];
            EXPECT_NEAR(bigY / luminance, 1, 2e-3);
            EXPECT_NEAR(bigX / (bigX + bigY + bigZ), x, 2e-3);
            EXPECT_NEAR(bigY / (bigX + bigY + bigZ), y, 2e-3);
        }
    expectReported(0);
}

TEST_F(SampleShaders, GlassLosesNoLightButWhatItAbsorbs) {
    rtRecursionLimit(256); // total reflection may hold a ray for long
    rtWeightCutoff(1e-5f);
    const RTuint white = own<White>("White");
    RTuint glass = sample("glass", "Glass");
    rtUseEnvironmentShader(white);
    ball(glass, 0.8, false);
    const SmallPicture furnace = render();
    expectReported(0);
    for (const auto& [x, y] : pixelsWhere([](int, int) { return true; })) {
        EXPECT_LE(furnace.at(x, y)[0], 1.0001f);
        EXPECT_GE(furnace.at(x, y)[0], 0.99f) << x << ", " << y;
    }
    // A slab of thickness d, looked at straight on, against the sum of all its reflections.
    const float index = 1.6f, absorption = 0.7f, d = 0.5f;
    glass = sample("glass", "Glass");
    set("index", index);
    set("absorption", Color(absorption, 0, 0));
    rtUseEnvironmentShader(white);
    for (const float z : {d, 0.0f}) {
        const float outward = z > 0 ? 1.0f : -1.0f;
        rtBindShader(glass);
        rtNormal3f(0, 0, outward);
        rtBegin(RT_QUADS);
        for (const auto& [x, y] : {std::pair{-9.0f, -9.0f}, {9.0f, -9.0f}, {9.0f, 9.0f},
                                   {-9.0f, 9.0f}})
            rtVertex3f(x * outward, y, z); // anticlockwise seen from outside
        rtEnd();
    }
    const SmallPicture slab = render();
    const double r = std::pow((index - 1.0) / (index + 1.0), 2), e = std::exp(-absorption * d);
    const double reflected = r + (1 - r) * (1 - r) * r * e * e / (1 - r * r * e * e);
    const double passed = (1 - r) * (1 - r) * e / (1 - r * r * e * e);
    EXPECT_NEAR(slab.at(5, 6)[0], reflected + passed, 1e-4);
    EXPECT_NEAR(slab.at(5, 6)[1], 1, 1e-4);
    expectReported(0);
}

TEST_F(SampleShaders, PacketsAndPointsAreEqualToTheBit) {
    const RTuint light = sun({0.3f, -0.4f, -1}, 0.7f), white = own<White>("White");
    const RTuint oneByOne = own<OneByOne>("OneByOne");
    for (const auto& [library, name] : {std::pair{"marble", "Marble"}, {"glass", "Glass"}}) {
        SCOPED_TRACE(name);
        const RTuint shader = sample(library, name);
        const auto picture = [&](bool packets) {
            rtUseLight(light);
            rtUseEnvironmentShader(white);
            if (!packets) rtUseRenderingObject(oneByOne);
            ball(shader, 0.7, true);
            rectangle(shader, 0, 0, 16, 16, -0.9f);
            return render();
        };
        EXPECT_EQ(differences(picture(true), picture(false)), PixelSet());
        expectReported(0);
    }
}

TEST_F(SampleShaders, AMatteBallInWhiteSurroundingsReflectsItsColour) {
    const RTuint paths = sample("path_tracer", "PathTracer");
    set("paths", 4);
    const RTuint matte = sample("path_tracer", "Matte");
    set("color", Color(0.5f, 0.25f, 1));
    const RTuint white = own<White>("White");
    rtUseRenderingObject(paths);
    rtUseEnvironmentShader(white);
    ball(matte, 0.8, false);
    const SmallPicture picture = render();
    // A convex body: each path meets the surroundings next, so there is no noise.
    for (int x = 6; x < 10; ++x) {
        EXPECT_NEAR(picture.at(x, 8)[0], 0.5, 1e-5);
        EXPECT_NEAR(picture.at(x, 8)[1], 0.25, 1e-5);
        EXPECT_NEAR(picture.at(x, 8)[2], 1, 1e-5);
    }
    EXPECT_EQ(picture.at(0, 0)[0], 1);
    expectReported(0);
}

TEST_F(SampleShaders, ToonHasAFewStepsAndAnOutline) {
    const RTuint toon = sample("toon", "Toon");
    set("steps", 4);
    set("color", Color(1.0f));
    rtUseLight(sun({1, -1, -1}, 1));
    rtClearColor(0, 0, 1, 1);
    ball(toon, 0.9, true);
    const SmallPicture picture = render();
    std::set<float> steps;
    for (const auto& [x, y] : pixelsWhere([](int, int) { return true; }))
        if (picture.at(x, y)[2] == picture.at(x, y)[0]) steps.insert(picture.at(x, y)[0]);
    EXPECT_GE(steps.size(), 4u);
    for (const float step : steps) {
        const bool known = step == 0 || step == 0.2f || step == 0.4f || step == 0.6f ||
                           step == 0.8f;
        EXPECT_TRUE(known) << step;
    }
    EXPECT_TRUE(steps.contains(0)) << "the outline";
    expectReported(0);
}

} // namespace
} // namespace smart::test

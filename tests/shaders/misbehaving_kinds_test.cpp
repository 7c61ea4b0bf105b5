// SPDX-License-Identifier: MIT
// Lights, environments, cameras and rendering objects that misbehave in a part of the picture.
#include <stdexcept>

#include "tests/shaders/misbehaving_surfaces.h"
#include "tests/shaders/shader_picture.h"

namespace smart::test {
namespace {

using namespace openrt;
using misbehaving::kInf;
using misbehaving::kMax;
using misbehaving::kNan;

const PixelSet kLeft = pixelsWhere([](int x, int) { return x < kPictureSize / 2; });
const PixelSet kRight = pixelsWhere([](int x, int) { return x >= kPictureSize / 2; });
const PixelSet kAll = pixelsWhere([](int, int) { return true; });

/// What goes wrong, by number; 0: nothing.
struct Fault {
    int number = 0;
    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<int>("fault", PER_SHADER, 0);
    }
};

class MisbehavingKinds : public ShaderPicture {
protected:
    MisbehavingKinds() {
        steady_ = constant({0.25f, 0.75f, 0.5f});
        lit_ = builtin("Phong");
        sun_ = builtin("DirectionalLight");
        set("radiance", Color(0.5f));
    }
    /// The left half asks no light, the right half asks them all.
    void halves() {
        rectangle(steady_, 0, 0, 8, 16, 0);
        rectangle(lit_, 8, 0, 16, 16, 0);
    }
    template <class T>
    static RTuint faulty(const char* name, int fault) {
        const RTuint shader = own<T>(name);
        set("fault", fault);
        return shader;
    }
    /// The pixels of `black` are, all others are as in the reference; `counted` or not.
    void check(const SmallPicture& picture, const SmallPicture& reference, const PixelSet& black,
               bool counted) {
        for (const auto& [x, y] : differences(picture, reference))
            EXPECT_TRUE(black.contains({x, y})) << x << ", " << y;
        EXPECT_EQ(blackPixels(picture), black);
        expectReported(counted ? black.size() : 0);
    }

    RTuint steady_, lit_, sun_;
};

struct Lamp : Fault {
    bool illuminate(const Vec3&, Vec3& direction, float& distance, Color& radiance) const {
        direction = {0, 0, 1};
        distance = kInf;
        radiance = Color(0.25f);
        switch (number) {
        case 1: throw std::runtime_error("dark");
        case 2: radiance.g = kNan; break;
        case 3: radiance.g = kInf; break;
        case 4: direction.x = kNan; break;
        case 5: direction = {}; break;
        case 6: direction.z = kInf; break;
        case 7: distance = kNan; break;
        case 8: distance = -1; break;
        case 9: return false;
        }
        return true;
    }
};

TEST_F(MisbehavingKinds, ALightCostsTheSurfacesThatAskIt) {
    const auto picture = [&](RTuint light) {
        rtUseLight(sun_);
        if (light) rtUseLight(light);
        halves();
        return render();
    };
    const SmallPicture without = picture(0);
    const SmallPicture with = picture(faulty<Lamp>("Lamp", 0));
    EXPECT_EQ(differences(with, without), kRight) << "the control: it shines";
    expectReported(0);
    for (const int fault : {1, 2, 3}) {
        SCOPED_TRACE(fault);
        check(picture(faulty<Lamp>("Lamp", fault)), without, kRight, true);
    }
    // Without a direction, or on the point itself: no light, or a fault.
    for (const int fault : {4, 5, 6, 7, 8, 9}) {
        SCOPED_TRACE(fault);
        const SmallPicture odd = picture(faulty<Lamp>("Lamp", fault));
        for (const auto& [x, y] : differences(odd, without))
            EXPECT_TRUE(kRight.contains({x, y})) << x << ", " << y;
        for (const float value : odd.values) EXPECT_TRUE(std::isfinite(value));
        expectReported(blackPixels(odd).size());
    }
    EXPECT_EQ(picture(0), without);
}

/// Asks all lights, and so itself.
struct AsksLights : Fault {
    bool illuminate(TraceContext& c, RTuint, RTuint, LightSample& sample) const {
        sample = {{0, 0, 1}, kInf, Color(0.25f)};
        if (number == 0) return true;
        LightSample other{};
        for (RTuint i = 0; i < c.lightCount(); ++i)
            if (c.illuminate(i, other)) sample.radiance += other.radiance;
        return true;
    }
};

TEST_F(MisbehavingKinds, ALightThatAsksTheLightsGetsNone) {
    const auto picture = [&](int fault) {
        rtUseLight(sun_);
        rtUseLight(faulty<AsksLights>("AsksLights", fault));
        rectangle(lit_, 0, 0, 9, 8, 0);
        rectangle(lit_, 12, 12, 13, 13, 0); // shaded by itself
        return render();
    };
    const SmallPicture reference = picture(0);
    EXPECT_GT(reference.at(12, 12)[0], 0);
    check(picture(1), reference, {}, false);
}

struct ManySamples : Fault {
    RTuint lightSamples() const {
        switch (number) {
        case 1: return 0;
        case 2: return ~0u;
        case 3: throw 1;
        default: return 2;
        }
    }
    bool illuminate(TraceContext&, RTuint i, RTuint n, LightSample& sample) const {
        if (number == 4) throw 1;
        sample = {{0, 0, 1}, kInf, Color(0.25f)};
        if (number == 5) sample.radiance = Color(kNan);
        return i < n;
    }
};

TEST_F(MisbehavingKinds, ALightOfManySamplesCostsTheSurfacesThatAskIt) {
    const auto picture = [&](RTuint light) {
        rtUseLight(sun_);
        if (light) rtUseLight(light);
        rectangle(steady_, 0, 0, 8, 16, 0);
        rectangle(lit_, 8, 0, 9, 4, 0); // few, as ~0u samples may be many
        return render();
    };
    const SmallPicture without = picture(0);
    const PixelSet asking = pixelsWhere([](int x, int y) { return x == 8 && y < 4; });
    for (const int fault : {0, 1, 2, 3, 4, 5}) {
        SCOPED_TRACE(fault);
        const SmallPicture result = picture(faulty<ManySamples>("ManySamples", fault));
        EXPECT_EQ(differences(result, without), asking);
        const bool bad = fault >= 4;
        for (const auto& [x, y] : asking) EXPECT_EQ(result.at(x, y)[0] == 0, bad);
        expectReported(bad ? asking.size() : 0);
    }
}

struct Eye : Fault {
    void initPrimaryRay(float x, float y, TraceContext& c) const {
        const Vec3 origin{2 * x - 1, 2 * y - 1, 5}, ahead{0, 0, -1};
        if (x > 0.5f) return c.setRay(origin, ahead);
        switch (number) {
        case 1: throw std::runtime_error("shut");
        case 2: return c.setRay({kNan, 0, 0}, ahead);
        case 3: return c.setRay({0, -kInf, 0}, ahead);
        case 4: return c.setRay(origin, {0, kNan, 0});
        case 5: return c.setRay(origin, {0, 0, 0});
        case 6: return c.setRay(origin, {0, 0, -kInf});
        case 7: return; // sets none
        case 8: return c.setRay(origin, ahead, 7, 3);
        case 9: return c.setRay(origin, ahead, kNan, kNan);
        case 10: return c.setRay(origin, ahead, -kInf, kInf);
        case 11: return c.setRay(origin, ahead * 1e-38f);
        case 12: return c.setRay(origin, ahead * kMax);
        }
        c.setRay(origin, ahead);
    }
};

TEST_F(MisbehavingKinds, ACameraCostsThePixelsWhoseRaysAreNone) {
    const auto picture = [&](int fault) {
        rtUseCamera(faulty<Eye>("Eye", fault));
        rtUseLight(sun_);
        halves();
        return render();
    };
    rtClearColor(0, 0, 0, 1);
    const SmallPicture reference = picture(0);
    EXPECT_TRUE(blackPixels(reference).empty());
    for (const int fault : {1, 2, 3, 4, 5, 6, 7}) {
        SCOPED_TRACE(fault);
        check(picture(fault), reference, kLeft, true);
    }
    for (const int fault : {8, 9}) { // nothing lies between such limits
        SCOPED_TRACE(fault);
        check(picture(fault), reference, kLeft, false);
    }
    for (const int fault : {10, 11, 12}) { // fine
        SCOPED_TRACE(fault);
        check(picture(fault), reference, {}, false);
    }
}

struct Surroundings : Fault {
    static constexpr ShaderKind kind = ShaderKind::Environment;
    void shade(TraceContext& c) const {
        const Vec3 d = c.rayDirection();
        c.setRadiance({0.5f, 0.5f + 0.25f * d.x, 0.75f});
        if (d.x > 0) return;
        switch (number) {
        case 1: throw 1;
        case 2: return c.setRadiance({kNan, 0, 0});
        case 3: return c.setRadiance({0, -kInf, 0});
        case 4: // asks itself, twice
            return c.setRadiance((c.environment(d) + c.environment(d)) * 0.5f);
        case 5: // traces, back to where only it is
            return c.setRadiance((c.trace({0, 0, 9}, d) + c.trace({0, 0, 9}, d)) * 0.5f);
        case 6: return c.setRadiance(c.environment({kNan, 0, 0}) + c.environment({0, 0, 0}));
        }
    }
};

TEST_F(MisbehavingKinds, AnEnvironmentCostsThePixelsThatShowIt) {
    rtMatrixMode(RT_PROJECTION);
    rtLoadIdentity();
    rtFrustum(-0.5, 0.5, -0.5, 0.5, 0.5, 100);
    rtMatrixMode(RT_MODELVIEW);
    const auto picture = [&](int fault) {
        rtUseEnvironmentShader(faulty<Surroundings>("Surroundings", fault));
        rectangle(steady_, 4, 4, 12, 12, -1); // half of the way to the picture's edges
        return render();
    };
    const PixelSet shown = pixelsWhere(
        [](int x, int y) { return x < 8 && !(x >= 4 && x < 12 && y >= 4 && y < 12); });
    const SmallPicture reference = picture(0);
    EXPECT_TRUE(blackPixels(reference).empty());
    for (const int fault : {1, 2, 3}) {
        SCOPED_TRACE(fault);
        check(picture(fault), reference, shown, true);
    }
    for (const int fault : {4, 5}) { // until the recursion limit; black beyond
        SCOPED_TRACE(fault);
        check(picture(fault), reference, shown, false);
    }
    const SmallPicture odd = picture(6);
    for (const auto& [x, y] : differences(odd, reference)) EXPECT_TRUE(shown.contains({x, y}));
    for (const float value : odd.values) EXPECT_TRUE(std::isfinite(value));
    expectReported(0);
}

struct Picturing : Fault {
    Color renderPixel(PixelContext& p) const {
        const Vec4 seen = p.trace({0.5f, 0.5f});
        const Color color(seen.x, seen.y, seen.z);
        if (p.x() >= RTuint(kPictureSize / 2)) return color;
        switch (number) {
        case 1: throw std::runtime_error("no more pixels");
        case 2: return Color(kNan);
        case 3: p.setAlpha(kNan); return color;
        case 4: // points outside all bounds
            p.trace({kNan, 0});
            return color;
        case 5:
            p.trace({0, -kInf});
            return color;
        case 6: // odd questions whose answers are not used
            for (const RTuint n : {0u, 1u, ~0u})
                for (const RTuint i : {0u, 1u, ~0u}) p.samplePosition(i, n);
            p.trace({1000, -1000});
            p.environment({kNan, 0, 0});
            for (int i = 0; i < 100; ++i) p.random();
            return color;
        case 7: // visits, and fails there
            p.visit({0.5f, 0.5f}, [](TraceContext&) { throw 1; });
            return color;
        case 8: // visits within a visit
            p.visit({0.5f, 0.5f}, [&](TraceContext&) {
                p.visit({0.25f, 0.25f}, [&](TraceContext& c) { c.trace(c.position(), {0, 0, 1}); });
            });
            return color;
        }
        return color;
    }
};
struct NeverTraces {
    Color renderPixel(PixelContext&) const { return {0.5f, 0.25f, 0.125f}; }
};

TEST_F(MisbehavingKinds, ARenderingObjectCostsThePixelsThatItLoses) {
    const auto picture = [&](int fault) {
        rtUseRenderingObject(faulty<Picturing>("Picturing", fault));
        rtUseLight(sun_);
        halves();
        return render();
    };
    const SmallPicture reference = picture(0);
    EXPECT_TRUE(blackPixels(reference).empty());
    for (const int fault : {1, 2, 3, 4, 5, 7}) {
        SCOPED_TRACE(fault);
        check(picture(fault), reference, kLeft, true);
    }
    for (const int fault : {6, 8}) {
        SCOPED_TRACE(fault);
        check(picture(fault), reference, {}, false);
    }
    rtUseRenderingObject(own<NeverTraces>("NeverTraces"));
    halves();
    const SmallPicture plain = render();
    for (const auto& [x, y] : kAll) EXPECT_EQ(plain.at(x, y)[1], 0.25f);
    expectReported(0);
}

} // namespace
} // namespace smart::test

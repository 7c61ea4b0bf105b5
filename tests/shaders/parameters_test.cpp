// SPDX-License-Identifier: MIT
// Parameters through the public interface: types, scopes, defaults, latching, interpolation,
// freezing.
#include <algorithm>
#include <cstring>
#include <functional>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "tests/shaders/shader_picture.h"

namespace smart::test {
namespace {

using namespace openrt;

class Parameters : public ShaderPicture {
protected:
    static RTuint handle(const char* name) { return rtParameterHandle(name); }
};

/// One parameter of each type that can be per shader; shows a hash of them all.
struct Typed {
    bool flag = false;
    int i1 = 1;
    Int2 i2{2, 3};
    Int3 i3{4, 5, 6};
    float f1 = 7;
    Vec2 f2{8, 9};
    Color f3{10, 11, 12};
    Vec4 f4{13, 14, 15, 16};
    Mat4 f16;
    struct Raw {
        unsigned char bytes[5] = {1, 2, 3, 4, 5};
    } raw;
    const char* text = "default";

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<bool>("flag", PER_SHADER, offsetof(Typed, flag));
        r.registerParam<int>("i1", PER_SHADER, offsetof(Typed, i1));
        r.registerParam<Int2>("i2", PER_SHADER, offsetof(Typed, i2));
        r.registerParam<Int3>("i3", PER_SHADER, offsetof(Typed, i3));
        r.registerParam<float>("f1", PER_SHADER, offsetof(Typed, f1));
        r.registerParam<Vec2>("f2", PER_SHADER, offsetof(Typed, f2));
        r.registerParam<Color>("f3", PER_SHADER, offsetof(Typed, f3));
        r.registerParam<Vec4>("f4", PER_SHADER, offsetof(Typed, f4));
        r.registerParam<Mat4>("f16", PER_SHADER, offsetof(Typed, f16));
        r.registerParam<Raw>("raw", PER_SHADER, offsetof(Typed, raw));
        r.registerParam<const char*>("text", PER_SHADER, offsetof(Typed, text));
    }
    float digest() const {
        unsigned hash = 2166136261u;
        const auto mix = [&](const void* data, std::size_t size) {
            for (std::size_t i = 0; i < size; ++i)
                hash = (hash ^ static_cast<const unsigned char*>(data)[i]) * 16777619u;
        };
        mix(&flag, sizeof flag), mix(&i1, sizeof i1), mix(&i2, sizeof i2), mix(&i3, sizeof i3);
        mix(&f1, sizeof f1), mix(&f2, sizeof f2), mix(&f3, sizeof f3), mix(&f4, sizeof f4);
        mix(&f16, sizeof f16), mix(&raw, sizeof raw), mix(text, std::strlen(text));
        return float(hash >> 8);
    }
    void shade(TraceContext& c) const { c.setRadiance(Color(digest())); }
};

/// A call that sets a parameter, and the parameter that it fits.
struct Setter {
    const char* fits; ///< space-separated names
    std::function<void(RTuint)> call;
};

bool fits(const Setter& setter, const char* name) {
    std::istringstream names(setter.fits);
    return std::find(std::istream_iterator<std::string>(names), {}, name) !=
           std::istream_iterator<std::string>();
}

const RTfloat kNumbers[16] = {31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46};

const std::vector<Setter> kSetters = {
    {"flag i1", [](RTuint h) { rtParameter1i(h, 31); }},
    {"i2", [](RTuint h) { rtParameter2i(h, 31, 32); }},
    {"i3", [](RTuint h) { rtParameter3i(h, 31, 32, 33); }},
    {"f1", [](RTuint h) { rtParameter1f(h, 31); }},
    {"f1", [](RTuint h) { rtParameter1fv(h, kNumbers); }},
    {"f2", [](RTuint h) { rtParameter2f(h, 31, 32); }},
    {"f2", [](RTuint h) { rtParameter2fv(h, kNumbers); }},
    {"f3", [](RTuint h) { rtParameter3f(h, 31, 32, 33); }},
    {"f3", [](RTuint h) { rtParameter3fv(h, kNumbers); }},
    {"f4", [](RTuint h) { rtParameter4f(h, 31, 32, 33, 34); }},
    {"f4", [](RTuint h) { rtParameter4fv(h, kNumbers); }},
    {"f16", [](RTuint h) { rtParameter16fv(h, kNumbers); }},
    {"raw", [](RTuint h) { rtParameterRaw(h, kNumbers, 5); }},
    {"", [](RTuint h) { rtParameterRaw(h, kNumbers, 4); }},
    {"", [](RTuint h) { rtParameterRaw(h, kNumbers, 64); }},
    {"", [](RTuint h) { rtParameterRaw(h, kNumbers, 0); }},
    {"text", [](RTuint h) { rtParameterString(h, "31"); }},
};

TEST_F(Parameters, OnlyTheDeclaredTypeIsAccepted) {
    const RTuint shader = own<Typed>("Typed");
    const auto shown = [&] {
        rectangle(shader, 0, 0, 16, 16, 0);
        return render().at(3, 3)[0];
    };
    const float defaults = Typed().digest();
    EXPECT_EQ(shown(), defaults);
    int fitting = 0;
    for (const char* name :
         {"flag", "i1", "i2", "i3", "f1", "f2", "f3", "f4", "f16", "raw", "text"}) {
        for (std::size_t i = 0; i < kSetters.size(); ++i) {
            SCOPED_TRACE(std::string(name) + ", setter " + std::to_string(i));
            rtBindShader(shader);
            const float before = shown();
            kSetters[i].call(handle(name));
            if (fits(kSetters[i], name)) {
                ++fitting;
                EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR));
            } else {
                EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_OPERATION));
                EXPECT_EQ(shown(), before) << "nothing was written";
            }
        }
    }
    EXPECT_EQ(fitting, 15);
    Typed all;
    all.flag = true;
    all.i1 = 31;
    all.i2 = {31, 32};
    all.i3 = {31, 32, 33};
    all.f1 = 31;
    all.f2 = {31, 32};
    all.f3 = {31, 32, 33};
    all.f4 = {31, 32, 33, 34};
    all.f16 = Mat4(kNumbers);
    std::memcpy(all.raw.bytes, kNumbers, 5);
    all.text = "31";
    EXPECT_EQ(shown(), all.digest());
    EXPECT_NE(all.digest(), defaults);
    rtBindShader(own<Typed>("Typed"));
    rtParameter1fv(handle("f1"), nullptr);
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_VALUE));
    rtParameterString(handle("text"), nullptr);
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_VALUE));
    rtParameterRaw(handle("raw"), nullptr, 5);
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_VALUE));
}

TEST_F(Parameters, HandlesGoByText) {
    const RTuint first = own<Typed>("Typed");
    const RTuint f1 = handle("f1");
    EXPECT_EQ(handle(std::string("f1").c_str()), f1) << "another address, the same text";
    for (const char* unknown : {"", "f", "F1", "f1 ", " f1", "f16x", "Typed", "shade"}) {
        EXPECT_EQ(handle(unknown), RT_INVALID) << unknown;
        EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_VALUE));
    }
    const RTuint phong = builtin("Phong");
    EXPECT_EQ(handle("f1"), RT_INVALID);
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_VALUE));
    rtParameter1f(f1, 99); // a handle of a class that is not bound
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_OPERATION));
    rtBindShaderClass(0);
    EXPECT_EQ(handle("f1"), RT_INVALID);
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_OPERATION));
    for (const RTuint wrong : {0u, f1 + 1000, RT_INVALID}) {
        rtBindShader(first);
        rtParameter1f(wrong, 1);
        EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_VALUE));
    }
    rtBindShader(phong);
    rtBindShader(first);
    rtParameter1f(f1, 99);
    expectNoError();
}

/// As many numbers as a vertex can have; shows three of them, or one of each triangle.
struct Interpolated {
    struct VertexParam {
        float first = 0.125f;
        Vec3 middle{0.25f, 0.25f, 0.25f};
        float more[251] = {};
        float last = 0.375f;
    };
    struct TriangleParam {
        int number = 77;
        Vec2 pair{0.5f, 0.625f};
    };
    int what = 0;

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<int>("what", PER_SHADER, offsetof(Interpolated, what));
        r.registerParam<int>("number", PER_TRIANGLE, offsetof(TriangleParam, number));
        r.registerParam<Vec2>("pair", PER_TRIANGLE, offsetof(TriangleParam, pair));
        r.registerParam<float>("first", PER_VERTEX, offsetof(VertexParam, first));
        r.registerParam<Vec3>("middle", PER_VERTEX, offsetof(VertexParam, middle));
        r.registerParam<float>("last", PER_VERTEX, offsetof(VertexParam, last));
    }
    void shade(TraceContext& c) const {
        const auto& vertex = c.vertexParam<VertexParam>();
        const auto& triangle = c.triangleParam<TriangleParam>();
        if (what == 0) c.setRadiance({vertex.first, vertex.middle.y, vertex.last});
        else c.setRadiance({float(triangle.number), triangle.pair.x, triangle.pair.y});
    }
};

struct DVec3 {
    double x, y, z;
    DVec3 operator-(const DVec3& b) const { return {x - b.x, y - b.y, z - b.z}; }
};
DVec3 cross(const DVec3& a, const DVec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double dot(const DVec3& a, const DVec3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

TEST_F(Parameters, VertexValuesFollowExactBarycentrics) {
    // In perspective, where weights are not linear on the screen; the object turned and moved by
    // exact numbers: x -> y, y -> -x, then half as large, then to z = -3.
    rtMatrixMode(RT_PROJECTION);
    rtLoadIdentity();
    rtFrustum(-1, 1, -1, 1, 1, 100);
    rtMatrixMode(RT_MODELVIEW);
    const RTuint shader = own<Interpolated>("Interpolated");
    const RTuint first = handle("first"), middle = handle("middle"), last = handle("last");
    const double corners[3][3] = {{-4, 5, 1}, {6, 3, -20}, {-2, -7, 4}};
    const float values[3][3] = {{1, 0, 0.25f}, {0, 2, 0.5f}, {0.5f, 0, 4}};
    const RTuint object = rtNewObject(RT_DEFINE);
    rtBegin(RT_TRIANGLES);
    for (int i = 0; i < 3; ++i) {
        rtParameter1f(first, values[i][0]);
        rtParameter3f(middle, 9, values[i][1], 9);
        rtParameter1f(last, values[i][2]);
        rtVertex3dv(corners[i]);
    }
    rtEnd();
    rtEndObject();
    const RTdouble matrix[16] = {0, 0.5, 0, 0, -0.5, 0, 0, 0, 0, 0, 0.5, 0, 0, 0, -3, 1};
    rtPushMatrix();
    rtMultMatrixd(matrix);
    const RTuint outer = rtNewObject(RT_DEFINE);
    rtInstantiateObject(object);
    rtEndObject();
    rtInstantiateObject(outer);
    rtPopMatrix();
    rtBindShader(shader);
    rtParameter1f(first, 1000); // set after the vertices: not theirs
    const SmallPicture picture = render();
    expectReported(0);

    DVec3 world[3];
    for (int i = 0; i < 3; ++i)
        world[i] = {-0.5 * corners[i][1], 0.5 * corners[i][0], 0.5 * corners[i][2] - 3};
    int hits = 0;
    for (const auto& [x, y] : pixelsWhere([](int, int) { return true; })) {
        const DVec3 ray{(x + 0.5) / 8 - 1, (y + 0.5) / 8 - 1, -1};
        double weight[3], sum = 0;
        for (int i = 0; i < 3; ++i) {
            weight[i] = dot(ray, cross(world[(i + 1) % 3], world[(i + 2) % 3]));
            sum += weight[i];
        }
        const bool inside = std::ranges::all_of(weight, [&](double w) { return w / sum > 0; });
        if (!inside) {
            EXPECT_EQ(picture.at(x, y)[0], 0);
            continue;
        }
        ++hits;
        for (int k = 0; k < 3; ++k) {
            double expected = 0;
            for (int i = 0; i < 3; ++i) expected += weight[i] / sum * values[i][k];
            EXPECT_NEAR(picture.at(x, y)[k], expected, 1e-6 * 4) << x << ", " << y;
        }
    }
    EXPECT_GT(hits, 60);
}

TEST_F(Parameters, TriangleValuesAreThoseAtTheirLastVertex) {
    // Every mode; each vertex has a number, and a triangle shows one of them.
    struct Mode {
        RTenum mode;
        std::vector<Vec2> vertices;
        std::vector<int> expected; ///< of the triangles in order
    };
    // Triangles lie in a row of unit squares; only the numbers matter.
    const std::vector<Vec2> zigzag = {{0, 0}, {0, 1}, {1, 0}, {1, 1}, {2, 0}, {2, 1}};
    const std::vector<Mode> modes = {
        {RT_TRIANGLES, {{0, 0}, {1, 0}, {0, 1}, {1, 0}, {1, 1}, {0, 1}}, {2, 5}},
        {RT_TRIANGLE_STRIP, zigzag, {2, 3, 4, 5}},
        {RT_TRIANGLE_FAN, {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}}, {2, 3, 4}},
        {RT_QUADS, {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {1, 0}, {2, 0}, {2, 1}, {1, 1}}, {3, 3, 7, 7}},
        {RT_QUAD_STRIP, zigzag, {3, 3, 5, 5}},
    };
    const RTuint shader = own<Interpolated>("Interpolated");
    set("what", 1);
    const RTuint number = handle("number");
    std::vector<unsigned> primitive(kPictureSize * kPictureSize);
    rtSetAuxBuffer(RT_PRIMITIVE_ID, primitive.data(), RT_UNSIGNED_INT);
    for (const Mode& each : modes) {
        SCOPED_TRACE(each.mode);
        rtBindShader(shader);
        rtBegin(each.mode);
        for (std::size_t i = 0; i < each.vertices.size(); ++i) {
            rtParameter1i(number, int(i));
            rtVertex2f(each.vertices[i].x - 1, each.vertices[i].y - 0.5f);
        }
        rtParameter1i(number, 1000); // too late
        rtEnd();
        const SmallPicture picture = render();
        expectNoError();
        std::set<unsigned> seen;
        for (const auto& [x, y] : pixelsWhere([](int, int) { return true; })) {
            const unsigned id = primitive[std::size_t(y * kPictureSize + x)];
            if (id == RT_INVALID) continue;
            seen.insert(id);
            EXPECT_EQ(picture.at(x, y)[0], float(each.expected.at(id)));
            EXPECT_EQ(picture.at(x, y)[1], 0.5f) << "not set: the default";
        }
        EXPECT_EQ(seen.size(), each.expected.size());
    }
}

TEST_F(Parameters, EachShaderHasItsOwnAndStartsWithTheDefaults) {
    const RTuint a = own<Interpolated>("Interpolated");
    rtParameter1f(handle("first"), 0.75f);
    set("what", 0);
    const RTuint b = rtGenNewShader(); // of the same class
    rectangle(a, 0, 0, 8, 16, 0);
    rectangle(b, 8, 0, 16, 16, 0);
    const SmallPicture picture = render();
    EXPECT_EQ(picture.at(2, 2)[0], 0.75f);
    EXPECT_EQ(picture.at(12, 2)[0], 0.125f);
    EXPECT_EQ(picture.at(2, 2)[2], 0.375f);
    // Values last: over frames, objects, and while other shaders are bound.
    rectangle(b, 0, 0, 8, 16, 0);
    rectangle(a, 8, 0, 16, 16, 0);
    EXPECT_EQ(render().at(12, 2)[0], 0.75f);
    // An object keeps what its vertices were given; only per-shader parameters bind late.
    const RTuint object = rtNewObject(RT_DEFINE);
    rectangle(a, 0, 0, 16, 16, 0);
    rtEndObject();
    rtBindShader(a);
    rtParameter1f(handle("first"), 3);
    set("what", 1);
    rtInstantiateObject(object);
    EXPECT_EQ(render().at(2, 2)[0], 77) << "per shader: as the frame starts";
    rtBindShader(a);
    set("what", 0);
    rtInstantiateObject(object);
    EXPECT_EQ(render().at(2, 2)[0], 0.75f) << "per vertex: as the vertex was given";
    expectReported(0);
}

TEST_F(Parameters, AFrameKeepsTheValuesWithWhichItStarted) {
    const RTuint shader = own<Typed>("Typed");
    set("text", std::string(100'000, 'a'));
    Typed expected;
    const std::string long_(100'000, 'a');
    expected.text = long_.c_str();
    const RTuint object = rtNewObject(RT_DEFINE);
    rectangle(shader, 0, 0, 16, 16, 0);
    rtEndObject();
    for (int frame = 0; frame < 8; ++frame) {
        rtBindShader(shader);
        set("i1", frame);
        rtInstantiateObject(object);
        rtStartRendering();
        // While it is rendered, or before.
        set("i1", -1);
        {
            std::string passing = "text number " + std::to_string(frame);
            set("text", passing);
            passing.assign(passing.size(), 'x');
        }
        rtEndRendering();
        expected.i1 = frame;
        EXPECT_EQ(shown().at(7, 7)[0], expected.digest()) << frame;
        set("text", long_);
    }
    expectReported(0);
}

} // namespace
} // namespace smart::test

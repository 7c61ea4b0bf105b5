// SPDX-License-Identifier: MIT
// openrt-gallery FOLDER [CLASS...]: the pictures of docs/builtin-shaders.md, one of each built-in
// shader class, as FOLDER/CLASS.png. The same pixels at every run.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "openrt/rt.hpp"
#include "samples/common/refuse_options.h"
#include "samples/common/write_png.h"

namespace {

using openrt::Color;
using openrt::Mat4;
using openrt::Vec3;
using openrt::Vec4;

constexpr RTuint kSide = 160;
constexpr double kPi = 3.14159265358979323846;

RTuint make(const char* shaderClass) {
    rtGenNewShaderClass(shaderClass, nullptr);
    return rtGenNewShader();
}
template <class T>
void set(const char* name, const T& value) {
    rtParameter(rtParameterHandle(name), value);
}

/// A texture made from a function of (x, y) in [0, 1).
template <class Function>
RTuint makeTexture(int width, int height, Function&& color) {
    std::vector<float> pixels;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Color c =
                color((float(x) + 0.5f) / float(width), (float(y) + 0.5f) / float(height));
            pixels.insert(pixels.end(), {c.r, c.g, c.b});
        }
    RTuint name = 0;
    rtGenTextures(1, &name);
    rtBindTexture(RT_TEXTURE_2D, name);
    rtTexParameteri(RT_TEXTURE_2D, RT_TEXTURE_MIN_FILTER, RT_LINEAR);
    rtTexImage2D(RT_TEXTURE_2D, 0, RT_RGB, width, height, 0, RT_RGB, RT_FLOAT, pixels.data());
    return name;
}
RTuint tiles() {
    static const RTuint texture = makeTexture(64, 64, [](float x, float y) {
        const bool odd = (int(x * 8) + int(y * 8)) % 2 != 0;
        return odd ? Color(0.75f, 0.72f, 0.65f) : Color(0.35f, 0.38f, 0.42f);
    });
    return texture;
}
RTuint sky() {
    static const RTuint texture = makeTexture(128, 64, [](float x, float y) {
        if (y < 0.5f) return Color(0.22f, 0.2f, 0.18f) * (0.6f + y);
        const float height = 2 * y - 1;
        const float ridge = 0.06f + 0.05f * std::sin(float(2 * kPi) * 3 * x) +
                            0.03f * std::sin(float(2 * kPi) * 7 * x);
        if (height < ridge) return Color(0.16f, 0.22f, 0.2f);
        return Color(0.85f, 0.85f, 0.8f) * (1 - height) + Color(0.2f, 0.42f, 0.8f) * height;
    });
    return texture;
}

/// `coloured`: by the direction from its centre, for surfaces that show the current colour.
void drawBall(const Vec3& center, float radius, bool coloured) {
    const int rings = 48, sectors = 96;
    rtColor3f(1, 1, 1);
    const auto point = [&](int ring, int sector) {
        const double polar = kPi * ring / rings, around = 2 * kPi * sector / sectors;
        const double x = std::sin(polar) * std::cos(around), y = std::cos(polar),
                     z = -std::sin(polar) * std::sin(around);
        rtNormal3d(x, y, z);
        rtTexCoord2d(2.0 * sector / sectors, 1.0 - double(ring) / rings);
        if (coloured) rtColor3d(0.5 + 0.5 * x, 0.5 + 0.5 * y, 0.5 + 0.5 * z);
        rtVertex3d(center.x + radius * x, center.y + radius * y, center.z + radius * z);
    };
    for (int ring = 0; ring < rings; ++ring) {
        rtBegin(RT_QUAD_STRIP);
        for (int sector = 0; sector <= sectors; ++sector) {
            point(ring, sector);
            point(ring + 1, sector);
        }
        rtEnd();
    }
}
void drawRectangle(const Vec3& corner, const Vec3& edge1, const Vec3& edge2, float tilesAcross) {
    const Vec3 normal = normalize(cross(edge1, edge2));
    const Vec3 corners[4] = {corner, corner + edge1, corner + edge1 + edge2, corner + edge2};
    const float st[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    rtColor3f(1, 1, 1);
    rtNormal(normal);
    rtBegin(RT_QUADS);
    for (int i = 0; i < 4; ++i) {
        rtTexCoord2f(tilesAcross * st[i][0], tilesAcross * st[i][1]);
        rtVertex(corners[i]);
    }
    rtEnd();
}

/// What a picture shows; the makers of a class's picture change what concerns them.
struct Picture {
    RTuint ball = 0, floor = 0, light = 0, camera = 0, environment = 0, renderingObject = 0;
    RTuint samples = 16;
    std::function<void()> more = [] {}; ///< draws what stands beside the ball
};

/// Points the bound pinhole or lens camera; `degrees`: angle of view.
void aim(const Vec3& eye, const Vec3& target, float degrees) {
    const Vec3 ahead = normalize(target - eye), right = normalize(cross(ahead, Vec3(0, 1, 0)));
    const Vec3 up = cross(right, ahead);
    const float half = float(std::tan(degrees * kPi / 360));
    set("origin", eye);
    set("lowerLeft", ahead - (right + up) * half);
    set("horizontal", right * (2 * half));
    set("vertical", up * (2 * half));
}
const Vec3 kEye(2.4f, 2.3f, 4.4f), kTarget(0, 0.85f, 0);

RTuint tiledFloor() {
    const RTuint floor = make("Phong");
    set("texture", int(tiles()));
    set("ambient", Color(0.2f));
    return floor;
}
Picture usual() {
    Picture p;
    p.floor = tiledFloor();
    p.ball = make("Phong");
    set("diffuse", Color(0.7f, 0.3f, 0.2f));
    set("ambient", Color(0.1f, 0.05f, 0.04f));
    set("specular", Color(0.4f));
    p.light = make("PointLight");
    set("position", Vec3(3, 5, 4));
    set("radiance", Color(32.0f));
    p.camera = make("Pinhole");
    aim(kEye, kTarget, 36);
    p.environment = make("ImageEnvironment");
    set("texture", int(sky()));
    return p;
}
Picture dark() { // nothing but the light of the class
    Picture p = usual();
    p.environment = make("ConstantEnvironment");
    rtBindShader(p.floor);
    set("ambient", Color());
    p.ball = make("Phong");
    return p;
}
void usePaths(Picture& p, int samples) {
    p.renderingObject = make("PathTracer");
    set("samples", samples);
}
Mat4 perspectiveMatrix(float degrees) {
    const float f = 1 / float(std::tan(degrees * kPi / 360)), n = 0.1f, far = 100;
    Mat4 m;
    m.m[0] = m.m[5] = f;
    m.m[10] = -(far + n) / (far - n);
    m.m[11] = -1;
    m.m[14] = -2 * far * n / (far - n);
    m.m[15] = 0;
    return m;
}
Mat4 lookAtMatrix(const Vec3& eye, const Vec3& target) {
    const Vec3 back = normalize(eye - target), right = normalize(cross(Vec3(0, 1, 0), back));
    const Vec3 up = cross(back, right), axes[3] = {right, up, back};
    Mat4 m;
    for (int row = 0; row < 3; ++row) {
        m.m[row] = axes[row].x;
        m.m[4 + row] = axes[row].y;
        m.m[8 + row] = axes[row].z;
        m.m[12 + row] = -dot(axes[row], eye);
    }
    return m;
}

struct Maker {
    const char* name;
    std::function<void(Picture&)> change;
    bool lit = true; ///< false: starts from dark()
};

const std::vector<Maker>& makers() {
    static const std::vector<Maker> all = {
        {"FixedFunction", [](Picture& p) { p.ball = 0; }},
        {"ConstantShader",
         [](Picture& p) {
             p.ball = make("ConstantShader");
             set("value", Color(0.9f, 0.6f, 0.1f));
         }},
        {"DiffuseShader",
         [](Picture& p) {
             p.ball = make("DiffuseShader");
             set("color", Color(0.3f, 0.6f, 0.3f));
         }},
        {"TexturedDiffuseShader",
         [](Picture& p) {
             p.ball = make("TexturedDiffuseShader");
             set("texture", int(tiles()));
             set("radiance", Color(0.15f));
         }},
        {"TextureShader",
         [](Picture& p) {
             p.ball = make("TextureShader");
             set("texture", int(tiles()));
         }},
        {"MirrorShader",
         [](Picture& p) {
             p.ball = make("MirrorShader");
             set("attenuation", Color(0.95f, 0.93f, 0.88f));
         }},
        {"Phong", [](Picture&) {}},
        {"MetallicRoughness",
         [](Picture& p) {
             p.ball = make("MetallicRoughness");
             set("baseColor", Vec4(1, 0.77f, 0.34f, 1));
             set("roughness", 0.25f);
             usePaths(p, 100);
         }},
        {"Glass",
         [](Picture& p) {
             p.ball = make("Glass");
             set("absorption", Color(0.35f, 0.08f, 0.1f));
         }},
        {"AmbientOcclusion",
         [](Picture& p) {
             p.ball = p.floor = make("AmbientOcclusion");
             set("samples", 36);
             p.more = [] { drawRectangle({-1.6f, 0, -3}, {0, 0, 6}, {0, 5, 0}, 1); };
         }},
        {"PointLight",
         [](Picture& p) {
             p.light = make("PointLight");
             set("position", Vec3(1.5f, 3, 1));
             set("radiance", Color(9, 8, 6));
         },
         false},
        {"SpotLightShader",
         [](Picture& p) {
             p.light = make("SpotLightShader");
             set("position", Vec3(2, 4, 1.5f));
             set("radiance", Color(16.0f));
             set("direction", Vec3(-2, -3.4f, -1.5f));
             set("cutoff", 19.0f);
             set("exponent", 8.0f);
         },
         false},
        {"PunctualLight",
         [](Picture& p) {
             p.light = make("PunctualLight");
             set("position", Vec3(2, 4, 1.5f));
             set("radiance", Color(20.0f));
             set("range", 7.0f);
             set("direction", Vec3(-2, -3.4f, -1.5f));
             set("cutoff", 22.0f);
             set("innerCutoff", 12.0f);
         },
         false},
        {"DirectionalLight",
         [](Picture& p) {
             p.light = make("DirectionalLight");
             set("direction", Vec3(-2, -3, -1));
         },
         false},
        {"QuadLight",
         [](Picture& p) {
             p.light = make("QuadLight");
             set("corner", Vec3(0.6f, 3, -0.4f));
             set("edge1", Vec3(0, 0, 1.6f));
             set("edge2", Vec3(-1.6f, 0.6f, 0));
             set("radiance", Color(9.0f));
             set("samples", 16);
             set("twoSided", true);
         },
         false},
        {"SphereLight",
         [](Picture& p) {
             p.light = make("SphereLight");
             set("center", Vec3(1.5f, 3, 1));
             set("radius", 0.6f);
             set("radiance", Color(24, 21, 16));
             set("samples", 16);
         },
         false},
        {"ConstantEnvironment",
         [](Picture& p) {
             p.environment = make("ConstantEnvironment");
             set("radiance", Color(0.4f, 0.6f, 0.9f));
             p.ball = make("MirrorShader");
         }},
        {"ImageEnvironment",
         [](Picture& p) {
             p.environment = make("ImageEnvironment");
             set("texture", int(sky()));
             set("rotation", 140.0f);
             p.ball = make("MirrorShader");
         }},
        {"PinholeCameraShader",
         [](Picture& p) {
             p.camera = make("PinholeCameraShader");
             aim({0.9f, 0.6f, 2.4f}, kTarget, 80);
         }},
        {"Pinhole",
         [](Picture& p) {
             p.camera = make("Pinhole");
             aim(kEye, kTarget, 36);
         }},
        {"Orthographic",
         [](Picture& p) {
             p.camera = make("Orthographic");
             const Vec3 ahead = normalize(kTarget - kEye);
             const Vec3 right = normalize(cross(ahead, Vec3(0, 1, 0))), up = cross(right, ahead);
             set("direction", ahead);
             set("lowerLeft", kEye - (right + up) * 1.8f);
             set("horizontal", right * 3.6f);
             set("vertical", up * 3.6f);
         }},
        {"ThinLens",
         [](Picture& p) {
             p.camera = make("ThinLens");
             aim(kEye, kTarget, 36);
             set("aperture", 0.35f);
             set("focusDistance", 4.3f);
             p.samples = 100;
         }},
        {"Panorama",
         [](Picture& p) {
             p.camera = make("Panorama");
             set("origin", Vec3(0.4f, 1.2f, 2.2f));
         }},
        {"Matrix",
         [](Picture& p) {
             p.camera = make("Matrix");
             set("projection", perspectiveMatrix(36));
             set("modelView", lookAtMatrix(kEye, kTarget));
         }},
        {"Default",
         [](Picture& p) {
             p.renderingObject = make("Default");
             p.samples = 1;
         }},
        {"Antialias", [](Picture& p) { p.renderingObject = make("Antialias"); }},
        {"PathTracer",
         [](Picture& p) {
             p.more = [] {
                 rtBindShader(make("DiffuseShader"));
                 set("color", Color(0.25f, 0.6f, 0.25f));
                 drawRectangle({-1.6f, 0, -3}, {0, 0, 6}, {0, 5, 0}, 1);
             };
             p.ball = make("DiffuseShader");
             set("color", Color(0.8f));
             p.light = make("SphereLight");
             set("center", Vec3(3, 5, 4));
             set("radius", 0.5f);
             set("radiance", Color(50.0f));
             set("samples", 1);
             usePaths(p, 256);
         }},
    };
    return all;
}

bool render(const Maker& maker, const std::string& folder) {
    std::vector<unsigned char> pixels(std::size_t(kSide) * kSide * 4);
    Picture p = maker.lit ? usual() : dark();
    maker.change(p);
    rtSetFrameBuffer(pixels.data(), kSide, kSide, RT_RGBA_8);
    rtSamples(p.samples);
    rtUseCamera(p.camera);
    rtUseLight(p.light);
    rtUseEnvironmentShader(p.environment);
    if (p.renderingObject) rtUseRenderingObject(p.renderingObject);
    rtBindShader(p.ball);
    drawBall({0, 1, 0}, 1, p.ball == 0);
    rtBindShader(p.floor);
    drawRectangle({-6, 0, 6}, {12, 0, 0}, {0, 0, -12}, 1.5f);
    p.more();
    rtRender();
    if (rtGetError() != RT_NO_ERROR) {
        std::fprintf(stderr, "%s: %s\n", maker.name, rtGetErrorText());
        return false;
    }
    for (std::size_t i = 3; i < pixels.size(); i += 4) pixels[i] = 255;
    const std::string path = folder + "/" + maker.name + ".png";
    return writePng(path.c_str(), pixels.data(), kSide, kSide) == 1;
}

} // namespace

int main(int argc, char* argv[]) {
    constexpr const char* kUsage = "openrt-gallery FOLDER [CLASS...]";
    rtInit(&argc, argv);
    refuseOptions(argc, argv, kUsage);
    if (argc < 2) {
        std::fprintf(stderr, "usage: %s\n", kUsage);
        return 2;
    }
    std::vector<Maker> wanted = argc == 2 ? makers() : std::vector<Maker>();
    for (int i = 2; i < argc; ++i) {
        const auto isNamed = [&](const Maker& maker) { return maker.name == std::string(argv[i]); };
        const auto found = std::find_if(makers().begin(), makers().end(), isNamed);
        if (found == makers().end()) {
            std::fprintf(stderr, "openrt-gallery: there is no class %s\n", argv[i]);
            return 2;
        }
        wanted.push_back(*found);
    }
    rtEnable(RT_FRAMEBUFFER_SRGB);
    const bool good = std::all_of(wanted.begin(), wanted.end(), [&](const Maker& maker) {
        return render(maker, argv[1]);
    });
    rtExit();
    return good ? 0 : 1;
}

/* SPDX-License-Identifier: MIT */
/* 06_shaders: five balls, each with a surface shader from a shader library, on a chequered floor,
 * under a sky and a shining rectangle that come from shader libraries too.
 * Usage: 06_shaders [OUTPUT.png | OUTPUT.pfm [FOLDER]]
 * FOLDER holds the libraries marble.so, glass.so, ...; without it the library looks where
 * OPENRT_SHADER_PATH says and in its own folder of shaders.
 *
 * A class is loaded by its name and its library's; a shader is a class with values. */

#include "openrt/rt.h"
#include "samples/common/refuse_options.h"
#include "samples/common/write_picture.h"

enum { kWidth = 640, kHeight = 360 };

static const char *folder;

/* A new shader of a class in a library, bound, for its parameters to be set. */
static RTuint load(const char *className, const char *library) {
    char path[1024];
    if (folder)
        snprintf(path, sizeof path, "%s/%s", folder, library);
    else
        snprintf(path, sizeof path, "%s", library);
    rtGenNewShaderClass(className, path);
    return rtGenNewShader();
}

static void set1f(const char *name, float x) { rtParameter1f(rtParameterHandle(name), x); }
static void set3f(const char *name, float x, float y, float z) {
    rtParameter3f(rtParameterHandle(name), x, y, z);
}

/* A ball with the bound shader. `heat`: handle of a parameter that each vertex is given, the
 * warmer the higher it lies, or 0. */
static void ball(double x, double y, double z, double radius, RTuint heat) {
    enum { kStacks = 48, kSlices = 96 };
    int i, j, side;
    for (i = 0; i < kStacks; ++i) {
        rtBegin(RT_QUAD_STRIP);
        for (j = 0; j <= kSlices; ++j)
            for (side = 0; side < 2; ++side) {
                const double pi = 3.14159265358979;
                const double latitude = pi * (i + side) / kStacks;
                const double longitude = 2 * pi * j / kSlices;
                const double nx = sin(latitude) * sin(longitude), ny = cos(latitude);
                const double nz = sin(latitude) * cos(longitude);
                if (heat) rtParameter1f(heat, (float)(0.5 + 0.5 * ny));
                rtNormal3d(nx, ny, nz);
                rtVertex3d(x + radius * nx, y + radius * ny, z + radius * nz);
            }
        rtEnd();
    }
}

static void floorOf(RTuint shader) {
    const float corners[4][2] = {{-20, 8}, {20, 8}, {20, -40}, {-20, -40}};
    int i;
    rtBindShader(shader);
    rtNormal3f(0, 1, 0);
    rtBegin(RT_QUADS);
    for (i = 0; i < 4; ++i) {
        rtTexCoord2f(corners[i][0] / 8, corners[i][1] / 8);
        rtVertex3f(corners[i][0], 0, corners[i][1]);
    }
    rtEnd();
}

int main(int argc, char *argv[]) {
    static float pixels[kWidth * kHeight * 3];
    int written = 0;
    RTuint heat;

    rtInit(&argc, argv);
    refuseOptions(argc, argv, "06_shaders [FILE [FOLDER]]");
    folder = argc > 2 ? argv[2] : NULL;

    rtMatrixMode(RT_PROJECTION);
    rtFrustum(-0.64, 0.64, -0.36, 0.36, 1.0, 100.0);
    rtMatrixMode(RT_MODELVIEW);
    rtLoadIdentity();
    rtRotatef(9, 1, 0, 0);
    rtTranslatef(0, -2.2f, -7.4f); /* from here on y = 0 is the floor */

    rtUseEnvironmentShader(load("Sky", "sky"));
    set3f("sun", 0.6f, 0.5f, -0.4f);
    set1f("scale", 0.04f);

    rtUseLight(load("AreaLight", "area_light"));
    set3f("corner", 1, 5, -3); /* in eye space: shader parameters go through no matrix */
    set3f("edge1", -3, 0, 0);
    set3f("edge2", 0, 0, -3);
    set3f("radiance", 22, 21, 19);

    floorOf(load("Checker", "checker"));

    load("Marble", "marble");
    set1f("veins", 3);
    ball(-3.6, 0.9, -1.2, 0.9, 0);

    load("Toon", "toon");
    rtParameter1i(rtParameterHandle("steps"), 3);
    ball(-1.8, 0.9, -0.4, 0.9, 0);

    load("Glass", "glass");
    set3f("absorption", 0.3f, 0.08f, 0.15f);
    ball(0.0, 0.9, 0.6, 0.9, 0);

    load("Heat", "heat");
    heat = rtParameterHandle("heat");
    ball(1.8, 0.9, -0.4, 0.9, heat);

    load("Wood", "wood");
    set1f("rings", 9);
    ball(3.6, 0.9, -1.2, 0.9, 0);

    rtSamples(4);
    rtSetFrameBuffer((RTubyte *)pixels, kWidth, kHeight, RT_RGB_32F);
    rtRender();

    if (rtGetError() != RT_NO_ERROR)
        fprintf(stderr, "06_shaders: %s\n", rtGetErrorText());
    else
        written = writePicture(argc > 1 ? argv[1] : "06_shaders.png", pixels, kWidth, kHeight);
    rtExit();
    return written ? 0 : 1;
}

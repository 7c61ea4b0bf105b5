/* SPDX-License-Identifier: MIT */
/* One sphere, compiled once, in a thousand places; every seventh with another shader; lit by a
 * point light that casts shadows. */
#include <math.h>
#include <stdlib.h>

#include "openrt/rt.h"
#include "samples/common/refuse_options.h"
#include "samples/common/write_png.h"

enum { kWidth = 800, kHeight = 600, kRings = 24, kSectors = 48, kSide = 10 };

static const double kPi = 3.14159265358979323846;

static void spherePoint(int ring, int sector) {
    const double polar = kPi * ring / kRings, around = 2.0 * kPi * sector / kSectors;
    const double x = sin(polar) * cos(around), y = cos(polar), z = sin(polar) * sin(around);
    rtNormal3d(x, y, z);
    rtVertex3d(x, y, z);
}

static RTuint makeSphere(void) {
    int ring, sector;
    const RTuint object = rtNewObject(RT_DEFINE);
    for (ring = 0; ring < kRings; ++ring) {
        rtBegin(RT_QUAD_STRIP);
        for (sector = 0; sector <= kSectors; ++sector) {
            spherePoint(ring, sector);
            spherePoint(ring + 1, sector);
        }
        rtEnd();
    }
    rtEndObject();
    return object;
}

static RTuint makePhong(float r, float g, float b) {
    const RTuint shader = rtGenNewShader();
    rtParameter3f(rtParameterHandle("diffuse"), r, g, b);
    rtParameter3f(rtParameterHandle("ambient"), 0.1f * r, 0.1f * g, 0.1f * b);
    return shader;
}

int main(int argc, char *argv[]) {
    RTubyte *pixels = malloc(4 * kWidth * kHeight);
    RTuint sphere, light, red, blue;
    RTenum error;
    int x, y, z, number = 0, written = 0;
    if (!pixels) return 1;

    rtInit(&argc, argv);
    refuseOptions(argc, argv, "02_instances [FILE]");
    rtSetFrameBuffer(pixels, kWidth, kHeight, RT_RGBA_8);
    rtEnable(RT_FRAMEBUFFER_SRGB);
    rtEnable(RT_MULTISAMPLE);
    rtClearColor(0.02f, 0.03f, 0.05f, 1.0f);

    rtGenNewShaderClass("PointLight", NULL);
    light = rtGenNewShader(); /* its position is in the space of the eye */
    rtParameter3f(rtParameterHandle("position"), 15.0f, 30.0f, 0.0f);
    rtParameter3f(rtParameterHandle("radiance"), 4500.0f, 4300.0f, 4000.0f);

    rtGenNewShaderClass("Phong", NULL);
    red = makePhong(0.8f, 0.2f, 0.15f);
    blue = makePhong(0.15f, 0.3f, 0.8f);
    rtBindShader(blue);
    sphere = makeSphere();

    rtMatrixMode(RT_PROJECTION);
    rtPerspective(40.0, (double)kWidth / kHeight, 0.1, 200.0);
    rtMatrixMode(RT_MODELVIEW);
    rtLookAt(26.0, 20.0, 42.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0);

    /* A frame: its light and its instances. */
    rtUseLight(light);
    for (x = 0; x < kSide; ++x) {
        for (y = 0; y < kSide; ++y) {
            for (z = 0; z < kSide; ++z) {
                rtPushMatrix();
                rtTranslated(3.0 * (x - 4.5), 3.0 * (y - 4.5), 3.0 * (z - 4.5));
                if (number++ % 7 == 0)
                    rtInstantiateObjectShader(sphere, red);
                else
                    rtInstantiateObject(sphere);
                rtPopMatrix();
            }
        }
    }
    rtRender();

    error = rtGetError();
    if (error != RT_NO_ERROR)
        fprintf(stderr, "02_instances: %s\n", rtGetErrorText());
    else
        written = writePng(argc > 1 ? argv[1] : "02_instances.png", pixels, kWidth, kHeight);
    rtExit();
    free(pixels);
    return written ? 0 : 1;
}

/* SPDX-License-Identifier: MIT */
/* 03_sphere: a smooth sphere under a point light. Usage: 03_sphere [OUTPUT.png | OUTPUT.pfm]
 *
 * A programmable surface (DiffuseShader) and a light (SpotLightShader, without a cone a point
 * light) by name; vertices with normals, so that a ball of triangles shades as a sphere.
 * A diffuse point shows colour * cos(angle to the light) * radiance / distance^2. */
#include <math.h>

#include "openrt/rt.h"
#include "samples/common/refuse_options.h"
#include "samples/common/write_picture.h"

enum { kWidth = 400, kHeight = 400, kStacks = 256, kSlices = 512 };

static void spherePoint(int stack, int slice) {
    const double pi = 3.14159265358979323846;
    const double latitude = pi * stack / kStacks, longitude = 2 * pi * (slice % kSlices) / kSlices;
    const double x = sin(latitude) * cos(longitude), y = cos(latitude),
                 z = sin(latitude) * sin(longitude);
    rtNormal3d(x, y, z);
    rtVertex3d(x, y, z);
}

static RTuint makeSphere(void) {
    const RTuint sphere = rtNewObject(RT_COMPILE);
    rtGenNewShaderClass("DiffuseShader", NULL);
    rtGenNewShader();
    rtParameter3f(rtParameterHandle("color"), 0.9f, 0.5f, 0.2f);
    for (int stack = 0; stack < kStacks; ++stack) {
        rtBegin(RT_QUAD_STRIP);
        for (int slice = 0; slice <= kSlices; ++slice) {
            spherePoint(stack, slice);
            spherePoint(stack + 1, slice);
        }
        rtEnd();
    }
    rtEndObject();
    return sphere;
}

static RTuint makeLight(void) {
    RTuint light;
    rtGenNewShaderClass("SpotLightShader", NULL);
    light = rtGenNewShader();
    rtParameter3f(rtParameterHandle("position"), 3.0f, 3.0f, -1.0f);
    rtParameter3f(rtParameterHandle("radiance"), 25.0f, 25.0f, 25.0f);
    return light;
}

int main(int argc, char *argv[]) {
    static float pixels[kWidth * kHeight * 3];
    int written = 0;
    RTuint sphere, light;

    rtInit(&argc, argv);
    refuseOptions(argc, argv, "03_sphere [FILE]");

    sphere = makeSphere();
    light = makeLight();

    rtMatrixMode(RT_PROJECTION);
    rtPerspective(40.0, (double)kWidth / kHeight, 0.1, 100.0);
    rtMatrixMode(RT_MODELVIEW);

    rtUseLight(light);
    rtTranslated(0.0, 0.0, -5.0);
    rtInstantiateObject(sphere);
    rtClearColor(0.0f, 0.0f, 0.0f, 1.0f);
    rtSetFrameBuffer((RTubyte *)pixels, kWidth, kHeight, RT_RGB_32F);
    rtRender();

    if (rtGetError() != RT_NO_ERROR)
        fprintf(stderr, "03_sphere: %s\n", rtGetErrorText());
    else
        written = writePicture(argc > 1 ? argv[1] : "03_sphere.png", pixels, kWidth, kHeight);
    rtExit();
    return written ? 0 : 1;
}

/* SPDX-License-Identifier: MIT */
/* 04_floor: a floor, a square that hangs over it, a point light and the shadow it casts.
 * Usage: 04_floor [OUTPUT.png | OUTPUT.pfm]
 *
 * The Phong surface sends shadow rays: its diffuse part is
 * colour * cos(angle to the light) * radiance / distance^2 where the light is seen, else nothing. */

#include "openrt/rt.h"
#include "samples/common/refuse_options.h"
#include "samples/common/write_picture.h"

enum { kWidth = 480, kHeight = 320 };

static RTuint makeSurface(float red, float green, float blue) {
    RTuint surface;
    rtGenNewShaderClass("Phong", NULL);
    surface = rtGenNewShader();
    rtParameter3f(rtParameterHandle("diffuse"), red, green, blue);
    return surface;
}

static void square(RTuint surface, double halfSize, double y) {
    rtBindShader(surface);
    rtBegin(RT_QUADS);
    rtVertex3d(-halfSize, y, halfSize);
    rtVertex3d(halfSize, y, halfSize);
    rtVertex3d(halfSize, y, -halfSize);
    rtVertex3d(-halfSize, y, -halfSize);
    rtEnd();
}

int main(int argc, char *argv[]) {
    static float pixels[kWidth * kHeight * 3];
    int written = 0;
    RTuint light, floorSurface, blockerSurface;

    rtInit(&argc, argv);
    refuseOptions(argc, argv, "04_floor [FILE]");

    rtGenNewShaderClass("PointLight", NULL);
    light = rtGenNewShader();
    rtParameter3f(rtParameterHandle("position"), 0.0f, 3.0f, -10.0f);
    rtParameter3f(rtParameterHandle("radiance"), 12.0f, 12.0f, 12.0f);
    floorSurface = makeSurface(0.7f, 0.8f, 0.9f);
    blockerSurface = makeSurface(0.9f, 0.2f, 0.2f);

    rtMatrixMode(RT_PROJECTION);
    rtFrustum(-0.75, 0.75, -0.5, 0.5, 1.0, 100.0);
    rtMatrixMode(RT_MODELVIEW);
    rtTranslated(0.0, 0.0, -10.0);

    rtUseLight(light);
    square(floorSurface, 20.0, -2.0);
    square(blockerSurface, 1.0, -0.5);
    rtSetFrameBuffer((RTubyte *)pixels, kWidth, kHeight, RT_RGB_32F);
    rtRender();

    if (rtGetError() != RT_NO_ERROR)
        fprintf(stderr, "04_floor: %s\n", rtGetErrorText());
    else
        written = writePicture(argc > 1 ? argv[1] : "04_floor.png", pixels, kWidth, kHeight);
    rtExit();
    return written ? 0 : 1;
}

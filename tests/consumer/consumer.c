/* SPDX-License-Identifier: MIT */
/* An application outside the project: renders a triangle in front of the clear colour. */
#include <openrt/rt.h>
#include <stdio.h>

int main(void) {
    float pixels[8 * 8 * 3];
    const float *centre = pixels + (4 * 8 + 4) * 3;
    rtInit(NULL, NULL);
    rtSetFrameBuffer((RTubyte *)pixels, 8, 8, RT_RGB_32F);
    rtBegin(RT_TRIANGLES);
    rtColor3f(0.25f, 0.5f, 1.0f);
    rtVertex3f(-0.5f, -0.5f, 0.0f);
    rtVertex3f(0.5f, -0.5f, 0.0f);
    rtVertex3f(0.0f, 0.5f, 0.0f);
    rtEnd();
    rtRender();
    printf("%s: %g %g %g\n", (const char *)rtGetString(RT_VERSION), centre[0], centre[1], centre[2]);
    return rtGetError() == RT_NO_ERROR && centre[0] == 0.25f && centre[1] == 0.5f &&
                   centre[2] == 1.0f && pixels[0] == 0.0f
               ? 0
               : 1;
}

/* SPDX-License-Identifier: MIT */
/* usage: shader_consumer CLASS FILE: prints the colour of a square with a shader of a library. */
#include <openrt/rt.h>
#include <stdio.h>

int main(int argc, char *argv[]) {
    float pixel[3];
    rtInit(NULL, NULL);
    rtSetFrameBuffer((RTubyte *)pixel, 1, 1, RT_RGB_32F);
    if (argc != 3 || rtGenNewShaderClass(argv[1], argv[2]) == RT_INVALID) {
        printf("%s\n", rtGetErrorText());
        return 1;
    }
    rtGenNewShader();
    rtBegin(RT_QUADS);
    rtVertex3f(-1, -1, 0);
    rtVertex3f(1, -1, 0);
    rtVertex3f(1, 1, 0);
    rtVertex3f(-1, 1, 0);
    rtEnd();
    rtRender();
    printf("%g %g %g\n", pixel[0], pixel[1], pixel[2]);
    return rtGetError() != RT_NO_ERROR;
}

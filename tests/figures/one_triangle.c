/* SPDX-License-Identifier: MIT */
/* One triangle in a small picture, and nothing else: what it costs to start. */
#include "openrt/rt.h"

enum { kSize = 64 };

int main(void) {
    static RTubyte pixels[kSize * kSize * 4];
    rtInit(0, 0);
    rtSetFrameBuffer(pixels, kSize, kSize, RT_RGBA_8);
    rtBegin(RT_TRIANGLES);
    rtVertex3f(-1, -1, 0);
    rtVertex3f(1, -1, 0);
    rtVertex3f(0, 1, 0);
    rtEnd();
    rtRender();
    return pixels[(kSize / 2 * kSize + kSize / 2) * 4] ? 0 : 1;
}

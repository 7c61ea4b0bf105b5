/* SPDX-License-Identifier: MIT */
/* The pictures of layer_scenes.inc, as OpenGL and as this library draw them. */
#ifndef OPENRT_TESTS_API_LAYER_SCENES_H
#define OPENRT_TESTS_API_LAYER_SCENES_H

#ifdef __cplusplus
extern "C" {
#endif

typedef struct LayerScene {
    const char *name; /* NULL behind the last */
    void (*draw)(void);
} LayerScene;

extern const LayerScene glLayerScenes[], rtLayerScenes[];

/* 64 x 64 pixels, from the bottom: red, green, blue, alpha; window depths. */
void glReadPicture(unsigned char *colors, float *depths);
void rtReadPicture(unsigned char *colors, float *depths);

#ifdef __cplusplus
}
#endif
#endif

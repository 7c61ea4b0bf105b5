/* SPDX-License-Identifier: MIT */
#ifndef OPENRT_TESTS_API_FIXED_FUNCTION_SCENES_H
#define OPENRT_TESTS_API_FIXED_FUNCTION_SCENES_H

enum { SCENE_SIDE = 96 };

/* What a scene has; numbers in it come from a seed. */
enum {
    SCENE_LIGHTS = 1 << 0,
    SCENE_LOCAL_VIEWER = 1 << 1,
    SCENE_TWO_SIDED = 1 << 2,
    SCENE_SEPARATE_SPECULAR = 1 << 3,
    SCENE_SPOTS = 1 << 4,
    SCENE_ATTENUATION = 1 << 5,
    SCENE_COLOR_MATERIAL = 1 << 6,
    SCENE_FOG = 1 << 7,
    SCENE_TEXTURE = 1 << 8,
    SCENE_TEXGEN = 1 << 9,
    SCENE_TEXTURE_MATRIX = 1 << 10,
    SCENE_FLAT = 1 << 11,
    SCENE_QUADS = 1 << 12,
    SCENE_ORTHO = 1 << 13,
    SCENE_TURNED = 1 << 14,
    SCENE_CLOCKWISE = 1 << 15,
    SCENE_RESCALE = 1 << 16,
    SCENE_LIST = 1 << 17,
    SCENE_NAMED_TEXTURE = 1 << 18,
    SCENE_MIPMAPS = 1 << 19,
    SCENE_FEATURES = 20
};

#ifdef __cplusplus
extern "C" {
#endif
void drawWithMesa(unsigned features, unsigned seed);
void drawWithLibrary(unsigned features, unsigned seed);
#ifdef __cplusplus
}
#endif

#endif

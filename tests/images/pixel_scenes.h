/* SPDX-License-Identifier: MIT */
/* Pictures of points, lines, edges, bitmaps and rectangles of pixels, by number: compiled once with
 * OpenGL's headers, once with openrt/gl.h. */
#ifndef TESTS_IMAGES_PIXEL_SCENES_H
#define TESTS_IMAGES_PIXEL_SCENES_H

#ifdef __cplusplus
extern "C" {
#endif

enum { PIXEL_SCENE_WIDTH = 96, PIXEL_SCENE_HEIGHT = 72 };

enum PixelScene {
    SCENE_POINTS, /* parameter: size */
    SCENE_POINTS_AT_BORDERS,
    SCENE_STAR, /* parameter: width of the lines */
    SCENE_RANDOM_LINES, /* parameter: width */
    SCENE_STIPPLE, /* parameter: factor */
    SCENE_STRIP_AND_LOOP,
    SCENE_SHADED_LINES,
    SCENE_CUBE_EDGES, /* hidden lines by depth */
    SCENE_SPHERE_EDGES,
    SCENE_EDGE_FLAGS,
    SCENE_FACE_MODES,
    SCENE_POLYGON_POINTS,
    SCENE_CLIP_PLANE,
    SCENE_NEAR_PLANE,
    SCENE_BITMAPS,
    SCENE_DRAW_PIXELS, /* parameter: which zoom */
    SCENE_FOGGED_LIT_LINES,
    SCENE_ORDER, /* lines, a bitmap and triangles over each other without depth test */
    SCENE_LISTS
};

void drawPixelSceneOpenGl(enum PixelScene scene, int parameter);
void drawPixelSceneOpenRt(enum PixelScene scene, int parameter);

#ifdef __cplusplus
}
#endif

#endif

/* SPDX-License-Identifier: MIT */
/* State that can be asked for: taken as a whole before and after a call, so that everything that
 * the call changed is told, and that a wrong call which changed something is found out. */
#ifndef OPENRT_CONFORMANCE_KNOWN_STATE_H
#define OPENRT_CONFORMANCE_KNOWN_STATE_H

#include "tests/conformance/questions.h"

enum { kStateRoom = 1024 };

typedef struct {
    double values[kStateRoom];
    const char* names[kStateRoom];
    int count;
} KnownState;

static double* roomFor(KnownState* known, const char* name, int count) {
    double* const room = known->values + known->count;
    if (known->count + count > kStateRoom) abort();
    for (int i = 0; i < count; ++i) known->names[known->count++] = name;
    return room;
}

typedef struct {
    const char* name;
    GLenum state;
    int count;
} Query;

#define QUERY(state, count) \
    { #state, state, count }

static const Query kQueries[] = {QUERY(GL_CURRENT_COLOR, 4),
                                 QUERY(GL_CURRENT_NORMAL, 3),
                                 QUERY(GL_CURRENT_TEXTURE_COORDS, 4),
                                 QUERY(GL_CURRENT_SECONDARY_COLOR, 3),
                                 QUERY(GL_CURRENT_FOG_COORDINATE, 1),
                                 QUERY(GL_EDGE_FLAG, 1),
                                 QUERY(GL_CURRENT_RASTER_POSITION, 4),
                                 QUERY(GL_CURRENT_RASTER_POSITION_VALID, 1),
                                 QUERY(GL_CURRENT_RASTER_COLOR, 4),
                                 QUERY(GL_CURRENT_RASTER_TEXTURE_COORDS, 4),
                                 QUERY(GL_MATRIX_MODE, 1),
                                 QUERY(GL_MODELVIEW_MATRIX, 16),
                                 QUERY(GL_PROJECTION_MATRIX, 16),
                                 QUERY(GL_TEXTURE_MATRIX, 16),
                                 QUERY(GL_MODELVIEW_STACK_DEPTH, 1),
                                 QUERY(GL_PROJECTION_STACK_DEPTH, 1),
                                 QUERY(GL_TEXTURE_STACK_DEPTH, 1),
                                 QUERY(GL_ATTRIB_STACK_DEPTH, 1),
                                 QUERY(GL_CLIENT_ATTRIB_STACK_DEPTH, 1),
                                 QUERY(GL_VIEWPORT, 4),
                                 QUERY(GL_DEPTH_RANGE, 2),
                                 QUERY(GL_SCISSOR_BOX, 4),
                                 QUERY(GL_SCISSOR_TEST, 1),
                                 QUERY(GL_FOG_COLOR, 4),
                                 QUERY(GL_FOG_DENSITY, 1),
                                 QUERY(GL_FOG_START, 1),
                                 QUERY(GL_FOG_END, 1),
                                 QUERY(GL_FOG_MODE, 1),
                                 QUERY(GL_FOG_COORDINATE_SOURCE, 1),
                                 QUERY(GL_FOG, 1),
                                 QUERY(GL_COLOR_SUM, 1),
                                 QUERY(GL_SHADE_MODEL, 1),
                                 QUERY(GL_LIGHTING, 1),
                                 QUERY(GL_LIGHT0, 1),
                                 QUERY(GL_NORMALIZE, 1),
                                 QUERY(GL_RESCALE_NORMAL, 1),
                                 QUERY(GL_COLOR_MATERIAL, 1),
                                 QUERY(GL_COLOR_MATERIAL_FACE, 1),
                                 QUERY(GL_COLOR_MATERIAL_PARAMETER, 1),
                                 QUERY(GL_LIGHT_MODEL_AMBIENT, 4),
                                 QUERY(GL_LIGHT_MODEL_LOCAL_VIEWER, 1),
                                 QUERY(GL_LIGHT_MODEL_TWO_SIDE, 1),
                                 QUERY(GL_LIGHT_MODEL_COLOR_CONTROL, 1),
                                 QUERY(GL_POINT_SIZE, 1),
                                 QUERY(GL_POINT_SIZE_MIN, 1),
                                 QUERY(GL_POINT_FADE_THRESHOLD_SIZE, 1),
                                 QUERY(GL_POINT_DISTANCE_ATTENUATION, 3),
                                 QUERY(GL_POINT_SMOOTH, 1),
                                 QUERY(GL_LINE_WIDTH, 1),
                                 QUERY(GL_LINE_SMOOTH, 1),
                                 QUERY(GL_LINE_STIPPLE, 1),
                                 QUERY(GL_LINE_STIPPLE_PATTERN, 1),
                                 QUERY(GL_LINE_STIPPLE_REPEAT, 1),
                                 QUERY(GL_CULL_FACE, 1),
                                 QUERY(GL_CULL_FACE_MODE, 1),
                                 QUERY(GL_FRONT_FACE, 1),
                                 QUERY(GL_POLYGON_SMOOTH, 1),
                                 QUERY(GL_POLYGON_MODE, 2),
                                 QUERY(GL_POLYGON_OFFSET_FACTOR, 1),
                                 QUERY(GL_POLYGON_OFFSET_UNITS, 1),
                                 QUERY(GL_POLYGON_OFFSET_FILL, 1),
                                 QUERY(GL_POLYGON_STIPPLE, 1),
                                 QUERY(GL_MULTISAMPLE, 1),
                                 QUERY(GL_SAMPLE_COVERAGE_VALUE, 1),
                                 QUERY(GL_SAMPLE_COVERAGE_INVERT, 1),
                                 QUERY(GL_TEXTURE_1D, 1),
                                 QUERY(GL_TEXTURE_2D, 1),
                                 QUERY(GL_TEXTURE_BINDING_1D, 1),
                                 QUERY(GL_TEXTURE_BINDING_2D, 1),
                                 QUERY(GL_TEXTURE_GEN_S, 1),
                                 QUERY(GL_TEXTURE_GEN_Q, 1),
                                 QUERY(GL_ALPHA_TEST, 1),
                                 QUERY(GL_ALPHA_TEST_FUNC, 1),
                                 QUERY(GL_ALPHA_TEST_REF, 1),
                                 QUERY(GL_STENCIL_FUNC, 1),
                                 QUERY(GL_STENCIL_REF, 1),
                                 QUERY(GL_STENCIL_FAIL, 1),
                                 QUERY(GL_STENCIL_PASS_DEPTH_FAIL, 1),
                                 QUERY(GL_STENCIL_PASS_DEPTH_PASS, 1),
                                 QUERY(GL_STENCIL_CLEAR_VALUE, 1),
                                 QUERY(GL_DEPTH_TEST, 1),
                                 QUERY(GL_DEPTH_FUNC, 1),
                                 QUERY(GL_DEPTH_WRITEMASK, 1),
                                 QUERY(GL_DEPTH_CLEAR_VALUE, 1),
                                 QUERY(GL_BLEND, 1),
                                 QUERY(GL_BLEND_SRC_RGB, 1),
                                 QUERY(GL_BLEND_SRC_ALPHA, 1),
                                 QUERY(GL_BLEND_DST_RGB, 1),
                                 QUERY(GL_BLEND_DST_ALPHA, 1),
                                 QUERY(GL_BLEND_EQUATION, 1),
                                 QUERY(GL_BLEND_COLOR, 4),
                                 QUERY(GL_DITHER, 1),
                                 QUERY(GL_COLOR_LOGIC_OP, 1),
                                 QUERY(GL_LOGIC_OP_MODE, 1),
                                 QUERY(GL_COLOR_WRITEMASK, 4),
                                 QUERY(GL_COLOR_CLEAR_VALUE, 4),
                                 QUERY(GL_ACCUM_CLEAR_VALUE, 4),
                                 QUERY(GL_UNPACK_SWAP_BYTES, 1),
                                 QUERY(GL_UNPACK_LSB_FIRST, 1),
                                 QUERY(GL_UNPACK_ROW_LENGTH, 1),
                                 QUERY(GL_UNPACK_SKIP_ROWS, 1),
                                 QUERY(GL_UNPACK_SKIP_PIXELS, 1),
                                 QUERY(GL_UNPACK_ALIGNMENT, 1),
                                 QUERY(GL_PACK_SWAP_BYTES, 1),
                                 QUERY(GL_PACK_LSB_FIRST, 1),
                                 QUERY(GL_PACK_ROW_LENGTH, 1),
                                 QUERY(GL_PACK_SKIP_ROWS, 1),
                                 QUERY(GL_PACK_SKIP_PIXELS, 1),
                                 QUERY(GL_PACK_ALIGNMENT, 1),
                                 QUERY(GL_RED_SCALE, 1),
                                 QUERY(GL_RED_BIAS, 1),
                                 QUERY(GL_ALPHA_SCALE, 1),
                                 QUERY(GL_ALPHA_BIAS, 1),
                                 QUERY(GL_ZOOM_X, 1),
                                 QUERY(GL_ZOOM_Y, 1),
                                 QUERY(GL_LIST_BASE, 1),
                                 QUERY(GL_LIST_INDEX, 1),
                                 QUERY(GL_RENDER_MODE, 1),
                                 QUERY(GL_VERTEX_ARRAY, 1),
                                 QUERY(GL_VERTEX_ARRAY_SIZE, 1),
                                 QUERY(GL_VERTEX_ARRAY_STRIDE, 1),
                                 QUERY(GL_NORMAL_ARRAY, 1),
                                 QUERY(GL_NORMAL_ARRAY_STRIDE, 1),
                                 QUERY(GL_COLOR_ARRAY, 1),
                                 QUERY(GL_COLOR_ARRAY_SIZE, 1),
                                 QUERY(GL_COLOR_ARRAY_STRIDE, 1),
                                 QUERY(GL_TEXTURE_COORD_ARRAY, 1),
                                 QUERY(GL_TEXTURE_COORD_ARRAY_SIZE, 1),
                                 QUERY(GL_TEXTURE_COORD_ARRAY_STRIDE, 1),
                                 QUERY(GL_EDGE_FLAG_ARRAY, 1),
                                 QUERY(GL_SECONDARY_COLOR_ARRAY, 1),
                                 QUERY(GL_FOG_COORDINATE_ARRAY, 1),
                                 QUERY(GL_ARRAY_BUFFER_BINDING, 1),
                                 QUERY(GL_ELEMENT_ARRAY_BUFFER_BINDING, 1),
                                 QUERY(GL_FOG_HINT, 1),
                                 QUERY(GL_PERSPECTIVE_CORRECTION_HINT, 1),
                                 QUERY(GL_CLIP_PLANE0, 1),
                                 QUERY(GL_CLIP_PLANE5, 1)};

enum { kQueryCount = sizeof kQueries / sizeof kQueries[0] };

static void takeState(KnownState* known) {
    GLfloat values[16] = {0};
    known->count = 0;
    for (int i = 0; i < kQueryCount; ++i)
        glGetDoublev(kQueries[i].state, roomFor(known, kQueries[i].name, kQueries[i].count));
#define TAKE(call, name, n)                          \
    call;                                            \
    for (int k = 0; k < (n); ++k) *roomFor(known, name, 1) = (double)values[k]
    TAKE(glGetLightfv(GL_LIGHT0, GL_AMBIENT, values), "light ambient", 4);
    TAKE(glGetLightfv(GL_LIGHT0, GL_DIFFUSE, values), "light diffuse", 4);
    TAKE(glGetLightfv(GL_LIGHT0, GL_SPECULAR, values), "light specular", 4);
    TAKE(glGetLightfv(GL_LIGHT0, GL_POSITION, values), "light position", 4);
    TAKE(glGetLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, values), "spot direction", 3);
    TAKE(glGetLightfv(GL_LIGHT0, GL_SPOT_EXPONENT, values), "spot exponent", 1);
    TAKE(glGetLightfv(GL_LIGHT0, GL_SPOT_CUTOFF, values), "spot cutoff", 1);
    TAKE(glGetLightfv(GL_LIGHT0, GL_CONSTANT_ATTENUATION, values), "constant attenuation", 1);
    TAKE(glGetLightfv(GL_LIGHT0, GL_LINEAR_ATTENUATION, values), "linear attenuation", 1);
    TAKE(glGetLightfv(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, values), "quadratic attenuation", 1);
    TAKE(glGetMaterialfv(GL_FRONT, GL_AMBIENT, values), "front ambient", 4);
    TAKE(glGetMaterialfv(GL_FRONT, GL_DIFFUSE, values), "front diffuse", 4);
    TAKE(glGetMaterialfv(GL_FRONT, GL_SHININESS, values), "front shininess", 1);
    TAKE(glGetMaterialfv(GL_BACK, GL_SPECULAR, values), "back specular", 4);
    TAKE(glGetMaterialfv(GL_BACK, GL_EMISSION, values), "back emission", 4);
    TAKE(glGetTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, values), "texture environment", 1);
    TAKE(glGetTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, values), "environment colour", 4);
    TAKE(glGetTexEnvfv(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, values), "lod bias", 1);
    TAKE(glGetTexGenfv(GL_S, GL_TEXTURE_GEN_MODE, values), "generation of s", 1);
    TAKE(glGetTexGenfv(GL_S, GL_OBJECT_PLANE, values), "object plane of s", 4);
    TAKE(glGetTexGenfv(GL_T, GL_EYE_PLANE, values), "eye plane of t", 4);
    TAKE(glGetTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, values), "min filter", 1);
    TAKE(glGetTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, values), "mag filter", 1);
    TAKE(glGetTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, values), "wrap of s", 1);
    TAKE(glGetTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, values), "wrap of t", 1);
    TAKE(glGetTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, values), "border colour", 4);
    TAKE(glGetTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, values), "max level", 1);
    TAKE(glGetTexLevelParameterfv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, values), "width", 1);
    TAKE(glGetTexLevelParameterfv(GL_TEXTURE_2D, 0, GL_TEXTURE_HEIGHT, values), "height", 1);
    TAKE(glGetTexLevelParameterfv(GL_TEXTURE_1D, 0, GL_TEXTURE_WIDTH, values), "width, 1D", 1);
#undef TAKE
    glGetClipPlane(GL_CLIP_PLANE0, roomFor(known, "clip plane", 4));
}

/* Names and new values of what has changed. */
static void tellChanges(const KnownState* before, const KnownState* after) {
    for (int i = 0; i < before->count; ++i)
        if (before->values[i] != after->values[i])
            printf("  %s %.7g\n", after->names[i], after->values[i]);
}

static int isSame(const KnownState* before, const KnownState* after) {
    for (int i = 0; i < before->count; ++i)
        if (before->values[i] != after->values[i]) return 0;
    return 1;
}

#endif

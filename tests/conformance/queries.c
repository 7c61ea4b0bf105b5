/* SPDX-License-Identifier: MIT */
/* The state of OpenGL 1.5's tables 6.5 to 6.37, by each of the four kinds of query: at the start,
 * after a call that sets it, and after the attribute stacks have brought it back. What belongs to
 * an implementation is compared with the least that OpenGL wants. */
#define GL_GLEXT_PROTOTYPES
#include "tests/conformance/questions.h"

enum { kMostValues = 16 };

static void tellDoubles(const GLdouble* values, int count) {
    for (int i = 0; i < count; ++i) printf("%.7g ", values[i]);
    printf("\n");
}

/* Mesa converts matrices to integers as if they were colours. */
static void tellMatrix(GLenum state) {
    GLfloat floats[kMostValues] = {0};
    GLdouble doubles[kMostValues] = {0};
    glGetFloatv(state, floats);
    glGetDoublev(state, doubles);
    for (int i = 0; i < kMostValues; ++i) printf("%.7g ", (double)floats[i]);
    printf("\n");
    tellDoubles(doubles, kMostValues);
    tellError();
}

static void tellAll(GLenum state, int count) {
    GLboolean booleans[kMostValues] = {0};
    GLint integers[kMostValues] = {0};
    GLfloat floats[kMostValues] = {0};
    GLdouble doubles[kMostValues] = {0};
    glGetBooleanv(state, booleans);
    glGetIntegerv(state, integers);
    glGetFloatv(state, floats);
    glGetDoublev(state, doubles);
    for (int i = 0; i < count; ++i) printf("%d ", booleans[i]);
    printf("\n");
    for (int i = 0; i < count; ++i) printf("%d ", integers[i]);
    printf("\n");
    for (int i = 0; i < count; ++i) printf("%.7g ", (double)floats[i]);
    printf("\n");
    tellDoubles(doubles, count);
    tellError();
}

#define NAMED_STATE(name, state, count, change)                \
    beginCase(name);                                           \
    tellAll(state, count);                                     \
    glPushClientAttrib((GLbitfield)GL_CLIENT_ALL_ATTRIB_BITS); \
    glPushAttrib(GL_ALL_ATTRIB_BITS);                          \
    change;                                                    \
    tellAll(state, count);                                     \
    glPopAttrib();                                             \
    glPopClientAttrib();                                       \
    tellAll(state, count)

#define STATE(state, count, change) NAMED_STATE(#state, state, count, change)

#define SWITCH(state)                                \
    NAMED_STATE(#state, state, 1, glEnable(state));  \
    glPushAttrib(GL_ALL_ATTRIB_BITS);                \
    glEnable(state);                                 \
    printf("%d\n", glIsEnabled(state));              \
    glDisable(state);                                \
    printf("%d\n", glIsEnabled(state));              \
    glPopAttrib();                                   \
    tellError()

#define MATRIX(state)     \
    beginCase(#state);    \
    tellMatrix(state);    \
    glLoadMatrixf(matrix); \
    tellMatrix(state)

static const GLfloat color[4] = {0.2f, 0.4f, 0.8f, 0.6f};
static GLubyte memory[256];

static void currentValues(void) {
    STATE(GL_CURRENT_COLOR, 4, glColor4fv(color));
    STATE(GL_CURRENT_SECONDARY_COLOR, 3, glSecondaryColor3f(0.2f, 0.4f, 0.8f));
    STATE(GL_CURRENT_NORMAL, 3, glNormal3f(0.6f, 0.0f, 0.8f));
    STATE(GL_CURRENT_TEXTURE_COORDS, 4, glTexCoord4f(0.25f, 3.0f, -2.0f, 7.0f));
    STATE(GL_CURRENT_FOG_COORDINATE, 1, glFogCoordf(3.25f));
    STATE(GL_EDGE_FLAG, 1, glEdgeFlag(GL_FALSE));
    STATE(GL_CURRENT_RASTER_POSITION, 4, glRasterPos3f(0.25f, -0.5f, 0.125f));
    STATE(GL_CURRENT_RASTER_POSITION_VALID, 1, glRasterPos2f(5.0f, 5.0f));
    STATE(GL_CURRENT_RASTER_COLOR, 4, (glColor4fv(color), glRasterPos2f(0.0f, 0.0f)));
    STATE(GL_CURRENT_RASTER_TEXTURE_COORDS, 4,
          (glTexCoord2f(0.25f, 0.75f), glRasterPos2f(0.0f, 0.0f)));
    STATE(GL_CURRENT_RASTER_DISTANCE, 1, glRasterPos3f(0.0f, 0.0f, -0.5f));
    STATE(GL_VERTEX_ARRAY_SIZE, 1, glVertexPointer(3, GL_SHORT, 16, memory));
    STATE(GL_VERTEX_ARRAY_TYPE, 1, glVertexPointer(3, GL_SHORT, 16, memory));
    STATE(GL_VERTEX_ARRAY_STRIDE, 1, glVertexPointer(3, GL_SHORT, 16, memory));
    STATE(GL_VERTEX_ARRAY_BUFFER_BINDING, 1, glVertexPointer(3, GL_SHORT, 16, memory));
    STATE(GL_NORMAL_ARRAY_TYPE, 1, glNormalPointer(GL_BYTE, 4, memory));
    STATE(GL_NORMAL_ARRAY_STRIDE, 1, glNormalPointer(GL_BYTE, 4, memory));
    STATE(GL_COLOR_ARRAY_SIZE, 1, glColorPointer(3, GL_UNSIGNED_BYTE, 8, memory));
    STATE(GL_COLOR_ARRAY_TYPE, 1, glColorPointer(3, GL_UNSIGNED_BYTE, 8, memory));
    STATE(GL_COLOR_ARRAY_STRIDE, 1, glColorPointer(3, GL_UNSIGNED_BYTE, 8, memory));
    STATE(GL_SECONDARY_COLOR_ARRAY_TYPE, 1, glSecondaryColorPointer(3, GL_SHORT, 8, memory));
    STATE(GL_SECONDARY_COLOR_ARRAY_STRIDE, 1, glSecondaryColorPointer(3, GL_SHORT, 8, memory));
    STATE(GL_FOG_COORDINATE_ARRAY_TYPE, 1, glFogCoordPointer(GL_DOUBLE, 16, memory));
    STATE(GL_FOG_COORDINATE_ARRAY_STRIDE, 1, glFogCoordPointer(GL_DOUBLE, 16, memory));
    STATE(GL_TEXTURE_COORD_ARRAY_SIZE, 1, glTexCoordPointer(2, GL_INT, 32, memory));
    STATE(GL_TEXTURE_COORD_ARRAY_TYPE, 1, glTexCoordPointer(2, GL_INT, 32, memory));
    STATE(GL_TEXTURE_COORD_ARRAY_STRIDE, 1, glTexCoordPointer(2, GL_INT, 32, memory));
    STATE(GL_EDGE_FLAG_ARRAY_STRIDE, 1, glEdgeFlagPointer(3, memory));
    STATE(GL_VERTEX_ARRAY, 1, glEnableClientState(GL_VERTEX_ARRAY));
    STATE(GL_NORMAL_ARRAY, 1, glEnableClientState(GL_NORMAL_ARRAY));
    STATE(GL_COLOR_ARRAY, 1, glEnableClientState(GL_COLOR_ARRAY));
    STATE(GL_SECONDARY_COLOR_ARRAY, 1, glEnableClientState(GL_SECONDARY_COLOR_ARRAY));
    STATE(GL_FOG_COORDINATE_ARRAY, 1, glEnableClientState(GL_FOG_COORDINATE_ARRAY));
    STATE(GL_TEXTURE_COORD_ARRAY, 1, glEnableClientState(GL_TEXTURE_COORD_ARRAY));
    STATE(GL_EDGE_FLAG_ARRAY, 1, glEnableClientState(GL_EDGE_FLAG_ARRAY));
    STATE(GL_ARRAY_BUFFER_BINDING, 1, glBindBuffer(GL_ARRAY_BUFFER, 5));
    STATE(GL_ELEMENT_ARRAY_BUFFER_BINDING, 1, glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 6));
}

static void transformation(void) {
    static const GLfloat matrix[16] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};
    glPushMatrix();
    MATRIX(GL_MODELVIEW_MATRIX);
    MATRIX(GL_TRANSPOSE_MODELVIEW_MATRIX);
    STATE(GL_MODELVIEW_STACK_DEPTH, 1, (glPushMatrix(), glPopMatrix()));
    glPopMatrix();
    glMatrixMode(GL_PROJECTION);
    glPushMatrix();
    MATRIX(GL_PROJECTION_MATRIX);
    MATRIX(GL_TRANSPOSE_PROJECTION_MATRIX);
    STATE(GL_PROJECTION_STACK_DEPTH, 1, glLoadIdentity());
    glPopMatrix();
    glMatrixMode(GL_TEXTURE);
    glPushMatrix();
    MATRIX(GL_TEXTURE_MATRIX);
    MATRIX(GL_TRANSPOSE_TEXTURE_MATRIX);
    STATE(GL_TEXTURE_STACK_DEPTH, 1, glLoadIdentity());
    glPopMatrix();
    glMatrixMode(GL_MODELVIEW);
    STATE(GL_MATRIX_MODE, 1, glMatrixMode(GL_TEXTURE));
    STATE(GL_VIEWPORT, 4, glViewport(1, 2, 3, 4));
    STATE(GL_DEPTH_RANGE, 2, glDepthRange(0.25, 0.75));
    SWITCH(GL_NORMALIZE);
    SWITCH(GL_RESCALE_NORMAL);
    SWITCH(GL_CLIP_PLANE0);
    SWITCH(GL_CLIP_PLANE5);
    beginCase("clip_plane");
    {
        static const GLdouble plane[4] = {1.0, 2.0, 3.0, 4.0};
        GLdouble found[4] = {0};
        glClipPlane(GL_CLIP_PLANE3, plane);
        glGetClipPlane(GL_CLIP_PLANE3, found);
        tellDoubles(found, 4);
        glGetClipPlane(GL_CLIP_PLANE4, found);
        tellDoubles(found, 4);
        tellError();
    }
}

static void coloring(void) {
    STATE(GL_FOG_COLOR, 4, glFogfv(GL_FOG_COLOR, color));
    STATE(GL_FOG_INDEX, 1, (void)0);
    STATE(GL_FOG_DENSITY, 1, glFogf(GL_FOG_DENSITY, 0.125f));
    STATE(GL_FOG_START, 1, glFogi(GL_FOG_START, 3));
    STATE(GL_FOG_END, 1, glFogf(GL_FOG_END, -7.25f));
    STATE(GL_FOG_MODE, 1, glFogi(GL_FOG_MODE, GL_LINEAR));
    SWITCH(GL_FOG);
    beginCase("GL_FOG_COORDINATE_SOURCE"); /* Mesa does not bring it back, */
    tellAll(GL_FOG_COORDINATE_SOURCE, 1);
    glFogi(GL_FOG_COORDINATE_SOURCE, GL_FOG_COORDINATE);
    tellAll(GL_FOG_COORDINATE_SOURCE, 1);
    glFogi(GL_FOG_COORDINATE_SOURCE, GL_FRAGMENT_DEPTH);
    beginCase("GL_COLOR_SUM"); /* nor this, table 6.8 */
    tellAll(GL_COLOR_SUM, 1);
    glEnable(GL_COLOR_SUM);
    tellAll(GL_COLOR_SUM, 1);
    glDisable(GL_COLOR_SUM);
    tellAll(GL_COLOR_SUM, 1);
    STATE(GL_SHADE_MODEL, 1, glShadeModel(GL_FLAT));
    SWITCH(GL_LIGHTING);
    SWITCH(GL_COLOR_MATERIAL);
    STATE(GL_COLOR_MATERIAL_PARAMETER, 1, glColorMaterial(GL_BACK, GL_EMISSION));
    STATE(GL_COLOR_MATERIAL_FACE, 1, glColorMaterial(GL_BACK, GL_EMISSION));
    STATE(GL_LIGHT_MODEL_AMBIENT, 4, glLightModelfv(GL_LIGHT_MODEL_AMBIENT, color));
    STATE(GL_LIGHT_MODEL_LOCAL_VIEWER, 1, glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1));
    STATE(GL_LIGHT_MODEL_TWO_SIDE, 1, glLightModelf(GL_LIGHT_MODEL_TWO_SIDE, 1.0f));
    STATE(GL_LIGHT_MODEL_COLOR_CONTROL, 1,
          glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR));
    SWITCH(GL_LIGHT0);
    SWITCH(GL_LIGHT7);
}

typedef struct {
    const char* name;
    GLenum value;
    int count;
} Parameter;

#define PARAMETER(value, count) \
    { #value, value, count }

/* By floats and by integers, at the start and when they were given four numbers. */
static void tellParameters(const char* object, GLenum target, const Parameter* parameters,
                           size_t count, const GLfloat* numbers,
                           void(GLAPIENTRY* set)(GLenum, GLenum, const GLfloat*),
                           void(GLAPIENTRY* getFloats)(GLenum, GLenum, GLfloat*),
                           void(GLAPIENTRY* getIntegers)(GLenum, GLenum, GLint*)) {
    for (size_t i = 0; i < count; ++i) {
        char name[96];
        snprintf(name, sizeof name, "%s/%s", object, parameters[i].name);
        beginCase(name);
        glPushAttrib(GL_ALL_ATTRIB_BITS);
        for (int time = 0; time < 2; ++time) {
            GLfloat floats[4] = {0};
            GLint integers[4] = {0};
            if (time == 1) set(target, parameters[i].value, numbers);
            getFloats(target, parameters[i].value, floats);
            getIntegers(target, parameters[i].value, integers);
            for (int k = 0; k < parameters[i].count; ++k)
                printf("%.7g %d\n", (double)floats[k], integers[k]);
            tellError();
        }
        glPopAttrib();
    }
}

#define PARAMETERS(object, target, list, numbers, set, getFloats, getIntegers)               \
    tellParameters(object, target, list, sizeof(list) / sizeof(list)[0], numbers, set, getFloats, \
                   getIntegers)

static void lightsAndMaterials(void) {
    static const Parameter lightParameters[] = {
        PARAMETER(GL_POSITION, 4),           PARAMETER(GL_SPOT_DIRECTION, 3),
        PARAMETER(GL_SPOT_EXPONENT, 1),      PARAMETER(GL_SPOT_CUTOFF, 1),
        PARAMETER(GL_CONSTANT_ATTENUATION, 1), PARAMETER(GL_LINEAR_ATTENUATION, 1),
        PARAMETER(GL_QUADRATIC_ATTENUATION, 1)};
    static const Parameter lightColors[] = {PARAMETER(GL_AMBIENT, 4), PARAMETER(GL_DIFFUSE, 4),
                                            PARAMETER(GL_SPECULAR, 4)};
    static const Parameter materialColors[] = {
        PARAMETER(GL_AMBIENT, 4), PARAMETER(GL_DIFFUSE, 4), PARAMETER(GL_SPECULAR, 4),
        PARAMETER(GL_EMISSION, 4)};
    static const Parameter shininess[] = {PARAMETER(GL_SHININESS, 1)};
    static const GLfloat numbers[4] = {3.0f, -2.0f, 5.0f, 1.0f};
    for (int i = 0; i < 8; ++i) {
        char name[24];
        snprintf(name, sizeof name, "light%d", i);
        PARAMETERS(name, (GLenum)(GL_LIGHT0 + i), lightParameters, numbers, glLightfv, glGetLightfv,
                   glGetLightiv);
        PARAMETERS(name, (GLenum)(GL_LIGHT0 + i), lightColors, color, glLightfv, glGetLightfv,
                   glGetLightiv);
    }
    PARAMETERS("front", GL_FRONT, materialColors, color, glMaterialfv, glGetMaterialfv,
               glGetMaterialiv);
    PARAMETERS("back", GL_BACK, materialColors, color, glMaterialfv, glGetMaterialfv,
               glGetMaterialiv);
    PARAMETERS("front", GL_FRONT, shininess, numbers, glMaterialfv, glGetMaterialfv,
               glGetMaterialiv);
    PARAMETERS("back", GL_BACK, shininess, numbers, glMaterialfv, glGetMaterialfv,
               glGetMaterialiv);
}

static void rasterization(void) {
    static const GLfloat attenuation[3] = {0.5f, 0.25f, 2.5f};
    STATE(GL_POINT_SIZE, 1, glPointSize(2.75f));
    STATE(GL_POINT_SIZE_MIN, 1, glPointParameterf(GL_POINT_SIZE_MIN, 1.75f));
    STATE(GL_POINT_FADE_THRESHOLD_SIZE, 1, glPointParameteri(GL_POINT_FADE_THRESHOLD_SIZE, 3));
    STATE(GL_POINT_DISTANCE_ATTENUATION, 3,
          glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, attenuation));
    SWITCH(GL_POINT_SMOOTH);
    STATE(GL_LINE_WIDTH, 1, glLineWidth(2.25f));
    SWITCH(GL_LINE_SMOOTH);
    STATE(GL_LINE_STIPPLE_PATTERN, 1, glLineStipple(3, 0xABCD));
    STATE(GL_LINE_STIPPLE_REPEAT, 1, glLineStipple(300, 0xABCD));
    SWITCH(GL_LINE_STIPPLE);
    SWITCH(GL_CULL_FACE);
    STATE(GL_CULL_FACE_MODE, 1, glCullFace(GL_FRONT_AND_BACK));
    STATE(GL_FRONT_FACE, 1, glFrontFace(GL_CW));
    SWITCH(GL_POLYGON_SMOOTH);
    STATE(GL_POLYGON_MODE, 2, glPolygonMode(GL_BACK, GL_POINT));
    STATE(GL_POLYGON_OFFSET_FACTOR, 1, glPolygonOffset(1.25f, -2.25f));
    STATE(GL_POLYGON_OFFSET_UNITS, 1, glPolygonOffset(1.25f, -2.25f));
    SWITCH(GL_POLYGON_OFFSET_FILL);
    SWITCH(GL_POLYGON_OFFSET_LINE);
    SWITCH(GL_POLYGON_OFFSET_POINT);
    SWITCH(GL_POLYGON_STIPPLE);
    STATE(GL_SAMPLE_COVERAGE_VALUE, 1, glSampleCoverage(0.25f, GL_TRUE));
    STATE(GL_SAMPLE_COVERAGE_INVERT, 1, glSampleCoverage(0.25f, GL_TRUE));
    beginCase("polygon_stipple");
    {
        GLubyte mask[128], found[128] = {0};
        for (int i = 0; i < 128; ++i) mask[i] = (GLubyte)(37 * i);
        glPolygonStipple(mask);
        glGetPolygonStipple(found);
        for (int i = 0; i < 128; ++i) printf("%d\n", found[i]);
        tellError();
    }
}

static void texturing(void) {
    static const Parameter parameters[] = {
        PARAMETER(GL_TEXTURE_BORDER_COLOR, 4), PARAMETER(GL_TEXTURE_MIN_LOD, 1),
        PARAMETER(GL_TEXTURE_MAX_LOD, 1),      PARAMETER(GL_TEXTURE_BASE_LEVEL, 1),
        PARAMETER(GL_TEXTURE_MAX_LEVEL, 1),    PARAMETER(GL_TEXTURE_PRIORITY, 1)};
    static const Parameter tokens[] = {
        PARAMETER(GL_TEXTURE_MIN_FILTER, 1), PARAMETER(GL_TEXTURE_MAG_FILTER, 1)};
    static const Parameter wraps[] = {
        PARAMETER(GL_TEXTURE_WRAP_S, 1), PARAMETER(GL_TEXTURE_WRAP_T, 1)};
    static const Parameter automatic[] = {PARAMETER(GL_GENERATE_MIPMAP, 1)};
    static const Parameter environment[] = {PARAMETER(GL_TEXTURE_ENV_COLOR, 4)};
    static const Parameter modes[] = {PARAMETER(GL_TEXTURE_ENV_MODE, 1)};
    static const Parameter functions[] = {PARAMETER(GL_COMBINE_RGB, 1),
                                          PARAMETER(GL_COMBINE_ALPHA, 1)};
    static const Parameter sources[] = {
        PARAMETER(GL_SOURCE0_RGB, 1),   PARAMETER(GL_SOURCE1_RGB, 1),   PARAMETER(GL_SOURCE2_RGB, 1),
        PARAMETER(GL_SOURCE0_ALPHA, 1), PARAMETER(GL_SOURCE1_ALPHA, 1),
        PARAMETER(GL_SOURCE2_ALPHA, 1)};
    static const Parameter operands[] = {
        PARAMETER(GL_OPERAND0_RGB, 1),   PARAMETER(GL_OPERAND1_RGB, 1),
        PARAMETER(GL_OPERAND2_RGB, 1),   PARAMETER(GL_OPERAND0_ALPHA, 1),
        PARAMETER(GL_OPERAND1_ALPHA, 1), PARAMETER(GL_OPERAND2_ALPHA, 1)};
    static const Parameter scales[] = {PARAMETER(GL_RGB_SCALE, 1), PARAMETER(GL_ALPHA_SCALE, 1)};
    static const Parameter bias[] = {PARAMETER(GL_TEXTURE_LOD_BIAS, 1)};
    static const Parameter generationModes[] = {PARAMETER(GL_TEXTURE_GEN_MODE, 1)};
    static const Parameter planes[] = {PARAMETER(GL_OBJECT_PLANE, 4), PARAMETER(GL_EYE_PLANE, 4)};
    static const GLenum coordinates[4] = {GL_S, GL_T, GL_R, GL_Q};
    static const GLfloat numbers[4] = {3.0f, -2.0f, 5.0f, 1.0f}, whole[4] = {3.0f},
                         nearest[1] = {GL_NEAREST}, clamp[1] = {GL_CLAMP_TO_BORDER},
                         one[1] = {1.0f}, decal[1] = {GL_DECAL}, add[1] = {GL_INTERPOLATE},
                         primary[1] = {GL_PRIMARY_COLOR}, alpha[1] = {GL_ONE_MINUS_SRC_ALPHA},
                         four[1] = {4.0f}, linear[1] = {GL_OBJECT_LINEAR};
    glBindTexture(GL_TEXTURE_2D, 12);
    PARAMETERS("texture_2d", GL_TEXTURE_2D, parameters, whole, glTexParameterfv,
               glGetTexParameterfv, glGetTexParameteriv);
    PARAMETERS("texture_2d", GL_TEXTURE_2D, tokens, nearest, glTexParameterfv,
               glGetTexParameterfv, glGetTexParameteriv);
    PARAMETERS("texture_1d", GL_TEXTURE_1D, wraps, clamp, glTexParameterfv, glGetTexParameterfv,
               glGetTexParameteriv);
    PARAMETERS("texture_2d", GL_TEXTURE_2D, automatic, one, glTexParameterfv,
               glGetTexParameterfv, glGetTexParameteriv);
#define OF_ENVIRONMENT(list, numbers)                                                       \
    PARAMETERS("environment", GL_TEXTURE_ENV, list, numbers, glTexEnvfv, glGetTexEnvfv, \
               glGetTexEnviv)
    OF_ENVIRONMENT(environment, color);
    OF_ENVIRONMENT(modes, decal);
    OF_ENVIRONMENT(functions, add);
    OF_ENVIRONMENT(sources, primary);
    OF_ENVIRONMENT(operands, alpha);
    OF_ENVIRONMENT(scales, four);
    PARAMETERS("filter_control", GL_TEXTURE_FILTER_CONTROL, bias, whole, glTexEnvfv, glGetTexEnvfv,
               glGetTexEnviv);
    for (int i = 0; i < 4; ++i) {
        char name[24];
        snprintf(name, sizeof name, "generate_%d", i);
        PARAMETERS(name, coordinates[i], generationModes, linear, glTexGenfv, glGetTexGenfv,
                   glGetTexGeniv);
        PARAMETERS(name, coordinates[i], planes, numbers, glTexGenfv, glGetTexGenfv,
                   glGetTexGeniv);
    }
    SWITCH(GL_TEXTURE_1D);
    SWITCH(GL_TEXTURE_2D);
    SWITCH(GL_TEXTURE_GEN_S);
    SWITCH(GL_TEXTURE_GEN_T);
    SWITCH(GL_TEXTURE_GEN_R);
    SWITCH(GL_TEXTURE_GEN_Q);
    STATE(GL_TEXTURE_BINDING_1D, 1, glBindTexture(GL_TEXTURE_1D, 13));
    STATE(GL_TEXTURE_BINDING_2D, 1, glBindTexture(GL_TEXTURE_2D, 14));
    STATE(GL_ACTIVE_TEXTURE, 1, glActiveTexture(GL_TEXTURE0));
    STATE(GL_CLIENT_ACTIVE_TEXTURE, 1, glClientActiveTexture(GL_TEXTURE0));
    beginCase("image");
    {
        static const GLenum asked[] = {GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_BORDER};
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, memory);
        for (GLint level = 0; level < 2; ++level)
            for (size_t i = 0; i < sizeof asked / sizeof asked[0]; ++i) {
                GLint integer = -1;
                GLfloat number = -1.0f;
                glGetTexLevelParameteriv(GL_TEXTURE_2D, level, asked[i], &integer);
                glGetTexLevelParameterfv(GL_TEXTURE_2D, level, asked[i], &number);
                printf("%d %g\n", integer, (double)number);
            }
        tellError();
    }
}

static void fragments(void) {
    SWITCH(GL_SCISSOR_TEST);
    STATE(GL_SCISSOR_BOX, 4, glScissor(1, 2, 3, 4));
    SWITCH(GL_ALPHA_TEST);
    STATE(GL_ALPHA_TEST_FUNC, 1, glAlphaFunc(GL_NOTEQUAL, 0.4f));
    STATE(GL_ALPHA_TEST_REF, 1, glAlphaFunc(GL_NOTEQUAL, 0.4f));
    STATE(GL_STENCIL_FUNC, 1, glStencilFunc(GL_LEQUAL, 0, 0xF0));
    STATE(GL_STENCIL_REF, 1, glStencilFunc(GL_LEQUAL, 0, 0xF0));
    STATE(GL_STENCIL_FAIL, 1, glStencilOp(GL_INCR, GL_ZERO, GL_INVERT));
    STATE(GL_STENCIL_PASS_DEPTH_FAIL, 1, glStencilOp(GL_INCR, GL_ZERO, GL_INVERT));
    STATE(GL_STENCIL_PASS_DEPTH_PASS, 1, glStencilOp(GL_INCR, GL_ZERO, GL_INVERT));
    SWITCH(GL_DEPTH_TEST);
    STATE(GL_DEPTH_FUNC, 1, glDepthFunc(GL_GEQUAL));
    SWITCH(GL_BLEND);
#define BLENDED glBlendFuncSeparate(GL_DST_COLOR, GL_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_DST_ALPHA)
    STATE(GL_BLEND_SRC, 1, BLENDED);
    STATE(GL_BLEND_DST, 1, BLENDED);
    STATE(GL_BLEND_SRC_RGB, 1, BLENDED);
    STATE(GL_BLEND_SRC_ALPHA, 1, BLENDED);
    STATE(GL_BLEND_DST_RGB, 1, BLENDED);
    STATE(GL_BLEND_DST_ALPHA, 1, BLENDED);
    STATE(GL_BLEND_EQUATION, 1, glBlendEquation(GL_FUNC_REVERSE_SUBTRACT));
    STATE(GL_BLEND_COLOR, 4, glBlendColor(0.2f, 0.4f, 0.8f, 0.6f));
    SWITCH(GL_DITHER);
    SWITCH(GL_INDEX_LOGIC_OP);
    SWITCH(GL_COLOR_LOGIC_OP);
    STATE(GL_LOGIC_OP_MODE, 1, glLogicOp(GL_NAND));
    STATE(GL_COLOR_WRITEMASK, 4, glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE));
    STATE(GL_DEPTH_WRITEMASK, 1, glDepthMask(GL_FALSE));
    STATE(GL_COLOR_CLEAR_VALUE, 4, glClearColor(0.2f, 0.4f, 0.8f, 0.6f));
    STATE(GL_DEPTH_CLEAR_VALUE, 1, glClearDepth(0.3));
    STATE(GL_STENCIL_CLEAR_VALUE, 1, glClearStencil(0));
    STATE(GL_ACCUM_CLEAR_VALUE, 4, glClearAccum(-0.2f, 0.4f, 0.8f, 0.6f));
}

static void pixels(void) {
#define STORED(name)                                                                          \
    NAMED_STATE("GL_UNPACK_" #name, GL_UNPACK_##name, 1, glPixelStorei(GL_UNPACK_##name, 1)); \
    NAMED_STATE("GL_PACK_" #name, GL_PACK_##name, 1, glPixelStoref(GL_PACK_##name, 1.0f))
    STORED(SWAP_BYTES);
    STORED(LSB_FIRST);
    STORED(ROW_LENGTH);
    STORED(SKIP_ROWS);
    STORED(SKIP_PIXELS);
    STORED(ALIGNMENT);
#define TRANSFERRED(name, value) NAMED_STATE(#name, name, 1, glPixelTransferf(name, value))
    TRANSFERRED(GL_RED_SCALE, 0.5f);
    TRANSFERRED(GL_GREEN_SCALE, 0.25f);
    TRANSFERRED(GL_BLUE_SCALE, 2.25f);
    TRANSFERRED(GL_ALPHA_SCALE, -1.25f);
    TRANSFERRED(GL_RED_BIAS, 0.125f);
    TRANSFERRED(GL_GREEN_BIAS, -0.25f);
    TRANSFERRED(GL_BLUE_BIAS, 0.75f);
    TRANSFERRED(GL_ALPHA_BIAS, 1.25f);
    STATE(GL_ZOOM_X, 1, glPixelZoom(2.25f, -1.75f));
    STATE(GL_ZOOM_Y, 1, glPixelZoom(2.25f, -1.75f));
}

static void hintsAndOthers(void) {
    STATE(GL_PERSPECTIVE_CORRECTION_HINT, 1, glHint(GL_PERSPECTIVE_CORRECTION_HINT, GL_NICEST));
    STATE(GL_POINT_SMOOTH_HINT, 1, glHint(GL_POINT_SMOOTH_HINT, GL_FASTEST));
    STATE(GL_LINE_SMOOTH_HINT, 1, glHint(GL_LINE_SMOOTH_HINT, GL_NICEST));
    STATE(GL_POLYGON_SMOOTH_HINT, 1, glHint(GL_POLYGON_SMOOTH_HINT, GL_FASTEST));
    STATE(GL_FOG_HINT, 1, glHint(GL_FOG_HINT, GL_NICEST));
    STATE(GL_TEXTURE_COMPRESSION_HINT, 1, glHint(GL_TEXTURE_COMPRESSION_HINT, GL_FASTEST));
    STATE(GL_LIST_BASE, 1, glListBase(17));
    STATE(GL_LIST_INDEX, 1, (void)0);
    STATE(GL_ATTRIB_STACK_DEPTH, 1, (void)0);
    STATE(GL_CLIENT_ATTRIB_STACK_DEPTH, 1, (void)0);
    STATE(GL_NAME_STACK_DEPTH, 1, (void)0);
    STATE(GL_RGBA_MODE, 1, (void)0);
    STATE(GL_INDEX_MODE, 1, (void)0);
    STATE(GL_STEREO, 1, (void)0);
    STATE(GL_AUX_BUFFERS, 1, (void)0);
    beginCase("GL_GENERATE_MIPMAP_HINT"); /* Mesa does not bring it back */
    glHint(GL_GENERATE_MIPMAP_HINT, GL_NICEST);
    tellAll(GL_GENERATE_MIPMAP_HINT, 1);
    beginCase("stencil_masks"); /* the bits of a stencil buffer, of which there may be none */
    {
        static const GLenum asked[] = {GL_STENCIL_VALUE_MASK, GL_STENCIL_WRITEMASK};
        glPushAttrib(GL_STENCIL_BUFFER_BIT);
        for (int time = 0; time < 2; ++time) {
            for (size_t i = 0; i < sizeof asked / sizeof asked[0]; ++i) {
                GLint mask = 0;
                glGetIntegerv(asked[i], &mask);
                printf("%d\n", mask & 0xFF);
            }
            glStencilFunc(GL_LEQUAL, 0, 0xF0);
            glStencilMask(0x3C);
        }
        glPopAttrib();
        tellError();
    }
    beginCase("buffer_object");
    {
        GLint size = -1, usage = -1;
        glBindBuffer(GL_ARRAY_BUFFER, 5);
        glBufferData(GL_ARRAY_BUFFER, 24, memory, GL_DYNAMIC_DRAW);
        glGetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_SIZE, &size);
        glGetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_USAGE, &usage);
        printf("%d %d\n", size, usage);
        glBindBuffer(GL_ARRAY_BUFFER, 0);
        tellError();
    }
    beginCase("array_pointers");
    {
        static const GLenum asked[] = {GL_VERTEX_ARRAY_POINTER, GL_NORMAL_ARRAY_POINTER,
                                       GL_COLOR_ARRAY_POINTER, GL_TEXTURE_COORD_ARRAY_POINTER,
                                       GL_EDGE_FLAG_ARRAY_POINTER};
        glVertexPointer(3, GL_FLOAT, 0, memory);
        for (size_t i = 0; i < sizeof asked / sizeof asked[0]; ++i) {
            void* pointer = NULL;
            glGetPointerv(asked[i], &pointer);
            printf("%d\n", pointer == memory ? 1 : pointer == NULL ? 0 : 2);
        }
        tellError();
    }
}

/* Whether there is as much as OpenGL 1.5 wants at least. */
static void limits(void) {
    static const Parameter least[] = {
        PARAMETER(GL_MAX_LIGHTS, 8),
        PARAMETER(GL_MAX_CLIP_PLANES, 6),
        PARAMETER(GL_MAX_MODELVIEW_STACK_DEPTH, 32),
        PARAMETER(GL_MAX_PROJECTION_STACK_DEPTH, 2),
        PARAMETER(GL_MAX_TEXTURE_STACK_DEPTH, 2),
        PARAMETER(GL_SUBPIXEL_BITS, 4),
        PARAMETER(GL_MAX_TEXTURE_SIZE, 64),
        PARAMETER(GL_MAX_TEXTURE_LOD_BIAS, 2),
        PARAMETER(GL_MAX_LIST_NESTING, 64),
        PARAMETER(GL_MAX_VIEWPORT_DIMS, kWindow),
        PARAMETER(GL_MAX_ATTRIB_STACK_DEPTH, 16),
        PARAMETER(GL_MAX_CLIENT_ATTRIB_STACK_DEPTH, 16),
        PARAMETER(GL_ALIASED_POINT_SIZE_RANGE, 1),
        PARAMETER(GL_SMOOTH_POINT_SIZE_RANGE, 1),
        PARAMETER(GL_ALIASED_LINE_WIDTH_RANGE, 1),
        PARAMETER(GL_SMOOTH_LINE_WIDTH_RANGE, 1),
        PARAMETER(GL_MAX_ELEMENTS_INDICES, 1),
        PARAMETER(GL_MAX_ELEMENTS_VERTICES, 1),
        PARAMETER(GL_MAX_TEXTURE_UNITS, 2),
        PARAMETER(GL_RED_BITS, 8),
        PARAMETER(GL_GREEN_BITS, 8),
        PARAMETER(GL_BLUE_BITS, 8),
        PARAMETER(GL_ALPHA_BITS, 0),
        PARAMETER(GL_STENCIL_BITS, 0),
        PARAMETER(GL_ACCUM_RED_BITS, 0),
        PARAMETER(GL_INDEX_BITS, 0),
        PARAMETER(GL_SAMPLE_BUFFERS, 0),
        PARAMETER(GL_SAMPLES, 0),
        PARAMETER(GL_NUM_COMPRESSED_TEXTURE_FORMATS, 0),
        PARAMETER(GL_MAX_NAME_STACK_DEPTH, 64),
        PARAMETER(GL_DEPTH_BITS, 16)};
    for (size_t i = 0; i < sizeof least / sizeof least[0]; ++i) {
        GLint values[2] = {-1, -1};
        beginCase(least[i].name);
        glGetIntegerv(least[i].value, values);
        printf("%d\n", values[0] >= least[i].count);
        tellError();
    }
}

static void askQuestions(void) {
    currentValues();
    transformation();
    coloring();
    lightsAndMaterials();
    rasterization();
    texturing();
    fragments();
    pixels();
    hintsAndOthers();
    limits();
}

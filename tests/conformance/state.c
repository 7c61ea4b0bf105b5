/* SPDX-License-Identifier: MIT */
/* What queries answer: at the start, and after calls that set or compute something. */
#include <math.h>

#include "tests/conformance/questions.h"

static void tell(const GLfloat* values, int count) {
    for (int i = 0; i < count; ++i) printf("%s%.9g", i ? " " : "", values[i]);
    printf("\n");
}

static void tellState(GLenum name, int count) {
    GLfloat values[16] = {0};
    glGetFloatv(name, values);
    tell(values, count);
}

typedef struct {
    const char* name;
    GLenum state;
    int count;
} Query;

#define QUERY(state, count) \
    { #state, state, count }

static void defaults(void) {
    static const Query queries[] = {QUERY(GL_CURRENT_COLOR, 4),
                                    QUERY(GL_CURRENT_NORMAL, 3),
                                    QUERY(GL_CURRENT_TEXTURE_COORDS, 4),
                                    QUERY(GL_CURRENT_RASTER_POSITION, 4),
                                    QUERY(GL_CURRENT_RASTER_COLOR, 4),
                                    QUERY(GL_CURRENT_RASTER_POSITION_VALID, 1),
                                    QUERY(GL_MATRIX_MODE, 1),
                                    QUERY(GL_MODELVIEW_MATRIX, 16),
                                    QUERY(GL_PROJECTION_MATRIX, 16),
                                    QUERY(GL_TEXTURE_MATRIX, 16),
                                    QUERY(GL_MODELVIEW_STACK_DEPTH, 1),
                                    QUERY(GL_PROJECTION_STACK_DEPTH, 1),
                                    QUERY(GL_TEXTURE_STACK_DEPTH, 1),
                                    QUERY(GL_VIEWPORT, 4),
                                    QUERY(GL_DEPTH_RANGE, 2),
                                    QUERY(GL_SCISSOR_BOX, 4),
                                    QUERY(GL_COLOR_CLEAR_VALUE, 4),
                                    QUERY(GL_DEPTH_CLEAR_VALUE, 1),
                                    QUERY(GL_SHADE_MODEL, 1),
                                    QUERY(GL_CULL_FACE_MODE, 1),
                                    QUERY(GL_FRONT_FACE, 1),
                                    QUERY(GL_POLYGON_MODE, 2),
                                    QUERY(GL_POLYGON_OFFSET_FACTOR, 1),
                                    QUERY(GL_POLYGON_OFFSET_UNITS, 1),
                                    QUERY(GL_POINT_SIZE, 1),
                                    QUERY(GL_LINE_WIDTH, 1),
                                    QUERY(GL_DEPTH_FUNC, 1),
                                    QUERY(GL_DEPTH_WRITEMASK, 1),
                                    QUERY(GL_COLOR_WRITEMASK, 4),
                                    QUERY(GL_ALPHA_TEST_FUNC, 1),
                                    QUERY(GL_ALPHA_TEST_REF, 1),
                                    QUERY(GL_BLEND_SRC, 1),
                                    QUERY(GL_BLEND_DST, 1),
                                    QUERY(GL_FOG_MODE, 1),
                                    QUERY(GL_FOG_DENSITY, 1),
                                    QUERY(GL_FOG_START, 1),
                                    QUERY(GL_FOG_END, 1),
                                    QUERY(GL_FOG_COLOR, 4),
                                    QUERY(GL_LIGHT_MODEL_AMBIENT, 4),
                                    QUERY(GL_LIGHT_MODEL_LOCAL_VIEWER, 1),
                                    QUERY(GL_LIGHT_MODEL_TWO_SIDE, 1),
                                    QUERY(GL_COLOR_MATERIAL_FACE, 1),
                                    QUERY(GL_COLOR_MATERIAL_PARAMETER, 1),
                                    QUERY(GL_TEXTURE_BINDING_2D, 1),
                                    QUERY(GL_LIST_BASE, 1),
                                    QUERY(GL_LIST_INDEX, 1),
                                    QUERY(GL_LIST_MODE, 1),
                                    QUERY(GL_ATTRIB_STACK_DEPTH, 1),
                                    QUERY(GL_UNPACK_ALIGNMENT, 1),
                                    QUERY(GL_PACK_ALIGNMENT, 1),
                                    QUERY(GL_UNPACK_ROW_LENGTH, 1),
                                    QUERY(GL_UNPACK_SKIP_ROWS, 1),
                                    QUERY(GL_UNPACK_SKIP_PIXELS, 1),
                                    QUERY(GL_EDGE_FLAG, 1),
                                    QUERY(GL_VERTEX_ARRAY_SIZE, 1),
                                    QUERY(GL_COLOR_ARRAY_SIZE, 1),
                                    QUERY(GL_TEXTURE_COORD_ARRAY_SIZE, 1),
                                    QUERY(GL_ZOOM_X, 1),
                                    QUERY(GL_ZOOM_Y, 1),
                                    QUERY(GL_RENDER_MODE, 1),
                                    QUERY(GL_LINE_STIPPLE_REPEAT, 1)};
    for (size_t i = 0; i < sizeof queries / sizeof queries[0]; ++i) {
        char name[96];
        snprintf(name, sizeof name, "default/%s", queries[i].name);
        beginCase(name);
        tellState(queries[i].state, queries[i].count);
        tellError();
    }
}

static void capabilities(void) {
    static const Query caps[] = {QUERY(GL_ALPHA_TEST, 1),
                                 QUERY(GL_AUTO_NORMAL, 1),
                                 QUERY(GL_BLEND, 1),
                                 QUERY(GL_CLIP_PLANE0, 1),
                                 QUERY(GL_CLIP_PLANE5, 1),
                                 QUERY(GL_COLOR_MATERIAL, 1),
                                 QUERY(GL_CULL_FACE, 1),
                                 QUERY(GL_DEPTH_TEST, 1),
                                 QUERY(GL_DITHER, 1),
                                 QUERY(GL_FOG, 1),
                                 QUERY(GL_LIGHT0, 1),
                                 QUERY(GL_LIGHT7, 1),
                                 QUERY(GL_LIGHTING, 1),
                                 QUERY(GL_LINE_SMOOTH, 1),
                                 QUERY(GL_NORMALIZE, 1),
                                 QUERY(GL_POINT_SMOOTH, 1),
                                 QUERY(GL_POLYGON_OFFSET_FILL, 1),
                                 QUERY(GL_SCISSOR_TEST, 1),
                                 QUERY(GL_TEXTURE_1D, 1),
                                 QUERY(GL_TEXTURE_2D, 1),
                                 QUERY(GL_TEXTURE_GEN_S, 1),
                                 QUERY(GL_STENCIL_TEST, 1),
                                 QUERY(GL_VERTEX_ARRAY, 1),
                                 QUERY(GL_NORMAL_ARRAY, 1),
                                 QUERY(GL_COLOR_ARRAY, 1),
                                 QUERY(GL_RESCALE_NORMAL, 1)};
    for (size_t i = 0; i < sizeof caps / sizeof caps[0]; ++i) {
        char name[96];
        snprintf(name, sizeof name, "enabled_at_start/%s", caps[i].name);
        beginCase(name);
        printf("%d\n", glIsEnabled(caps[i].state));
        tellError();
    }
    for (size_t i = 0; i < sizeof caps / sizeof caps[0]; ++i) {
        char name[96];
        if (caps[i].state == GL_STENCIL_TEST || caps[i].state == GL_AUTO_NORMAL ||
            caps[i].state == GL_VERTEX_ARRAY || caps[i].state == GL_NORMAL_ARRAY ||
            caps[i].state == GL_COLOR_ARRAY)
            continue;
        snprintf(name, sizeof name, "enable/%s", caps[i].name);
        beginCase(name);
        glPushAttrib(GL_ALL_ATTRIB_BITS);
        glEnable(caps[i].state);
        printf("%d\n", glIsEnabled(caps[i].state));
        glDisable(caps[i].state);
        printf("%d\n", glIsEnabled(caps[i].state));
        glPopAttrib();
        printf("%d\n", glIsEnabled(caps[i].state));
        tellError();
    }
}

#define MATRIX(name, calls)             \
    beginCase("matrix/" name);          \
    glPushMatrix();                     \
    glLoadIdentity();                   \
    calls;                              \
    tellState(GL_MODELVIEW_MATRIX, 16); \
    glPopMatrix();                      \
    tellError()

static void matrices(void) {
    static const GLdouble rows[16] = {1, 2, 3, 4, 0, 1, 0, 5, 0, 0, 2, 0, 0, 0, 0, 1};
    static const GLint viewport[4] = {2, 3, 20, 10};
    MATRIX("translate", glTranslatef(1.0f, 2.0f, 3.0f));
    MATRIX("rotate_axis", glRotatef(30.0f, 0.0f, 0.0f, 1.0f));
    MATRIX("rotate_any", glRotatef(77.0f, 1.0f, -2.0f, 3.0f));
    MATRIX("rotate_null_axis", glRotatef(77.0f, 0.0f, 0.0f, 0.0f));
    MATRIX("scale", glScaled(2.0, -3.0, 0.5));
    MATRIX("order", (glTranslatef(1.0f, 0.0f, 0.0f), glRotatef(90.0f, 0.0f, 0.0f, 1.0f),
                     glScalef(2.0f, 1.0f, 1.0f)));
    MATRIX("frustum", glFrustum(-1.0, 2.0, -3.0, 4.0, 1.0, 50.0));
    MATRIX("ortho", glOrtho(-1.0, 2.0, -3.0, 4.0, -5.0, 6.0));
    MATRIX("mult", glMultMatrixd(rows));
    MATRIX("mult_transposed", glMultTransposeMatrixd(rows));
    MATRIX("load_transposed", glLoadTransposeMatrixd(rows));
    MATRIX("perspective", gluPerspective(40.0, 1.5, 0.1, 100.0));
    MATRIX("look_at", gluLookAt(1.0, 2.0, 3.0, 0.0, 0.5, 0.0, 0.1, 1.0, 0.0));
    MATRIX("ortho2d", gluOrtho2D(0.0, 100.0, 50.0, 0.0));
    MATRIX("pick", gluPickMatrix(10.0, 12.0, 5.0, 5.0, (GLint*)viewport));
    beginCase("matrix/stack_depth");
    glPushMatrix();
    glPushMatrix();
    tellState(GL_MODELVIEW_STACK_DEPTH, 1);
    glPopMatrix();
    glPopMatrix();
    tellState(GL_MODELVIEW_STACK_DEPTH, 1);
    tellError();
}

static void projections(void) {
    static const GLint viewport[4] = {2, 3, 20, 10};
    GLdouble modelview[16], projection[16], x = 0, y = 0, z = 0;
    int done;
    glMatrixMode(GL_PROJECTION);
    glPushMatrix();
    glLoadIdentity();
    gluPerspective(50.0, 2.0, 1.0, 30.0);
    glMatrixMode(GL_MODELVIEW);
    glPushMatrix();
    gluLookAt(1.0, 2.0, 8.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0);
    glGetDoublev(GL_MODELVIEW_MATRIX, modelview);
    glGetDoublev(GL_PROJECTION_MATRIX, projection);
    beginCase("projection/project");
    done = gluProject(0.3, -0.4, 0.5, modelview, projection, viewport, &x, &y, &z);
    printf("%d %.9g %.9g %.9g\n", done, x, y, z);
    beginCase("projection/unproject");
    done = gluUnProject(7.0, 8.0, 0.9, modelview, projection, viewport, &x, &y, &z);
    printf("%d %.5g %.5g %.5g\n", done, x, y, z);
    beginCase("projection/unproject_singular");
    for (int i = 0; i < 16; ++i) modelview[i] = 0.0;
    done = gluUnProject(7.0, 8.0, 0.9, modelview, projection, viewport, &x, &y, &z);
    printf("%d\n", done);
    beginCase("projection/raster_position");
    glRasterPos3f(0.3f, -0.4f, 0.5f);
    tellState(GL_CURRENT_RASTER_POSITION, 4);
    tellState(GL_CURRENT_RASTER_POSITION_VALID, 1);
    beginCase("projection/raster_position_clipped");
    glRasterPos3f(0.3f, -0.4f, 50.0f);
    tellState(GL_CURRENT_RASTER_POSITION_VALID, 1);
    glPopMatrix();
    glMatrixMode(GL_PROJECTION);
    glPopMatrix();
    glMatrixMode(GL_MODELVIEW);
}

static void lightDefaults(GLenum light, const char* name) {
    static const Query queries[] = {QUERY(GL_AMBIENT, 4),
                                    QUERY(GL_DIFFUSE, 4),
                                    QUERY(GL_SPECULAR, 4),
                                    QUERY(GL_POSITION, 4),
                                    QUERY(GL_SPOT_DIRECTION, 3),
                                    QUERY(GL_SPOT_EXPONENT, 1),
                                    QUERY(GL_SPOT_CUTOFF, 1),
                                    QUERY(GL_CONSTANT_ATTENUATION, 1),
                                    QUERY(GL_LINEAR_ATTENUATION, 1),
                                    QUERY(GL_QUADRATIC_ATTENUATION, 1)};
    for (size_t i = 0; i < sizeof queries / sizeof queries[0]; ++i) {
        GLfloat values[4] = {0};
        char text[96];
        snprintf(text, sizeof text, "%s/%s", name, queries[i].name);
        beginCase(text);
        glGetLightfv(light, queries[i].state, values);
        tell(values, queries[i].count);
        tellError();
    }
}

static void materialDefaults(GLenum face, const char* name) {
    static const Query queries[] = {QUERY(GL_AMBIENT, 4), QUERY(GL_DIFFUSE, 4),
                                    QUERY(GL_SPECULAR, 4), QUERY(GL_EMISSION, 4),
                                    QUERY(GL_SHININESS, 1)};
    for (size_t i = 0; i < sizeof queries / sizeof queries[0]; ++i) {
        GLfloat values[4] = {0};
        char text[96];
        snprintf(text, sizeof text, "%s/%s", name, queries[i].name);
        beginCase(text);
        glGetMaterialfv(face, queries[i].state, values);
        tell(values, queries[i].count);
        tellError();
    }
}

static void lights(void) {
    static const GLfloat position[] = {1.0f, 2.0f, 3.0f, 1.0f}, direction[] = {0.0f, 1.0f, 0.0f},
                         color[] = {0.1f, 0.2f, 0.3f, 0.4f};
    GLfloat values[4] = {0};
    beginCase("light/position_in_eye_space");
    glPushMatrix();
    glTranslatef(0.0f, 0.0f, -5.0f);
    glRotatef(90.0f, 0.0f, 0.0f, 1.0f);
    glLightfv(GL_LIGHT2, GL_POSITION, position);
    glLightfv(GL_LIGHT2, GL_SPOT_DIRECTION, direction);
    glPopMatrix();
    glGetLightfv(GL_LIGHT2, GL_POSITION, values);
    tell(values, 4);
    glGetLightfv(GL_LIGHT2, GL_SPOT_DIRECTION, values);
    tell(values, 3);
    beginCase("material/both_faces");
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, color);
    glGetMaterialfv(GL_BACK, GL_SPECULAR, values);
    tell(values, 4);
    beginCase("material/color_material_follows");
    glEnable(GL_COLOR_MATERIAL);
    glColorMaterial(GL_FRONT, GL_DIFFUSE);
    glColor3f(0.2f, 0.3f, 0.4f);
    glGetMaterialfv(GL_FRONT, GL_DIFFUSE, values);
    tell(values, 4);
    glGetMaterialfv(GL_BACK, GL_DIFFUSE, values);
    tell(values, 4);
    glDisable(GL_COLOR_MATERIAL);
    beginCase("clip_plane/in_eye_space");
    {
        static const GLdouble plane[] = {0.0, 1.0, 0.5, 2.0};
        GLdouble answer[4] = {0};
        glPushMatrix();
        glTranslatef(1.0f, 2.0f, 3.0f);
        glScalef(2.0f, 1.0f, 1.0f);
        glClipPlane(GL_CLIP_PLANE1, plane);
        glPopMatrix();
        glGetClipPlane(GL_CLIP_PLANE1, answer);
        printf("%.6g %.6g %.6g %.6g\n", answer[0], answer[1], answer[2], answer[3]);
    }
}

static void currentValues(void) {
    static const GLubyte bytes[] = {255, 128, 0, 51};
    beginCase("current/color_bytes");
    glColor4ubv(bytes);
    tellState(GL_CURRENT_COLOR, 4);
    beginCase("current/color_shorts");
    glColor3s(32767, -32768, 0);
    tellState(GL_CURRENT_COLOR, 4);
    beginCase("current/color_integers");
    glColor3ui(0xFFFFFFFFu, 0x80000000u, 0u);
    tellState(GL_CURRENT_COLOR, 4);
    beginCase("current/color_not_clamped");
    glColor4f(2.0f, -1.0f, 0.5f, 3.0f);
    tellState(GL_CURRENT_COLOR, 4);
    beginCase("current/normal_bytes");
    glNormal3b(127, -128, 0);
    tellState(GL_CURRENT_NORMAL, 3);
    beginCase("current/texture_coordinates");
    glTexCoord2f(0.25f, 0.75f);
    tellState(GL_CURRENT_TEXTURE_COORDS, 4);
    glTexCoord4d(1.0, 2.0, 3.0, 4.0);
    tellState(GL_CURRENT_TEXTURE_COORDS, 4);
    beginCase("current/clear_color_clamped");
    glClearColor(2.0f, -1.0f, 0.5f, 1.0f);
    tellState(GL_COLOR_CLEAR_VALUE, 4);
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    beginCase("current/integer_of_color");
    {
        GLint values[4] = {0};
        glColor4f(1.0f, 0.0f, -1.0f, 0.5f);
        glGetIntegerv(GL_CURRENT_COLOR, values);
        printf("%d %d %d\n", values[0], values[1], values[2]);
    }
    beginCase("current/boolean_of_float");
    {
        GLboolean value = 0;
        glFogf(GL_FOG_DENSITY, 0.5f);
        glGetBooleanv(GL_FOG_DENSITY, &value);
        printf("%d\n", value);
        glFogf(GL_FOG_DENSITY, 1.0f);
    }
}

static void attributeStack(void) {
    beginCase("attributes/current_restored");
    glColor3f(0.1f, 0.2f, 0.3f);
    glPushAttrib(GL_CURRENT_BIT);
    glColor3f(0.9f, 0.9f, 0.9f);
    glPopAttrib();
    tellState(GL_CURRENT_COLOR, 4);
    beginCase("attributes/others_stay");
    glPushAttrib(GL_CURRENT_BIT);
    glPointSize(4.0f);
    glPopAttrib();
    tellState(GL_POINT_SIZE, 1);
    glPointSize(1.0f);
    beginCase("attributes/lighting_restored");
    glPushAttrib(GL_LIGHTING_BIT);
    glShadeModel(GL_FLAT);
    glEnable(GL_LIGHT3);
    glPopAttrib();
    tellState(GL_SHADE_MODEL, 1);
    printf("%d\n", glIsEnabled(GL_LIGHT3));
    beginCase("attributes/transform_restored");
    glPushAttrib(GL_TRANSFORM_BIT);
    glMatrixMode(GL_TEXTURE);
    glPopAttrib();
    tellState(GL_MATRIX_MODE, 1);
    beginCase("attributes/viewport_restored");
    glPushAttrib(GL_VIEWPORT_BIT);
    glViewport(1, 2, 3, 4);
    glPopAttrib();
    tellState(GL_VIEWPORT, 4);
    beginCase("attributes/client_restored");
    glPushClientAttrib((GLbitfield)GL_CLIENT_ALL_ATTRIB_BITS);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 7);
    glEnableClientState(GL_VERTEX_ARRAY);
    glPopClientAttrib();
    tellState(GL_UNPACK_ROW_LENGTH, 1);
    printf("%d\n", glIsEnabled(GL_VERTEX_ARRAY));
}

static void listsAndTextures(void) {
    static const GLubyte image[4 * 4 * 3] = {0};
    GLuint list, textures[2] = {0};
    GLint value = 0;
    beginCase("lists/generated_exist");
    list = glGenLists(3);
    printf("%d %d %d %d\n", glIsList(list), glIsList(list + 2), glIsList(list + 3), glIsList(0));
    glDeleteLists(list, 1);
    printf("%d %d\n", glIsList(list), glIsList(list + 1));
    beginCase("lists/compile_does_not_execute");
    glColor3f(0.0f, 0.0f, 0.0f);
    glNewList(list + 1, GL_COMPILE);
    glColor3f(1.0f, 0.5f, 0.25f);
    glEndList();
    tellState(GL_CURRENT_COLOR, 4);
    glCallList(list + 1);
    tellState(GL_CURRENT_COLOR, 4);
    beginCase("lists/compile_and_execute");
    glNewList(list + 1, GL_COMPILE_AND_EXECUTE);
    glColor3f(0.75f, 0.5f, 0.25f);
    glGetIntegerv(GL_LIST_MODE, &value);
    printf("%d\n", value == GL_COMPILE_AND_EXECUTE);
    glEndList();
    tellState(GL_CURRENT_COLOR, 4);
    beginCase("lists/matrix_effect_stays");
    glNewList(list + 2, GL_COMPILE);
    glTranslatef(1.0f, 0.0f, 0.0f);
    glEndList();
    glPushMatrix();
    glCallList(list + 2);
    glCallList(list + 2);
    tellState(GL_MODELVIEW_MATRIX, 16);
    glPopMatrix();
    beginCase("textures/names");
    glGenTextures(2, textures);
    printf("%d\n", glIsTexture(textures[0]));
    glBindTexture(GL_TEXTURE_2D, textures[0]);
    printf("%d %d\n", glIsTexture(textures[0]), glIsTexture(textures[1]));
    beginCase("textures/level_parameters");
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 4, 2, 0, GL_RGB, GL_UNSIGNED_BYTE, image);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &value);
    printf("%d\n", value);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_HEIGHT, &value);
    printf("%d\n", value);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 1, GL_TEXTURE_WIDTH, &value);
    printf("%d\n", value);
    beginCase("textures/parameters");
    glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, &value);
    printf("%d\n", value == GL_NEAREST_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, &value);
    printf("%d\n", value == GL_CLAMP_TO_EDGE);
    beginCase("textures/deleted_binding");
    glDeleteTextures(2, textures);
    tellState(GL_TEXTURE_BINDING_2D, 1);
    beginCase("glu/error_strings");
    printf("%s\n", (const char*)gluErrorString(GL_INVALID_ENUM));
    printf("%s\n", (const char*)gluErrorString(GL_NO_ERROR));
}

/* Images of textures, of each base format, read back in each format of pixels. */
static void texturesReadBack(void) {
    static const struct {
        const char* name;
        GLint format;
    } kept[] = {{"alpha", GL_ALPHA8}, {"luminance", GL_LUMINANCE8},
                {"luminance_alpha", GL_LUMINANCE8_ALPHA8}, {"intensity", GL_INTENSITY8},
                {"rgb", GL_RGB8}, {"rgba", GL_RGBA8}};
    static const GLenum formats[] = {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA, GL_RGB, GL_RGBA, GL_BGRA};
    static const GLenum types[] = {GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_FLOAT};
    GLubyte image[3 * 2 * 4], bytes[64];
    GLushort shorts[64];
    GLfloat floats[64];
    for (int i = 0; i < 24; ++i) image[i] = (GLubyte)(11 * i + 3);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (size_t k = 0; k < sizeof kept / sizeof kept[0]; ++k) {
        char name[64];
        snprintf(name, sizeof name, "textures/read_back/%s", kept[k].name);
        beginCase(name);
        glTexImage2D(GL_TEXTURE_2D, 0, kept[k].format, 3, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, image);
        for (size_t f = 0; f < sizeof formats / sizeof formats[0]; ++f)
            for (size_t t = 0; t < sizeof types / sizeof types[0]; ++t) {
                for (int i = 0; i < 64; ++i) floats[i] = (GLfloat)(shorts[i] = bytes[i] = 77);
                void* const to[3] = {bytes, shorts, floats};
                glPixelStorei(GL_PACK_ALIGNMENT, 4);
                glGetTexImage(GL_TEXTURE_2D, 0, formats[f], types[t], to[t]);
                for (int i = 0; i < 26; ++i)
                    printf("%.5g ", t == 0 ? bytes[i] : t == 1 ? shorts[i] : (double)floats[i]);
                printf("\n");
            }
        tellError();
    }
    beginCase("textures/read_back/wrong");
    bytes[0] = 5;
    glGetTexImage(GL_TEXTURE_2D, 3, GL_RGBA, GL_UNSIGNED_BYTE, bytes); /* no such image */
    tellError();
    glGetTexImage(GL_TEXTURE_2D, -1, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
    tellError();
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_RGBA, bytes);
    tellError();
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGB, GL_UNSIGNED_SHORT_4_4_4_4, bytes);
    tellError();
    glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, floats);
    tellError();
    glGetTexImage(GL_LIGHT0, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
    tellError();
    printf("%d\n", bytes[0]);
}

static void askQuestions(void) {
    defaults();
    capabilities();
    lightDefaults(GL_LIGHT0, "light0");
    lightDefaults(GL_LIGHT5, "light5");
    materialDefaults(GL_FRONT, "material_front");
    materialDefaults(GL_BACK, "material_back");
    matrices();
    projections();
    lights();
    currentValues();
    attributeStack();
    listsAndTextures();
    texturesReadBack();
}

/* SPDX-License-Identifier: MIT */
/* Wrong calls: which error is recorded, and whether state has changed. */
#include <string.h>

#include "tests/conformance/questions.h"

enum { kNoSuchEnum = 0x9999, kStates = 512 };

typedef struct {
    GLfloat values[kStates];
    int count;
} Fingerprint;

static void addState(Fingerprint* print, GLenum name, int count) {
    glGetFloatv(name, print->values + print->count);
    print->count += count;
}

/* What can be asked without doubt, so that a wrong call that changes something is found out. */
static void takeFingerprint(Fingerprint* print) {
    static const GLenum singles[] = {GL_MATRIX_MODE,
                                     GL_SHADE_MODEL,
                                     GL_CULL_FACE_MODE,
                                     GL_FRONT_FACE,
                                     GL_DEPTH_FUNC,
                                     GL_DEPTH_WRITEMASK,
                                     GL_BLEND_SRC,
                                     GL_BLEND_DST,
                                     GL_ALPHA_TEST_FUNC,
                                     GL_ALPHA_TEST_REF,
                                     GL_FOG_MODE,
                                     GL_FOG_DENSITY,
                                     GL_FOG_START,
                                     GL_FOG_END,
                                     GL_POINT_SIZE,
                                     GL_LINE_WIDTH,
                                     GL_UNPACK_ALIGNMENT,
                                     GL_PACK_ALIGNMENT,
                                     GL_UNPACK_ROW_LENGTH,
                                     GL_LIST_BASE,
                                     GL_TEXTURE_BINDING_2D,
                                     GL_MODELVIEW_STACK_DEPTH,
                                     GL_PROJECTION_STACK_DEPTH,
                                     GL_ATTRIB_STACK_DEPTH,
                                     GL_COLOR_MATERIAL_FACE,
                                     GL_COLOR_MATERIAL_PARAMETER};
    memset(print, 0, sizeof *print);
    for (size_t i = 0; i < sizeof singles / sizeof singles[0]; ++i) addState(print, singles[i], 1);
    addState(print, GL_POLYGON_MODE, 2);
    addState(print, GL_VIEWPORT, 4);
    addState(print, GL_SCISSOR_BOX, 4);
    addState(print, GL_CURRENT_COLOR, 4);
    addState(print, GL_CURRENT_NORMAL, 3);
    addState(print, GL_COLOR_CLEAR_VALUE, 4);
    addState(print, GL_FOG_COLOR, 4);
    addState(print, GL_LIGHT_MODEL_AMBIENT, 4);
    addState(print, GL_MODELVIEW_MATRIX, 16);
    addState(print, GL_PROJECTION_MATRIX, 16);
    glGetLightfv(GL_LIGHT0, GL_POSITION, print->values + print->count);
    glGetLightfv(GL_LIGHT0, GL_SPOT_CUTOFF, print->values + print->count + 4);
    glGetMaterialfv(GL_FRONT, GL_DIFFUSE, print->values + print->count + 5);
    glGetMaterialfv(GL_FRONT, GL_SHININESS, print->values + print->count + 9);
    print->count += 10;
}

static Fingerprint before;

static void begin(const char* name) {
    beginCase(name);
    takeFingerprint(&before);
    while (glGetError() != GL_NO_ERROR) {
    }
}

static void end(void) {
    Fingerprint after;
    tellError();
    alsoAllowed = NULL;
    tellError();
    takeFingerprint(&after);
    printf("state %s\n", memcmp(&before, &after, sizeof after) ? "changed" : "unchanged");
}

#define WRONG(name, call) \
    begin(name);          \
    call;                 \
    end()

#define INSIDE(name, call)       \
    begin("inside_begin/" name); \
    glBegin(GL_TRIANGLES);       \
    call;                        \
    glEnd();                     \
    end()

/* OpenGL 1.5 leaves open whether there is an error, or names another one than OSMesa. */
#define OPEN(name, call, error) \
    begin(name);                \
    call;                       \
    alsoAllowed = error;        \
    end()

static const GLfloat four[4] = {0.5f, 0.5f, 0.5f, 1.0f};
static const GLubyte image[64] = {0};
static GLfloat answer[16];
static GLint integers[16];

static void enums(void) {
    WRONG("begin/enum", glBegin(kNoSuchEnum));
    WRONG("enable/enum", glEnable(kNoSuchEnum));
    WRONG("disable/enum", glDisable(kNoSuchEnum));
    WRONG("is_enabled/enum", (void)glIsEnabled(kNoSuchEnum));
    WRONG("matrix_mode/enum", glMatrixMode(kNoSuchEnum));
    WRONG("shade_model/enum", glShadeModel(kNoSuchEnum));
    WRONG("cull_face/enum", glCullFace(kNoSuchEnum));
    WRONG("front_face/enum", glFrontFace(kNoSuchEnum));
    WRONG("polygon_mode/face", glPolygonMode(kNoSuchEnum, GL_LINE));
    WRONG("polygon_mode/mode", glPolygonMode(GL_FRONT, kNoSuchEnum));
    WRONG("depth_func/enum", glDepthFunc(kNoSuchEnum));
    WRONG("alpha_func/enum", glAlphaFunc(kNoSuchEnum, 0.5f));
    WRONG("blend_func/source", glBlendFunc(kNoSuchEnum, GL_ONE));
    WRONG("blend_func/destination", glBlendFunc(GL_ONE, kNoSuchEnum));
    WRONG("hint/target", glHint(kNoSuchEnum, GL_NICEST));
    WRONG("hint/mode", glHint(GL_FOG_HINT, kNoSuchEnum));
    WRONG("color_material/face", glColorMaterial(kNoSuchEnum, GL_DIFFUSE));
    WRONG("color_material/mode", glColorMaterial(GL_FRONT, GL_SHININESS));
    WRONG("light/light", glLightf(kNoSuchEnum, GL_SPOT_CUTOFF, 20.0f));
    WRONG("light/parameter", glLightf(GL_LIGHT0, kNoSuchEnum, 1.0f));
    WRONG("light_vector/light", glLightfv(kNoSuchEnum, GL_DIFFUSE, four));
    WRONG("light_vector/parameter", glLightfv(GL_LIGHT0, kNoSuchEnum, four));
    WRONG("light_model/parameter", glLightModelf(kNoSuchEnum, 1.0f));
    WRONG("light_model_vector/parameter", glLightModelfv(kNoSuchEnum, four));
    WRONG("material/face", glMaterialfv(kNoSuchEnum, GL_DIFFUSE, four));
    WRONG("material/parameter", glMaterialfv(GL_FRONT, kNoSuchEnum, four));
    WRONG("fog/parameter", glFogf(kNoSuchEnum, 1.0f));
    WRONG("fog/mode", glFogi(GL_FOG_MODE, kNoSuchEnum));
    WRONG("clip_plane/plane", glClipPlane(kNoSuchEnum, (const GLdouble[]){0, 0, 1, 0}));
    WRONG("get_float/enum", glGetFloatv(kNoSuchEnum, answer));
    WRONG("get_integer/enum", glGetIntegerv(kNoSuchEnum, integers));
    WRONG("get_light/light", glGetLightfv(kNoSuchEnum, GL_DIFFUSE, answer));
    WRONG("get_light/parameter", glGetLightfv(GL_LIGHT0, kNoSuchEnum, answer));
    WRONG("get_material/face", glGetMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, answer));
    WRONG("get_material/parameter", glGetMaterialfv(GL_FRONT, kNoSuchEnum, answer));
    WRONG("get_string/enum", (void)glGetString(kNoSuchEnum));
    WRONG("new_list/mode", glNewList(1, kNoSuchEnum));
    WRONG("call_lists/type", glCallLists(1, kNoSuchEnum, image));
    WRONG("clear/bits", glClear(0x80000000u));
    WRONG("draw_arrays/mode", glDrawArrays(kNoSuchEnum, 0, 3));
    WRONG("draw_elements/mode", glDrawElements(kNoSuchEnum, 3, GL_UNSIGNED_BYTE, image));
    WRONG("draw_elements/type", glDrawElements(GL_TRIANGLES, 3, GL_FLOAT, image));
    WRONG("enable_client_state/enum", glEnableClientState(kNoSuchEnum));
    WRONG("disable_client_state/enum", glDisableClientState(kNoSuchEnum));
    WRONG("interleaved_arrays/format", glInterleavedArrays(kNoSuchEnum, 0, image));
    WRONG("vertex_pointer/type", glVertexPointer(3, GL_UNSIGNED_BYTE, 0, image));
    WRONG("normal_pointer/type", glNormalPointer(GL_UNSIGNED_BYTE, 0, image));
    WRONG("color_pointer/type", glColorPointer(3, kNoSuchEnum, 0, image));
    WRONG("tex_coord_pointer/type", glTexCoordPointer(2, GL_UNSIGNED_BYTE, 0, image));
    WRONG("pixel_store/enum", glPixelStorei(kNoSuchEnum, 1));
    WRONG("bind_texture/target", glBindTexture(kNoSuchEnum, 1));
    WRONG("tex_parameter/target", glTexParameteri(kNoSuchEnum, GL_TEXTURE_WRAP_S, GL_REPEAT));
    WRONG("tex_parameter/parameter", glTexParameteri(GL_TEXTURE_2D, kNoSuchEnum, GL_REPEAT));
    WRONG("tex_parameter/wrap", glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, kNoSuchEnum));
    WRONG("tex_parameter/filter",
          glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR_MIPMAP_LINEAR));
    WRONG("tex_env/target", glTexEnvi(kNoSuchEnum, GL_TEXTURE_ENV_MODE, GL_MODULATE));
    WRONG("tex_env/parameter", glTexEnvi(GL_TEXTURE_ENV, kNoSuchEnum, GL_MODULATE));
    WRONG("tex_env/mode", glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, kNoSuchEnum));
    WRONG("tex_gen/coordinate", glTexGeni(kNoSuchEnum, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP));
    WRONG("tex_gen/parameter", glTexGeni(GL_S, kNoSuchEnum, GL_SPHERE_MAP));
    WRONG("tex_gen/mode", glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, kNoSuchEnum));
    WRONG("tex_gen/sphere_map_r", glTexGeni(GL_R, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP));
    WRONG("tex_image/target",
          glTexImage2D(kNoSuchEnum, 0, GL_RGB, 2, 2, 0, GL_RGB, GL_UNSIGNED_BYTE, image));
    WRONG("tex_image/format",
          glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 2, 2, 0, kNoSuchEnum, GL_UNSIGNED_BYTE, image));
    WRONG("tex_image/type",
          glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 2, 2, 0, GL_RGB, kNoSuchEnum, image));
    WRONG("tex_image/internal_format",
          glTexImage2D(GL_TEXTURE_2D, 0, kNoSuchEnum, 2, 2, 0, GL_RGB, GL_UNSIGNED_BYTE, image));
    WRONG("read_pixels/format",
          glReadPixels(0, 0, 1, 1, kNoSuchEnum, GL_UNSIGNED_BYTE, (void*)answer));
    WRONG("read_pixels/type", glReadPixels(0, 0, 1, 1, GL_RGB, kNoSuchEnum, (void*)answer));
    WRONG("get_tex_level/target",
          glGetTexLevelParameteriv(kNoSuchEnum, 0, GL_TEXTURE_WIDTH, integers));
    WRONG("get_tex_level/parameter",
          glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, kNoSuchEnum, integers));
}

static void values(void) {
    WRONG("viewport/negative", glViewport(0, 0, -1, 4));
    WRONG("scissor/negative", glScissor(0, 0, 4, -1));
    WRONG("point_size/zero", glPointSize(0.0f));
    WRONG("point_size/negative", glPointSize(-1.0f));
    WRONG("line_width/zero", glLineWidth(0.0f));
    WRONG("line_width/negative", glLineWidth(-2.0f));
    WRONG("light/spot_exponent_low", glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, -1.0f));
    WRONG("light/spot_exponent_high", glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, 129.0f));
    WRONG("light/spot_cutoff_low", glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, -1.0f));
    WRONG("light/spot_cutoff_between", glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 91.0f));
    WRONG("light/attenuation", glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, -0.1f));
    WRONG("material/shininess_low", glMaterialf(GL_FRONT, GL_SHININESS, -1.0f));
    WRONG("material/shininess_high", glMaterialf(GL_FRONT, GL_SHININESS, 129.0f));
    WRONG("fog/density", glFogf(GL_FOG_DENSITY, -1.0f));
    WRONG("new_list/zero", glNewList(0, GL_COMPILE));
    WRONG("gen_lists/negative", (void)glGenLists(-1));
    WRONG("gen_lists/none", (void)glGenLists(0));
    WRONG("delete_lists/negative", glDeleteLists(1, -1));
    WRONG("delete_lists/unknown", glDeleteLists(77777, 1));
    WRONG("call_list/unknown", glCallList(77777));
    OPEN("call_list/zero", glCallList(0), "no_error");
    WRONG("call_lists/negative", glCallLists(-1, GL_UNSIGNED_BYTE, image));
    WRONG("gen_textures/negative", glGenTextures(-1, (GLuint*)integers));
    WRONG("delete_textures/negative", glDeleteTextures(-1, (const GLuint*)integers));
    WRONG("delete_textures/unknown", glDeleteTextures(1, (const GLuint[]){77777}));
    WRONG("draw_arrays/count", glDrawArrays(GL_TRIANGLES, 0, -1));
    OPEN("draw_arrays/first", glDrawArrays(GL_TRIANGLES, -1, 3), "invalid_value");
    WRONG("draw_elements/count", glDrawElements(GL_TRIANGLES, -1, GL_UNSIGNED_BYTE, image));
    WRONG("vertex_pointer/size", glVertexPointer(1, GL_FLOAT, 0, image));
    WRONG("vertex_pointer/stride", glVertexPointer(3, GL_FLOAT, -1, image));
    WRONG("color_pointer/size", glColorPointer(2, GL_FLOAT, 0, image));
    WRONG("tex_coord_pointer/size", glTexCoordPointer(5, GL_FLOAT, 0, image));
    WRONG("interleaved_arrays/stride", glInterleavedArrays(GL_V3F, -1, image));
    WRONG("pixel_store/alignment", glPixelStorei(GL_UNPACK_ALIGNMENT, 3));
    WRONG("pixel_store/row_length", glPixelStorei(GL_UNPACK_ROW_LENGTH, -1));
    WRONG("frustum/near", glFrustum(-1.0, 1.0, -1.0, 1.0, 0.0, 10.0));
    WRONG("frustum/far", glFrustum(-1.0, 1.0, -1.0, 1.0, 1.0, -1.0));
    WRONG("frustum/flat", glFrustum(1.0, 1.0, -1.0, 1.0, 1.0, 10.0));
    WRONG("frustum/near_is_far", glFrustum(-1.0, 1.0, -1.0, 1.0, 2.0, 2.0));
    WRONG("ortho/flat", glOrtho(-1.0, 1.0, 3.0, 3.0, -1.0, 1.0));
    WRONG("ortho/near_is_far", glOrtho(-1.0, 1.0, -1.0, 1.0, 1.0, 1.0));
    WRONG("tex_image/level",
          glTexImage2D(GL_TEXTURE_2D, -1, GL_RGB, 2, 2, 0, GL_RGB, GL_UNSIGNED_BYTE, image));
    WRONG("tex_image/width",
          glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, -2, 2, 0, GL_RGB, GL_UNSIGNED_BYTE, image));
    WRONG("tex_image/border",
          glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 2, 2, 3, GL_RGB, GL_UNSIGNED_BYTE, image));
    WRONG("tex_sub_image/outside", {
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 2, 2, 0, GL_RGB, GL_UNSIGNED_BYTE, image);
        glTexSubImage2D(GL_TEXTURE_2D, 0, 1, 1, 2, 2, GL_RGB, GL_UNSIGNED_BYTE, image);
    });
    WRONG("read_pixels/negative",
          glReadPixels(0, 0, -1, 1, GL_RGB, GL_UNSIGNED_BYTE, (void*)answer));
    WRONG("bitmap/negative", glBitmap(-1, 1, 0.0f, 0.0f, 0.0f, 0.0f, image));
    WRONG("get_tex_level/level",
          glGetTexLevelParameteriv(GL_TEXTURE_2D, -1, GL_TEXTURE_WIDTH, integers));
    WRONG("bind_texture/other_target", {
        glBindTexture(GL_TEXTURE_2D, 4321);
        glBindTexture(GL_TEXTURE_1D, 4321);
        glBindTexture(GL_TEXTURE_2D, 0);
    });
}

static void nesting(void) {
    INSIDE("begin", glBegin(GL_TRIANGLES));
    INSIDE("enable", glEnable(GL_FOG));
    INSIDE("disable", glDisable(GL_DITHER));
    INSIDE("matrix_mode", glMatrixMode(GL_PROJECTION));
    INSIDE("load_identity", glLoadIdentity());
    INSIDE("load_matrix", glLoadMatrixf(before.values));
    INSIDE("translate", glTranslatef(1.0f, 0.0f, 0.0f));
    INSIDE("rotate", glRotatef(30.0f, 0.0f, 0.0f, 1.0f));
    INSIDE("scale", glScalef(2.0f, 2.0f, 2.0f));
    INSIDE("push_matrix", glPushMatrix());
    INSIDE("pop_matrix", glPopMatrix());
    INSIDE("frustum", glFrustum(-1.0, 1.0, -1.0, 1.0, 1.0, 10.0));
    INSIDE("viewport", glViewport(0, 0, 8, 8));
    INSIDE("scissor", glScissor(0, 0, 8, 8));
    INSIDE("clear", glClear(GL_COLOR_BUFFER_BIT));
    INSIDE("clear_color", glClearColor(1.0f, 0.0f, 0.0f, 1.0f));
    INSIDE("shade_model", glShadeModel(GL_FLAT));
    INSIDE("cull_face", glCullFace(GL_FRONT));
    INSIDE("front_face", glFrontFace(GL_CW));
    INSIDE("depth_func", glDepthFunc(GL_GREATER));
    INSIDE("depth_mask", glDepthMask(GL_FALSE));
    INSIDE("blend_func", glBlendFunc(GL_ONE, GL_ONE));
    INSIDE("alpha_func", glAlphaFunc(GL_LESS, 0.5f));
    INSIDE("light", glLightfv(GL_LIGHT0, GL_POSITION, four));
    INSIDE("light_model", glLightModelfv(GL_LIGHT_MODEL_AMBIENT, four));
    INSIDE("color_material", glColorMaterial(GL_BACK, GL_EMISSION));
    INSIDE("fog", glFogf(GL_FOG_DENSITY, 3.0f));
    INSIDE("point_size", glPointSize(3.0f));
    INSIDE("line_width", glLineWidth(3.0f));
    INSIDE("polygon_mode", glPolygonMode(GL_FRONT, GL_LINE));
    INSIDE("new_list", glNewList(1, GL_COMPILE));
    INSIDE("end_list", glEndList());
    INSIDE("gen_lists", (void)glGenLists(1));
    INSIDE("push_attrib", glPushAttrib(GL_ALL_ATTRIB_BITS));
    INSIDE("pop_attrib", glPopAttrib());
    INSIDE("bind_texture", glBindTexture(GL_TEXTURE_2D, 1));
    INSIDE("tex_env", glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL));
    INSIDE("rect", glRectf(0.0f, 0.0f, 1.0f, 1.0f));
    INSIDE("draw_arrays", glDrawArrays(GL_TRIANGLES, 0, 0));
    INSIDE("raster_pos", glRasterPos2f(0.0f, 0.0f));
    INSIDE("read_pixels", glReadPixels(0, 0, 1, 1, GL_RGB, GL_UNSIGNED_BYTE, (void*)answer));
    INSIDE("get_float", glGetFloatv(GL_FOG_DENSITY, answer));
    INSIDE("is_list", (void)glIsList(1));
    INSIDE("finish", glFinish());
    INSIDE("call_list", glCallList(77777));
    INSIDE("material", glMaterialf(GL_FRONT, GL_SHININESS, before.values[0] * 0.0f));
    WRONG("end/without_begin", glEnd());
    WRONG("end_list/without_new_list", glEndList());
    WRONG("new_list/within_list", {
        glNewList(5, GL_COMPILE);
        glNewList(6, GL_COMPILE);
        glEndList();
    });
    WRONG("list/wrong_call_is_kept", {
        glNewList(5, GL_COMPILE);
        glShadeModel(kNoSuchEnum);
        glEndList();
        glCallList(5);
    });
    WRONG("list/calls_itself", {
        glNewList(5, GL_COMPILE);
        glCallList(5);
        glEndList();
        glCallList(5);
    });
    WRONG("pop_matrix/underflow", glPopMatrix());
    WRONG("pop_attrib/underflow", glPopAttrib());
    WRONG("pop_client_attrib/underflow", glPopClientAttrib());
}

static void stackLimits(void) {
    begin("push_matrix/32_fit");
    for (int i = 0; i < 31; ++i) glPushMatrix();
    tellError();
    for (int i = 0; i < 31; ++i) glPopMatrix();
    end();
    begin("push_attrib/16_fit");
    for (int i = 0; i < 16; ++i) glPushAttrib(GL_CURRENT_BIT);
    tellError();
    glPushAttrib(GL_CURRENT_BIT);
    tellError();
    for (int i = 0; i < 16; ++i) glPopAttrib();
    end();
    begin("projection_stack/2_fit");
    glMatrixMode(GL_PROJECTION);
    glPushMatrix();
    tellError();
    glPopMatrix();
    glMatrixMode(GL_MODELVIEW);
    end();
    begin("error/first_stays");
    glEnable(kNoSuchEnum);
    glPointSize(-1.0f);
    end();
}

static void askQuestions(void) {
    glDepthFunc(GL_LEQUAL);
    enums();
    values();
    nesting();
    stackLimits();
}

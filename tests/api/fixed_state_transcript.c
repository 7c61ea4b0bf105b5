/* SPDX-License-Identifier: MIT */
#include "tests/api/fixed_state_transcript.h"

#ifndef OPENRT
#    include <GL/gl.h>
#    include <GL/glext.h>
#endif
#include <stdio.h>
#include <string.h>

#include "tests/api/fixed_state_queries.inc"

static Dump dumps[2];
static Dump *before = &dumps[0], *after = &dumps[1];
static TranscriptLine writeLine;
static void *writeUser;
static GLfloat scratch[16];

static const char *nameOfError(GLenum error) {
    switch (error) {
    case GL_NO_ERROR: return "";
    case GL_INVALID_ENUM: return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE: return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION: return "GL_INVALID_OPERATION";
    case GL_STACK_OVERFLOW: return "GL_STACK_OVERFLOW";
    case GL_STACK_UNDERFLOW: return "GL_STACK_UNDERFLOW";
    default: return "another error";
    }
}

/* After a call: its error, and what it changed. */
static void step(const char *call) {
    char line[2 * WIDTH];
    snprintf(line, sizeof line, "%s: %s", call, nameOfError(glGetError()));
    writeLine(writeUser, line);
    dumpState(after);
    for (int i = 0; i < after->count; ++i)
        if (strcmp(before->lines[i], after->lines[i]) != 0) writeLine(writeUser, after->lines[i]);
    Dump *const last = before;
    before = after;
    after = last;
}
#define DO(...)            \
    do {                   \
        __VA_ARGS__;       \
        step(#__VA_ARGS__); \
    } while (0)

#include "tests/api/fixed_state_calls.inc"

static void defaults(void) {
    for (int i = 0; i < before->count; ++i) writeLine(writeUser, before->lines[i]);
}

/* Everything, to one of two values. */
static void setAll(int second) {
    const GLfloat f = second ? 0.25f : 0.75f;
    const GLfloat v[4] = {f, f / 2, 1 - f, f};
    const GLdouble plane[4] = {f, 1, 2, 3};
    GLubyte stipple[128];
    memset(stipple, second ? 0x55 : 0x33, sizeof stipple);
    const GLenum comparison = second ? GL_GREATER : GL_NOTEQUAL;

    /* Materials that follow the colour would do so at other times than Mesa's, see below; and of the
     * lights Mesa forgets that GL_ENABLE_BIT has their switches. */
    for (size_t i = 0; i < sizeof(switches) / sizeof(switches)[0]; ++i) {
        const GLenum name = switches[i].name;
        if (name == GL_STENCIL_TEST || name == GL_AUTO_NORMAL || name == GL_MAP1_VERTEX_3 ||
            name == GL_COLOR_MATERIAL || (name >= GL_LIGHT0 && name <= GL_LIGHT7))
            continue;
        (second ? glEnable : glDisable)(name);
    }
    glMatrixMode(second ? GL_TEXTURE : GL_MODELVIEW);
    glColor4fv(v);
    glNormal3fv(v);
    glTexCoord4fv(v);
    glFogCoordf(f);
    glEdgeFlag((GLboolean)second);
    glFogi(GL_FOG_MODE, second ? GL_LINEAR : GL_EXP2);
    glFogf(GL_FOG_DENSITY, f);
    glFogf(GL_FOG_START, f);
    glFogf(GL_FOG_END, f);
    glFogfv(GL_FOG_COLOR, v);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, v);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, second);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, second);
    glShadeModel(second ? GL_FLAT : GL_SMOOTH);
    glLightfv(GL_LIGHT1, GL_DIFFUSE, v);
    glLightfv(GL_LIGHT1, GL_POSITION, v);
    glLightf(GL_LIGHT7, GL_SPOT_CUTOFF, 10 * f);
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, v);
    glMaterialfv(GL_FRONT, GL_EMISSION, v);
    glMaterialf(GL_BACK, GL_SHININESS, f);
    glColorMaterial(second ? GL_FRONT : GL_BACK, second ? GL_EMISSION : GL_AMBIENT);
    glPointSize(f);
    glLineWidth(f);
    glLineStipple(second + 2, (GLushort)(0x1111 << second));
    glPolygonOffset(f, 2 * f);
    glPolygonMode(GL_FRONT, second ? GL_LINE : GL_POINT);
    glPolygonStipple(stipple);
    glCullFace(second ? GL_FRONT : GL_BACK);
    glFrontFace(second ? GL_CW : GL_CCW);
    glClipPlane(GL_CLIP_PLANE0, plane);
    glAlphaFunc(comparison, f);
    glBlendFunc(second ? GL_DST_COLOR : GL_ONE, second ? GL_ZERO : GL_SRC_COLOR);
    glBlendEquation(second ? GL_MIN : GL_MAX);
    glBlendColor(v[0], v[1], v[2], v[3]);
    glLogicOp(second ? GL_XOR : GL_AND);
    glDepthFunc(comparison);
    glDepthMask((GLboolean)second);
    glColorMask((GLboolean)second, 1, (GLboolean)!second, 0);
    glStencilFunc(comparison, 0, 1);
    glStencilOp(second ? GL_INCR : GL_ZERO, GL_KEEP, GL_KEEP);
    glClearStencil(second);
    glClearDepth(f);
    glClearColor(v[0], v[1], v[2], v[3]);
    glClearAccum(v[0], v[1], v[2], v[3]);
    glDepthRange(f, 1);
    glViewport(second, 2, 3, 4);
    glScissor(second, 2, 3, 4);
    glSampleCoverage(f, (GLboolean)second);
    glHint(GL_FOG_HINT, second ? GL_NICEST : GL_FASTEST);
    glListBase((GLuint)second + 7);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, second ? GL_ADD : GL_BLEND);
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, v);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, second ? GL_ADD : GL_REPLACE);
    glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, second ? GL_SPHERE_MAP : GL_OBJECT_LINEAR);
    glTexGenfv(GL_T, GL_OBJECT_PLANE, v);
    glBindTexture(GL_TEXTURE_1D, (GLuint)second + 10);
    glBindTexture(GL_TEXTURE_2D, (GLuint)second + 20);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, second ? GL_CLAMP : GL_REPEAT);
}

/* Mesa keeps material calls back until somebody asks. */
static void settle(void) {
    glGetMaterialfv(GL_FRONT, GL_AMBIENT, scratch);
}

static void attributeGroups(void) {
    static const GLbitfield groups[] = {
        GL_CURRENT_BIT, GL_POINT_BIT, GL_LINE_BIT, GL_POLYGON_BIT, GL_POLYGON_STIPPLE_BIT,
        GL_PIXEL_MODE_BIT, GL_LIGHTING_BIT, GL_FOG_BIT, GL_DEPTH_BUFFER_BIT, GL_ACCUM_BUFFER_BIT,
        GL_STENCIL_BUFFER_BIT, GL_VIEWPORT_BIT, GL_TRANSFORM_BIT, GL_ENABLE_BIT,
        GL_COLOR_BUFFER_BIT, GL_HINT_BIT, GL_EVAL_BIT, GL_LIST_BIT, GL_TEXTURE_BIT,
        GL_SCISSOR_BIT, GL_MULTISAMPLE_BIT, 0, GL_ALL_ATTRIB_BITS,
        GL_LIGHTING_BIT | GL_CURRENT_BIT, GL_COLOR_BUFFER_BIT | GL_ENABLE_BIT};
    for (size_t i = 0; i < sizeof(groups) / sizeof(groups)[0]; ++i) {
        char name[32];
        snprintf(name, sizeof name, "group 0x%X", (unsigned)groups[i]);
        writeLine(writeUser, name);
        DO(setAll(0));
        DO(glPushAttrib(groups[i]); setAll(1); settle(); glPopAttrib());
        DO(setAll(1));
        DO(glPushAttrib(groups[i]); setAll(0); settle(); glPopAttrib());
    }
}

static void colorMaterialGroups(void) {
    DO(setAll(0));
    for (int i = 0; i < 2; ++i) {
        const GLbitfield group = i ? GL_ENABLE_BIT : GL_LIGHTING_BIT;
        DO(glPushAttrib(group); glEnable(GL_COLOR_MATERIAL); glColor3f(0.125f, 1, 0.5f);
           settle(); glPopAttrib());
        DO(glColor3f(1, 0, (GLfloat)i));
        DO(glEnable(GL_COLOR_MATERIAL));
        DO(glPushAttrib(group | GL_CURRENT_BIT); glColor3f(0, 1, 0); glDisable(GL_COLOR_MATERIAL);
           settle(); glPopAttrib());
        DO(glDisable(GL_COLOR_MATERIAL));
    }
}

static void stacks(void) {
    DO(glPopAttrib());
    for (int i = 0; i < 17; ++i) DO(glPushAttrib(GL_LINE_BIT); glLineWidth((GLfloat)(i + 2)));
    for (int i = 0; i < 17; ++i) DO(glPopAttrib());
    DO(glPopClientAttrib());
    for (int i = 0; i < 17; ++i)
        DO(glPushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT); glPixelStorei(GL_UNPACK_ROW_LENGTH, i));
    for (int i = 0; i < 17; ++i) DO(glPopClientAttrib());
    DO(glPixelStorei(GL_UNPACK_ALIGNMENT, 2));
    DO(glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT); glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
       glPopClientAttrib());
    DO(glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS); glPixelStorei(GL_UNPACK_ALIGNMENT, 8);
       glPopClientAttrib());
    DO(glInitNames());
    DO((void)glRenderMode(GL_RENDER));
    DO((void)glRenderMode(GL_LINEAR));
}

/* Not legal between begin and end. */
static void insideBegin(void) {
#define INSIDE(...)             \
    do {                        \
        glBegin(GL_TRIANGLES);  \
        __VA_ARGS__;            \
        glEnd();                \
        step(#__VA_ARGS__);     \
    } while (0)
    INSIDE(glEnable(GL_FOG));
    INSIDE(glDisable(GL_DITHER));
    INSIDE(glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 4));
    INSIDE(glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1));
    INSIDE(glShadeModel(GL_FLAT));
    INSIDE(glColorMaterial(GL_FRONT, GL_AMBIENT));
    INSIDE(glFogf(GL_FOG_DENSITY, 2));
    INSIDE(glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL));
    INSIDE(glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP));
    INSIDE(glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP));
    INSIDE(glBindTexture(GL_TEXTURE_2D, 5));
    INSIDE(glClipPlane(GL_CLIP_PLANE0, doubles));
    INSIDE(glCullFace(GL_FRONT));
    INSIDE(glFrontFace(GL_CW));
    INSIDE(glPolygonMode(GL_FRONT, GL_LINE));
    INSIDE(glPolygonOffset(1, 2));
    INSIDE(glPointSize(2));
    INSIDE(glLineWidth(2));
    INSIDE(glLineStipple(2, 2));
    INSIDE(glAlphaFunc(GL_LESS, 0.5f));
    INSIDE(glBlendFunc(GL_ONE, GL_ONE));
    INSIDE(glBlendEquation(GL_MIN));
    INSIDE(glBlendColor(1, 1, 1, 1));
    INSIDE(glLogicOp(GL_XOR));
    INSIDE(glDepthFunc(GL_ALWAYS));
    INSIDE(glDepthMask(0));
    INSIDE(glColorMask(0, 0, 0, 0));
    INSIDE(glStencilFunc(GL_LESS, 0, 1));
    INSIDE(glStencilOp(GL_ZERO, GL_ZERO, GL_ZERO));
    INSIDE(glClearStencil(3));
    INSIDE(glClearAccum(1, 1, 1, 1));
    INSIDE(glHint(GL_FOG_HINT, GL_NICEST));
    INSIDE(glPushAttrib(GL_ALL_ATTRIB_BITS));
    INSIDE(glPopAttrib());
    INSIDE((void)glIsEnabled(GL_FOG));
    INSIDE(glGetFloatv(GL_CURRENT_COLOR, scratch));
    INSIDE(glGetLightfv(GL_LIGHT0, GL_AMBIENT, scratch));
    INSIDE((void)glGetString(GL_VERSION));
    INSIDE((void)glRenderMode(GL_RENDER));
}

#ifdef OPENRT
const char *const stateSectionNames[STATE_SECTIONS] = {
    "defaults", "lighting", "materials", "fog",           "environment", "generation", "raster",
    "fragments", "switching", "textures", "currentValues", "attributeGroups", "colorMaterialGroups", "stacks",
    "insideBegin"};

#endif

void TRANSCRIBE(int section, TranscriptLine line, void *user) {
    static void (*const sections[])(void) = {defaults,  lighting,  materials, fog,
                                             environment, generation, raster,  fragments,
                                             switching, textures,  currentValues,
                                             attributeGroups, colorMaterialGroups,
                                             stacks, insideBegin};
    writeLine = line;
    writeUser = user;
    glClear(GL_DEPTH_BUFFER_BIT); /* the library's mark of a program in OpenGL's manner */
    glViewport(0, 0, 8, 8);
    glScissor(0, 0, 8, 8);
    dumpState(before);
    sections[section]();
}

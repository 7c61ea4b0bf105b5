/* SPDX-License-Identifier: MIT */
/* The state that each texture unit has by itself: current coordinates, what is bound and switched
 * on, environments, matrices, arrays; what the attribute stacks bring back of it. */
#define GL_GLEXT_PROTOTYPES
#include "tests/conformance/questions.h"

enum { kUnits = 4 };

static void tellCoordinates(GLenum unit) {
    GLfloat current[4];
    glActiveTexture(unit);
    glGetFloatv(GL_CURRENT_TEXTURE_COORDS, current);
    for (int i = 0; i < 4; ++i) printf("%g ", (double)current[i]);
    printf("\n");
    glActiveTexture(GL_TEXTURE0);
}

/* Every kind of number in a unit of its own, and fewer components from call to call: where they
 * become more and fewer again, Mesa keeps some of before. */
#define FAMILY(kind, unit, values)                            \
    glMultiTexCoord4##kind(unit, values[0], values[1], values[2], values[3]), \
        tellCoordinates(unit);                                \
    glMultiTexCoord4##kind##v(unit, values + 1), tellCoordinates(unit); \
    glMultiTexCoord3##kind(unit, values[0], values[1], values[2]), tellCoordinates(unit); \
    glMultiTexCoord3##kind##v(unit, values + 1), tellCoordinates(unit); \
    glMultiTexCoord2##kind(unit, values[0], values[1]), tellCoordinates(unit); \
    glMultiTexCoord2##kind##v(unit, values + 1), tellCoordinates(unit); \
    glMultiTexCoord1##kind(unit, values[0]), tellCoordinates(unit); \
    glMultiTexCoord1##kind##v(unit, values + 1), tellCoordinates(unit)

static void families(void) {
    static const GLdouble doubles[5] = {0.81, 0.17, 3.5, 2.0, -0.5};
    static const GLfloat floats[5] = {0.37f, 0.62f, -4.0f, 1.5f, 2.25f};
    static const GLint integers[5] = {3, 1, -6, 5, 12};
    static const GLshort shorts[5] = {2, 5, 9, 7, -3};
    beginCase("families");
    FAMILY(d, GL_TEXTURE0, doubles);
    FAMILY(f, GL_TEXTURE1, floats);
    FAMILY(i, GL_TEXTURE2, integers);
    FAMILY(s, GL_TEXTURE3, shorts);
    tellError();
}

static void tellUnit(void) {
    static const GLenum asked[] = {GL_ACTIVE_TEXTURE, GL_CLIENT_ACTIVE_TEXTURE,
                                   GL_TEXTURE_BINDING_1D, GL_TEXTURE_BINDING_2D,
                                   GL_TEXTURE_STACK_DEPTH, GL_TEXTURE_1D, GL_TEXTURE_2D,
                                   GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_Q, GL_TEXTURE_COORD_ARRAY,
                                   GL_TEXTURE_COORD_ARRAY_SIZE, GL_TEXTURE_COORD_ARRAY_TYPE,
                                   GL_TEXTURE_COORD_ARRAY_STRIDE};
    GLfloat values[16];
    GLint number = 0;
    for (size_t i = 0; i < sizeof asked / sizeof asked[0]; ++i) {
        glGetIntegerv(asked[i], &number);
        printf("%d ", number);
    }
    printf("\n");
    glGetFloatv(GL_CURRENT_TEXTURE_COORDS, values);
    for (int i = 0; i < 4; ++i) printf("%g ", (double)values[i]);
    glGetFloatv(GL_CURRENT_RASTER_TEXTURE_COORDS, values);
    for (int i = 0; i < 4; ++i) printf("%g ", (double)values[i]);
    glGetFloatv(GL_TEXTURE_MATRIX, values);
    for (int i = 0; i < 16; ++i) printf("%g ", (double)values[i]);
    glGetTexEnviv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, &number);
    printf("%d ", number);
    glGetTexEnviv(GL_TEXTURE_ENV, GL_SOURCE0_RGB, &number);
    printf("%d ", number);
    glGetTexEnvfv(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, values);
    printf("%g ", (double)values[0]);
    glGetTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, values);
    for (int i = 0; i < 4; ++i) printf("%g ", (double)values[i]);
    glGetTexGenfv(GL_T, GL_EYE_PLANE, values);
    for (int i = 0; i < 4; ++i) printf("%g ", (double)values[i]);
    printf("\n");
}

static void tellUnits(void) {
    GLint active = 0, client = 0;
    glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
    glGetIntegerv(GL_CLIENT_ACTIVE_TEXTURE, &client);
    printf("%d %d\n", active, client);
    for (int unit = 0; unit < kUnits; ++unit) {
        glActiveTexture(GL_TEXTURE0 + (GLenum)unit);
        glClientActiveTexture(GL_TEXTURE0 + (GLenum)unit);
        tellUnit();
    }
    glActiveTexture((GLenum)active);
    glClientActiveTexture((GLenum)client);
    tellError();
}

/* Every value of a unit is set to something of its own. */
static void changeUnit(int unit) {
    const GLfloat number = (GLfloat)unit;
    const GLfloat vector[4] = {0.25f, 0.5f, 0.125f * number, 0.75f};
    glActiveTexture(GL_TEXTURE0 + (GLenum)unit);
    glClientActiveTexture(GL_TEXTURE0 + (GLenum)unit);
    glBindTexture(GL_TEXTURE_1D, 101 + (GLuint)unit);
    glBindTexture(GL_TEXTURE_2D, 111 + (GLuint)unit);
    (unit % 2 ? glEnable : glDisable)(GL_TEXTURE_1D);
    (unit > 1 ? glEnable : glDisable)(GL_TEXTURE_2D);
    (unit == 2 ? glEnable : glDisable)(GL_TEXTURE_GEN_S);
    (unit == 3 ? glEnable : glDisable)(GL_TEXTURE_GEN_Q);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, unit % 2 ? GL_ADD : GL_BLEND);
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_RGB, GL_TEXTURE0 + unit);
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, vector);
    glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, number - 1.5f);
    glTexGenfv(GL_T, GL_EYE_PLANE, vector);
    glMultiTexCoord4fv(GL_TEXTURE0 + (GLenum)unit, vector);
    glTexCoordPointer(1 + unit, GL_FLOAT, 8 * unit, vector);
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    glMatrixMode(GL_TEXTURE);
    glLoadIdentity();
    if (unit % 2) glPushMatrix();
    glTranslatef(number, 0.5f, 0.0f);
    glMatrixMode(GL_MODELVIEW);
}

static void resetUnit(int unit) {
    glActiveTexture(GL_TEXTURE0 + (GLenum)unit);
    glMatrixMode(GL_TEXTURE);
    if (unit % 2) glPopMatrix();
    glLoadIdentity();
    glMatrixMode(GL_MODELVIEW);
}

static void sameCoordinates(void) {
    for (int unit = 0; unit < kUnits; ++unit)
        glMultiTexCoord4f(GL_TEXTURE0 + (GLenum)unit, 0.5f, 0.75f, 0.25f, 2.0f);
    tellUnits();
}

static void stateOfUnits(void) {
    static const struct {
        const char* name;
        GLbitfield groups;
    } stacks[] = {{"texture", GL_TEXTURE_BIT},
                  {"enable", GL_ENABLE_BIT},
                  {"current", GL_CURRENT_BIT},
                  {"transform", GL_TRANSFORM_BIT},
                  {"all", GL_ALL_ATTRIB_BITS}};
    glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    beginCase("state/start");
    tellUnits();
    for (int unit = 0; unit < kUnits; ++unit) changeUnit(unit);
    glRasterPos2f(0.3f, 0.4f);
    beginCase("state/changed");
    tellUnits();
    for (int unit = 0; unit < kUnits; ++unit) resetUnit(unit);
    glPopAttrib();
    beginCase("state/popped");
    tellUnits();
    glPopClientAttrib();
    beginCase("state/client_popped");
    tellUnits();
    for (size_t i = 0; i < sizeof stacks / sizeof stacks[0]; ++i) {
        char name[48];
        snprintf(name, sizeof name, "state/stack/%s", stacks[i].name);
        beginCase(name);
        sameCoordinates();
        glPushAttrib(GL_ALL_ATTRIB_BITS);
        glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
        changeUnit(2);
        changeUnit(1);
        glPushAttrib(stacks[i].groups);
        glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
        changeUnit(3);
        changeUnit(0);
        glActiveTexture(GL_TEXTURE2);
        glDisable(GL_TEXTURE_2D);
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
        glBindTexture(GL_TEXTURE_2D, 5);
        glClientActiveTexture(GL_TEXTURE2);
        glDisableClientState(GL_TEXTURE_COORD_ARRAY);
        tellCoordinates(GL_TEXTURE2); /* without, Mesa restores some too early */
        glActiveTexture(GL_TEXTURE2);
        glPopClientAttrib();
        glPopAttrib();
        tellUnits();
        resetUnit(0);
        resetUnit(1);
        resetUnit(2);
        resetUnit(3);
        glPopClientAttrib();
        glPopAttrib();
    }
    /* A texture that is deleted is bound nowhere any more. */
    beginCase("state/deleted");
    sameCoordinates();
    {
        const GLuint name = 111;
        for (int unit = 0; unit < kUnits; ++unit) {
            glActiveTexture(GL_TEXTURE0 + (GLenum)unit);
            glBindTexture(GL_TEXTURE_2D, unit == 2 ? 112 : name);
        }
        glDeleteTextures(1, &name);
        tellUnits();
        for (int unit = kUnits; unit-- > 0;) {
            glActiveTexture(GL_TEXTURE0 + (GLenum)unit);
            glBindTexture(GL_TEXTURE_2D, 0);
        }
    }
    beginCase("state/in_list");
    glNewList(2, GL_COMPILE);
    glActiveTexture(GL_TEXTURE1);
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_ADD);
    glMultiTexCoord2f(GL_TEXTURE3, 0.5f, 0.25f);
    glClientActiveTexture(GL_TEXTURE2); /* at once */
    glEndList();
    tellUnits();
    glClientActiveTexture(GL_TEXTURE0);
    glCallList(2);
    tellUnits();
    glDisable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    glActiveTexture(GL_TEXTURE0);
}

/* Coordinates of the raster position, which go the way of a vertex's in every unit. */
static void rasterPosition(void) {
    /* Of those that look at normals Mesa makes something else here. */
    static const GLenum generations[] = {GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_EYE_LINEAR,
                                         GL_OBJECT_LINEAR};
    static const GLfloat plane[4] = {0.25f, 0.5f, -0.75f, 0.125f};
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    for (int unit = 0; unit < kUnits; ++unit) {
        glActiveTexture(GL_TEXTURE0 + (GLenum)unit);
        glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, (GLint)generations[unit]);
        glTexGenfv(GL_S, GL_OBJECT_PLANE, plane);
        glTexGenfv(GL_S, GL_EYE_PLANE, plane);
        glEnable(GL_TEXTURE_GEN_S);
        glMultiTexCoord4f(GL_TEXTURE0 + (GLenum)unit, 0.5f, 0.25f, 0.125f, 1.0f);
        glMatrixMode(GL_TEXTURE);
        glScalef(1.0f + 0.5f * (GLfloat)unit, 0.75f, 1.0f);
        glMatrixMode(GL_MODELVIEW);
    }
    glPushMatrix();
    glTranslatef(0.125f, -0.25f, 0.375f);
    glRasterPos3f(0.3f, 0.4f, -0.2f);
    glPopMatrix();
    for (int unit = 0; unit < kUnits; ++unit) {
        GLfloat values[4];
        char name[32];
        snprintf(name, sizeof name, "raster/%d", unit);
        beginCase(name);
        glActiveTexture(GL_TEXTURE0 + (GLenum)unit);
        glGetFloatv(GL_CURRENT_RASTER_TEXTURE_COORDS, values);
        for (int i = 0; i < 4; ++i) printf("%g ", (double)values[i]);
        printf("\n");
        tellError();
        glMatrixMode(GL_TEXTURE);
        glLoadIdentity();
        glMatrixMode(GL_MODELVIEW);
    }
    glPopAttrib();
}

static void wrongUnits(void) {
    beginCase("wrong/active");
    glActiveTexture(GL_TEXTURE0 - 1);
    tellError();
    glActiveTexture(GL_TEXTURE0 + 1000);
    tellError();
    glClientActiveTexture(GL_TEXTURE0 - 1);
    tellError();
    glClientActiveTexture(GL_TEXTURE0 + 1000);
    tellError();
    tellUnits();
    beginCase("wrong/inside");
    glBegin(GL_TRIANGLES);
    glActiveTexture(GL_TEXTURE1);
    glEnd();
    tellError();
    tellUnits();
    beginCase("wrong/stack");
    glActiveTexture(GL_TEXTURE1);
    glMatrixMode(GL_TEXTURE);
    glPopMatrix();
    tellError();
    glActiveTexture(GL_TEXTURE0);
    glPushMatrix();
    glActiveTexture(GL_TEXTURE1);
    glPopMatrix();
    tellError();
    glActiveTexture(GL_TEXTURE0);
    glPopMatrix();
    tellError();
    glMatrixMode(GL_MODELVIEW);
}

static void askQuestions(void) {
    families();
    stateOfUnits();
    rasterPosition();
    wrongUnits();
}

/* SPDX-License-Identifier: MIT */
/* Several texture units: what they make of a fragment together, and where their texture coordinates
 * come from. */
#define GL_GLEXT_PROTOTYPES
#include "tests/conformance/questions.h"

enum { kUnits = 4, kSide = 4 };

static const GLfloat corners[4][2] = {{2.25f, 3.25f}, {29.75f, 3.25f}, {2.25f, 28.75f},
                                      {29.75f, 28.75f}};
static const GLfloat colors[4][4] = {{0.11f, 0.82f, 0.33f, 0.9f}, {0.63f, 0.14f, 0.97f, 0.3f},
                                     {0.91f, 0.72f, 0.43f, 0.6f}, {0.52f, 0.31f, 0.84f, 0.8f}};
/* Of each unit and corner; no edge of a texel runs through a pixel that is looked at. */
static const GLfloat coordinates[kUnits][4][4] = {
    {{0.03f, 0.02f, 0, 1}, {0.98f, 0.04f, 0, 1}, {0.01f, 0.96f, 0, 1}, {0.97f, 0.99f, 0, 1}},
    {{1.93f, 0.12f, 0, 2}, {0.18f, 0.34f, 0, 2}, {1.71f, 1.86f, 0, 2}, {0.07f, 1.69f, 0, 2}},
    {{0.12f, 1.52f, 0, 1}, {1.38f, 0.14f, 0, 1}, {0.31f, 0.16f, 0, 1}, {0.67f, 0.49f, 0, 1}},
    {{0.43f, 0.72f, 0, 1}, {0.08f, 0.24f, 0, 1}, {0.61f, 0.56f, 0, 1}, {0.77f, 0.29f, 0, 1}}};

static GLuint names[kUnits];

static void tellLevel(int level) {
    if (kTellsAlternatives)
        printf("%d|%d|%d ", level, level + 1, level - 1);
    else
        printf("%d ", level);
}

static void tellPixels(void) {
    static const int places[7][2] = {{16, 16}, {5, 6}, {26, 5}, {7, 25}, {25, 26}, {11, 20}, {0, 0}};
    for (int i = 0; i < 7; ++i) {
        GLubyte pixel[4] = {0};
        glReadPixels(places[i][0], places[i][1], 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
        for (int k = 0; k < 3; ++k) tellLevel(pixel[k]);
        printf("\n");
    }
    tellError();
}

static void makeTextures(void) {
    static const GLint formats[kUnits] = {GL_RGBA, GL_RGB, GL_LUMINANCE_ALPHA, GL_INTENSITY};
    glGenTextures(kUnits, names);
    for (int unit = 0; unit < kUnits; ++unit) {
        GLubyte image[kSide * kSide][4];
        for (int i = 0; i < kSide * kSide; ++i)
            for (int k = 0; k < 4; ++k)
                image[i][k] = (GLubyte)(40 + (i * 53 + k * 71 + unit * 37 + i * i * k) % 190);
        glBindTexture(GL_TEXTURE_2D, names[unit]);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glTexImage2D(GL_TEXTURE_2D, 0, formats[unit], kSide, kSide, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                     image);
    }
    glBindTexture(GL_TEXTURE_2D, 0);
}

/* Each unit with its texture; `first` is the one that is active afterwards. */
static void useUnits(int first, int count) {
    for (int unit = first + count - 1; unit >= first; --unit) {
        glActiveTexture(GL_TEXTURE0 + (GLenum)unit);
        glBindTexture(GL_TEXTURE_2D, names[unit]);
        glEnable(GL_TEXTURE_2D);
    }
}

static void coordinate(int i) {
    glTexCoord4fv(coordinates[0][i]);
    for (int unit = 1; unit < kUnits; ++unit)
        glMultiTexCoord4fv(GL_TEXTURE0 + (GLenum)unit, coordinates[unit][i]);
}

static void vertex(int i) {
    glColor4fv(colors[i]);
    coordinate(i);
    glVertex2fv(corners[i]);
}

static void immediate(void) {
    glBegin(GL_TRIANGLE_STRIP); /* how a quad is split would be open */
    for (int i = 0; i < 4; ++i) vertex(i);
    glEnd();
}

static void inList(void) {
    glNewList(1, GL_COMPILE);
    immediate();
    glEndList();
    glCallList(1);
}

static void setArrays(void) {
    glVertexPointer(2, GL_FLOAT, 0, corners);
    glColorPointer(4, GL_FLOAT, 0, colors);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    for (int unit = 0; unit < kUnits; ++unit) {
        glClientActiveTexture(GL_TEXTURE0 + (GLenum)unit);
        glTexCoordPointer(4, GL_FLOAT, 0, coordinates[unit]);
        glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    }
}

static void dropArrays(void) {
    glDisableClientState(GL_VERTEX_ARRAY);
    glDisableClientState(GL_COLOR_ARRAY);
    for (int unit = kUnits; unit-- > 0;) {
        glClientActiveTexture(GL_TEXTURE0 + (GLenum)unit);
        glDisableClientState(GL_TEXTURE_COORD_ARRAY);
    }
}

static void fromArrays(void) {
    setArrays();
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    dropArrays();
}

static void fromElements(void) {
    static const GLubyte order[4] = {2, 3, 0, 1};
    setArrays();
    glDrawElements(GL_TRIANGLE_STRIP, 4, GL_UNSIGNED_BYTE, order);
    dropArrays();
}

static void elementByElement(void) {
    setArrays();
    glBegin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 4; ++i) glArrayElement(i);
    glEnd();
    dropArrays();
}

static void arraysInList(void) {
    glNewList(1, GL_COMPILE);
    fromArrays();
    glEndList();
    glCallList(1);
}

/* Elements with the coordinates of the second unit, which lie in front of the vertices. */
static void interleaved(void) {
    static GLfloat elements[4][5];
    for (int i = 0; i < 4; ++i) {
        elements[i][0] = coordinates[0][i][0];
        elements[i][1] = coordinates[0][i][1];
        elements[i][2] = corners[i][0];
        elements[i][3] = corners[i][1];
    }
    glColor4fv(colors[2]);
    coordinate(1);
    glClientActiveTexture(GL_TEXTURE1);
    glInterleavedArrays(GL_T2F_V3F, 0, elements);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glDisableClientState(GL_TEXTURE_COORD_ARRAY);
    glDisableClientState(GL_VERTEX_ARRAY);
    glClientActiveTexture(GL_TEXTURE0);
}

/* The list sets none of them: they are those of the call. */
static void inherited(void) {
    glNewList(1, GL_COMPILE);
    glBegin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 4; ++i) glVertex2fv(corners[i]);
    glEnd();
    glEndList();
    glColor4fv(colors[1]);
    coordinate(2);
    glCallList(1);
}

/* The list sets those of one unit, which stay. */
static void partlyInherited(void) {
    coordinate(3);
    glColor4fv(colors[2]);
    glNewList(1, GL_COMPILE);
    glBegin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 4; ++i) {
        glMultiTexCoord2fv(GL_TEXTURE1, coordinates[3][i]);
        glVertex2fv(corners[i]);
    }
    glEnd();
    glEndList();
    glCallList(1);
    glBegin(GL_TRIANGLE_STRIP);
    glVertex2f(20.25f, 20.25f);
    glVertex2f(29.75f, 20.25f);
    glVertex2f(20.25f, 29.75f);
    glVertex2f(29.75f, 29.75f);
    glEnd();
}

/* From the second vertex on: the first has what was set before. */
static void changedLate(void) {
    glColor4fv(colors[3]);
    coordinate(0);
    glBegin(GL_TRIANGLE_STRIP);
    glVertex2fv(corners[0]);
    for (int i = 1; i < 4; ++i) vertex(i);
    glEnd();
}

/* Level, so that all pixels across have the same colour. */
static void lines(void) {
    static const GLfloat ends[2][2] = {{2.25f, 16.5f}, {29.75f, 16.5f}};
    glLineWidth(27.0f);
    glBegin(GL_LINES);
    for (int i = 0; i < 2; ++i) {
        glColor4fv(colors[3 * i]);
        coordinate(3 * i);
        glVertex2fv(ends[i]);
    }
    glEnd();
    glLineWidth(1.0f);
}

static void points(void) {
    glPointSize(11.0f);
    glBegin(GL_POINTS);
    for (int i = 0; i < 4; ++i) vertex(i);
    glEnd();
    glPointSize(1.0f);
}

static void rectangle(void) {
    glColor4fv(colors[2]);
    coordinate(1);
    glRectf(2.25f, 3.25f, 29.75f, 28.75f);
}

static void bitmap(void) {
    static GLubyte bits[32][4];
    for (int i = 0; i < 32; ++i)
        for (int k = 0; k < 4; ++k) bits[i][k] = 0xFF;
    glColor4fv(colors[1]);
    coordinate(3);
    glRasterPos2f(1.0f, 2.0f);
    glBitmap(28, 28, 0.0f, 0.0f, 0.0f, 0.0f, bits[0]);
}

typedef struct {
    const char* name;
    void (*draw)(void);
} Drawing;
static const Drawing drawings[] = {{"immediate", immediate},
                                   {"list", inList},
                                   {"arrays", fromArrays},
                                   {"elements", fromElements},
                                   {"element_by_element", elementByElement},
                                   {"arrays_in_list", arraysInList},
                                   {"interleaved", interleaved},
                                   {"inherited", inherited},
                                   {"partly_inherited", partlyInherited},
                                   {"changed_late", changedLate},
                                   {"lines", lines},
                                   {"points", points},
                                   {"rectangle", rectangle},
                                   {"bitmap", bitmap}};

static void tellDrawing(const char* group, const Drawing* drawing) {
    char name[128];
    snprintf(name, sizeof name, "%s/%s", group, drawing->name);
    beginCase(name);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    drawing->draw();
    tellPixels();
}

enum { kDrawings = sizeof drawings / sizeof drawings[0] };

static void tellDrawings(const char* group) {
    for (size_t i = 0; i < kDrawings; ++i) tellDrawing(group, &drawings[i]);
}

/* Without the last, the bitmap: Mesa has no transformed coordinates there. */
static void tellPrimitives(const char* group) {
    for (size_t i = 0; i + 1 < kDrawings; ++i) tellDrawing(group, &drawings[i]);
}

static void environment(int unit, GLenum mode) {
    static const GLfloat constant[4] = {0.3f, 0.7f, 0.6f, 0.4f};
    glActiveTexture(GL_TEXTURE0 + (GLenum)unit);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, (GLint)mode);
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, constant);
}

static void modes(void) {
    static const struct {
        const char* name;
        GLenum mode;
    } cases[] = {{"modulate", GL_MODULATE}, {"add", GL_ADD},         {"decal", GL_DECAL},
                 {"blend", GL_BLEND},       {"replace", GL_REPLACE}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        char name[64];
        glPushAttrib(GL_ALL_ATTRIB_BITS);
        useUnits(0, 2);
        environment(1, cases[i].mode);
        snprintf(name, sizeof name, "two/%s", cases[i].name);
        tellDrawings(name);
        glPopAttrib();
    }
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    useUnits(0, kUnits);
    environment(1, GL_ADD);
    environment(2, GL_MODULATE);
    environment(3, GL_BLEND);
    tellDrawings("four");
    glShadeModel(GL_FLAT);
    tellDrawings("four/flat");
    glShadeModel(GL_SMOOTH);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ZERO); /* alpha shows by blending with black */
    tellDrawings("four/alpha");
    glPopAttrib();
    for (int unit = 1; unit < kUnits; ++unit) {
        char name[64];
        glPushAttrib(GL_ALL_ATTRIB_BITS);
        useUnits(unit, 1);
        snprintf(name, sizeof name, "only_unit/%d", unit);
        tellDrawings(name);
        glPopAttrib();
    }
    /* One that is switched off, or has no image, is passed over. */
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    useUnits(0, kUnits);
    glActiveTexture(GL_TEXTURE1);
    glDisable(GL_TEXTURE_2D);
    glActiveTexture(GL_TEXTURE2);
    glBindTexture(GL_TEXTURE_2D, 77);
    tellDrawings("passed_over");
    glPopAttrib();
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    useUnits(0, 2);
    glEnable(GL_COLOR_SUM);
    glSecondaryColor3f(0.1f, 0.2f, 0.05f);
    tellDrawings("sum");
    glPopAttrib();
    glSecondaryColor3f(0.0f, 0.0f, 0.0f);
}

static void source(GLenum which, GLenum value) {
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_RGB + which, (GLint)value);
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_ALPHA + which, (GLint)value);
}

static void combiners(void) {
    static const struct {
        const char* name;
        GLenum first, second;
    } cases[] = {{"previous", GL_PREVIOUS, GL_TEXTURE},
                 {"primary", GL_PRIMARY_COLOR, GL_TEXTURE},
                 {"constant", GL_CONSTANT, GL_PREVIOUS},
                 {"crossbar_0", GL_TEXTURE0, GL_PREVIOUS},
                 {"crossbar_1", GL_PREVIOUS, GL_TEXTURE1},
                 {"crossbar_both", GL_TEXTURE0, GL_TEXTURE1},
                 {"crossbar_later", GL_TEXTURE2, GL_TEXTURE0}};
    static const struct {
        const char* name;
        GLenum function;
    } functions[] = {{"modulate", GL_MODULATE},       {"add_signed", GL_ADD_SIGNED},
                     {"interpolate", GL_INTERPOLATE}, {"subtract", GL_SUBTRACT},
                     {"dot3", GL_DOT3_RGB}};
    static const Drawing drawing = {"immediate", immediate};
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    useUnits(0, 3);
    for (int unit = 0; unit < 3; ++unit)
        for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i)
            for (size_t j = 0; j < sizeof functions / sizeof functions[0]; ++j) {
                char name[96];
                snprintf(name, sizeof name, "combine/%d/%s/%s", unit, cases[i].name,
                         functions[j].name);
                environment(unit, GL_COMBINE);
                glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, (GLint)functions[j].function);
                source(0, cases[i].first);
                source(1, cases[i].second);
                source(2, GL_PRIMARY_COLOR);
                tellDrawing(name, &drawing);
                environment(unit, GL_MODULATE);
            }
    glPopAttrib();
}

/* Coordinates on their way: matrices and generation of one unit leave the others alone. */
static void transformations(void) {
    static const GLfloat plane[4] = {0.031f, 0.013f, 0.0f, 0.07f},
                         other[4] = {-0.017f, 0.029f, 0.0f, 0.31f};
    static const GLenum generations[] = {GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_SPHERE_MAP};
    static const char* const generationNames[] = {"object", "eye", "sphere"};
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    useUnits(0, 2);
    glMatrixMode(GL_TEXTURE);
    for (int unit = 0; unit < 2; ++unit) {
        char name[32];
        glActiveTexture(GL_TEXTURE0 + (GLenum)unit);
        glPushMatrix();
        glScalef(0.71f, 1.33f, 1.0f);
        glTranslatef(0.23f, 0.11f, 0.0f);
        glRotatef(17.0f, 0.0f, 0.0f, 1.0f);
        snprintf(name, sizeof name, "matrix/%d", unit);
        tellPrimitives(name);
        glPopMatrix();
    }
    glMatrixMode(GL_MODELVIEW);
    for (int unit = 0; unit < 2; ++unit)
        for (int i = 0; i < 3; ++i) {
            char name[32];
            glActiveTexture(GL_TEXTURE0 + (GLenum)unit);
            glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, (GLint)generations[i]);
            glTexGeni(GL_T, GL_TEXTURE_GEN_MODE, (GLint)generations[i]);
            glTexGenfv(GL_S, GL_OBJECT_PLANE, plane);
            glTexGenfv(GL_T, GL_OBJECT_PLANE, other);
            glTexGenfv(GL_S, GL_EYE_PLANE, other);
            glTexGenfv(GL_T, GL_EYE_PLANE, plane);
            glEnable(GL_TEXTURE_GEN_S);
            glEnable(GL_TEXTURE_GEN_T);
            glNormal3f(0.36f, 0.48f, 0.8f);
            glPushMatrix();
            if (i < 2) {
                glTranslatef(1.0f, 2.0f, 0.0f);
                glScalef(0.9f, 0.9f, 1.0f);
            }
            snprintf(name, sizeof name, "generated/%s/%d", generationNames[i], unit);
            tellPrimitives(name);
            glPopMatrix();
            glDisable(GL_TEXTURE_GEN_S);
            glDisable(GL_TEXTURE_GEN_T);
        }
    glPopAttrib();
}

static void askQuestions(void) {
    useWindowCoordinates();
    makeTextures();
    modes();
    combiners();
    transformations();
}

/* SPDX-License-Identifier: MIT */
/* What vertices latch beside colour, normal and texture coordinate: secondary colours, fog
 * coordinates, and the size that points have at their distance; by immediate mode, in lists, out of
 * arrays, and as lines and points. */
#define GL_GLEXT_PROTOTYPES
#include "tests/conformance/questions.h"

static const GLfloat corners[4][2] = {{2.25f, 3.25f}, {29.75f, 3.25f}, {2.25f, 28.75f},
                                      {29.75f, 28.75f}};
static const GLfloat colors[4][3] = {{0.11f, 0.22f, 0.33f}, {0.63f, 0.14f, 0.27f},
                                     {0.21f, 0.72f, 0.43f}, {0.52f, 0.31f, 0.84f}};
/* No sum is above 1, where Mesa cuts off after fog. */
static const GLfloat added[4][3] = {{0.41f, 0.02f, 0.13f}, {0.03f, 0.34f, 0.07f},
                                    {0.11f, 0.12f, 0.43f}, {0.42f, 0.61f, 0.04f}};
/* None below 0, of which Mesa drops the sign. */
static const GLfloat coordinates[4] = {0.3f, 2.7f, 0.8f, 1.6f};

static void tellLevel(int level) {
    if (kTellsAlternatives)
        printf("%d|%d|%d ", level, level + 1, level - 1);
    else
        printf("%d ", level);
}

static void tellPixel(int x, int y) {
    GLubyte pixel[4] = {0};
    glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    for (int k = 0; k < 3; ++k) tellLevel(pixel[k]);
    printf("\n");
}

static void tellPixels(void) {
    tellPixel(16, 16);
    tellPixel(5, 6);
    tellPixel(26, 5);
    tellPixel(7, 25);
    tellPixel(25, 26);
    tellPixel(0, 0);
    tellError();
}

static void vertex(int i) {
    glColor3fv(colors[i]);
    glSecondaryColor3fv(added[i]);
    glFogCoordf(coordinates[i]);
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

static void fromArrays(void) {
    glVertexPointer(2, GL_FLOAT, 0, corners);
    glColorPointer(3, GL_FLOAT, 0, colors);
    glSecondaryColorPointer(3, GL_FLOAT, 0, added);
    glFogCoordPointer(GL_FLOAT, 0, coordinates);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glEnableClientState(GL_SECONDARY_COLOR_ARRAY);
    glEnableClientState(GL_FOG_COORDINATE_ARRAY);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glDisableClientState(GL_VERTEX_ARRAY);
    glDisableClientState(GL_COLOR_ARRAY);
    glDisableClientState(GL_SECONDARY_COLOR_ARRAY);
    glDisableClientState(GL_FOG_COORDINATE_ARRAY);
}

/* The list sets none of them: they are those of the call. */
static void inherited(void) {
    glNewList(1, GL_COMPILE);
    glBegin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 4; ++i) glVertex2fv(corners[i]);
    glEnd();
    glEndList();
    glColor3fv(colors[1]);
    glSecondaryColor3fv(added[2]);
    glFogCoordf(coordinates[3]);
    glCallList(1);
}

/* From the second vertex on: the first has what was set before. */
static void changedLate(void) {
    glColor3fv(colors[3]);
    glSecondaryColor3fv(added[0]);
    glFogCoordf(coordinates[0]);
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
        glColor3fv(colors[3 * i]);
        glSecondaryColor3fv(added[3 * i]);
        glFogCoordf(coordinates[3 * i]);
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
    glColor3fv(colors[2]);
    glSecondaryColor3fv(added[1]);
    glFogCoordf(coordinates[1]);
    glRectf(2.25f, 3.25f, 29.75f, 28.75f);
}

typedef struct {
    const char* name;
    void (*draw)(void);
} Drawing;
static const Drawing drawings[] = {
    {"immediate", immediate}, {"list", inList},  {"arrays", fromArrays}, {"inherited", inherited},
    {"changed_late", changedLate}, {"lines", lines}, {"points", points},
    {"rectangle", rectangle}};

static void tellDrawing(const char* group, const Drawing* drawing) {
    char name[96];
    snprintf(name, sizeof name, "%s/%s", group, drawing->name);
    beginCase(name);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    drawing->draw();
    tellPixels();
}

static void tellDrawings(const char* group) {
    for (size_t i = 0; i < sizeof drawings / sizeof drawings[0]; ++i)
        tellDrawing(group, &drawings[i]);
}

static void secondaryColors(void) {
    tellDrawings("secondary/off");
    glEnable(GL_COLOR_SUM);
    tellDrawings("secondary/on");
    glShadeModel(GL_FLAT);
    tellDrawings("secondary/flat");
    glShadeModel(GL_SMOOTH);
    /* After the texture. */
    {
        static const GLubyte texel[4] = {200, 90, 40, 255};
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
        glEnable(GL_TEXTURE_2D);
        tellDrawings("secondary/textured");
        glDisable(GL_TEXTURE_2D);
    }
    /* Lighting has a secondary colour of its own. */
    glEnable(GL_LIGHTING);
    tellDrawings("secondary/lit");
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
    tellDrawings("secondary/separate_specular");
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SINGLE_COLOR);
    glDisable(GL_LIGHTING);
    beginCase("secondary/is_not_of_lighting");
    glPushAttrib(GL_LIGHTING_BIT);
    glDisable(GL_COLOR_SUM);
    glPopAttrib();
    printf("%d\n", glIsEnabled(GL_COLOR_SUM));
    tellError();
    /* What is above 1 is cut off before the sum. */
    beginCase("secondary/clamped");
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(GL_COLOR_SUM);
    glColor3f(-3.0f, 0.25f, 0.1f);
    glSecondaryColor3f(0.5f, -2.0f, 3.0f);
    glRectf(2.25f, 3.25f, 29.75f, 28.75f);
    tellPixels();
    glDisable(GL_COLOR_SUM);
}

static void fogCoordinates(void) {
    static const GLenum modes[3] = {GL_LINEAR, GL_EXP, GL_EXP2};
    static const char* const names[3] = {"fog/linear", "fog/exp", "fog/exp2"};
    static const GLfloat fogColor[4] = {0.9f, 0.1f, 0.3f, 1.0f};
    glFogfv(GL_FOG_COLOR, fogColor);
    glFogf(GL_FOG_START, 0.25f);
    glFogf(GL_FOG_END, 2.5f);
    glFogf(GL_FOG_DENSITY, 0.6f);
    glEnable(GL_FOG);
    tellDrawings("fog/depth");
    glFogi(GL_FOG_COORDINATE_SOURCE, GL_FOG_COORDINATE);
    for (int i = 0; i < 3; ++i) {
        glFogi(GL_FOG_MODE, (GLint)modes[i]);
        tellDrawings(names[i]);
    }
    glShadeModel(GL_FLAT); /* which is of colours alone */
    glFogi(GL_FOG_MODE, GL_LINEAR);
    tellDrawings("fog/flat");
    glShadeModel(GL_SMOOTH);
    glEnable(GL_COLOR_SUM);
    tellDrawings("fog/after_the_sum");
    glDisable(GL_COLOR_SUM);
    glFogi(GL_FOG_COORDINATE_SOURCE, GL_FRAGMENT_DEPTH);
    glDisable(GL_FOG);
}

/* How many pixels a point covers: its size at that depth on the axis of the eye. */
static void tellPoint(GLfloat z) {
    static GLubyte pixels[kWindow][kWindow][3];
    int covered = 0;
    glClear(GL_COLOR_BUFFER_BIT);
    glColor3f(1.0f, 1.0f, 1.0f);
    glBegin(GL_POINTS);
    glVertex3f(0.01f, 0.01f, z);
    glEnd();
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, kWindow, kWindow, GL_RGB, GL_UNSIGNED_BYTE, pixels);
    for (int i = 0; i < kWindow * kWindow; ++i) covered += pixels[i / kWindow][i % kWindow][0] > 0;
    printf("%d\n", covered);
}

static void pointSizes(void) {
    static const struct {
        const char* name;
        GLfloat attenuation[3], least, most, size;
    } cases[] = {{"plain", {1.0f, 0.0f, 0.0f}, 0.0f, 30.0f, 7.3f},
                 {"constant", {4.0f, 0.0f, 0.0f}, 0.0f, 30.0f, 14.4f},
                 {"linear", {0.0f, 0.3f, 0.0f}, 0.0f, 30.0f, 9.3f},
                 {"quadratic", {0.0f, 0.0f, 0.02f}, 0.0f, 30.0f, 5.2f},
                 {"all", {0.5f, 0.2f, 0.01f}, 0.0f, 30.0f, 12.4f},
                 {"least", {0.0f, 0.0f, 1.0f}, 4.3f, 30.0f, 12.4f},
                 {"most", {0.0f, 0.0f, 0.001f}, 0.0f, 8.6f, 12.4f}};
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glFrustum(-1.0, 1.0, -1.0, 1.0, 1.0, 40.0);
    glMatrixMode(GL_MODELVIEW);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        char name[64];
        snprintf(name, sizeof name, "point_size/%s", cases[i].name);
        beginCase(name);
        glPushAttrib(GL_POINT_BIT);
        glPointSize(cases[i].size);
        glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, cases[i].attenuation);
        glPointParameterf(GL_POINT_SIZE_MIN, cases[i].least);
        glPointParameterf(GL_POINT_SIZE_MAX, cases[i].most);
        tellPoint(-1.3f);
        tellPoint(-3.1f);
        tellPoint(-9.7f);
        tellPoint(-31.0f);
        glPopAttrib();
        tellPoint(-3.1f);
        tellError();
    }
}

static void askQuestions(void) {
    useWindowCoordinates();
    secondaryColors();
    fogCoordinates();
    pointSizes();
}

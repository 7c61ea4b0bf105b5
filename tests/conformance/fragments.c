/* SPDX-License-Identifier: MIT */
/* What becomes of a fragment: a rectangle is drawn over another one, or over nothing, with one
 * state after the other, and the pixel in the middle is read back. Colours may be off by one level,
 * as frame buffers round. */
#define GL_GLEXT_PROTOTYPES
#include "tests/conformance/questions.h"

typedef struct {
    const char* name;
    GLenum value;
} Token;

#define TOKEN(value) \
    { #value, value }

static void begin(const char* group, const char* first, const char* second) {
    char name[160];
    snprintf(name, sizeof name, "%s/%s%s%s", group, first, *second ? "/" : "", second);
    beginCase(name);
}

static void rectangle(const GLfloat* color, GLfloat z) {
    glColor4fv(color);
    glBegin(GL_TRIANGLE_STRIP); /* how a quad is split would be open */
    glVertex3f(4.25f, 4.25f, z);
    glVertex3f(27.75f, 4.25f, z);
    glVertex3f(4.25f, 27.75f, z);
    glVertex3f(27.75f, 27.75f, z);
    glEnd();
}

static void tellLevel(int level) {
    if (kTellsAlternatives)
        printf("%d|%d|%d ", level, level + 1, level - 1);
    else
        printf("%d ", level);
}

static void tellPixel(void) {
    GLubyte pixel[4] = {0};
    glReadPixels(16, 16, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    for (int k = 0; k < 3; ++k) tellLevel(pixel[k]);
    printf("\n");
}

/* The state between is that of the rectangle on top. */
static void clearBoth(void) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

static const GLfloat below[4] = {0.31f, 0.62f, 0.84f, 1.0f}, above[4] = {0.73f, 0.22f, 0.49f, 0.6f};

static void blending(void) {
    static const Token sources[] = {
        TOKEN(GL_ZERO), TOKEN(GL_ONE), TOKEN(GL_SRC_COLOR), TOKEN(GL_ONE_MINUS_SRC_COLOR),
        TOKEN(GL_DST_COLOR), TOKEN(GL_ONE_MINUS_DST_COLOR), TOKEN(GL_SRC_ALPHA),
        TOKEN(GL_ONE_MINUS_SRC_ALPHA), TOKEN(GL_DST_ALPHA), TOKEN(GL_ONE_MINUS_DST_ALPHA),
        TOKEN(GL_CONSTANT_COLOR), TOKEN(GL_ONE_MINUS_CONSTANT_COLOR), TOKEN(GL_CONSTANT_ALPHA),
        TOKEN(GL_ONE_MINUS_CONSTANT_ALPHA), TOKEN(GL_SRC_ALPHA_SATURATE)};
    static const Token equations[] = {TOKEN(GL_FUNC_ADD), TOKEN(GL_FUNC_SUBTRACT),
                                      TOKEN(GL_FUNC_REVERSE_SUBTRACT), TOKEN(GL_MIN),
                                      TOKEN(GL_MAX)};
    enum { kSources = sizeof sources / sizeof sources[0] };
    glBlendColor(0.4f, 0.9f, 0.2f, 0.3f);
    for (int i = 0; i < kSources; ++i)
        for (int j = 0; j < kSources - 1; ++j) { /* the last is a source's only */
            begin("blend", sources[i].name, sources[j].name);
            clearBoth();
            rectangle(below, 0.0f);
            glEnable(GL_BLEND);
            glBlendFunc(sources[i].value, sources[j].value);
            rectangle(above, 0.0f);
            glDisable(GL_BLEND);
            tellPixel();
        }
    for (size_t i = 0; i < sizeof equations / sizeof equations[0]; ++i) {
        begin("blend_equation", equations[i].name, "");
        clearBoth();
        rectangle(below, 0.0f);
        glEnable(GL_BLEND);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE);
        glBlendEquation(equations[i].value);
        rectangle(above, 0.0f);
        glBlendEquation(GL_FUNC_ADD);
        glDisable(GL_BLEND);
        tellPixel();
    }
}

static void logicAndMasks(void) {
    static const Token operations[] = {
        TOKEN(GL_CLEAR), TOKEN(GL_SET), TOKEN(GL_COPY), TOKEN(GL_COPY_INVERTED), TOKEN(GL_NOOP),
        TOKEN(GL_INVERT), TOKEN(GL_AND), TOKEN(GL_NAND), TOKEN(GL_OR), TOKEN(GL_NOR),
        TOKEN(GL_XOR), TOKEN(GL_EQUIV), TOKEN(GL_AND_REVERSE), TOKEN(GL_AND_INVERTED),
        TOKEN(GL_OR_REVERSE), TOKEN(GL_OR_INVERTED)};
    /* Whole levels, so that no bit is open: 90, 150, 60 and 204, 15, 240. */
    static const GLfloat first[4] = {90.0f / 255, 150.0f / 255, 60.0f / 255, 1.0f},
                         second[4] = {204.0f / 255, 15.0f / 255, 240.0f / 255, 1.0f};
    for (size_t i = 0; i < sizeof operations / sizeof operations[0]; ++i) {
        begin("logic", operations[i].name, "");
        clearBoth();
        rectangle(first, 0.0f);
        glEnable(GL_COLOR_LOGIC_OP);
        glLogicOp(operations[i].value);
        rectangle(second, 0.0f);
        glDisable(GL_COLOR_LOGIC_OP);
        tellPixel();
    }
    for (int mask = 0; mask < 16; ++mask) {
        char name[16];
        snprintf(name, sizeof name, "%d", mask);
        begin("color_mask", name, "");
        clearBoth();
        rectangle(below, 0.0f);
        glColorMask(mask & 1, mask >> 1 & 1, mask >> 2 & 1, mask >> 3 & 1);
        rectangle(above, 0.0f);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        tellPixel();
    }
}

static void tests(void) {
    static const Token functions[] = {TOKEN(GL_NEVER),   TOKEN(GL_LESS),     TOKEN(GL_EQUAL),
                                      TOKEN(GL_LEQUAL),  TOKEN(GL_GREATER),  TOKEN(GL_NOTEQUAL),
                                      TOKEN(GL_GEQUAL),  TOKEN(GL_ALWAYS)};
    static const GLfloat places[3] = {0.5f, 0.0f, -0.5f}, alphas[3] = {0.25f, 0.5f, 0.75f};
    static const char* const names[3] = {"0", "1", "2"};
    for (size_t i = 0; i < sizeof functions / sizeof functions[0]; ++i)
        for (int k = 0; k < 3; ++k) {
            GLfloat color[4] = {0.73f, 0.22f, 0.49f, alphas[k]};
            GLfloat depth = -1.0f;
            begin("alpha", functions[i].name, names[k]);
            clearBoth();
            rectangle(below, 0.0f);
            glEnable(GL_ALPHA_TEST);
            glAlphaFunc(functions[i].value, 0.5f);
            rectangle(color, 0.0f);
            glDisable(GL_ALPHA_TEST);
            tellPixel();
            begin("depth", functions[i].name, names[k]);
            clearBoth();
            glEnable(GL_DEPTH_TEST);
            glDepthFunc(GL_ALWAYS);
            rectangle(below, 0.0f);
            glDepthFunc(functions[i].value);
            rectangle(above, places[k]);
            glDisable(GL_DEPTH_TEST);
            tellPixel();
            glReadPixels(16, 16, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
            printf("%.4f\n", (double)depth);
            begin("depth_and_alpha", functions[i].name, names[k]);
            clearBoth();
            glEnable(GL_DEPTH_TEST);
            glEnable(GL_ALPHA_TEST);
            glDepthFunc(GL_LESS);
            rectangle(above, 0.25f);
            rectangle(color, 0.5f); /* nearer, if it passes */
            glDisable(GL_ALPHA_TEST);
            rectangle(below, 0.375f);
            glDisable(GL_DEPTH_TEST);
            tellPixel();
        }
    begin("depth", "mask", "");
    clearBoth();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_FALSE);
    rectangle(above, 0.5f);
    glDepthMask(GL_TRUE);
    rectangle(below, 0.0f);
    glDisable(GL_DEPTH_TEST);
    tellPixel();
    begin("depth", "offset", "");
    clearBoth();
    glEnable(GL_DEPTH_TEST);
    rectangle(above, 0.0f);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(0.0f, -2.0f);
    rectangle(below, 0.0f);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDisable(GL_DEPTH_TEST);
    tellPixel();
}

static void fog(void) {
    static const Token modes[] = {TOKEN(GL_LINEAR), TOKEN(GL_EXP), TOKEN(GL_EXP2)};
    static const GLfloat places[4] = {0.9f, 0.5f, -0.25f, -0.9f}, color[4] = {0.9f, 0.1f, 0.3f, 1.0f};
    static const char* const names[4] = {"0", "1", "2", "3"};
    glFogfv(GL_FOG_COLOR, color);
    glFogf(GL_FOG_START, 0.1f);
    glFogf(GL_FOG_END, 0.8f);
    glFogf(GL_FOG_DENSITY, 0.9f);
    for (size_t i = 0; i < 3; ++i)
        for (int k = 0; k < 4; ++k) {
            begin("fog", modes[i].name, names[k]);
            clearBoth();
            glEnable(GL_FOG);
            glFogi(GL_FOG_MODE, (GLint)modes[i].value);
            rectangle(below, places[k]);
            glDisable(GL_FOG);
            tellPixel();
        }
}

static void textureEnvironment(void) {
    static const Token modes[] = {TOKEN(GL_MODULATE), TOKEN(GL_DECAL), TOKEN(GL_BLEND),
                                  TOKEN(GL_REPLACE), TOKEN(GL_ADD)};
    static const Token formats[] = {TOKEN(GL_ALPHA), TOKEN(GL_LUMINANCE),
                                    TOKEN(GL_LUMINANCE_ALPHA), TOKEN(GL_INTENSITY), TOKEN(GL_RGB),
                                    TOKEN(GL_RGBA)};
    static const Token functions[] = {TOKEN(GL_REPLACE), TOKEN(GL_MODULATE), TOKEN(GL_ADD),
                                      TOKEN(GL_ADD_SIGNED), TOKEN(GL_INTERPOLATE),
                                      TOKEN(GL_SUBTRACT), TOKEN(GL_DOT3_RGB),
                                      TOKEN(GL_DOT3_RGBA)};
    static const Token sources[] = {TOKEN(GL_TEXTURE), TOKEN(GL_CONSTANT), TOKEN(GL_PRIMARY_COLOR),
                                    TOKEN(GL_PREVIOUS)};
    static const Token operands[] = {TOKEN(GL_SRC_COLOR), TOKEN(GL_ONE_MINUS_SRC_COLOR),
                                     TOKEN(GL_SRC_ALPHA), TOKEN(GL_ONE_MINUS_SRC_ALPHA)};
    static const GLubyte texel[4] = {200, 90, 40, 150};
    static const GLfloat constant[4] = {0.3f, 0.7f, 0.6f, 0.4f};
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, constant);
    glEnable(GL_TEXTURE_2D);
    /* Alpha shows by blending with the black that was cleared. */
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ZERO);
    for (size_t i = 0; i < sizeof modes / sizeof modes[0]; ++i)
        for (size_t j = 0; j < sizeof formats / sizeof formats[0]; ++j) {
            if (modes[i].value == GL_DECAL && formats[j].value != GL_RGB &&
                formats[j].value != GL_RGBA)
                continue; /* undefined */
            begin("environment", modes[i].name, formats[j].name);
            glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, (GLint)modes[i].value);
            glTexImage2D(GL_TEXTURE_2D, 0, (GLint)formats[j].value, 1, 1, 0, GL_RGBA,
                         GL_UNSIGNED_BYTE, texel);
            clearBoth();
            rectangle(above, 0.0f);
            tellPixel();
        }
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE1_RGB, GL_CONSTANT);
    for (size_t i = 0; i < sizeof functions / sizeof functions[0]; ++i) {
        begin("combine", functions[i].name, "");
        glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, (GLint)functions[i].value);
        if (i < 6) glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, (GLint)functions[i].value);
        clearBoth();
        rectangle(above, 0.0f);
        tellPixel();
    }
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_REPLACE);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_REPLACE);
    for (size_t i = 0; i < sizeof sources / sizeof sources[0]; ++i)
        for (size_t j = 0; j < sizeof operands / sizeof operands[0]; ++j) {
            begin("combine_source", sources[i].name, operands[j].name);
            glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_RGB, (GLint)sources[i].value);
            glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_ALPHA, (GLint)sources[i].value);
            glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_RGB, (GLint)operands[j].value);
            glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_ALPHA,
                      (GLint)operands[j % 2 ? 3 : 2].value);
            clearBoth();
            rectangle(above, 0.0f);
            tellPixel();
        }
    for (GLint scale = 1; scale <= 4; scale *= 2) {
        static const char* const names[5] = {"", "1", "2", "", "4"};
        begin("combine_scale", names[scale], "");
        glTexEnvi(GL_TEXTURE_ENV, GL_RGB_SCALE, scale);
        glTexEnvi(GL_TEXTURE_ENV, GL_ALPHA_SCALE, scale);
        clearBoth();
        rectangle(constant, 0.0f);
        tellPixel();
    }
    glDisable(GL_BLEND);
    glDisable(GL_TEXTURE_2D);
}

/* A lit rectangle, by itself and in a list; `change` is what one case has that others have not. */
static void tellLit(const char* name, void (*change)(void)) {
    static const GLfloat ambient[4] = {0.1f, 0.2f, 0.3f, 1.0f}, diffuse[4] = {0.5f, 0.4f, 0.3f, 1.0f},
                         specular[4] = {0.3f, 0.4f, 0.2f, 1.0f},
                         backColor[4] = {0.2f, 0.6f, 0.1f, 1.0f};
    begin("lighting", name, "");
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    glPushMatrix();
    clearBoth();
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glLightfv(GL_LIGHT0, GL_AMBIENT, backColor);
    glLightfv(GL_LIGHT0, GL_SPECULAR, specular);
    glMaterialfv(GL_FRONT, GL_AMBIENT, ambient);
    glMaterialfv(GL_FRONT, GL_DIFFUSE, diffuse);
    glMaterialfv(GL_FRONT, GL_SPECULAR, diffuse);
    glMaterialfv(GL_BACK, GL_DIFFUSE, backColor);
    glMaterialf(GL_FRONT, GL_SHININESS, 3.0f);
    glNormal3f(0.36f, 0.48f, 0.8f);
    change();
    rectangle(above, 0.0f);
    tellPixel();
    clearBoth();
    glNewList(1, GL_COMPILE);
    rectangle(above, 0.0f);
    glEndList();
    glCallList(1);
    tellPixel();
    glPopMatrix();
    glPopAttrib();
}

static void nothing(void) {}
static void separateSpecular(void) {
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    glEnable(GL_TEXTURE_2D);
}
static void texturedSpecular(void) {
    separateSpecular();
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SINGLE_COLOR);
}
static void localViewer(void) {
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE);
}
static void noModelAmbient(void) {
    static const GLfloat dark[4] = {0.0f, 0.0f, 0.0f, 1.0f};
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, dark);
}
static void emission(void) {
    static const GLfloat glow[4] = {0.2f, 0.1f, 0.3f, 1.0f};
    glMaterialfv(GL_FRONT, GL_EMISSION, glow);
}
static void twoSides(void) {
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
    glFrontFace(GL_CW);
    glNormal3f(0.36f, 0.48f, -0.8f);
}
static void oneSide(void) {
    twoSides();
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_FALSE);
}
/* A light that the normal points to, and a viewer that it points away from: no highlight. */
static void seenFromBehind(void) {
    static const GLfloat position[4] = {0.9f, 0.0f, -0.45f, 0.0f};
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glNormal3f(0.36f, 0.48f, -0.8f);
}
static void longNormal(void) {
    glNormal3f(0.72f, 0.96f, 1.6f);
}
static void normalized(void) {
    longNormal();
    glEnable(GL_NORMALIZE);
}
/* The rectangle stays where it is: its middle is the fixed point. */
static void scaled(void) {
    glTranslatef(16.0f, 16.0f, 0.0f);
    glScalef(0.75f, 0.75f, 0.75f);
    glTranslatef(-16.0f, -16.0f, 0.0f);
}
static void rescaled(void) {
    scaled();
    glEnable(GL_RESCALE_NORMAL);
}
static void stretched(void) {
    glTranslatef(16.0f, 16.0f, 0.0f);
    glScalef(0.5f, 1.0f, 0.8f);
    glTranslatef(-16.0f, -16.0f, 0.0f);
    glEnable(GL_NORMALIZE);
}
static void nearLight(void) {
    static const GLfloat position[4] = {10.0f, 20.0f, 8.0f, 1.0f};
    glLightfv(GL_LIGHT0, GL_POSITION, position);
}
static void attenuated(void) {
    nearLight();
    glLightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, 0.5f);
    glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.0625f);
    glLightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 0.0015f);
}
static void spotlight(void) {
    static const GLfloat direction[3] = {0.2f, -0.1f, -1.0f};
    nearLight();
    glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, direction);
    glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 85.0f);
    glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, 2.0f);
}
static void secondLight(void) {
    static const GLfloat position[4] = {1.0f, -0.5f, 1.0f, 0.0f}, dim[4] = {0.4f, 0.3f, 0.2f, 1.0f};
    glEnable(GL_LIGHT1);
    glLightfv(GL_LIGHT1, GL_POSITION, position);
    glLightfv(GL_LIGHT1, GL_DIFFUSE, dim);
}
static void colorIs(GLenum mode) {
    glColorMaterial(GL_FRONT, mode);
    glEnable(GL_COLOR_MATERIAL);
}
static void colorIsAmbient(void) {
    colorIs(GL_AMBIENT);
}
static void colorIsDiffuse(void) {
    colorIs(GL_DIFFUSE);
}
static void colorIsSpecular(void) {
    colorIs(GL_SPECULAR);
}
static void colorIsEmission(void) {
    colorIs(GL_EMISSION);
}
static void colorIsBoth(void) {
    colorIs(GL_AMBIENT_AND_DIFFUSE);
}

static void lighting(void) {
    tellLit("plain", nothing);
    tellLit("separate_specular", separateSpecular);
    tellLit("textured_specular", texturedSpecular);
    tellLit("local_viewer", localViewer);
    tellLit("no_model_ambient", noModelAmbient);
    tellLit("emission", emission);
    tellLit("two_sides", twoSides);
    tellLit("one_side", oneSide);
    tellLit("seen_from_behind", seenFromBehind);
    tellLit("long_normal", longNormal);
    tellLit("normalized", normalized);
    tellLit("scaled", scaled);
    tellLit("rescaled", rescaled);
    tellLit("stretched", stretched);
    tellLit("near_light", nearLight);
    tellLit("attenuated", attenuated);
    tellLit("spotlight", spotlight);
    tellLit("second_light", secondLight);
    tellLit("color_is_ambient", colorIsAmbient);
    tellLit("color_is_diffuse", colorIsDiffuse);
    tellLit("color_is_specular", colorIsSpecular);
    tellLit("color_is_emission", colorIsEmission);
    tellLit("color_is_ambient_and_diffuse", colorIsBoth);
}

/* Pixels of a picture of two colours, but those that OpenGL leaves open. */
static void tellCovered(int (*isOpen)(int column, int row)) {
    static GLubyte pixels[kWindow][kWindow][3];
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, kWindow, kWindow, GL_RGB, GL_UNSIGNED_BYTE, pixels);
    for (int row = kWindow - 1; row >= 0; --row) {
        for (int column = 0; column < kWindow; ++column)
            putchar(isOpen(column, row)             ? '?'
                    : pixels[row][column][0] > 250  ? '#'
                    : pixels[row][column][0] == 0   ? '.'
                                                    : '+');
        putchar('\n');
    }
}

static int isNowhereOpen(int column, int row) {
    (void)column;
    (void)row;
    return 0;
}

/* A point 9 pixels wide: what it covers by half is the implementation's. */
static int isNearCircle(int column, int row) {
    const double x = column + 0.5 - 10.3, y = row + 0.5 - 21.7, square = x * x + y * y;
    return square > 2.8 * 2.8 && square < 6.0 * 6.0;
}

/* Lines 7 pixels wide from (5, 4) to (27, 15); dashes of 8 pixels begin at its start. */
static double alongLine(int column, int row) {
    return ((column + 0.5 - 5.0) * 22.0 + (row + 0.5 - 4.0) * 11.0) / 24.596747752497686;
}
static double besideLine(int column, int row) {
    const double y = ((row + 0.5 - 4.0) * 22.0 - (column + 0.5 - 5.0) * 11.0) / 24.596747752497686;
    return y < 0.0 ? -y : y;
}
static int isNearLine(int column, int row) {
    const double along = alongLine(column, row), beside = besideLine(column, row);
    if (along < -2.0 || along > 26.6) return 0;
    return (beside > 2.0 && beside < 5.0) || along < 2.0 || along > 22.6;
}
static int isNearDash(int column, int row) {
    const double along = alongLine(column, row);
    const double inDash = along - 8.0 * (int)(along / 8.0);
    return isNearLine(column, row) || (besideLine(column, row) < 5.0 && along > -2.0 &&
                                       along < 26.6 && (inDash < 0.9 || inDash > 7.1));
}

static void line(void) {
    glBegin(GL_LINES);
    glVertex2f(5.0f, 4.0f);
    glVertex2f(27.0f, 15.0f);
    glEnd();
}

static void smoothness(void) {
    GLubyte stipple[128];
    glColor3f(1.0f, 1.0f, 1.0f);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    beginCase("smooth/point");
    clearBoth();
    glEnable(GL_POINT_SMOOTH);
    glPointSize(9.0f);
    glBegin(GL_POINTS);
    glVertex2f(10.3f, 21.7f);
    glEnd();
    glDisable(GL_POINT_SMOOTH);
    tellCovered(isNearCircle);
    glEnable(GL_LINE_SMOOTH);
    glLineWidth(7.0f);
    beginCase("smooth/line");
    clearBoth();
    line();
    tellCovered(isNearLine);
    beginCase("smooth/dashes");
    clearBoth();
    glEnable(GL_LINE_STIPPLE);
    glLineStipple(8, 0x5555);
    line();
    glDisable(GL_LINE_STIPPLE);
    glDisable(GL_LINE_SMOOTH);
    tellCovered(isNearDash);
    glLineWidth(1.0f);
    glDisable(GL_BLEND);
    beginCase("polygon_stipple");
    clearBoth();
    for (int i = 0; i < 128; ++i) stipple[i] = (GLubyte)(29 * i + 7);
    glPolygonStipple(stipple);
    glEnable(GL_POLYGON_STIPPLE);
    glRectf(3.25f, 2.25f, 29.75f, 30.75f);
    glDisable(GL_POLYGON_STIPPLE);
    tellCovered(isNowhereOpen);
    beginCase("scissor");
    clearBoth();
    glEnable(GL_SCISSOR_TEST);
    glScissor(5, 9, 17, 4);
    glRectf(3.25f, 2.25f, 29.75f, 30.75f);
    glDisable(GL_SCISSOR_TEST);
    tellCovered(isNowhereOpen);
}

/* A mesh whose edges run through the centres of pixels: of the triangles that share an edge exactly
 * one draws the pixel, whichever that is. */
static void sharedEdges(void) {
    static GLubyte pixels[kWindow][kWindow][3];
    glColor3f(0.2f, 0.2f, 0.2f);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    for (int fan = 0; fan < 2; ++fan) {
        beginCase(fan ? "shared_edges/fans" : "shared_edges/strips");
        clearBoth();
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column) {
                const GLfloat x = 4.5f + 8.0f * (GLfloat)column, y = 4.5f + 8.0f * (GLfloat)row;
                glBegin(fan ? GL_TRIANGLE_FAN : GL_TRIANGLE_STRIP);
                if (fan) glVertex2f(x + 4.0f, y + 4.0f);
                glVertex2f(x, y);
                glVertex2f(x + 8.0f, y);
                if (fan) glVertex2f(x + 8.0f, y + 8.0f);
                glVertex2f(x, y + 8.0f);
                glVertex2f(fan ? x : x + 8.0f, fan ? y : y + 8.0f);
                glEnd();
            }
        glReadPixels(0, 0, kWindow, kWindow, GL_RGB, GL_UNSIGNED_BYTE, pixels);
        for (int row = 5; row < 28; ++row) { /* the outer edges are open */
            for (int column = 5; column < 28; ++column)
                putchar('a' + (pixels[row][column][0] + 20) / 51);
            putchar('\n');
        }
    }
    glDisable(GL_BLEND);
}

static void askQuestions(void) {
    useWindowCoordinates();
    blending();
    logicAndMasks();
    tests();
    fog();
    textureEnvironment();
    lighting();
    smoothness();
    sharedEdges();
}

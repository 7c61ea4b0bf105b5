/* SPDX-License-Identifier: MIT */
/* Images in the window: every format and type of memory, how they lie in it, what the transfer does
 * to them, zoom, the raster position, what happens to their fragments, and pixels read back. */
#define GL_GLEXT_PROTOTYPES
#include "tests/conformance/questions.h"

#include <string.h>

enum { kWide = 6, kHigh = 5, kBytes = 4096 };

typedef struct {
    const char* name;
    GLenum value;
} Named;
#define NAMED(value) {#value, value}

static GLubyte window[kWindow][kWindow][3];

/* A half-tone behind, so that an image's alpha is seen where it is blended. */
static void clearGrey(void) {
    glClearColor(0.4f, 0.4f, 0.4f, 0.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

static void defaultStores(void) {
    static const GLenum packs[] = {GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS,
                                   GL_PACK_SWAP_BYTES, GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS,
                                   GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SWAP_BYTES,
                                   GL_UNPACK_LSB_FIRST};
    for (size_t i = 0; i < sizeof packs / sizeof packs[0]; ++i) glPixelStorei(packs[i], 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
}

static int slack = 1; /* of 255, for roundings on the way */

static void tellLevel(int level) {
    printf("%d", level);
    for (int off = 1; kTellsAlternatives && off <= slack; ++off)
        printf("|%d|%d", level - off, level + off);
    putchar(' ');
}

static void tellPixels(int wide, int high) {
    for (int y = 0; y < high; ++y) {
        for (int x = 0; x < wide; ++x)
            for (int k = 0; k < 3; ++k) tellLevel(window[y][x][k]);
        putchar('\n');
    }
}

static void readWindow(void) {
    defaultStores();
    glReadPixels(0, 0, kWindow, kWindow, GL_RGB, GL_UNSIGNED_BYTE, window);
}

static void tellWindow(void) {
    readWindow();
    tellPixels(kWindow, kWindow);
}

/* Bytes without a pattern, each time others, since Mesa knows images again that it was given
 * before, however they lie in memory now; no float among them is infinite or no number. */
static void fill(GLubyte* memory, GLenum type) {
    static unsigned seed;
    unsigned random = 12345u + ++seed * 977u;
    for (int i = 0; i < kBytes; ++i) {
        random = random * 1664525u + 1013904223u;
        memory[i] = (GLubyte)(random >> 24);
    }
    if (type != GL_FLOAT) return;
    for (int i = 0; i + 4 <= kBytes; i += 4) {
        const GLfloat value = (GLfloat)memory[i] / 160.0f - 0.3f;
        memcpy(memory + i, &value, sizeof value);
    }
}

static const Named plainFormats[] = {
    NAMED(GL_RGB),       NAMED(GL_RGBA),            NAMED(GL_BGR), NAMED(GL_BGRA),
    NAMED(GL_LUMINANCE), NAMED(GL_LUMINANCE_ALPHA), NAMED(GL_RED), NAMED(GL_GREEN),
    NAMED(GL_BLUE),      NAMED(GL_ALPHA)};
static const Named plainTypes[] = {NAMED(GL_UNSIGNED_BYTE), NAMED(GL_BYTE),
                                   NAMED(GL_UNSIGNED_SHORT), NAMED(GL_SHORT),
                                   NAMED(GL_UNSIGNED_INT),   NAMED(GL_INT),
                                   NAMED(GL_FLOAT)};
static const struct {
    Named format, type;
} packed[] = {{NAMED(GL_RGB), NAMED(GL_UNSIGNED_BYTE_3_3_2)},
              {NAMED(GL_RGB), NAMED(GL_UNSIGNED_BYTE_2_3_3_REV)},
              {NAMED(GL_RGB), NAMED(GL_UNSIGNED_SHORT_5_6_5)},
              {NAMED(GL_RGB), NAMED(GL_UNSIGNED_SHORT_5_6_5_REV)},
              {NAMED(GL_RGBA), NAMED(GL_UNSIGNED_SHORT_4_4_4_4)},
              {NAMED(GL_BGRA), NAMED(GL_UNSIGNED_SHORT_4_4_4_4_REV)},
              {NAMED(GL_RGBA), NAMED(GL_UNSIGNED_SHORT_5_5_5_1)},
              {NAMED(GL_BGRA), NAMED(GL_UNSIGNED_SHORT_1_5_5_5_REV)},
              {NAMED(GL_RGBA), NAMED(GL_UNSIGNED_INT_8_8_8_8)},
              {NAMED(GL_BGRA), NAMED(GL_UNSIGNED_INT_8_8_8_8_REV)},
              {NAMED(GL_RGBA), NAMED(GL_UNSIGNED_INT_10_10_10_2)},
              {NAMED(GL_BGRA), NAMED(GL_UNSIGNED_INT_2_10_10_10_REV)}};

static void drawAs(const char* group, const Named* format, const Named* type) {
    static GLubyte memory[kBytes];
    char name[128];
    snprintf(name, sizeof name, "%s/%s/%s", group, format->name + 3, type->name + 3);
    beginCase(name);
    clearGrey();
    fill(memory, type->value);
    glRasterPos2i(1, 2);
    glDrawPixels(kWide, kHigh, format->value, type->value, memory);
    readWindow();
    tellPixels(kWide + 2, kHigh + 3);
}

static void everyFormat(const char* group) {
    for (size_t f = 0; f < sizeof plainFormats / sizeof plainFormats[0]; ++f)
        for (size_t t = 0; t < sizeof plainTypes / sizeof plainTypes[0]; ++t)
            drawAs(group, &plainFormats[f], &plainTypes[t]);
    for (size_t i = 0; i < sizeof packed / sizeof packed[0]; ++i)
        drawAs(group, &packed[i].format, &packed[i].type);
}

static void formats(void) {
    everyFormat("draw");
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    slack = 2;
    everyFormat("blend");
    slack = 1;
    glDisable(GL_BLEND);
}

static void transfers(void) {
    static const struct {
        const char* name;
        GLfloat scale[4], bias[4];
    } cases[] = {{"scaled", {0.5f, 2.0f, 1.0f, 1.0f}, {0.0f, 0.0f, 0.0f, 0.0f}},
                 {"moved", {1.0f, 1.0f, 1.0f, 1.0f}, {0.25f, -0.5f, 0.75f, 0.0f}},
                 {"turned", {-1.0f, -1.0f, -1.0f, -1.0f}, {1.0f, 0.5f, 1.5f, 1.0f}},
                 {"alpha", {1.0f, 1.0f, 1.0f, 0.5f}, {0.0f, 0.0f, 0.0f, 0.25f}},
                 {"all_black", {-1.0f, 0.0f, 0.0f, 1.0f}, {0.0f, 0.0f, -2.0f, 0.0f}}};
    static const GLenum scales[] = {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE};
    static const GLenum biases[] = {GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS};
    static const Named bytes = NAMED(GL_UNSIGNED_BYTE), floats = NAMED(GL_FLOAT);
    static const Named rgba = NAMED(GL_RGBA), luminance = NAMED(GL_LUMINANCE);
    glEnable(GL_BLEND);
    slack = 2;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        char name[64];
        for (int k = 0; k < 4; ++k) {
            glPixelTransferf(scales[k], cases[i].scale[k]);
            glPixelTransferf(biases[k], cases[i].bias[k]);
        }
        snprintf(name, sizeof name, "transfer/%s", cases[i].name);
        drawAs(name, &rgba, &bytes);
        drawAs(name, &rgba, &floats);
        drawAs(name, &luminance, &bytes);
    }
    for (int k = 0; k < 4; ++k) {
        glPixelTransferf(scales[k], 1.0f);
        glPixelTransferf(biases[k], 0.0f);
    }
    slack = 1;
    glDisable(GL_BLEND);
}

/* How an image lies in memory. */
static void stores(void) {
    static const struct {
        const char* name;
        GLint alignment, rowLength, skipRows, skipPixels, swap;
    } cases[] = {{"alignment_2", 2, 0, 0, 0, 0}, {"alignment_4", 4, 0, 0, 0, 0},
                 {"alignment_8", 8, 0, 0, 0, 0}, {"row_length", 1, 11, 0, 0, 0},
                 {"rows_skipped", 1, 0, 3, 0, 0}, {"pixels_skipped", 1, 9, 0, 2, 0},
                 {"all_of_it", 4, 9, 2, 3, 0},   {"swapped", 1, 0, 0, 0, 1}};
    static const Named types[] = {NAMED(GL_UNSIGNED_BYTE), NAMED(GL_UNSIGNED_SHORT),
                                  NAMED(GL_UNSIGNED_INT), NAMED(GL_UNSIGNED_SHORT_5_6_5)};
    static const Named rgb = NAMED(GL_RGB);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i)
        for (size_t t = 0; t < sizeof types / sizeof types[0]; ++t) {
            char name[64];
            glPixelStorei(GL_UNPACK_ALIGNMENT, cases[i].alignment);
            glPixelStorei(GL_UNPACK_ROW_LENGTH, cases[i].rowLength);
            glPixelStorei(GL_UNPACK_SKIP_ROWS, cases[i].skipRows);
            glPixelStorei(GL_UNPACK_SKIP_PIXELS, cases[i].skipPixels);
            glPixelStorei(GL_UNPACK_SWAP_BYTES, cases[i].swap);
            snprintf(name, sizeof name, "store/%s", cases[i].name);
            drawAs(name, &rgb, &types[t]);
        }
}

static void drawBytes(void) {
    static GLubyte memory[kBytes];
    fill(memory, GL_UNSIGNED_BYTE);
    glDrawPixels(kWide, kHigh, GL_RGB, GL_UNSIGNED_BYTE, memory);
}

/* Zoomed so that no centre of a pixel lies on a border; Mesa rounds the position, so that it has
 * no fraction where the pixels are not of size one. */
static void zooms(void) {
    static const struct {
        GLfloat x, y, zoomX, zoomY;
    } cases[] = {{3.0f, 4.0f, 2.0f, 3.0f},    {20.0f, 4.0f, -1.0f, 1.0f},
                 {3.0f, 25.0f, 1.0f, -1.0f},  {28.0f, 28.0f, -3.0f, -2.0f},
                 {4.0f, 5.0f, 2.6f, 1.72f},    {4.0f, 5.0f, 0.57f, 0.43f},
                 {28.0f, 4.0f, -2.28f, 3.63f}, {16.0f, 16.0f, 9.0f, 8.0f},
                 {4.0f, 20.0f, 0.31f, -0.34f},  {5.0f, 6.0f, 0.0f, 1.0f},
                 {8.25f, 3.25f, 1.0f, 1.0f},  {8.75f, 3.75f, 1.0f, 1.0f}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        char name[32];
        snprintf(name, sizeof name, "zoom/%d", (int)i);
        beginCase(name);
        clearGrey();
        glPixelZoom(cases[i].zoomX, cases[i].zoomY);
        glRasterPos2f(cases[i].x, cases[i].y);
        drawBytes();
        tellWindow();
    }
    glPixelZoom(1.0f, 1.0f);
}

static void tellRaster(void) {
    GLfloat position[4];
    GLboolean valid;
    glGetFloatv(GL_CURRENT_RASTER_POSITION, position);
    glGetBooleanv(GL_CURRENT_RASTER_POSITION_VALID, &valid);
    printf("raster %.2f %.2f valid %d\n", position[0], position[1], valid);
}

static void bitmaps(void) {
    static GLubyte memory[kBytes];
    static const struct {
        const char* name;
        GLfloat x, y, originX, originY, moveX, moveY;
        GLint lsb, skip;
    } cases[] = {{"plain", 4.0f, 5.0f, 0.0f, 0.0f, 13.0f, 0.0f, 0, 0},
                 {"origin", 9.0f, 9.0f, 3.0f, -2.0f, 9.0f, 8.0f, 0, 0},
                 {"fractions", 6.6f, 7.4f, 1.3f, 0.8f, 10.6f, 3.7f, 0, 0},
                 {"backwards", 20.0f, 20.0f, 0.0f, 0.0f, -12.0f, -9.0f, 0, 0},
                 {"lsb_first", 4.0f, 5.0f, 0.0f, 0.0f, 13.0f, 0.0f, 1, 0},
                 {"skipped", 4.0f, 5.0f, 0.0f, 0.0f, 13.0f, 0.0f, 0, 3},
                 {"lsb_first_skipped", 4.0f, 5.0f, 0.0f, 0.0f, 13.0f, 0.0f, 1, 5},
                 {"leaving", 27.0f, 28.0f, 0.0f, 0.0f, 3.0f, 2.0f, 0, 0}};
    fill(memory, GL_UNSIGNED_BYTE);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        char name[64];
        snprintf(name, sizeof name, "bitmap/%s", cases[i].name);
        beginCase(name);
        clearGrey();
        defaultStores();
        glPixelStorei(GL_UNPACK_LSB_FIRST, cases[i].lsb);
        glPixelStorei(GL_UNPACK_SKIP_PIXELS, cases[i].skip);
        glColor3f(1.0f, 0.5f, 0.0f);
        glRasterPos2f(cases[i].x, cases[i].y);
        glColor3f(0.0f, 0.0f, 1.0f); /* too late for the raster position's colour */
        for (int k = 0; k < 2; ++k)
            glBitmap(11, 7, cases[i].originX, cases[i].originY, cases[i].moveX, cases[i].moveY,
                     memory);
        tellRaster();
        tellWindow();
    }
    beginCase("bitmap/moves_only");
    glRasterPos2f(3.0f, 4.0f);
    glBitmap(0, 0, 0.0f, 0.0f, 2.5f, -1.5f, NULL);
    tellRaster();
}

/* A raster position that is clipped draws nothing; one set in window coordinates is not clipped. */
static void positions(void) {
    beginCase("position/clipped");
    clearGrey();
    glRasterPos2f(-1.0f, 5.0f);
    drawBytes();
    tellRaster();
    tellWindow();
    beginCase("position/moved_out_of_the_window");
    clearGrey();
    glRasterPos2f(1.0f, 5.0f);
    glBitmap(0, 0, 0.0f, 0.0f, -4.0f, -7.0f, NULL);
    drawBytes();
    tellRaster();
    tellWindow();
    beginCase("position/of_the_window");
    clearGrey();
    glWindowPos2i(-2, 29);
    drawBytes();
    tellRaster();
    tellWindow();
}

static void square(GLfloat z) {
    glColor3f(0.2f, 0.9f, 0.3f);
    glBegin(GL_TRIANGLE_STRIP);
    glVertex3f(0.0f, 0.0f, z);
    glVertex3f(6.0f, 0.0f, z);
    glVertex3f(0.0f, kWindow, z);
    glVertex3f(6.0f, kWindow, z);
    glEnd();
    glColor3f(1.0f, 1.0f, 1.0f);
}

static void scissored(void) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(5, 6, 7, 3);
}
static void alphaTested(void) {
    glEnable(GL_ALPHA_TEST);
    glAlphaFunc(GL_GREATER, 0.5f);
}
static void depthTested(void) {
    glEnable(GL_DEPTH_TEST);
    square(0.5f);
}
static void masked(void) { glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE); }
static void combined(void) {
    square(0.0f);
    glEnable(GL_COLOR_LOGIC_OP);
    glLogicOp(GL_XOR);
}
static void fogged(void) {
    static const GLfloat color[4] = {1.0f, 0.2f, 0.1f, 1.0f};
    glEnable(GL_FOG);
    glFogi(GL_FOG_MODE, GL_LINEAR);
    glFogf(GL_FOG_START, -1.0f);
    glFogf(GL_FOG_END, 1.0f);
    glFogfv(GL_FOG_COLOR, color);
}
static void textured(void) {
    static const GLubyte texel[3] = {250, 120, 60};
    defaultStores();
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 1, 1, 0, GL_RGB, GL_UNSIGNED_BYTE, texel);
    glEnable(GL_TEXTURE_2D);
}

/* What happens to an image's fragments. */
static void fragments(void) {
    static const struct {
        const char* name;
        void (*set)(void);
        GLfloat z;
    } cases[] = {{"scissor", scissored, 0.0f},        {"alpha_test", alphaTested, 0.0f},
                 {"depth_in_front", depthTested, 0.7f}, {"depth_behind", depthTested, 0.3f},
                 {"color_mask", masked, 0.0f},        {"logic_op", combined, 0.0f},
                 {"fog", fogged, 0.0f},               {"texture", textured, 0.0f}};
    static GLubyte memory[kBytes];
    fill(memory, GL_UNSIGNED_BYTE);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        char name[64];
        snprintf(name, sizeof name, "fragments/%s", cases[i].name);
        beginCase(name);
        glPushAttrib(GL_ALL_ATTRIB_BITS);
        clearGrey();
        cases[i].set();
        glRasterPos3f(3.0f, 4.0f, cases[i].z);
        defaultStores();
        glDrawPixels(kWide, kHigh, GL_RGBA, GL_UNSIGNED_BYTE, memory);
        glPopAttrib();
        tellWindow();
    }
}

static void copies(void) {
    static const struct {
        const char* name;
        GLint x, y, wide, high;
        GLfloat toX, toY, zoomX, zoomY;
    } cases[] = {{"apart", 2, 2, kWide, kHigh, 12.0f, 15.0f, 1.0f, 1.0f},
                 {"overlapping", 2, 2, kWide, kHigh, 4.0f, 3.0f, 1.0f, 1.0f},
                 {"larger", 2, 2, kWide, kHigh, 10.0f, 10.0f, 3.0f, 2.0f},
                 {"mirrored", 2, 2, kWide, kHigh, 25.0f, 25.0f, -2.0f, -2.0f},
                 {"nothing", 2, 2, 0, kHigh, 12.0f, 15.0f, 1.0f, 1.0f}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        char name[64];
        snprintf(name, sizeof name, "copy/%s", cases[i].name);
        beginCase(name);
        clearGrey();
        glRasterPos2i(2, 2);
        drawBytes();
        glPixelZoom(cases[i].zoomX, cases[i].zoomY);
        glRasterPos2f(cases[i].toX, cases[i].toY);
        glCopyPixels(cases[i].x, cases[i].y, cases[i].wide, cases[i].high, GL_COLOR);
        glPixelZoom(1.0f, 1.0f);
        tellWindow();
    }
}

/* An image in a display list is taken when the list is compiled. */
static void lists(void) {
    static GLubyte memory[kBytes];
    static const GLubyte bits[2] = {0xB5, 0x4E};
    const GLuint list = glGenLists(1);
    beginCase("list");
    clearGrey();
    fill(memory, GL_UNSIGNED_BYTE);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 8);
    glNewList(list, GL_COMPILE);
    glDrawPixels(kWide, kHigh, GL_RGB, GL_UNSIGNED_BYTE, memory);
    glBitmap(8, 2, -7.0f, 0.0f, 9.0f, 10.0f, bits);
    glEndList();
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    memset(memory, 0, sizeof memory);
    glRasterPos2i(2, 2);
    glCallList(list);
    glCallList(list);
    tellRaster();
    tellWindow();
    glDeleteLists(list, 1);
}

/* Pixels read in every form; types of more than eight bits in their upper ones. */
static void readings(void) {
    static GLubyte memory[kBytes];
    static const GLint stores[][4] = {{1, 0, 0, 0}, {4, 9, 2, 3}}; /* alignment, row, skips */
    clearGrey();
    glRasterPos2i(2, 3);
    drawBytes();
    for (size_t f = 0; f < sizeof plainFormats / sizeof plainFormats[0]; ++f)
        for (size_t s = 0; s < sizeof stores / sizeof stores[0]; ++s) {
            char name[64];
            snprintf(name, sizeof name, "read/%s/%d", plainFormats[f].name + 3, (int)s);
            beginCase(name);
            memset(memory, 77, sizeof memory);
            glPixelStorei(GL_PACK_ALIGNMENT, stores[s][0]);
            glPixelStorei(GL_PACK_ROW_LENGTH, stores[s][1]);
            glPixelStorei(GL_PACK_SKIP_ROWS, stores[s][2]);
            glPixelStorei(GL_PACK_SKIP_PIXELS, stores[s][3]);
            glReadPixels(1, 2, kWide, kHigh, plainFormats[f].value, GL_UNSIGNED_BYTE, memory);
            defaultStores();
            for (int i = 0; i < 256; ++i) tellLevel(memory[i]);
            printf("\n");
        }
    for (size_t t = 0; t < sizeof plainTypes / sizeof plainTypes[0]; ++t) {
        char name[64];
        snprintf(name, sizeof name, "read/%s", plainTypes[t].name + 3);
        beginCase(name);
        memset(memory, 0, sizeof memory);
        glReadPixels(1, 2, kWide, kHigh, GL_RGB, plainTypes[t].value, memory);
        for (int i = 0; i < kWide * kHigh * 3; ++i) {
            GLfloat value = 0.0f;
            switch (plainTypes[t].value) {
                case GL_UNSIGNED_BYTE:
                    value = memory[i] / 255.0f;
                    break;
                case GL_BYTE:
                    value = ((GLbyte*)memory)[i] / 127.0f;
                    break;
                case GL_UNSIGNED_SHORT:
                    value = ((GLushort*)memory)[i] / 65535.0f;
                    break;
                case GL_SHORT:
                    value = ((GLshort*)memory)[i] / 32767.0f;
                    break;
                case GL_UNSIGNED_INT:
                    value = (GLfloat)(((GLuint*)memory)[i] / 4294967295.0);
                    break;
                case GL_INT:
                    value = (GLfloat)(((GLint*)memory)[i] / 2147483647.0);
                    break;
                default:
                    value = ((GLfloat*)memory)[i];
            }
            tellLevel((int)(value * 120.0f + 0.5f));
        }
        printf("\n");
    }
}

/* The image of the bound texture, a texel a pixel. */
static void showTexture(void) {
    clearGrey();
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    glEnable(GL_BLEND);
    glBegin(GL_TRIANGLE_STRIP);
    glTexCoord2f(0.0f, 0.0f);
    glVertex2i(1, 1);
    glTexCoord2f(1.0f, 0.0f);
    glVertex2i(9, 1);
    glTexCoord2f(0.0f, 1.0f);
    glVertex2i(1, 5);
    glTexCoord2f(1.0f, 1.0f);
    glVertex2i(9, 5);
    glEnd();
    glDisable(GL_BLEND);
    glDisable(GL_TEXTURE_2D);
    readWindow();
    tellPixels(10, 6);
}

static void textureAs(const char* group, const Named* format, const Named* type) {
    static GLubyte memory[kBytes];
    char name[128];
    snprintf(name, sizeof name, "%s/%s/%s", group, format->name + 3, type->name + 3);
    beginCase(name);
    fill(memory, type->value);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 4, 0, format->value, type->value, memory);
    showTexture();
    glTexSubImage2D(GL_TEXTURE_2D, 0, 2, 1, 4, 2, format->value, type->value, memory + 64);
    showTexture();
}

static void textures(void) {
    static GLubyte memory[kBytes];
    static const Named bytes = NAMED(GL_UNSIGNED_BYTE), numbers = NAMED(GL_SHORT);
    static const Named rgba = NAMED(GL_RGBA);
    const GLuint list = glGenLists(1);
    slack = 2;
    for (size_t f = 0; f < sizeof plainFormats / sizeof plainFormats[0]; ++f)
        textureAs("texture", &plainFormats[f], &bytes);
    for (size_t t = 0; t < sizeof plainTypes / sizeof plainTypes[0]; ++t)
        textureAs("texture", &rgba, &plainTypes[t]);
    for (size_t i = 0; i < sizeof packed / sizeof packed[0]; ++i)
        textureAs("texture", &packed[i].format, &packed[i].type);
    glPixelTransferf(GL_RED_SCALE, 0.5f);
    glPixelTransferf(GL_GREEN_BIAS, 0.25f);
    glPixelTransferf(GL_ALPHA_SCALE, -1.0f);
    glPixelTransferf(GL_ALPHA_BIAS, 1.0f);
    textureAs("texture/transfer", &rgba, &bytes);
    textureAs("texture/transfer", &rgba, &numbers);
    glPixelTransferf(GL_ALPHA_SCALE, 1.0f);
    glPixelTransferf(GL_ALPHA_BIAS, 0.0f);
    glPixelTransferf(GL_RED_SCALE, 1.0f);
    glPixelTransferf(GL_GREEN_BIAS, 0.0f);
    beginCase("texture/copied");
    clearGrey();
    drawBytes();
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 1, 2, 8, 4, 0);
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 3, 1, 0, 0, 2, 2);
    showTexture();
    beginCase("texture/in_a_list");
    fill(memory, GL_UNSIGNED_BYTE);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 4, 0, GL_RGB, GL_UNSIGNED_BYTE, memory);
    glNewList(list, GL_COMPILE);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 1, 1, 3, 2, GL_BGRA, GL_UNSIGNED_BYTE, memory);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 4, 0, 2, 2, GL_RGB, GL_UNSIGNED_SHORT_5_6_5, memory);
    glEndList();
    memset(memory, 0, sizeof memory);
    showTexture();
    glCallList(list);
    showTexture();
    glDeleteLists(list, 1);
    slack = 1;
}

static void askQuestions(void) {
    useWindowCoordinates();
    glColor4f(1.0f, 1.0f, 1.0f, 1.0f);
    formats();
    transfers();
    stores();
    zooms();
    bitmaps();
    positions();
    fragments();
    copies();
    lists();
    readings();
    textures();
}

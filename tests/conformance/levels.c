/* SPDX-License-Identifier: MIT */
/* Which level of a texture a fragment gets: on flat, turned and slanted triangles and on lines, in
 * two units and several viewports; what proxies say of levels that a texture might have. */
#define GL_GLEXT_PROTOTYPES
#include "tests/conformance/window_pixels.h"

#include <math.h>

enum { kSide = 32, kLevels = 6 };

/* Each level has another colour: of a channel, so that two units can be told from each other. */
static void useLevels(int unit) {
    static GLubyte image[kSide * kSide][4];
    glActiveTexture(GL_TEXTURE0 + (GLenum)unit);
    glBindTexture(GL_TEXTURE_2D, (GLuint)(5 + unit));
    for (int level = 0; level < kLevels; ++level) {
        for (int i = 0; i < kSide * kSide; ++i) image[i][unit] = (GLubyte)(40 * level + 30);
        glTexImage2D(GL_TEXTURE_2D, level, GL_RGB, kSide >> level, kSide >> level, 0, GL_RGBA,
                     GL_UNSIGNED_BYTE, image);
    }
    for (int i = 0; i < kSide * kSide; ++i) image[i][unit] = 0;
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, unit == 0 ? GL_REPLACE : GL_ADD);
    glEnable(GL_TEXTURE_2D);
}

static void dropLevels(void) {
    for (int unit = 2; unit-- > 0;) {
        glActiveTexture(GL_TEXTURE0 + (GLenum)unit);
        glDisable(GL_TEXTURE_2D);
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
        glBindTexture(GL_TEXTURE_2D, 0);
    }
}

/* How many texels s and t go on from pixel to pixel: with x, with y. */
typedef struct {
    GLfloat sx, tx, sy, ty;
} Texels;

static void vertexAt(const Texels* first, const Texels* second, GLfloat scale, GLfloat x,
                     GLfloat y) {
    glMultiTexCoord2f(GL_TEXTURE0, scale * (first->sx * x + first->sy * y) / kSide,
                      scale * (first->tx * x + first->ty * y) / kSide);
    glMultiTexCoord2f(GL_TEXTURE1, (second->sx * x + second->sy * y) / scale / kSide,
                      (second->tx * x + second->ty * y) / scale / kSide);
    glVertex2f(x, y);
}

/* In the middle of a level, as an implementation may take a simpler measure than the length. */
static void flat(void) {
    static const struct {
        const char* name;
        Texels texels;
    } ways[] = {
        {"along", {1.0f, 0.0f, 0.0f, 1.0f}},           {"turned", {0.9f, 0.5f, -0.5f, 0.9f}},
        {"far_turned", {-0.4f, 0.95f, -0.95f, -0.4f}}, {"skewed", {1.0f, 0.2f, 0.3f, 0.3f}},
        {"only_sx", {1.0f, 0.1f, 0.1f, 0.2f}},         {"only_tx", {0.1f, 1.0f, 0.2f, 0.1f}},
        {"only_sy", {0.1f, 0.2f, 1.0f, 0.1f}},         {"only_ty", {0.2f, 0.1f, 0.1f, 1.0f}},
        {"flipped", {0.3f, -1.0f, 0.9f, 0.3f}}};
    enum { kWays = sizeof ways / sizeof ways[0] };
    useLevels(0);
    useLevels(1);
    for (int way = 0; way < kWays; ++way)
        for (int level = -1; level < kLevels; ++level) {
            const Texels* const first = &ways[way].texels;
            const Texels* const second = &ways[(way + 5) % kWays].texels;
            const GLfloat scale = ldexpf(1.0f, level);
            Texels more = *second; /* of which the other unit sees the smallest first */
            char name[64];
            more.sx *= 16.0f, more.tx *= 16.0f, more.sy *= 16.0f, more.ty *= 16.0f;
            snprintf(name, sizeof name, "flat/%s/%d", ways[way].name, level);
            beginCase(name);
            clearBoth();
            glBegin(GL_TRIANGLES);
            vertexAt(first, &more, scale, 1.25f, 2.25f);
            vertexAt(first, &more, scale, 30.75f, 4.25f);
            vertexAt(first, &more, scale, 6.25f, 29.75f);
            glEnd();
            readWindow();
            tellPixel(7, 7);
            tellPixel(12, 14);
            tellPixel(20, 8);
        }
    dropLevels();
}

/* Levels that OpenGL's answers have at the pixel, or that near. */
static void tellLevelsNear(int x, int y, int reachX, int reachY) {
    for (int unit = 0; unit < 2; ++unit) {
        unsigned seen = 0, told = 0;
        for (int j = y - reachY; j <= y + reachY; ++j)
            for (int i = x - reachX; i <= x + reachX; ++i)
                if (i >= 0 && i < kWindow && j >= 0 && j < kWindow)
                    seen |= 1u << (window[j][i][unit] + 10) / 40;
        if (!kTellsAlternatives) seen = 1u << (window[y][x][unit] + 10) / 40;
        for (unsigned level = 0; level < 8; ++level)
            if (seen >> level & 1u) printf("%s%u", told++ != 0 ? "|" : "", level);
        putchar(' ');
    }
}

static const GLint viewports[][4] = {
    {0, 0, 32, 32}, {3, 9, 28, 22}, {-5, -40, 40, 90}, {7, 2, 20, 29}, {-60, -10, 100, 42}};
enum { kViewports = sizeof viewports / sizeof viewports[0] };

static void lookIntoDepth(void) {
    useLevels(0);
    useLevels(1);
    glMatrixMode(GL_PROJECTION);
    glPushMatrix();
    glLoadIdentity();
    glFrustum(-1.0, 1.0, -1.0, 1.0, 1.0, 50.0);
    glMatrixMode(GL_MODELVIEW);
}

static void lookFlatAgain(void) {
    glViewport(0, 0, kWindow, kWindow);
    glMatrixMode(GL_PROJECTION);
    glPopMatrix();
    glMatrixMode(GL_MODELVIEW);
    dropLevels();
}

/* A floor, in a viewport that begins elsewhere. */
static void perspective(void) {
    static const GLfloat scales[3] = {0.5f, 1.2f, 2.4f};
    lookIntoDepth();
    for (int i = 0; i < kViewports; ++i)
        for (int k = 0; k < 5; ++k) { /* the third one, turned, changes too slowly */
            const GLfloat scale = scales[k % 3];
            char name[64];
            snprintf(name, sizeof name, "perspective/%d/%d", i, k);
            beginCase(name);
            clearBoth();
            glViewport(viewports[i][0], viewports[i][1], viewports[i][2], viewports[i][3]);
            glPushMatrix();
            if (k >= 3) glRotatef(90.0f, 0.0f, 0.0f, 1.0f);
            glBegin(GL_TRIANGLES);
            glMultiTexCoord2f(GL_TEXTURE0, 0.0f, 0.0f);
            glMultiTexCoord2f(GL_TEXTURE1, 0.0f, 0.0f);
            glVertex3f(-1.5f, -1.2f, -1.2f);
            glMultiTexCoord2f(GL_TEXTURE0, scale, 0.3f * scale);
            glMultiTexCoord2f(GL_TEXTURE1, 0.0f, 4.0f * scale);
            glVertex3f(1.5f, -1.2f, -1.2f);
            glMultiTexCoord2f(GL_TEXTURE0, 0.0f, 4.0f * scale);
            glMultiTexCoord2f(GL_TEXTURE1, 2.0f * scale, 0.0f);
            glVertex3f(0.0f, 8.0f, -6.5f);
            glEnd();
            glPopMatrix();
            readWindow();
            for (int y = 1; y < kWindow; y += 2) {
                for (int x = 1; x < kWindow; x += 2) tellLevelsNear(x, y, 4, 4);
                printf("\n");
            }
        }
    lookFlatAgain();
}

/* A wall whose level changes along x alone, or a floor along y alone: whatever measure an
 * implementation takes, it is that coordinate's change. */
static void receding(void) {
    static const GLfloat ends[][2] = {{-1.0f, -1.0f}, {2.5f, -4.0f}}; /* sideways, z */
    lookIntoDepth();
    for (int i = 0; i < kViewports; ++i)
        for (int k = 0; k < 8; ++k) {
            const int isFloor = k & 1;
            const GLfloat side = k & 2 ? -1.0f : 1.0f, scale = k & 4 ? 3.0f : 1.0f;
            char name[64];
            snprintf(name, sizeof name, "receding/%d/%d", i, k);
            beginCase(name);
            clearBoth();
            glViewport(viewports[i][0], viewports[i][1], viewports[i][2], viewports[i][3]);
            glBegin(GL_TRIANGLE_STRIP);
            for (int corner = 0; corner < 4; ++corner) {
                const GLfloat* const end = ends[corner / 2];
                const GLfloat across = corner & 1 ? 9.0f : -9.0f, along = side * end[0];
                const GLfloat s = scale * (GLfloat)(corner / 2);
                glMultiTexCoord2f(GL_TEXTURE0, s, 0.4f);
                glMultiTexCoord2f(GL_TEXTURE1, 0.4f, 4.0f * s);
                if (isFloor)
                    glVertex3f(across, along, end[1]);
                else
                    glVertex3f(along, across, end[1]);
            }
            glEnd();
            readWindow();
            for (int y = 2; y < kWindow - 2; y += 3) {
                for (int x = 2; x < kWindow - 2; x += 3)
                    tellLevelsNear(x, y, isFloor ? 0 : 2, isFloor ? 2 : 0);
                printf("\n");
            }
        }
    lookFlatAgain();
}

/* From within a pixel's diamond to within another one's, so that the pixels are not open. */
static void lines(void) {
    static const GLfloat lengths[] = {0.75f, 1.0f, 2.0f, 5.0f};
    useLevels(0);
    useLevels(1);
    for (int steep = 0; steep < 2; ++steep)
        for (size_t i = 0; i < sizeof lengths / sizeof lengths[0]; ++i)
            for (int level = 0; level < kLevels; ++level) {
                const GLfloat there = 10.375f + lengths[i];
                const GLfloat s = lengths[i] * ldexpf(1.0f, level) / kSide;
                const GLfloat t = lengths[i] * ldexpf(1.0f, kLevels - 1 - level) / kSide;
                char name[64];
                snprintf(name, sizeof name, "lines/%s/%d/%d", steep ? "up" : "across", (int)i,
                         level);
                beginCase(name);
                clearBoth();
                glBegin(GL_LINES);
                glMultiTexCoord2f(GL_TEXTURE0, 0.0f, 0.0f);
                glMultiTexCoord2f(GL_TEXTURE1, 0.0f, 0.0f);
                glVertex2f(steep ? 10.5f : 10.375f, steep ? 10.375f : 10.5f);
                glMultiTexCoord2f(GL_TEXTURE0, s, s / 8);
                glMultiTexCoord2f(GL_TEXTURE1, t / 8, t);
                glVertex2f(steep ? 10.5f : there, steep ? there : 10.5f);
                glEnd();
                readWindow();
                tellPixel(10, 10);
                for (int k = 1; k < (int)lengths[i]; ++k)
                    tellPixel(steep ? 10 : 10 + k, steep ? 10 + k : 10);
            }
    dropLevels();
}

static void tellProxy(GLenum target, GLint level) {
    static const GLenum asked[] = {GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_BORDER};
    for (size_t i = 0; i < sizeof asked / sizeof asked[0]; ++i) {
        GLint integer = -1;
        glGetTexLevelParameteriv(target, level, asked[i], &integer);
        printf("%d ", integer);
    }
    printf("\n");
    tellError();
}

static void tellProxyImage(GLint level, GLint internalFormat, GLsizei width, GLsizei height,
                           GLint border, GLenum format, GLenum type) {
    glTexImage2D(GL_PROXY_TEXTURE_2D, level, internalFormat, width, height, border, format, type,
                 NULL);
    tellError();
    tellProxy(GL_PROXY_TEXTURE_2D, 1);
}

/* What is asked of images that are too large, and of wrong ones; what a proxy is not. */
static void proxies(void) {
    GLubyte memory[16 * 8 * 4] = {0};
    GLint value = -1;
    beginCase("proxies");
    tellProxy(GL_PROXY_TEXTURE_1D, 0);
    tellProxyImage(1, GL_RGB, 64, 32, 0, GL_RGB, GL_UNSIGNED_BYTE);
    tellProxyImage(1, GL_RGB, -1, 32, 0, GL_RGB, GL_UNSIGNED_BYTE);
    tellProxyImage(1, GL_RGB, 64, 32, 2, GL_RGB, GL_UNSIGNED_BYTE);
    tellProxyImage(1, GL_RGB, 64, 32, 0, GL_RGB, 0x9999);
    tellProxyImage(1, GL_RGB, 64, 32, 0, 0x9999, GL_UNSIGNED_BYTE);
    tellProxyImage(1, GL_RGB, 64, 32, 0, GL_RGBA, GL_UNSIGNED_SHORT_5_6_5);
    tellProxyImage(1, GL_RGB, 64, 32, 0, GL_DEPTH_COMPONENT, GL_FLOAT);
    tellProxyImage(1, GL_DEPTH_COMPONENT, 64, 32, 0, GL_RGB, GL_FLOAT);
    tellProxyImage(1, 99, 64, 32, 0, GL_RGB, GL_UNSIGNED_BYTE);
    tellProxyImage(-1, GL_RGB, 8, 8, 0, GL_RGB, GL_UNSIGNED_BYTE);
    tellProxyImage(99, GL_RGB, 8, 8, 0, GL_RGB, GL_UNSIGNED_BYTE);
    tellProxyImage(1, GL_RGB, 1 << 20, 32, 0, GL_RGB, GL_UNSIGNED_BYTE);
    tellProxyImage(1, GL_RGBA, 16, 8, 0, GL_BGRA, GL_FLOAT);
    tellProxyImage(1, GL_RGB, 8, 1 << 20, 0, GL_RGB, GL_UNSIGNED_BYTE);
    glTexImage1D(GL_PROXY_TEXTURE_1D, 0, 1, 5, 0, GL_RED, GL_SHORT, NULL);
    tellProxy(GL_PROXY_TEXTURE_1D, 0);
    glTexImage1D(GL_PROXY_TEXTURE_2D, 0, 1, 5, 0, GL_RED, GL_SHORT, NULL);
    tellError();
    tellProxy(GL_TEXTURE_2D, 1);
    glNewList(7, GL_COMPILE);
    tellProxyImage(1, GL_RGB, 4, 2, 0, GL_RGB, GL_UNSIGNED_BYTE);
    glEndList();
    tellProxyImage(1, GL_RGB, 2, 4, 0, GL_RGB, GL_UNSIGNED_BYTE);
    glCallList(7);
    tellProxy(GL_PROXY_TEXTURE_2D, 1);
    glDeleteLists(7, 1);
    glBindTexture(GL_PROXY_TEXTURE_2D, 1);
    tellError();
    glEnable(GL_PROXY_TEXTURE_2D);
    tellError();
    glTexParameteri(GL_PROXY_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    tellError();
    glGetTexParameteriv(GL_PROXY_TEXTURE_2D, GL_TEXTURE_WRAP_S, &value);
    tellError();
    glTexSubImage2D(GL_PROXY_TEXTURE_2D, 1, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, memory);
    tellError();
    glCopyTexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGB, 0, 0, 1, 1, 0);
    tellError();
    glGetTexImage(GL_PROXY_TEXTURE_2D, 1, GL_RGBA, GL_UNSIGNED_BYTE, memory);
    tellError();
}

static void askQuestions(void) {
    useWindowCoordinates();
    glColor4f(1.0f, 1.0f, 1.0f, 1.0f);
    flat();
    perspective();
    receding();
    lines();
    proxies();
}

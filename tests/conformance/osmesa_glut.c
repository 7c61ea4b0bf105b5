/* SPDX-License-Identifier: MIT */
/* GLUT without a display: the calls of tests/conformance/glut/GL/glut.h on OSMesa, one window,
 * one context, a fixed clock. Options are told in osmesa_glut.h. */
#include "tests/conformance/osmesa_glut.h"

#include <GL/glut.h>
#include <GL/osmesa.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "samples/common/write_png.h"

enum { kMaxTimers = 32 };

typedef struct {
    void (*callback)(int);
    int value, due, active;
} Timer;

static struct {
    DriverOptions options;
    void (*display)(void);
    void (*reshape)(int, int);
    void (*idle)(void);
    void (*visibility)(int);
    Timer timers[kMaxTimers];
    unsigned displayMode;
    int width, height, clock;
    PixelShift shift;
    OSMesaContext context;
    void* pixels; /* RGBA, bytes or floats */
} driver = {.width = 300, .height = 300};

static void fail(const char* text) {
    fprintf(stderr, "GLUT on OSMesa: %s\n", text);
    exit(2);
}

/* The two calls through which a variant acts; the program's are bound to these. */

void GLAPIENTRY glViewport(GLint x, GLint y, GLsizei width, GLsizei height) {
    typedef void(GLAPIENTRY * Viewport)(GLint, GLint, GLsizei, GLsizei);
    typedef void(GLAPIENTRY * ViewportIndexed)(GLuint, GLfloat, GLfloat, GLfloat, GLfloat);
    static Viewport whole;
    static ViewportIndexed fractional;
    if (whole == NULL) {
        whole = (Viewport)OSMesaGetProcAddress("glViewport");
        fractional = (ViewportIndexed)OSMesaGetProcAddress("glViewportIndexedf");
    }
    whole(x, y, width, height);
    if (driver.shift.x == 0.0f && driver.shift.y == 0.0f) return;
    if (fractional == NULL) fail("this OSMesa can not move the viewport by parts of a pixel");
    fractional(0, (float)x + driver.shift.x, (float)y + driver.shift.y, (float)width,
               (float)height);
}

void GLAPIENTRY glShadeModel(GLenum mode) {
    typedef void(GLAPIENTRY * Mode)(GLenum);
    static Mode shadeModel, provokingVertex;
    if (shadeModel == NULL) {
        shadeModel = (Mode)OSMesaGetProcAddress("glShadeModel");
        provokingVertex = (Mode)OSMesaGetProcAddress("glProvokingVertex");
    }
    shadeModel(mode);
    if (!driver.options.splitFirst) return;
    if (provokingVertex == NULL) fail("this OSMesa can not choose the provoking vertex");
    provokingVertex(mode == GL_SMOOTH ? GL_FIRST_VERTEX_CONVENTION : GL_LAST_VERTEX_CONVENTION);
}

void glutInit(int* argc, char** argv) {
    takeDriverOptions(argc, argv, &driver.options);
    if (driver.options.width > 0) glutInitWindowSize(driver.options.width, driver.options.height);
}

void glutInitDisplayMode(unsigned int mode) {
    if (mode & GLUT_INDEX) fail("colour index is not supported");
    driver.displayMode = mode;
}

void glutInitWindowSize(int width, int height) {
    driver.width = width;
    driver.height = height;
}

void glutInitWindowPosition(int x, int y) {
    (void)x;
    (void)y;
}

/* With floats OpenGL would leave fragments as they are. */
static void clampFragments(void) {
    typedef void(GLAPIENTRY * ClampColor)(GLenum, GLenum);
    const ClampColor clampColor = (ClampColor)OSMesaGetProcAddress("glClampColor");
    if (clampColor == NULL) fail("this OSMesa can not clamp colours");
    clampColor(GL_CLAMP_FRAGMENT_COLOR, GL_TRUE);
}

int glutCreateWindow(const char* title) {
    (void)title;
    if (driver.context != NULL) fail("one window only");
    driver.context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, NULL);
    driver.pixels = calloc((size_t)driver.width * (size_t)driver.height, 4 * sizeof(GLfloat));
    if (driver.context == NULL || driver.pixels == NULL ||
        !OSMesaMakeCurrent(driver.context, driver.pixels,
                           driver.options.floatBuffer ? GL_FLOAT : GL_UNSIGNED_BYTE, driver.width,
                           driver.height))
        fail("no context");
    glShadeModel(GL_SMOOTH);
    if (driver.options.floatBuffer) clampFragments();
    return 1;
}

void glutPostRedisplay(void) {}
void glutSwapBuffers(void) {
    glFlush();
}

int glutGet(GLenum state) {
    switch (state) {
        case GLUT_ELAPSED_TIME:
            return driver.clock;
        case GLUT_WINDOW_WIDTH:
        case GLUT_INIT_WINDOW_WIDTH:
            return driver.width;
        case GLUT_WINDOW_HEIGHT:
        case GLUT_INIT_WINDOW_HEIGHT:
            return driver.height;
        case GLUT_WINDOW_DEPTH_SIZE:
            return 24;
        case GLUT_WINDOW_DOUBLEBUFFER:
            return (driver.displayMode & GLUT_DOUBLE) != 0;
        case GLUT_INIT_DISPLAY_MODE:
            return (int)driver.displayMode;
        default:
            return -1;
    }
}

void glutDisplayFunc(void (*callback)(void)) {
    driver.display = callback;
}
void glutReshapeFunc(void (*callback)(int, int)) {
    driver.reshape = callback;
}
void glutIdleFunc(void (*callback)(void)) {
    driver.idle = callback;
}
void glutVisibilityFunc(void (*callback)(int)) {
    driver.visibility = callback;
}

/* Nobody presses a key here. */
void glutKeyboardFunc(void (*callback)(unsigned char, int, int)) {
    (void)callback;
}
void glutSpecialFunc(void (*callback)(int, int, int)) {
    (void)callback;
}
void glutMouseFunc(void (*callback)(int, int, int, int)) {
    (void)callback;
}
void glutMotionFunc(void (*callback)(int, int)) {
    (void)callback;
}

void glutTimerFunc(unsigned int milliseconds, void (*callback)(int), int value) {
    for (int i = 0; i < kMaxTimers; ++i) {
        Timer* timer = &driver.timers[i];
        if (timer->active) continue;
        *timer = (Timer){callback, value, driver.clock + (int)milliseconds, 1};
        return;
    }
    fail("too many timers");
}

/* Timers due until `now`, earliest first; each sees the time it was due at. */
static void callTimers(int now) {
    for (;;) {
        Timer* next = NULL;
        for (int i = 0; i < kMaxTimers; ++i) {
            Timer* timer = &driver.timers[i];
            if (timer->active && timer->due <= now && (next == NULL || timer->due < next->due))
                next = timer;
        }
        if (next == NULL) break;
        next->active = 0;
        driver.clock = next->due;
        next->callback(next->value);
    }
    driver.clock = now;
}

static GLubyte byteOf(GLfloat value) {
    return (GLubyte)(255.0f * (value > 0.0f ? (value < 1.0f ? value : 1.0f) : 0.0f) + 0.5f);
}

/* The picture as opaque bytes, row 0 at the bottom. */
static GLubyte* opaquePicture(size_t count) {
    GLubyte* picture = malloc(count * 4);
    if (picture == NULL) fail("out of memory");
    for (size_t i = 0; i < 4 * count; ++i) {
        if (i % 4 == 3)
            picture[i] = 255;
        else if (driver.options.floatBuffer)
            picture[i] = byteOf(((const GLfloat*)driver.pixels)[i]);
        else
            picture[i] = ((const GLubyte*)driver.pixels)[i];
    }
    return picture;
}

static void deliver(int frame, int variant) {
    const DriverOptions* options = &driver.options;
    const size_t count = (size_t)driver.width * (size_t)driver.height;
    char path[4352];
    if (options->output != NULL) {
        GLubyte* opaque = opaquePicture(count);
        if (!frameFile(path, sizeof path, options->output, frame, variant) ||
            !writePng(path, opaque, (unsigned)driver.width, (unsigned)driver.height))
            fail("a frame could not be written");
        free(opaque);
    }
    if (options->depth != NULL) {
        float* depth = malloc(count * sizeof *depth);
        if (depth == NULL) fail("out of memory");
        glPushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
        glPixelStorei(GL_PACK_ALIGNMENT, 4);
        glReadPixels(0, 0, driver.width, driver.height, GL_DEPTH_COMPONENT, GL_FLOAT, depth);
        glPopClientAttrib();
        if (!frameFile(path, sizeof path, options->depth, frame, variant) ||
            !writeDepth(path, depth, driver.width, driver.height))
            fail("a frame could not be written");
        free(depth);
    }
}

static void setSize(void) {
    if (driver.reshape != NULL)
        driver.reshape(driver.width, driver.height);
    else
        glViewport(0, 0, driver.width, driver.height);
}

static double drawFrame(void) {
    struct timespec start, end;
    if (driver.options.variants > 0) setSize(); /* the viewport moves */
    clock_gettime(CLOCK_MONOTONIC, &start);
    driver.display();
    glFinish();
    clock_gettime(CLOCK_MONOTONIC, &end);
    return 1e3 * (double)(end.tv_sec - start.tv_sec) + 1e-6 * (double)(end.tv_nsec - start.tv_nsec);
}

static void beginReport(FILE* report) {
    GLfloat clear[4];
    glGetFloatv(GL_COLOR_CLEAR_VALUE, clear);
    fprintf(report,
            "{\"renderer\": \"%s\", \"version\": \"%s\", \"clear\": [%g, %g, %g], \"ms\": [",
            (const char*)glGetString(GL_RENDERER), (const char*)glGetString(GL_VERSION), clear[0],
            clear[1], clear[2]);
}

void glutMainLoop(void) {
    const DriverOptions* options = &driver.options;
    FILE* report = NULL;
    if (driver.context == NULL || driver.display == NULL) fail("no window, or no display callback");
    if (options->report != NULL && (report = fopen(options->report, "w")) == NULL)
        fail("the report could not be written");
    setSize();
    if (driver.visibility != NULL) driver.visibility(GLUT_VISIBLE);
    for (int frame = 0; frame < options->frames; ++frame) {
        double milliseconds = 0;
        callTimers(frame * kFrameMilliseconds);
        if (driver.idle != NULL) driver.idle();
        for (int variant = options->variants; variant >= 0; --variant) {
            driver.shift = options->shifts[variant];
            milliseconds = drawFrame();
            deliver(frame, variant);
        }
        if (report == NULL) continue;
        if (frame == 0) beginReport(report);
        fprintf(report, "%s%.4f", frame ? ", " : "", milliseconds);
    }
    if (report != NULL && (fprintf(report, "]}\n"), fclose(report) != 0))
        fail("the report could not be written");
    OSMesaDestroyContext(driver.context);
    free(driver.pixels);
    exit(0);
}

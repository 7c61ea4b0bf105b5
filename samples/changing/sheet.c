/* SPDX-License-Identifier: MIT */
/* sheet: satin over moving balls, 200,000 triangles whose vertices are given anew for every frame.
 * The triangles and colours stay, so rtUpdateObject takes positions alone, in the order in which
 * the object was given its vertices. Without normals a surface shader takes the triangles' own.
 * Usage: sheet [--columns N] [--redefine] [--fps] [rtut's options, as --rt-offscreen N]
 *   --redefine  defines the object anew instead, to compare */
#include <math.h>

#include "openrt/rt.h"
#include "openrt/rtut.h"
#include "samples/changing/frame_rate.h"
#include "samples/changing/options.h"

enum { kBalls = 7, kMaxColumns = 4000 };

static const double kWidth = 16, kDepth = 10, kTwoPi = 6.283185307179586;

static long columns = 400, redefines, printsRate;
static long rows; /* five for eight columns, so that cells are squares: 400 x 250 x 2 triangles */
static RTuint sheet, surface, lights[2];
static RTfloat *heights;   /* of the grid's points */
static RTfloat *positions; /* of the vertices, as the strips take them: each inner row twice */

static double columnX(long column) {
    return kWidth * ((double)column / (double)columns - 0.5);
}
static double rowZ(long row) {
    return kDepth * ((double)row / (double)rows - 0.5);
}

/* Balls that lift the sheet, and a ripple that goes through it. */
static double heightAt(double x, double z, double time, double balls[kBalls][3]) {
    double height = 0.06 * sin(2.1 * x - 1.7 * z - 3 * time);
    int i;
    height += 0.04 * sin(3.3 * z + 1.4 * x + 2 * time);
    for (i = 0; i < kBalls; ++i) {
        const double dx = x - balls[i][0], dz = z - balls[i][1], size = balls[i][2];
        const double far = (dx * dx + dz * dz) / (size * size);
        if (far < 9) height += 1.25 * size * exp(-1.6 * far) * (1 - far / 9);
    }
    return height;
}

static void deform(double time) {
    double balls[kBalls][3];
    long row, column;
    RTfloat *next = positions;
    int i;
    for (i = 0; i < kBalls; ++i) {
        const double turn = time * (0.35 + 0.05 * i) + kTwoPi * i / kBalls;
        balls[i][0] = (5.6 - 0.3 * i) * cos(turn);
        balls[i][1] = 3.4 * sin(turn * (i % 2 ? 1.0 : -1.0) + i);
        balls[i][2] = 0.8 + 0.1 * i;
    }
    for (row = 0; row <= rows; ++row)
        for (column = 0; column <= columns; ++column)
            heights[row * (columns + 1) + column] =
                (RTfloat)heightAt(columnX(column), rowZ(row), time, balls);
    for (row = 0; row < rows; ++row) {
        for (column = 0; column <= columns; ++column) {
            for (i = 0; i < 2; ++i) {
                *next++ = (RTfloat)columnX(column);
                *next++ = heights[(row + i) * (columns + 1) + column];
                *next++ = (RTfloat)rowZ(row + i);
            }
        }
    }
}

static RTsizei vertexCount(void) {
    return (RTsizei)(2 * rows * (columns + 1));
}

/* What stands between rtNewObject or rtReplaceObject and rtEndObject. */
static void describeSheet(void) {
    const RTfloat *next = positions;
    long row, column;
    int i;
    rtBindShader(surface);
    for (row = 0; row < rows; ++row) {
        rtBegin(RT_QUAD_STRIP);
        for (column = 0; column <= columns; ++column) {
            for (i = 0; i < 2; ++i, next += 3) {
                const double stripe = sin(kTwoPi * 10 * (double)column / (double)columns);
                if (stripe > 0.55)
                    rtColor3f(0.85f, 0.62f, 0.2f);
                else
                    rtColor3f(0.62f, 0.03f, 0.07f);
                rtVertex3fv(next);
            }
        }
        rtEnd();
    }
    rtEndObject();
    rtBindShader(0);
}

static void check(void) {
    if (rtGetError() == RT_NO_ERROR) return;
    fprintf(stderr, "sheet: %s\n", rtGetErrorText());
    rtExit();
    exit(1);
}

static void display(void) {
    const double time = 1e-3 * rtutGet(RTUT_ELAPSED_TIME);
    frameBegins();
    deform(time);
    if (redefines) {
        rtReplaceObject(sheet);
        describeSheet();
    } else {
        rtUpdateObject(sheet, 0, vertexCount(), positions);
    }
    rtClear(RT_COLOR_BUFFER_BIT | RT_DEPTH_BUFFER_BIT);
    rtUseLight(lights[0]);
    rtUseLight(lights[1]);
    rtInstantiateObject(sheet);
    frameIsDescribed();
    rtutSwapBuffers();
    check();
}

static void reshape(int width, int height) {
    rtViewport(0, 0, (RTsizei)width, (RTsizei)height);
    rtMatrixMode(RT_PROJECTION);
    rtLoadIdentity();
    rtPerspective(36, (RTdouble)width / height, 0.5, 100);
    rtMatrixMode(RT_MODELVIEW);
    rtLoadIdentity();
    rtLookAt(0, 8.5, 11.2, 0, 0.2, 0.6, 0, 1, 0);
}

/* In the space of the eye: the model-view matrix does not act on parameters. */
static RTuint makeLight(const RTfloat *position, const RTfloat *radiance) {
    RTuint light;
    rtGenNewShaderClass("PointLight", NULL);
    light = rtGenNewShader();
    rtParameter3f(rtParameterHandle("position"), position[0], position[1], position[2]);
    rtParameter3f(rtParameterHandle("radiance"), radiance[0], radiance[1], radiance[2]);
    return light;
}

int main(int argc, char **argv) {
    static const RTfloat left[] = {-11, 7, -9}, right[] = {9, 9, -6};
    static const RTfloat warm[] = {125, 112, 95}, cool[] = {34, 44, 70};
    const Option options[] = {{"--columns", &columns, 8, kMaxColumns, 0},
                              {"--redefine", &redefines, 0, 1, 1},
                              {"--fps", &printsRate, 0, 1, 1}};
    rtutInitWindowSize(800, 600);
    rtutInit(&argc, argv);
    readOptions(argc, argv, options, 3);
    rows = columns * 5 / 8;
    heights = malloc((size_t)(rows + 1) * (size_t)(columns + 1) * sizeof *heights);
    positions = malloc((size_t)vertexCount() * 3 * sizeof *positions);
    if (!heights || !positions) return 1;
    rtutInitDisplayMode(RTUT_RGB | RTUT_DEPTH | RTUT_DOUBLE);
    rtutCreateWindow("sheet");
    if (printsRate) countFrames("sheet");
    rtClearColor(0.03f, 0.03f, 0.045f, 1);
    rtEnable(RT_FRAMEBUFFER_SRGB);
    lights[0] = makeLight(left, warm);
    lights[1] = makeLight(right, cool);
    rtGenNewShaderClass("MetallicRoughness", NULL);
    surface = rtGenNewShader();
    rtParameter1f(rtParameterHandle("metallic"), 0.35f);
    rtParameter1f(rtParameterHandle("roughness"), 0.42f);
    deform(0);
    sheet = rtNewObject(RT_DEFINE);
    describeSheet();
    check();
    rtutDisplayFunc(display);
    rtutReshapeFunc(reshape);
    rtutIdleFunc(rtutPostRedisplay);
    rtutMainLoop();
    return 0;
}

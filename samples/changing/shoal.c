/* SPDX-License-Identifier: MIT */
/* shoal: thousands of fish, each an instance that moves from frame to frame. What a frame costs
 * beside its rays is a matrix and a call for each fish, and the tree over them. A fish is one of
 * eight objects, the poses of a beat of its tail; its colour is the instance's.
 * Usage: shoal [--instances N] [--no-shadows] [--fps] [rtut's options, as --rt-offscreen N] */
#include <math.h>

#include "openrt/rt.h"
#include "openrt/rtut.h"
#include "samples/changing/frame_rate.h"
#include "samples/changing/options.h"

enum { kPoses = 8, kRings = 9, kSides = 8, kMaxFish = 10000000 };

static const double kTwoPi = 6.283185307179586;

static RTuint poses[kPoses], ground;
static long fishCount = 4000, withoutShadows, printsRate;

/* A number from 0 to 1 that belongs to the fish and to what it is asked for. */
static double chance(unsigned fish, unsigned what) {
    unsigned x = fish * 2654435761u + what * 40503u + 12345u;
    x = (x ^ (x >> 15)) * 2246822519u;
    x = (x ^ (x >> 13)) * 3266489917u;
    return (double)(x ^ (x >> 16)) / 4294967296.0;
}

/* How far the body is bent aside, from the head (0) to the tail (1). */
static double bend(double along, double beat) {
    return 0.16 * along * along * sin(kTwoPi * (beat - 0.55 * along));
}

static void bodyVertex(int ring, int side, double beat) {
    const double along = (double)ring / (kRings - 1), angle = kTwoPi * side / kSides;
    const double thick = 0.21 * pow(sin(3.05 * along + 0.05), 0.8) * (1 - 0.35 * along);
    const double x = 0.5 - along, y = cos(angle), z = sin(angle);
    rtNormal3d(0.35 * (0.45 - along), y, 1.8 * z);
    rtVertex3d(x, thick * y, 0.55 * thick * z + bend(along, beat));
}

static void fin(double beat, double x0, double x1, double y0, double y1, double x2, double y2) {
    rtBegin(RT_TRIANGLES);
    rtNormal3f(0, 0, 1);
    rtVertex3d(x0, y0, bend(0.5 - x0, beat));
    rtVertex3d(x1, y1, bend(0.5 - x1, beat));
    rtVertex3d(x2, y2, bend(0.5 - x2, beat));
    rtEnd();
}

static RTuint makeFish(double beat) {
    const RTuint object = rtNewObject(RT_DEFINE);
    int ring, side;
    for (ring = 0; ring + 1 < kRings; ++ring) {
        rtBegin(RT_QUAD_STRIP);
        for (side = 0; side <= kSides; ++side) {
            bodyVertex(ring, side, beat);
            bodyVertex(ring + 1, side, beat);
        }
        rtEnd();
    }
    fin(beat, -0.46, -0.78, 0, 0.24, -0.62, 0);
    fin(beat, -0.46, -0.78, 0, -0.24, -0.62, 0);
    fin(beat, 0.15, -0.16, 0.17, 0.3, -0.18, 0.13);
    rtEndObject();
    return object;
}

static double dune(double x, double z) {
    return -6.2 + 0.5 * sin(0.31 * x + 0.8 * sin(0.17 * z)) + 0.35 * sin(0.43 * z - 0.3 * x);
}

static RTuint makeGround(void) {
    enum { kCells = 96 };
    const double cell = 1.25, half = 0.5 * cell * kCells;
    const RTuint object = rtNewObject(RT_DEFINE);
    int i, k, row;
    for (i = 0; i < kCells; ++i) {
        rtBegin(RT_QUAD_STRIP);
        for (k = 0; k <= kCells; ++k) {
            for (row = 0; row < 2; ++row) {
                const double x = cell * (i + row) - half, z = cell * k - half, h = 0.1;
                rtNormal3d(dune(x - h, z) - dune(x + h, z), 2 * h, dune(x, z - h) - dune(x, z + h));
                rtVertex3d(x, dune(x, z), z);
            }
        }
        rtEnd();
    }
    rtEndObject();
    return object;
}

/* Where a fish is: on its own way round a ring that turns and breathes. */
static void place(unsigned fish, double time, double *p) {
    const double around = kTwoPi * chance(fish, 0) + (0.22 + 0.1 * chance(fish, 1)) * time;
    const double tube = kTwoPi * chance(fish, 2) + (0.5 - 0.2 * chance(fish, 3)) * time;
    const double wide = 3.1 * sqrt(chance(fish, 4)) * (1 + 0.25 * sin(3 * around - 0.6 * time));
    const double radius = 6.5 + wide * cos(tube);
    p[0] = radius * cos(around);
    p[1] = 0.9 * wide * sin(tube) + 1.3 * sin(2 * around + 0.4 * time);
    p[2] = radius * sin(around);
}

/* The matrix of a fish that swims to where it will be next. */
static void instantiateFish(unsigned fish, double time) {
    const double size = 0.75 * (0.6 + 0.6 * chance(fish, 5)) * pow(4000.0 / (double)fishCount, 0.3);
    const double warm = chance(fish, 6) < 0.12 ? 1 : 0, beat = 2.5 * time + chance(fish, 7);
    double p[3], q[3], ahead[3], aside[2], length, across;
    RTfloat m[16] = {0};
    int k;
    place(fish, time, p);
    place(fish, time + 0.02, q);
    for (k = 0; k < 3; ++k) ahead[k] = q[k] - p[k];
    across = sqrt(ahead[0] * ahead[0] + ahead[2] * ahead[2]) + 1e-9;
    length = sqrt(across * across + ahead[1] * ahead[1]);
    aside[0] = -ahead[2] / across;
    aside[1] = ahead[0] / across;
    for (k = 0; k < 3; ++k) m[k] = (RTfloat)(size * ahead[k] / length);
    m[4] = (RTfloat)(-size * ahead[1] / length * ahead[0] / across); /* up */
    m[5] = (RTfloat)(size * across / length);
    m[6] = (RTfloat)(-size * ahead[1] / length * ahead[2] / across);
    m[8] = (RTfloat)(size * aside[0]);
    m[10] = (RTfloat)(size * aside[1]);
    for (k = 0; k < 3; ++k) m[12 + k] = (RTfloat)p[k];
    m[15] = 1;
    rtColor3d(0.45 + 0.5 * warm, 0.62 - 0.25 * warm + 0.2 * chance(fish, 8),
              0.78 - 0.65 * warm + 0.1 * chance(fish, 9));
    rtPushMatrix();
    rtMultMatrixf(m);
    rtInstantiateObject(poses[(unsigned)((beat - floor(beat)) * kPoses) % kPoses]);
    rtPopMatrix();
}

static void display(void) {
    static const RTfloat sun[] = {6, 30, 4, 1};
    const double time = 1e-3 * rtutGet(RTUT_ELAPSED_TIME);
    unsigned fish;
    frameBegins();
    rtClear(RT_COLOR_BUFFER_BIT | RT_DEPTH_BUFFER_BIT);
    rtLoadIdentity();
    rtLookAt(17 * cos(0.05 * time), 3.5, 17 * sin(0.05 * time), 0, -0.8, 0, 0, 1, 0);
    rtLightfv(RT_LIGHT0, RT_POSITION, sun);
    rtColor3f(0.95f, 0.86f, 0.62f);
    rtInstantiateObject(ground);
    for (fish = 0; fish < (unsigned)fishCount; ++fish) instantiateFish(fish, time);
    frameIsDescribed();
    rtutSwapBuffers();
}

static void reshape(int width, int height) {
    rtViewport(0, 0, (RTsizei)width, (RTsizei)height);
    rtMatrixMode(RT_PROJECTION);
    rtLoadIdentity();
    rtPerspective(45, (RTdouble)width / height, 0.5, 200);
    rtMatrixMode(RT_MODELVIEW);
}

int main(int argc, char **argv) {
    static const RTfloat water[] = {0.05f, 0.23f, 0.34f, 1}, light[] = {1, 1, 0.92f, 1},
                         dim[] = {0.22f, 0.32f, 0.38f, 1}, shine[] = {0.5f, 0.5f, 0.5f, 1};
    const Option options[] = {{"--instances", &fishCount, 1, kMaxFish, 0},
                              {"--no-shadows", &withoutShadows, 0, 1, 1},
                              {"--fps", &printsRate, 0, 1, 1}};
    int i;
    rtutInitWindowSize(800, 600);
    rtutInit(&argc, argv);
    readOptions(argc, argv, options, 3);
    rtutInitDisplayMode(RTUT_RGB | RTUT_DEPTH | RTUT_DOUBLE);
    rtutCreateWindow("shoal");
    if (printsRate) countFrames("shoal");
    rtClearColor(water[0], water[1], water[2], 1);
    rtEnable(RT_DEPTH_TEST);
    rtEnable(RT_LIGHTING);
    rtEnable(RT_LIGHT0);
    rtEnable(RT_COLOR_MATERIAL);
    rtEnable(RT_NORMALIZE);
    if (!withoutShadows) rtEnable(RT_SHADOWS);
    rtLightfv(RT_LIGHT0, RT_DIFFUSE, light);
    rtLightModelfv(RT_LIGHT_MODEL_AMBIENT, dim);
    rtMaterialfv(RT_FRONT_AND_BACK, RT_SPECULAR, shine);
    rtMaterialf(RT_FRONT_AND_BACK, RT_SHININESS, 24);
    rtEnable(RT_FOG);
    rtFogi(RT_FOG_MODE, RT_EXP2);
    rtFogf(RT_FOG_DENSITY, 0.026f);
    rtFogfv(RT_FOG_COLOR, water);
    for (i = 0; i < kPoses; ++i) poses[i] = makeFish((double)i / kPoses);
    ground = makeGround();
    rtutDisplayFunc(display);
    rtutReshapeFunc(reshape);
    rtutIdleFunc(rtutPostRedisplay);
    rtutMainLoop();
    return 0;
}

/* SPDX-License-Identifier: MIT */
/* What rays hit does not depend on what was tested before, nor on the scene's scale: powers of two
 * change nothing but the exponents of distances. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

enum { RAYS = 256, ROWS = 12, COLUMNS = 24, COPIES = 20 };

static float uniform(void) {
    return (float)rand() / (float)RAND_MAX;
}

static void triangle(const float *a, const float *b, const float *c) {
    rtVertex3fv(a);
    rtVertex3fv(b);
    rtVertex3fv(c);
}

static void spherePoint(int row, int column, float scale, float *point) {
    const double pi = 3.14159265358979;
    const double polar = pi * row / ROWS, around = 2 * pi * (column % COLUMNS) / COLUMNS;
    point[0] = scale * (float)(sin(polar) * cos(around));
    point[1] = scale * (float)(sin(polar) * sin(around));
    point[2] = scale * (float)cos(polar);
}

static RTuint sphere(float scale) {
    int row, column;
    rtNewObject(RT_DEFINE_AND_INSTANTIATE);
    rtBegin(RT_TRIANGLES);
    for (row = 0; row < ROWS; ++row)
        for (column = 0; column < COLUMNS; ++column) {
            float a[3], b[3], c[3], d[3];
            spherePoint(row, column, scale, a);
            spherePoint(row, column + 1, scale, b);
            spherePoint(row + 1, column, scale, c);
            spherePoint(row + 1, column + 1, scale, d);
            if (row > 0) triangle(a, b, d);
            if (row + 1 < ROWS) triangle(a, d, c);
        }
    rtEnd();
    rtEndObject();
    return rtCompileScene();
}

static void shootAt(float scale, RTray *rays, RThit *hits, RTenum coherence) {
    const RTuint scene = sphere(scale);
    RTubyte blocked[RAYS];
    int i, k;
    srand(1);
    for (i = 0; i < RAYS; ++i) {
        const float height = 2 * uniform() - 1, around = 6.28f * uniform();
        const float from[3] = {2 * sqrtf(1 - height * height) * cosf(around),
                               2 * sqrtf(1 - height * height) * sinf(around), 2 * height};
        for (k = 0; k < 3; ++k) {
            rays[i].origin[k] = scale * from[k];
            rays[i].direction[k] = scale * (uniform() - 0.5f - from[k]);
        }
        rays[i].tnear = 0;
        rays[i].tfar = INFINITY;
    }
    rtIntersect(scene, rays, hits, RAYS, coherence);
    for (i = 0; i < RAYS; ++i) rays[i].tfar = hits[i].t * 1.0001f;
    rtOccluded(scene, rays, blocked, RAYS, coherence);
    for (i = 0; i < RAYS; ++i) CHECK(blocked[i] == 1);
    for (i = 0; i < RAYS; ++i) rays[i].tfar = hits[i].t * 0.9999f;
    rtOccluded(scene, rays, blocked, RAYS, coherence);
    for (i = 0; i < RAYS; ++i) CHECK(blocked[i] == 0);
    rtReleaseScene(scene);
}

static void testScales(void) {
    static RTray rays[RAYS];
    static RThit usual[RAYS], scaled[RAYS];
    int exponent, i;
    shootAt(1, rays, usual, RT_INCOHERENT);
    for (exponent = -34; exponent >= -60; --exponent) {
        const RTenum coherence = exponent % 2 ? RT_COHERENT : RT_INCOHERENT;
        rtInit(NULL, NULL);
        shootAt(ldexpf(1, exponent), rays, scaled, coherence);
        for (i = 0; i < RAYS; ++i)
            CHECK(scaled[i].primitive == usual[i].primitive && scaled[i].t == usual[i].t &&
                  scaled[i].u == usual[i].u && scaled[i].v == usual[i].v);
    }
}

/* Many triangles in one place, so that layers have leaves of their own. */
static void layer(float z) {
    const float a[3] = {-4, -4, z}, b[3] = {12, -4, z}, c[3] = {-4, 12, z};
    int i;
    for (i = 0; i < COPIES; ++i) triangle(a, b, c);
}

/* Layers at 1 and 1 - 2^-18, and in another instance one between: too close for a float comparison
 * of their distances, in whatever order they are met. */
static void testLayers(void) {
    const float step = ldexpf(1, -19);
    static RTray rays[RAYS];
    static RThit hits[RAYS];
    int first, i;
    for (i = 0; i < RAYS; ++i) {
        const int up = i % 2;
        const RTray ray = {{0.01f * uniform(), 0.01f * uniform(), up ? 0.75f : 1.25f},
                           0,
                           {uniform() - 0.5f, uniform() - 0.5f, up ? 1.0f : -1.0f},
                           INFINITY};
        rays[i] = ray;
    }
    for (first = 0; first < 2; ++first) {
        RTuint two, one, scene;
        rtInit(NULL, NULL);
        two = rtNewObject(RT_DEFINE);
        rtBegin(RT_TRIANGLES);
        layer(1);
        layer(1 - 2 * step);
        rtEnd();
        rtEndObject();
        one = rtNewObject(RT_DEFINE);
        rtBegin(RT_TRIANGLES);
        layer(1 - step);
        rtEnd();
        rtEndObject();
        rtInstantiateObject(first ? one : two);
        rtInstantiateObject(first ? two : one);
        scene = rtCompileScene();
        rtIntersect(scene, rays, hits, RAYS, RT_INCOHERENT);
        for (i = 0; i < RAYS; ++i)
            CHECK(hits[i].object == two && hits[i].primitive == (i % 2 ? COPIES : 0));
        rtReleaseScene(scene);
    }
}

/* A triangle and its back, whose planes double rounds differently, and a ray along them that may
 * begin and end at 1 only: which of the two it hits does not depend on which is the first. */
static void testLimits(void) {
    static const float corners[3][3] = {{-0x1.25f1bp-2f, -0x1.dd9d54p-1f, -0x1.f28a3ap-1f},
                                        {0x1.5f4448p-1f, -0x1.3586e4p-1f, 0x1.3610ccp-4f},
                                        {-0x1.004758p-3f, 0x1.a9c92p-3f, -0x1.e886c4p-5f}};
    const RTray ray = {{-0x1.25f1bp-2f, 0x1.0898acp+1f, 0x1.035d72p+1f}, 1, {0, -3, -3}, 1};
    RTuint front[2];
    int first;
    for (first = 0; first < 2; ++first) {
        RTuint scene;
        RThit hit;
        rtInit(NULL, NULL);
        rtNewObject(RT_DEFINE_AND_INSTANTIATE);
        rtBegin(RT_TRIANGLES);
        triangle(corners[first], corners[1 - first], corners[2]);
        triangle(corners[1 - first], corners[first], corners[2]);
        rtEnd();
        rtEndObject();
        scene = rtCompileScene();
        rtIntersect(scene, &ray, &hit, 1, RT_INCOHERENT);
        CHECK(hit.primitive < 2);
        front[first] = hit.primitive ^ (RTuint)first;
        rtReleaseScene(scene);
    }
    CHECK(front[0] == front[1]);
}

int main(void) {
    rtInit(NULL, NULL);
    testScales();
    testLayers();
    testLimits();
    CHECK_ERROR(RT_NO_ERROR);
    rtExit();
    return failureCount != 0;
}

/* SPDX-License-Identifier: MIT */
/* Rays from the application: values of hits and misses, limits, ties, streams, handles. */
#include <fenv.h>
#include <pthread.h>

#include "check.h"
#include "picture.h"

static RTuint scene;

static RThit shoot(RTray ray) {
    RThit hit;
    RTubyte blocked = 7;
    memset(&hit, 0x55, sizeof hit);
    rtIntersect(scene, &ray, &hit, 1, RT_INCOHERENT);
    rtOccluded(scene, &ray, &blocked, 1, RT_INCOHERENT);
    CHECK(blocked == (hit.primitive != RT_INVALID));
    return hit;
}

static RTray towards(float x, float y) {
    const RTray ray = {{x, y, 5}, 0, {0, 0, -2}, 100};
    return ray;
}

static int isMiss(RThit hit, float tfar) {
    return (hit.t == tfar || (isnan(hit.t) && isnan(tfar))) && hit.u == 0 && hit.v == 0 &&
           hit.primitive == RT_INVALID && hit.object == RT_INVALID &&
           hit.instance == RT_INVALID && hit.normal[0] == 0 && hit.normal[1] == 0 &&
           hit.normal[2] == 0 && hit.flags == 0;
}

static void *shootElsewhere(void *result) {
    const RTray ray = towards(0.25f, 0.25f);
    rtIntersect(scene, &ray, result, 1, RT_COHERENT);
    return NULL;
}

int main(void) {
    RTuint object, nested;
    RTray ray;
    RThit hit;
    startPicture();
    object = rtNewObject(RT_DEFINE);
    rtBegin(RT_TRIANGLES);
    rtVertex3f(0, 0, 0);
    rtVertex3f(1, 0, 0);
    rtVertex3f(0, 1, 0);
    rtEnd();
    rtEndObject();
    nested = rtNewObject(RT_DEFINE);
    rtInstantiateObject(object);
    rtEndObject();
    rtInstantiateObject(object);
    rtTranslatef(2, 0, 0);
    rtScalef(-1, 2, 1);
    rtInstantiateObject(nested);
    rtLoadIdentity();
    rtInstantiateObject(object); /* a tie with the first */
    scene = rtCompileScene();
    CHECK(scene != RT_INVALID && scene != 0);

    /* A hit: distance in units of the direction, weights, normal, side. */
    hit = shoot(towards(0.25f, 0.5f));
    CHECK(hit.t == 2.5f && hit.u == 0.25f && hit.v == 0.5f);
    CHECK(hit.primitive == 0 && hit.object == object && hit.instance == 0);
    CHECK(hit.normal[0] == 0 && hit.normal[1] == 0 && hit.normal[2] == 1 && hit.flags == 0);
    ray = towards(0.25f, 0.5f);
    ray.origin[2] = -5;
    ray.direction[2] = 1;
    hit = shoot(ray);
    CHECK(hit.t == 5 && hit.flags == RT_HIT_BACK);

    /* Nested: the innermost object, the outermost instance; the normal of the mirrored triangle. */
    hit = shoot(towards(1.75f, 0.5f));
    CHECK(hit.object == object && hit.instance == 1);
    CHECK(hit.normal[2] == -2 && hit.flags == RT_HIT_BACK);

    /* Misses. */
    CHECK(isMiss(shoot(towards(-1, -1)), 100));
    ray = towards(0.25f, 0.25f);
    ray.tfar = INFINITY;
    CHECK(shoot(ray).t == 2.5f);
    ray.origin[0] = 50;
    CHECK(isMiss(shoot(ray), INFINITY));

    /* Limits: closed, below 0 counts as 0, NaN or reversed misses. */
    ray = towards(0.25f, 0.25f);
    ray.tnear = 2.5f;
    ray.tfar = 2.5f;
    CHECK(shoot(ray).t == 2.5f);
    ray.tnear = 2.6f;
    ray.tfar = 100;
    CHECK(isMiss(shoot(ray), 100));
    ray.tnear = 0;
    ray.tfar = 2.4f;
    CHECK(isMiss(shoot(ray), 2.4f));
    ray.tnear = -10;
    ray.tfar = 100;
    CHECK(shoot(ray).t == 2.5f);
    ray.origin[2] = -5; /* the triangle lies behind */
    CHECK(isMiss(shoot(ray), 100));
    ray = towards(0.25f, 0.25f);
    ray.tnear = NAN;
    CHECK(isMiss(shoot(ray), 100));
    ray.tnear = 0;
    ray.tfar = NAN;
    CHECK(isMiss(shoot(ray), NAN));
    ray.tnear = 50;
    ray.tfar = 40;
    CHECK(isMiss(shoot(ray), 40));
    ray = towards(NAN, 0.25f);
    CHECK(isMiss(shoot(ray), 100));
    ray = towards(0.25f, 0.25f);
    ray.direction[1] = INFINITY;
    CHECK(isMiss(shoot(ray), 100));
    memset(ray.direction, 0, sizeof ray.direction);
    ray.direction[1] = 0;
    CHECK(isMiss(shoot(ray), 100));

    /* Streams equal single rays, whatever the coherence and outputs. */
    {
        enum { N = 100 };
        static float ox[N], oy[N], oz[N], dx[N], dy[N], dz[N], far[N], t[N], u[N], nz[N];
        static RTuint primitive[N];
        static RTubyte blocked[N];
        RTraystream rays;
        RThitstream hits;
        int i, c;
        memset(&rays, 0, sizeof rays);
        memset(&hits, 0, sizeof hits);
        for (i = 0; i < N; ++i) {
            ox[i] = (float)(i % 10) / 5 - 0.5f;
            oy[i] = (float)(i / 10) / 5 - 0.5f;
            oz[i] = 5;
            dz[i] = -1;
            far[i] = 50;
        }
        rays.ox = ox, rays.oy = oy, rays.oz = oz;
        rays.dx = dx, rays.dy = dy, rays.dz = dz;
        hits.t = t, hits.u = u, hits.nz = nz, hits.primitive = primitive;
        for (c = 0; c < 2; ++c) {
            const RTenum coherence = c ? RT_COHERENT : RT_INCOHERENT;
            int wrong = 0;
            memset(t, 0x55, sizeof t);
            rays.tfar = c ? far : NULL;
            rtIntersectStream(scene, &rays, &hits, N, coherence);
            rtOccludedStream(scene, &rays, blocked, N, coherence);
            for (i = 0; i < N; ++i) {
                const RTray single = {{ox[i], oy[i], oz[i]}, 0, {0, 0, -1}, c ? 50 : INFINITY};
                hit = shoot(single);
                wrong += t[i] != hit.t || u[i] != hit.u || nz[i] != hit.normal[2] ||
                         primitive[i] != hit.primitive ||
                         blocked[i] != (hit.primitive != RT_INVALID);
            }
            CHECK(wrong == 0);
        }
        /* One origin for all. */
        rays.flags = RT_COMMON_ORIGIN;
        rays.tfar = NULL;
        for (i = 0; i < N; ++i) dx[i] = (float)i / N;
        ox[0] = 0.1f, oy[0] = 0.2f;
        rtIntersectStream(scene, &rays, &hits, N, RT_COHERENT);
        {
            int wrong = 0;
            for (i = 0; i < N; ++i) {
                const RTray single = {{0.1f, 0.2f, 5}, 0, {dx[i], 0, -1}, INFINITY};
                hit = shoot(single);
                wrong += t[i] != hit.t || primitive[i] != hit.primitive;
            }
            CHECK(wrong == 0);
        }
        CHECK_ERROR(RT_NO_ERROR);

        /* Wrong calls touch no output. */
        t[0] = 4711;
        rays.flags = 2;
        rtIntersectStream(scene, &rays, &hits, N, RT_COHERENT);
        CHECK_ERROR(RT_INVALID_VALUE);
        rays.flags = 0;
        rays.dy = NULL;
        rtIntersectStream(scene, &rays, &hits, N, RT_COHERENT);
        CHECK_ERROR(RT_INVALID_VALUE);
        rays.dy = dy;
        rtIntersectStream(scene, &rays, NULL, N, RT_COHERENT);
        CHECK_ERROR(RT_INVALID_VALUE);
        rtIntersectStream(scene, &rays, &hits, -1, RT_COHERENT);
        CHECK_ERROR(RT_INVALID_VALUE);
        rtIntersectStream(scene, &rays, &hits, N, RT_TRIANGLES);
        CHECK_ERROR(RT_INVALID_ENUM);
        rtIntersectStream(scene + 1000, &rays, &hits, N, RT_COHERENT);
        CHECK_ERROR(RT_INVALID_VALUE);
        rtIntersectStream(0, &rays, &hits, N, RT_COHERENT);
        CHECK_ERROR(RT_INVALID_VALUE);
        CHECK(t[0] == 4711);
        rtIntersect(scene, NULL, NULL, 0, RT_COHERENT);
        CHECK_ERROR(RT_NO_ERROR);
        rtOccluded(scene, NULL, blocked, 1, RT_COHERENT);
        CHECK_ERROR(RT_INVALID_VALUE);
    }

    /* The scene stays open: what comes later is in later handles only. Handles differ. */
    {
        RTuint later;
        const RTray up = {{-0.5f, -0.5f, 5}, 0, {0, 0, -1}, 100};
        square(-1, -1, 0, 0, 0);
        later = rtCompileScene();
        CHECK(later > scene);
        CHECK(isMiss(shoot(up), 100));
        rtIntersect(later, &up, &hit, 1, RT_COHERENT);
        CHECK(hit.t == 5 && hit.object == 0 && hit.instance == 3);
        rtReleaseScene(later);
        rtReleaseScene(later);
        CHECK_ERROR(RT_INVALID_VALUE);
    }

    /* Any thread, no context; the caller's rounding mode stays and has no effect. */
    {
        pthread_t thread;
        RThit elsewhere;
        const RThit here = shoot(towards(0.25f, 0.25f));
        memset(&elsewhere, 0, sizeof elsewhere);
        pthread_create(&thread, NULL, shootElsewhere, &elsewhere);
        pthread_join(thread, NULL);
        CHECK(elsewhere.t == here.t && elsewhere.object == here.object);
        fesetround(FE_UPWARD);
        ray = towards(0.3f, 0.3f);
        ray.direction[0] = 0.01f;
        {
            const RThit up = shoot(ray);
            CHECK(fegetround() == FE_UPWARD);
            fesetround(FE_TONEAREST);
            hit = shoot(ray);
            CHECK(memcmp(&up, &hit, sizeof hit) == 0);
        }
    }

    /* An empty scene. */
    rtRender();
    scene = rtCompileScene();
    CHECK(isMiss(shoot(towards(0.25f, 0.25f)), 100));
    rtExit();
    hit.t = -1;
    ray = towards(0.25f, 0.25f);
    rtIntersect(scene, &ray, &hit, 1, RT_COHERENT);
    CHECK(hit.t == -1); /* rtExit frees compiled scenes */
    return failureCount;
}

/* SPDX-License-Identifier: MIT */
#include "misuse.h"

#include <stdio.h>
#include <string.h>

enum { kSize = 16, kRays = 64, kNames = 40 };

Ids ids;
RTubyte framePixels[kSize * kSize * 4];

typedef struct Observed {
    double state[kNames][16];
    double objectShaders[8];
    RThit hits[kRays];
    RTubyte picture[kSize * kSize * 4];
} Observed;

static const RTenum names[kNames] = {
    RT_CURRENT_COLOR, RT_CURRENT_NORMAL, RT_CURRENT_TEXTURE_COORDS, RT_COLOR_CLEAR_VALUE,
    RT_VIEWPORT, RT_MODELVIEW_MATRIX, RT_PROJECTION_MATRIX, RT_TEXTURE_MATRIX, RT_MATRIX_MODE,
    RT_MODELVIEW_STACK_DEPTH, RT_PROJECTION_STACK_DEPTH, RT_TEXTURE_STACK_DEPTH,
    RT_TEXTURE_BINDING_2D, RT_SHADER_BINDING, RT_SHADER_CLASS_BINDING, RT_UNPACK_ALIGNMENT,
    RT_UNPACK_ROW_LENGTH, RT_UNPACK_SKIP_PIXELS, RT_UNPACK_SKIP_ROWS, RT_UNPACK_SWAP_BYTES,
    RT_SAMPLES, RT_PRECISION_HINT, RT_BUILD_QUALITY, RT_LAZY_BUILD, RT_FRAMEBUFFER_SRGB,
    RT_MULTISAMPLE, RT_STAT_TRIANGLES, RT_STAT_INSTANCES, RT_STAT_NODES, RT_STAT_LEAVES,
    RT_STAT_REFERENCES, RT_STAT_DROPPED_TRIANGLES, RT_STAT_DROPPED_INSTANCES,
    RT_STAT_MODELS_BUILT, RT_STAT_RAYS, RT_STAT_PRIMARY_RAYS, RT_STAT_SHADOW_RAYS,
    RT_STAT_SECONDARY_RAYS, RT_STAT_BAD_PIXELS, RT_STAT_BYTES};

static void triangle(float x, float y, float z) {
    rtVertex3f(x, y, z);
    rtVertex3f(x + 1, y, z);
    rtVertex3f(x, y + 1, z);
}

static void makeThings(void) {
    static const RTubyte texels[16] = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 9, 9, 9, 9};
    memset(&ids, 0, sizeof ids);
    rtGenNewShaderClass("SpotLightShader", NULL);
    ids.light = rtGenNewShader();
    ids.lightHandle = rtParameterHandle("position");
    /* Without a projection the view is along z. */
    rtParameter3f(ids.lightHandle, 0.25f, 0.25f, -3);
    rtParameter3f(rtParameterHandle("radiance"), 9, 9, 9);
    rtGenNewShaderClass("PinholeCameraShader", NULL);
    ids.camera = rtGenNewShader();
    rtGenNewShaderClass("ConstantEnvironment", NULL);
    ids.environment = rtGenNewShader();
    ids.surfaceClass = rtGenNewShaderClass("DiffuseShader", NULL);
    ids.surface = rtGenNewShader();
    ids.colorHandle = rtParameterHandle("color");
    rtParameter3f(ids.colorHandle, 0.5f, 0.75f, 0.25f);
    rtGenTextures(1, &ids.texture);
    rtBindTexture(RT_TEXTURE_2D, ids.texture);
    rtTexImage2D(RT_TEXTURE_2D, 0, RT_RGBA, 2, 2, 0, RT_RGBA, RT_UNSIGNED_BYTE, texels);
    ids.object = rtNewObject(RT_DEFINE);
    rtBegin(RT_TRIANGLES);
    triangle(-1, -1, 0);
    rtEnd();
    rtEndObject();
}

static RTuint (*pendingCall)(void);
static Place pendingPlace;
static RTuint pendingResult;

static void at(Place place) {
    if (pendingCall && pendingPlace == place) pendingResult = pendingCall();
}

static void describeFrame(void) {
    rtUseLight(ids.light);
    rtColor3f(0.25f, 0.5f, 1.0f);
    rtBindShader(0);
    at(OUTSIDE);
    rtBegin(RT_TRIANGLES);
    rtVertex3f(0, 0, 0.5f);
    rtVertex3f(1, 0, 0.5f);
    at(IN_PRIMITIVE);
    rtVertex3f(0, 1, 0.5f);
    rtEnd();

    rtPushMatrix();
    rtTranslatef(0.25f, -0.5f, 0);
    ids.openObject = rtNewObject(RT_DEFINE);
    rtBindShader(ids.surface);
    rtBegin(RT_QUADS);
    rtVertex3f(0, 0, 0);
    rtVertex3f(1, 0, 0);
    rtVertex3f(1, 1, 0);
    rtVertex3f(0, 1, 0);
    rtEnd();
    rtTranslatef(0.25f, 0, 0);
    at(IN_OBJECT);
    rtBegin(RT_TRIANGLES);
    triangle(0, 0, 0.25f);
    rtEnd();
    rtEndObject();
    rtInstantiateObject(ids.openObject);
    rtPopMatrix();
    rtInstantiateObject(ids.object);
}

static void observe(Observed *seen) {
    RTray rays[kRays];
    RTuint scene;
    RTint shaders[8] = {0};
    int i;
    for (i = 0; i < kNames; ++i) rtGetDoublev(names[i], seen->state[i]);
    rtGetObjectiv(ids.openObject, RT_OBJECT_SHADER_COUNT, shaders);
    rtGetObjectiv(ids.openObject, RT_OBJECT_SHADERS, shaders + 1);
    for (i = 0; i < 8; ++i) seen->objectShaders[i] = shaders[i];
    scene = rtCompileScene();
    memset(rays, 0, sizeof rays);
    for (i = 0; i < kRays; ++i) {
        rays[i].origin[0] = -1 + (float)(i % 8) / 4 + 0.1f;
        rays[i].origin[1] = -1 + (float)(i / 8) / 4 + 0.1f;
        rays[i].origin[2] = 5;
        rays[i].direction[2] = -1;
        rays[i].tfar = 100;
    }
    rtIntersect(scene, rays, seen->hits, kRays, RT_INCOHERENT);
    rtReleaseScene(scene);
}

/* The whole program, with one call at one place; the error that is recorded in the end. */
static RTenum run(RTuint (*call)(void), Place place, Observed *seen) {
    RTenum error;
    memset(seen, 0, sizeof *seen);
    memset(framePixels, 0, sizeof framePixels);
    pendingCall = call;
    pendingPlace = place;
    pendingResult = 0;
    rtInit(NULL, NULL);
    rtThreads(1);
    rtSetFrameBuffer(framePixels, kSize, kSize, RT_RGBA_8);
    makeThings();
    describeFrame();
    observe(seen);
    rtStartRendering();
    at(IN_FLIGHT);
    error = rtGetError();
    rtEndRendering();
    if (error == RT_NO_ERROR) error = rtGetError();
    memcpy(seen->picture, framePixels, sizeof framePixels);
    return error;
}

/* Controls: legal calls with an effect, which the comparison has to see. */
static RTuint otherColor(void) {
    rtColor3f(1, 0, 0);
    return 0;
}
static RTuint otherMatrix(void) {
    rtScalef(0.5f, 1, 1);
    return 0;
}
static RTuint otherShader(void) {
    rtBindShader(ids.surface);
    return 0;
}
static RTuint otherParameter(void) {
    rtBindShader(ids.surface);
    rtParameter3f(ids.colorHandle, 0, 0, 0);
    rtBindShader(0);
    return 0;
}
static RTuint anotherInstance(void) {
    rtInstantiateObject(ids.object);
    return 0;
}
static RTuint anotherVertex(void) {
    rtVertex3f(0.5f, 0.5f, 0);
    return 0;
}
static RTuint otherHint(void) {
    rtObjectHint(RT_BUILD_QUALITY, RT_NICEST);
    return 0;
}

int checkMisuses(const Misuse *misuses, int count) {
    static const Misuse controls[] = {
        MISUSE(otherColor, OUTSIDE, RT_NO_ERROR),      MISUSE(otherColor, IN_PRIMITIVE, RT_NO_ERROR),
        MISUSE(otherMatrix, OUTSIDE, RT_NO_ERROR),     MISUSE(otherMatrix, IN_OBJECT, RT_NO_ERROR),
        MISUSE(otherShader, OUTSIDE, RT_NO_ERROR),     MISUSE(otherParameter, OUTSIDE, RT_NO_ERROR),
        MISUSE(anotherInstance, OUTSIDE, RT_NO_ERROR), MISUSE(anotherInstance, IN_OBJECT, RT_NO_ERROR),
        MISUSE(anotherVertex, IN_PRIMITIVE, RT_NO_ERROR), MISUSE(otherHint, OUTSIDE, RT_NO_ERROR)};
    static Observed reference, seen;
    int i, failures = 0;
    if (run(NULL, OUTSIDE, &reference) != RT_NO_ERROR) {
        fprintf(stderr, "the program itself is wrong: %s\n", rtGetErrorText());
        return 1;
    }
    for (i = 0; i < (int)(sizeof controls / sizeof controls[0]); ++i) {
        if (run(controls[i].call, controls[i].place, &seen) != RT_NO_ERROR ||
            memcmp(&seen, &reference, sizeof seen) == 0) {
            fprintf(stderr, "control %s at %d is not seen\n", controls[i].name,
                    (int)controls[i].place);
            ++failures;
        }
    }
    for (i = 0; i < count; ++i) {
        const Misuse *m = &misuses[i];
        const RTenum error = run(m->call, m->place, &seen);
        if (error != m->error || pendingResult != m->result) {
            fprintf(stderr, "%s at %d: error 0x%X (%s), expected 0x%X; result %u, expected %u\n",
                    m->name, (int)m->place, error, rtGetErrorText(), m->error, pendingResult,
                    m->result);
            ++failures;
        }
        if (memcmp(&seen, &reference, sizeof seen) != 0) {
            fprintf(stderr, "%s at %d: something changed\n", m->name, (int)m->place);
            ++failures;
        }
    }
    rtExit();
    return failures;
}

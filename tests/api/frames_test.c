/* SPDX-License-Identifier: MIT */
/* Frames: freezing, running beside the application, formats, auxiliary buffers, settings. */
#include <pthread.h>
#include <stdlib.h>
#include <time.h>

#include "check.h"
#include "openrt/rts.h"
#include "picture.h"

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* A surface that does not come back before it is let go, for ten seconds at most. */
static int letGo, gaveUp;
static int construct(void *shader, void *triangle, void *vertex) {
    (void)shader, (void)triangle, (void)vertex;
    return 0;
}
static int waitAndShade(const void *shader, RTSstate *state) {
    const double start = now();
    (void)shader;
    while (!__atomic_load_n(&letGo, __ATOMIC_ACQUIRE)) {
        if (now() - start > 10) {
            __atomic_store_n(&gaveUp, 1, __ATOMIC_RELEASE);
            break;
        }
    }
    rtsResultColor(state, 0.5f, 0.25f, 0.125f);
    return 0;
}

static RTuint waitingShader(void) {
    RTshaderclass waiting = {0};
    waiting.structSize = sizeof waiting;
    waiting.interfaceVersion = RTS_INTERFACE_VERSION;
    waiting.kind = RT_SURFACE_SHADER;
    waiting.name = "Waiting";
    waiting.alignment = 1;
    waiting.construct = construct;
    waiting.shade = waitAndShade;
    CHECK(rtRegisterShaderClass(&waiting) != RT_INVALID);
    return rtGenNewShader();
}

static float progress(void) {
    RTfloat value = -1;
    rtGetFloatv(RT_FRAME_PROGRESS, &value);
    return value;
}

/* rtStartRendering returns while the frame is being traced; what the application does meanwhile
 * belongs to the next frame. */
static void asynchronous(void) {
    static float second[PICTURE_SIZE][PICTURE_SIZE][4];
    RTuint object, shader;
    startPicture();
    shader = waitingShader();
    CHECK(shader != RT_INVALID);
    object = rtNewObject(RT_DEFINE);
    square(-1, -1, 1, 1, 0);
    rtEndObject();
    rtInstantiateObject(object);
    letGo = gaveUp = 0;
    rtStartRendering();
    CHECK(progress() < 1); /* returned, and no tile can be done */
    rtStartRendering();
    CHECK_ERROR(RT_INVALID_OPERATION);

    rtReplaceObject(object); /* the frame keeps all it was started with */
    rtEndObject();
    rtRemoveObject(object);
    rtRemoveShader(shader);
    rtSetFrameBuffer((RTubyte *)second, PICTURE_SIZE, PICTURE_SIZE, RT_RGBA_32F);
    rtClearColor(1, 0, 0, 1);
    rtViewport(0, 0, 1, 1);
    rtMatrixMode(RT_PROJECTION);
    rtLoadIdentity();
    rtMatrixMode(RT_MODELVIEW);
    rtColor3f(0, 1, 0);
    rtBindShader(0);
    square(-1, -1, 1, 1, 0); /* of the next frame */
    CHECK(progress() < 1);
    __atomic_store_n(&letGo, 1, __ATOMIC_RELEASE);
    rtRender(); /* with one in flight: only waits */
    CHECK_ERROR(RT_NO_ERROR);
    CHECK(!gaveUp && progress() == 1);
    CHECK(isColor(at(-0.9f, -0.9f), 0.5f, 0.25f, 0.125f));
    CHECK(isColor(at(0.9f, 0.9f), 0.5f, 0.25f, 0.125f));
    CHECK(second[0][0][1] == 0);
    rtEndRendering();
    CHECK_ERROR(RT_INVALID_OPERATION);

    rtRender();
    CHECK(isColor(second[0][0], 0, 1, 0) && isColor(second[1][1], 1, 0, 0));
    CHECK(isColor(at(-0.9f, -0.9f), 0.5f, 0.25f, 0.125f));
    CHECK_ERROR(RT_NO_ERROR);
}

/* Parameters are read when a frame is started. */
static void freezing(void) {
    RTuint value;
    startPicture();
    rtGenNewShaderClass("ConstantShader", NULL);
    rtGenNewShader();
    value = rtParameterHandle("value");
    rtParameter3f(value, 1, 0, 0);
    square(-1, -1, 1, 1, 0);
    rtParameter3f(value, 0, 1, 0); /* later than the vertices, earlier than the frame */
    rtStartRendering();
    rtParameter3f(value, 0, 0, 1);
    rtEndRendering();
    CHECK(isColor(at(0, 0), 0, 1, 0));
    square(-1, -1, 1, 1, 0);
    rtRender();
    CHECK(isColor(at(0, 0), 0, 0, 1));
    CHECK_ERROR(RT_NO_ERROR);
}

static void formats(void) {
    static const struct {
        RTenum format;
        int components, isFloat, order[4];
    } cases[] = {{RT_BGR_32, 3, 1, {2, 1, 0, 3}},   {RT_RGB_8, 3, 0, {0, 1, 2, 3}},
                 {RT_RGBA_8, 4, 0, {0, 1, 2, 3}},   {RT_BGRA_8, 4, 0, {2, 1, 0, 3}},
                 {RT_RGB_32F, 3, 1, {0, 1, 2, 3}},  {RT_RGBA_32F, 4, 1, {0, 1, 2, 3}}};
    /* Lower row, two pixels: the colour, and the clear colour above it in the second row. */
    const float color[4] = {0.2f, 1.5f, -0.5f, 0.25f}, clear[4] = {0.5f, 0, 1, 0.75f};
    const RTubyte colorBytes[4] = {51, 255, 0, 64}, clearBytes[4] = {128, 0, 255, 191};
    int i, k, pixel;
    for (i = 0; i < (int)(sizeof cases / sizeof cases[0]); ++i) {
        const int size = cases[i].components * (cases[i].isFloat ? 4 : 1);
        const int stride = 2 * size + 12;
        RTubyte memory[256];
        int wrong = 0;
        startPicture();
        memset(memory, 0xAA, sizeof memory);
        rtSetFrameBuffer(memory, 2, 2, cases[i].format);
        rtFrameBufferStride(stride);
        rtClearColor(clear[0], clear[1], clear[2], clear[3]);
        rtColor4fv(color);
        square(-1, -1, 1, 0, 0);
        rtRender();
        CHECK_ERROR(RT_NO_ERROR);
        for (pixel = 0; pixel < 4; ++pixel) {
            const RTubyte *p = memory + (pixel / 2) * stride + (pixel % 2) * size;
            const float *expected = pixel < 2 ? color : clear;
            const RTubyte *bytes = pixel < 2 ? colorBytes : clearBytes;
            for (k = 0; k < cases[i].components; ++k) {
                const int c = cases[i].order[k];
                if (cases[i].isFloat) {
                    float v;
                    memcpy(&v, p + 4 * k, 4);
                    wrong += fabsf(v - expected[c]) > 1e-6f;
                } else {
                    wrong += p[k] != bytes[c];
                }
            }
        }
        if (wrong) fprintf(stderr, "format 0x%X\n", cases[i].format);
        CHECK(wrong == 0);
        for (k = 2 * size; k < stride; ++k) wrong += memory[k] != 0xAA;
        CHECK(wrong == 0); /* nothing between the rows */
    }
    { /* sRGB: IEC 61966-2-1 */
        RTubyte memory[4];
        startPicture();
        rtSetFrameBuffer(memory, 1, 1, RT_RGBA_8);
        rtEnable(RT_FRAMEBUFFER_SRGB);
        rtColor4f(0.5f, 0.001f, 1, 0.5f);
        square(-1, -1, 1, 1, 0);
        rtRender();
        CHECK(memory[0] == 188 && memory[1] == 3 && memory[2] == 255 && memory[3] == 128);
    }
}

static void auxiliaryBuffers(void) {
    static float depth[16][16], distance[16][16], normal[16][16][3];
    static RTuint object[16][16], instance[16][16], primitive[16][16];
    RTuint id;
    startPicture();
    rtSetAuxBuffer(RT_DEPTH, depth, RT_FLOAT);
    rtSetAuxBuffer(RT_DISTANCE, distance, RT_FLOAT);
    rtSetAuxBuffer(RT_NORMAL, normal, RT_RGB_32F);
    rtSetAuxBuffer(RT_OBJECT_ID, object, RT_UNSIGNED_INT);
    rtSetAuxBuffer(RT_INSTANCE_ID, instance, RT_UNSIGNED_INT);
    rtSetAuxBuffer(RT_PRIMITIVE_ID, primitive, RT_UNSIGNED_INT);
    id = rtNewObject(RT_DEFINE);
    square(0, 0, 1, 1, 0);
    rtEndObject();
    square(-1, -1, 0, 0, 5);
    rtTranslatef(0, 0, -5);
    rtInstantiateObject(id);
    rtRender();
    CHECK_ERROR(RT_NO_ERROR);
    CHECK(object[4][4] == 0 && instance[4][4] == 0 && primitive[4][5] == 0);
    CHECK(primitive[5][4] == 1);
    CHECK(object[12][12] == id && instance[12][12] == 1);
    CHECK(object[4][12] == RT_INVALID && instance[4][12] == RT_INVALID);
    CHECK(primitive[4][12] == RT_INVALID && depth[4][12] == 1 && isinf(distance[4][12]));
    CHECK(normal[4][12][2] == 0 && normal[12][12][2] == 1 && normal[12][12][0] == 0);
    CHECK(fabsf(depth[4][4] - 0.25f) < 1e-6f && fabsf(depth[12][12] - 0.75f) < 1e-6f);
    CHECK(fabsf(distance[12][12] - distance[4][4] - 10) < 1e-5f);
    rtSetAuxBuffer(RT_DEPTH, NULL, 0);
    memset(depth, 0, sizeof depth);
    rtRender();
    CHECK(depth[0][0] == 0 && object[4][4] == RT_INVALID);
    CHECK_ERROR(RT_NO_ERROR);
}

/* Pixel centres with one sample; several are averaged, and depend on the seed only. */
static void sampling(void) {
    static float again[PICTURE_SIZE][PICTURE_SIZE][4];
    float edge;
    int i;
    startPicture();
    square(-1, -1, 0.03f, 1, 0); /* reaches a quarter into pixel 8, not its centre */
    rtRender();
    CHECK(at(0.03f, 0)[0] == 0 && at(-0.03f, 0)[0] == 1);
    rtSamples(64);
    rtSeed(1);
    square(-1, -1, 0.03f, 1, 0);
    rtRender();
    edge = at(0.03f, 0)[0];
    CHECK(edge > 0.1f && edge < 0.4f);
    memcpy(again, picture, sizeof again);
    rtThreads(3);
    square(-1, -1, 0.03f, 1, 0);
    rtRender();
    CHECK(memcmp(again, picture, sizeof again) == 0);
    rtSamples(1);
    rtEnable(RT_MULTISAMPLE); /* four */
    for (i = 0; i < 2; ++i) {
        RTint rays = 0;
        square(-1, -1, 0.03f, 1, 0);
        rtRender();
        rtGetIntegerv(RT_STAT_PRIMARY_RAYS, &rays);
        CHECK(rays == (i ? 16 : 4) * PICTURE_SIZE * PICTURE_SIZE);
        rtSamples(16);
    }
    CHECK_ERROR(RT_NO_ERROR);
}

/* rtFinish renders and leaves the scene open. */
static void finishing(void) {
    RTint rays = -1;
    startPicture();
    rtFinish(); /* nothing was given */
    rtGetIntegerv(RT_STAT_PRIMARY_RAYS, &rays);
    CHECK(rays == 0);
    square(-1, -1, 0, 0, 0);
    rtFinish();
    CHECK(at(-0.5f, -0.5f)[0] == 1 && at(0.5f, 0.5f)[0] == 0);
    memset(picture, 0, sizeof picture);
    rtFinish(); /* nothing was added: not rendered again */
    CHECK(at(-0.5f, -0.5f)[0] == 0);
    square(0, 0, 1, 1, 0);
    rtRender();
    CHECK(at(-0.5f, -0.5f)[0] == 1 && at(0.5f, 0.5f)[0] == 1);
    rtFlush();
    square(0, 0, 1, 1, 0);
    rtStartRendering();
    rtFinish(); /* waits for what is in flight */
    CHECK(at(-0.5f, -0.5f)[0] == 0 && at(0.5f, 0.5f)[0] == 1);
    rtEndRendering();
    CHECK_ERROR(RT_NO_ERROR);
}

/* The frame's cameras, environments and rendering objects. */
static void shadersOfTheFrame(void) {
    RTuint camera, environment;
    startPicture();
    rtGenNewShaderClass("PinholeCameraShader", NULL);
    camera = rtGenNewShader();
    rtParameter3f(rtParameterHandle("origin"), 0, 0, 4);
    rtParameter3f(rtParameterHandle("lowerLeft"), -1, -1, -4);
    rtParameter3f(rtParameterHandle("horizontal"), 2, 0, 0);
    rtParameter3f(rtParameterHandle("vertical"), 0, 2, 0);
    rtGenNewShaderClass("ConstantEnvironment", NULL);
    environment = rtGenNewShader();
    rtParameter3f(rtParameterHandle("radiance"), 0.25f, 0.5f, 2);
    rtBindShader(0);
    rtMatrixMode(RT_PROJECTION); /* ignored with a camera shader, even a singular one */
    rtScalef(0, 0, 0);
    rtMatrixMode(RT_MODELVIEW);
    rtUseCamera(camera);
    rtUseCamera(camera);
    CHECK_ERROR(RT_INVALID_OPERATION);
    rtUseEnvironmentShader(environment);
    rtUseEnvironmentShader(environment);
    CHECK_ERROR(RT_INVALID_OPERATION);
    rtColor3f(1, 1, 0);
    square(-1, -1, 0, 0, 0);
    rtRender();
    CHECK_ERROR(RT_NO_ERROR);
    CHECK(isColor(at(-0.1f, -0.1f), 1, 1, 0) && isColor(at(-0.9f, -0.9f), 1, 1, 0));
    CHECK(isColor(at(0.1f, 0.1f), 0.25f, 0.5f, 2));
    rtRender(); /* given anew every frame: no camera, and the projection is singular */
    CHECK_ERROR(RT_INVALID_OPERATION);
    rtUseCamera(camera);
    rtRender();
    CHECK_ERROR(RT_NO_ERROR);
    CHECK(isColor(at(0.1f, 0.1f), 0, 0, 0));
}

int main(void) {
    startPicture();
    rtInit(NULL, NULL);
    rtStartRendering(); /* no frame buffer */
    CHECK_ERROR(RT_INVALID_OPERATION);
    rtRender();
    CHECK_ERROR(RT_INVALID_OPERATION);
    rtFinish(); /* nothing to do */
    CHECK_ERROR(RT_NO_ERROR);
    asynchronous();
    freezing();
    formats();
    auxiliaryBuffers();
    sampling();
    finishing();
    shadersOfTheFrame();
    startPicture();
    rtStartRendering(); /* ends with a frame in flight */
    return failureCount;
}

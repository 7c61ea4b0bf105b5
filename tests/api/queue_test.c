/* SPDX-License-Identifier: MIT */
/* The queue of frames: what a frame in flight shows, order, waiting, asking, cancelling, memory. */
#include <malloc.h>
#include <pthread.h>
#include <stdlib.h>
#include <time.h>

#include "check.h"
#include "openrt/rts.h"
#include "picture.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
enum { kSanitized = 1, kTinyFrames = 1000 };
#else
enum { kSanitized = 0, kTinyFrames = 10000 };
#endif

enum { kSize = 64, kStates = 16 };

typedef struct Memory {
    float color[kSize * kSize][4], depth[kSize * kSize], normal[kSize * kSize][3];
    RTuint object[kSize * kSize], primitive[kSize * kSize];
} Memory;

static void pause_(long microseconds) {
    const struct timespec t = {microseconds / 1000000, microseconds % 1000000 * 1000};
    nanosleep(&t, NULL);
}

/* Everything that a frame may depend on, made anew from the number of a state. */
typedef struct Things {
    RTuint object, extra, textured, texture, plain, color, light, lightColor, environment, radiance;
} Things;

static Things makeThings(void) {
    Things t;
    rtInit(NULL, NULL);
    rtThreads(3);
    rtGenNewShaderClass("PointLight", NULL);
    t.light = rtGenNewShader();
    t.lightColor = rtParameterHandle("radiance");
    rtGenNewShaderClass("ConstantEnvironment", NULL);
    t.environment = rtGenNewShader();
    t.radiance = rtParameterHandle("radiance");
    rtGenTextures(1, &t.texture);
    rtGenNewShaderClass("TexturedDiffuseShader", NULL);
    t.textured = rtGenNewShader();
    rtParameter1i(rtParameterHandle("texture"), (RTint)t.texture);
    rtGenNewShaderClass("ConstantShader", NULL);
    t.plain = rtGenNewShader();
    t.color = rtParameterHandle("value");
    t.object = rtNewObject(RT_DEFINE);
    rtEndObject();
    t.extra = 0;
    return t;
}

static void describe(Things *t, int state, Memory *memory) {
    RTubyte texels[16 * 16 * 4];
    int i;
    rtSetFrameBuffer((RTubyte *)memory->color, kSize, kSize, RT_RGBA_32F);
    rtSetAuxBuffer(RT_DEPTH, memory->depth, RT_FLOAT);
    rtSetAuxBuffer(RT_NORMAL, memory->normal, RT_RGB_32F);
    rtSetAuxBuffer(RT_OBJECT_ID, memory->object, RT_UNSIGNED_INT);
    rtSetAuxBuffer(RT_PRIMITIVE_ID, memory->primitive, RT_UNSIGNED_INT);
    rtSamples(state % 3 == 0 ? 4 : 1);
    rtSeed((RTuint)state);
    rtClearColor((float)(state % 4) / 4, 0.5f, 0, 1);
    rtViewport(state % 5, 0, kSize - state % 5, kSize);
    rtHint(RT_PRECISION_HINT, state % 2 ? RT_FASTEST : RT_DONT_CARE);
    rtMatrixMode(RT_PROJECTION);
    rtLoadIdentity();
    rtPerspective(40 + state, 1, 0.1, 100);
    rtMatrixMode(RT_MODELVIEW);
    rtLoadIdentity();

    for (i = 0; i < (int)sizeof texels; ++i) texels[i] = (RTubyte)(i * (7 + state) + state);
    rtBindTexture(RT_TEXTURE_2D, t->texture);
    rtTexImage2D(RT_TEXTURE_2D, 0, RT_RGBA, 16, 16, 0, RT_RGBA, RT_UNSIGNED_BYTE, texels);
    rtBindShader(t->light);
    rtParameter3f(t->lightColor, 5 + (float)state, 4, 3);
    rtBindShader(t->environment);
    rtParameter3f(t->radiance, 0, 0, (float)state / kStates);
    rtBindShader(t->plain);
    rtParameter3f(t->color, 1, (float)(state % 7) / 7, 0.5f);

    rtReplaceObject(t->object);
    rtBindShader(t->textured);
    rtBegin(RT_TRIANGLE_FAN);
    rtNormal3f(0.1f * (float)(state % 3), 0, 1);
    for (i = 0; i <= 5 + state; ++i) {
        const float angle = 6.2831853f * (float)i / (float)(5 + state);
        rtTexCoord2f(cosf(angle), sinf(angle));
        rtVertex3f(cosf(angle), sinf(angle), 0.1f * (float)(i % 3));
    }
    rtEnd();
    rtEndObject();
    t->extra = rtNewObject(RT_DEFINE);
    square(-1, -1, 1, 1, -2);
    rtEndObject();
    rtBindShader(0);

    rtUseLight(t->light);
    if (state % 2) rtUseEnvironmentShader(t->environment);
    rtTranslatef(0, 0, -3);
    rtInstantiateObject(t->object);
    rtRotatef((float)state * 10, 0, 0, 1);
    rtInstantiateObject(t->extra);
    rtColor3f(0.25f, 1, (float)(state % 2));
    square(-0.25f, -1.5f, 0.25f, 1.5f, 0.5f);
}

/* After a frame was queued: nothing is left as it was. */
static void changeEverything(Things *t) {
    static RTubyte elsewhere[16];
    const RTubyte black[4] = {0, 0, 0, 0};
    rtReplaceObject(t->object);
    rtEndObject();
    rtRemoveObject(t->extra);
    rtBindTexture(RT_TEXTURE_2D, t->texture);
    rtTexImage2D(RT_TEXTURE_2D, 0, RT_RGBA, 1, 1, 0, RT_RGBA, RT_UNSIGNED_BYTE, black);
    rtBindShader(t->plain);
    rtParameter3f(t->color, 0, 0, 0);
    rtBindShader(t->light);
    rtParameter3f(t->lightColor, 0, 0, 0);
    rtClearColor(1, 1, 1, 1);
    rtSetFrameBuffer(elsewhere, 1, 1, RT_RGBA_32F);
    rtSetAuxBuffer(RT_DEPTH, NULL, 0);
    rtSetAuxBuffer(RT_NORMAL, NULL, 0);
    rtSetAuxBuffer(RT_OBJECT_ID, NULL, 0);
    rtSetAuxBuffer(RT_PRIMITIVE_ID, NULL, 0);
    rtMatrixMode(RT_PROJECTION);
    rtLoadIdentity();
    rtMatrixMode(RT_MODELVIEW);
    rtLoadIdentity();
}

/* Object ids of the extra object differ between the runs; all else has to be equal to the bit. */
static int samePicture(const Memory *a, const Memory *b) {
    return memcmp(a->color, b->color, sizeof a->color) == 0 &&
           memcmp(a->depth, b->depth, sizeof a->depth) == 0 &&
           memcmp(a->normal, b->normal, sizeof a->normal) == 0 &&
           memcmp(a->object, b->object, sizeof a->object) == 0 &&
           memcmp(a->primitive, b->primitive, sizeof a->primitive) == 0;
}

static void framesShowTheStateAtTheirStart(void) {
    Memory *blocking = calloc(kStates, sizeof *blocking), *queued = calloc(kStates, sizeof *queued);
    RTuint frames[kStates];
    Things things = makeThings();
    int i, different = 0;
    if (!blocking || !queued) exit(2);
    for (i = 0; i < kStates; ++i) {
        describe(&things, i, &blocking[i]);
        rtRender();
        if (i > 0) different += !samePicture(&blocking[i], &blocking[i - 1]);
    }
    CHECK_ERROR(RT_NO_ERROR);
    CHECK(different == kStates - 1); /* the control: the states do differ */
    rtExit();

    things = makeThings();
    rtFrameDepth(5);
    for (i = 0; i < kStates; ++i) {
        describe(&things, i, &queued[i]);
        frames[i] = rtQueueFrame();
        changeEverything(&things);
        if (i == kStates / 2) rtThreads(2); /* waits for those in flight */
    }
    CHECK_ERROR(RT_NO_ERROR);
    for (i = 0; i < kStates; ++i) {
        CHECK(rtWaitFrame(frames[i]) == RT_TRUE);
        CHECK(samePicture(&blocking[i], &queued[i]));
    }
    CHECK_ERROR(RT_NO_ERROR);
    free(blocking);
    free(queued);
}

/* Scenes described in turns and queued together are what each is alone. */
static void scenesInABunch(void) {
    enum { kScenes = 6 };
    static float pictures[kScenes][PICTURE_SIZE][PICTURE_SIZE][4];
    RTuint scenes[kScenes], frames[kScenes];
    int i, part;
    startPicture();
    rtThreads(2);
    rtFrameDepth(kScenes);
    for (i = 0; i < kScenes; ++i) scenes[i] = rtGenScene();
    for (part = 0; part < 4; ++part) {
        for (i = 0; i < kScenes; ++i) {
            rtBindScene(scenes[i]);
            rtColor3f((float)(i + 1) / kScenes, (float)part / 4, 1);
            square(-1 + 0.5f * (float)part, -1, -0.5f + 0.5f * (float)part, 1, (float)i);
        }
    }
    for (i = 0; i < kScenes; ++i) {
        rtBindScene(scenes[i]);
        rtSetFrameBuffer((RTubyte *)pictures[i], PICTURE_SIZE, PICTURE_SIZE, RT_RGBA_32F);
        frames[i] = rtQueueFrame();
        rtDeleteScene(scenes[i]);
    }
    for (i = kScenes - 1; i >= 0; --i) {
        CHECK(rtWaitFrame(frames[i]) == RT_TRUE);
        for (part = 0; part < 4; ++part)
            CHECK(isColor(pictures[i][8][4 * part + 2], (float)(i + 1) / kScenes, (float)part / 4,
                          1));
        CHECK(i == 0 || frames[i] == frames[i - 1] + 1);
    }
    CHECK_ERROR(RT_NO_ERROR);
}

/* All calls that need no context, on threads that have none. */
typedef struct Watched {
    RTuint frame;
    int wrong, rounds;
    RTboolean done;
} Watched;

static int rank(RTenum status) {
    return status == RT_QUEUED ? 0 : status == RT_RENDERING ? 1 : 2;
}

static void *watch(void *argument) {
    Watched *w = argument;
    float last = 0;
    int lastRank = 0;
    while (lastRank < 2) {
        const RTenum status = rtFrameStatus(w->frame);
        const float now = rtFrameProgress(w->frame);
        w->wrong += now < last || now > 1 || rank(status) < lastRank || status == RT_INVALID;
        last = now;
        lastRank = rank(status);
        ++w->rounds;
    }
    w->done = rtWaitFrame(w->frame);
    w->wrong += rtFrameProgress(w->frame) != 1 || rtFrameStatus(w->frame) != RT_DONE;
    return NULL;
}

static void progressNeverFalls(void) {
    static RTubyte pixels[4][160 * 160 * 4];
    pthread_t threads[4];
    Watched watched[4] = {{0, 0, 0, 0}};
    int i;
    startPicture();
    rtThreads(2);
    rtFrameDepth(4);
    for (i = 0; i < 4; ++i) {
        rtSetFrameBuffer(pixels[i], 160, 160, RT_RGBA_8);
        square(-1, -1, 1, 1, 0);
        watched[i].frame = rtQueueFrame();
        pthread_create(&threads[i], NULL, watch, &watched[i]);
    }
    for (i = 0; i < 4; ++i) {
        pthread_join(threads[i], NULL);
        CHECK(watched[i].wrong == 0 && watched[i].done == RT_TRUE && watched[i].rounds > 0);
    }
    CHECK_ERROR(RT_NO_ERROR);
}

/* Three threads cancel one of four frames each, at a random moment. */
typedef struct Cancelling {
    const RTuint *frames;
    unsigned victim, microseconds;
} Cancelling;

static void *cancelOne(void *argument) {
    const Cancelling *c = argument;
    RTuint frame;
    pause_(c->microseconds);
    frame = __atomic_load_n(&c->frames[c->victim], __ATOMIC_ACQUIRE);
    if (frame) rtCancelFrame(frame);
    return NULL;
}

static void cancellingAtRandom(void) {
    enum { kRounds = 200, kFrames = 4, kThreads = 3, kEdge = 40 };
    static float pixels[kFrames][kEdge * kEdge][4];
    unsigned random = 1;
    int round, i, k, done = 0, cancelled = 0;
    startPicture();
    rtThreads(2);
    rtFrameDepth(2);
    for (round = 0; round < kRounds; ++round) {
        pthread_t threads[kThreads];
        Cancelling cancelling[kThreads];
        RTuint frames[kFrames] = {0};
        memset(pixels, 0, sizeof pixels);
        for (i = 0; i < kThreads; ++i) {
            random = random * 1664525u + 1013904223u;
            cancelling[i].frames = frames;
            cancelling[i].victim = random >> 30;
            cancelling[i].microseconds = (random >> 8) % 800;
            pthread_create(&threads[i], NULL, cancelOne, &cancelling[i]);
        }
        for (i = 0; i < kFrames; ++i) {
            rtSetFrameBuffer((RTubyte *)pixels[i], kEdge, kEdge, RT_RGBA_32F);
            rtColor3f(1, 1, (float)i);
            square(-1, -1, 1, 1, 0);
            __atomic_store_n(&frames[i], rtQueueFrame(), __ATOMIC_RELEASE);
        }
        for (i = 0; i < kFrames; ++i) {
            const RTboolean isDone = rtWaitFrame(frames[i]);
            const RTenum status = rtFrameStatus(frames[i]);
            int complete = 1;
            CHECK(status == (isDone ? RT_DONE : RT_CANCELLED));
            for (k = 0; k < kEdge * kEdge; ++k)
                complete &= pixels[i][k][0] == 1 && pixels[i][k][2] == (float)i;
            CHECK(complete == isDone);
            isDone ? ++done : ++cancelled;
        }
        for (i = 0; i < kThreads; ++i) pthread_join(threads[i], NULL);
    }
    CHECK(done > 0 && cancelled > 0); /* the control: both happen */
    CHECK_ERROR(RT_NO_ERROR);
}

/* Bytes that the program holds; 0 where nobody can tell. */
static size_t heapBytes(void) {
#if defined(__GLIBC__) && __GLIBC_PREREQ(2, 33)
    const struct mallinfo2 info = mallinfo2();
    return kSanitized ? 0 : info.uordblks + info.hblkhd;
#else
    return 0;
#endif
}

/* Thousands of frames, some of which are cancelled and most never waited for. */
static void tinyFramesInConstantMemory(void) {
    static RTubyte pixels[8][8 * 8 * 4];
    RTuint first = 0, last = 0, object;
    RTint bytes[2];
    size_t heap[2];
    int i, k;
    startPicture();
    rtThreads(2);
    rtFrameDepth(4);
    object = rtNewObject(RT_DEFINE);
    square(-1, -1, 0, 1, 0);
    rtEndObject();
    for (k = 0; k < 2; ++k) {
        for (i = 0; i < kTinyFrames / (k ? 1 : 5); ++i) {
            rtSetFrameBuffer(pixels[i % 8], 8, 8, RT_RGBA_8);
            rtInstantiateObject(object);
            rtInstantiateObject(object);
            square(0, 0, 1, 1, 0);
            last = rtQueueFrame();
            if (!first) first = last;
            if (i % 16 == 5) rtCancelFrame(last);
        }
        rtFinish();
        rtGetIntegerv(RT_STAT_BYTES, &bytes[k]);
        heap[k] = heapBytes();
    }
    CHECK(last - first + 1 == kTinyFrames + kTinyFrames / 5);
    CHECK(bytes[0] == bytes[1]); /* the object's alone */
    /* A block lost per frame would be 32 bytes of each. Allowed are 8: what is freed but kept by
     * the allocator for one thread counts as held, and cancelled frames leave their outcome. */
    if (heap[1] > heap[0] + 8 * kTinyFrames)
        fprintf(stderr, "%zu bytes, then %zu\n", heap[0], heap[1]);
    CHECK(heap[1] <= heap[0] + 8 * kTinyFrames);
    CHECK(rtFrameStatus(first) == RT_DONE && rtWaitFrame(first) == RT_TRUE); /* long ago */
    CHECK(rtFrameProgress(first) == 1);
    CHECK(rtFrameStatus(first + 5) == RT_CANCELLED || rtFrameStatus(first + 5) == RT_DONE);
    rtCancelFrame(first);
    CHECK(rtFrameStatus(first) == RT_DONE);
    CHECK_ERROR(RT_NO_ERROR);
}

/* A surface that fails for every pixel it is asked for. */
static int construct(void *shader, void *triangle, void *vertex) {
    (void)shader, (void)triangle, (void)vertex;
    return 0;
}
static int fail(const void *shader, struct RTSstate *state) {
    (void)shader, (void)state;
    return 1;
}

static void *waitWithoutContext(void *argument) {
    Watched *w = argument;
    w->done = rtWaitFrame(w->frame);
    return NULL;
}

/* What goes wrong in workers is recorded once, where a context waits for it. */
static void errorsOfWorkers(void) {
    RTshaderclass failing = {0};
    RTcontext first, second;
    Watched w = {0, 0, 0, RT_FALSE};
    pthread_t thread;
    RTint rays = 0;
    startPicture();
    failing.structSize = sizeof failing;
    failing.interfaceVersion = RTS_INTERFACE_VERSION;
    failing.kind = RT_SURFACE_SHADER;
    failing.name = "Failing";
    failing.alignment = 1;
    failing.construct = construct;
    failing.shade = fail;
    rtRegisterShaderClass(&failing);
    rtGenNewShader();
    square(-1, -1, 0, 0, 0);
    w.frame = rtQueueFrame();
    pthread_create(&thread, NULL, waitWithoutContext, &w);
    pthread_join(thread, NULL);
    CHECK(w.done == RT_TRUE);
    rtFinish();
    CHECK_ERROR(RT_NO_ERROR);

    first = rtGetCurrentContext();
    second = rtCreateContext();
    rtMakeCurrent(second);
    CHECK(rtWaitFrame(w.frame) == RT_TRUE); /* another context's */
    rtGetIntegerv(RT_STAT_BAD_PIXELS, &rays);
    CHECK(rays == PICTURE_SIZE * PICTURE_SIZE / 4);
    CHECK_ERROR(RT_INVALID_OPERATION);
    CHECK(strstr(rtGetErrorText(), "64 pixels") != NULL);
    CHECK(rtWaitFrame(w.frame) == RT_TRUE);
    CHECK_ERROR(RT_NO_ERROR);
    rtDestroyContext(second);
    rtMakeCurrent(first);
    CHECK(rtWaitFrame(w.frame) == RT_TRUE);
    CHECK_ERROR(RT_NO_ERROR);
}

static void statisticsAreOfTheFrameWaitedFor(void) {
    static RTubyte pixels[3][64 * 64 * 4];
    RTuint frames[3];
    RTint rays = 0;
    int i;
    startPicture();
    rtFrameDepth(3);
    for (i = 0; i < 3; ++i) {
        rtSetFrameBuffer(pixels[i], 16u << i, 16, RT_RGBA_8);
        frames[i] = rtQueueFrame();
    }
    for (i = 2; i >= 0; --i) {
        rtWaitFrame(frames[i]);
        rtGetIntegerv(RT_STAT_PRIMARY_RAYS, &rays);
        CHECK(rays == (16 << i) * 16);
    }
    CHECK_ERROR(RT_NO_ERROR);
}

/* Frames that write to the same memory run one after the other; the last one is what remains. */
static void oneFrameBufferForAll(void) {
    static float pixels[100 * 100][4];
    RTuint frame = 0;
    int i, k, wrong = 0;
    startPicture();
    rtThreads(3);
    rtFrameDepth(8);
    rtSetFrameBuffer((RTubyte *)pixels, 100, 100, RT_RGBA_32F);
    for (i = 0; i < 40; ++i) {
        rtColor3f(0, (float)i, 0);
        square(-1, -1, 1, 1, 0);
        frame = rtQueueFrame();
    }
    CHECK(rtWaitFrame(frame) == RT_TRUE);
    for (k = 0; k < 100 * 100; ++k) wrong += pixels[k][1] != 39;
    CHECK(wrong == 0);
    CHECK_ERROR(RT_NO_ERROR);
}

/* rtStartRendering beside the queue; each counts for the depth, and frames end in order. */
static void besideRtStartRendering(void) {
    static float other[PICTURE_SIZE][PICTURE_SIZE][4];
    RTuint queued;
    startPicture();
    rtFrameDepth(3);
    rtColor3f(1, 0, 0);
    square(-1, -1, 1, 1, 0);
    rtStartRendering();
    rtSetFrameBuffer((RTubyte *)other, PICTURE_SIZE, PICTURE_SIZE, RT_RGBA_32F);
    rtColor3f(0, 1, 0);
    square(-1, -1, 1, 1, 0);
    queued = rtQueueFrame();
    CHECK(queued != RT_INVALID);
    rtStartRendering();
    CHECK_ERROR(RT_INVALID_OPERATION); /* its own limit stays */
    CHECK(rtWaitFrame(queued) == RT_TRUE);
    CHECK(isColor(at(0, 0), 1, 0, 0) && isColor(other[8][8], 0, 1, 0));
    rtEndRendering();
    CHECK_ERROR(RT_NO_ERROR);
    rtEndRendering();
    CHECK_ERROR(RT_INVALID_OPERATION);
}

static void badInput(void) {
    RTint depth = 0;
    RTuint frame;
    rtInit(NULL, NULL);
    CHECK(rtQueueFrame() == RT_INVALID); /* no frame buffer */
    CHECK_ERROR(RT_INVALID_OPERATION);
    startPicture();
    rtFrameDepth(0);
    CHECK_ERROR(RT_INVALID_VALUE);
    rtGetIntegerv(RT_FRAME_DEPTH, &depth);
    CHECK(depth == 2);
    rtFrameDepth(0xFFFFFFFFu); /* costs nothing */
    frame = rtQueueFrame();
    CHECK(rtWaitFrame(frame) == RT_TRUE && rtWaitFrame(frame) == RT_TRUE);
    CHECK_ERROR(RT_NO_ERROR);
    CHECK(rtWaitFrame(frame + 1) == RT_FALSE);
    CHECK_ERROR(RT_INVALID_VALUE);
    CHECK(rtFrameStatus(frame + 1) == RT_INVALID);
    CHECK_ERROR(RT_INVALID_VALUE);
    CHECK(rtFrameProgress(0) == 0);
    CHECK_ERROR(RT_INVALID_VALUE);
    rtCancelFrame(RT_INVALID);
    CHECK_ERROR(RT_INVALID_VALUE);
    rtMatrixMode(RT_PROJECTION);
    rtScalef(0, 0, 0);
    CHECK(rtQueueFrame() == RT_INVALID);
    CHECK_ERROR(RT_INVALID_OPERATION);
    rtLoadIdentity();
    CHECK(rtQueueFrame() == frame + 1); /* a refused frame takes no id */
    CHECK_ERROR(RT_NO_ERROR);
}

/* A frame is complete when what it belongs to ends; its id outlives the context, not rtExit. */
static void ends(void) {
    static RTubyte pixels[6][64 * 64 * 4];
    RTuint frames[6];
    RTcontext context;
    int i;
    startPicture();
    context = rtCreateContext();
    rtMakeCurrent(context);
    rtFrameDepth(6);
    rtClearColor(1, 1, 1, 1);
    for (i = 0; i < 6; ++i) {
        rtSetFrameBuffer(pixels[i], 64, 64, RT_RGBA_8);
        frames[i] = rtQueueFrame();
    }
    rtCancelFrame(frames[5]);
    rtDestroyContext(context);
    for (i = 0; i < 5; ++i) {
        CHECK(rtFrameStatus(frames[i]) == RT_DONE && rtWaitFrame(frames[i]) == RT_TRUE);
        CHECK(pixels[i][0] == 255 && pixels[i][64 * 64 * 4 - 1] == 255);
    }
    CHECK(rtFrameProgress(frames[5]) == 1);
    rtInit(NULL, NULL); /* ends the default context alone */
    CHECK(rtFrameStatus(frames[0]) == RT_DONE);
    rtSetFrameBuffer(pixels[0], 64, 64, RT_RGBA_8);
    rtQueueFrame();
    rtExit();
    CHECK(pixels[0][0] == 0);
    CHECK(rtFrameStatus(frames[0]) == RT_INVALID && rtWaitFrame(frames[0]) == RT_FALSE);
    startPicture();
    CHECK(rtQueueFrame() > frames[5]); /* never used again */
    CHECK_ERROR(RT_NO_ERROR);
}

int main(void) {
    CHECK(rtQueueFrame() == RT_INVALID && rtWaitFrame(1) == RT_FALSE);
    badInput();
    framesShowTheStateAtTheirStart();
    scenesInABunch();
    progressNeverFalls();
    cancellingAtRandom();
    tinyFramesInConstantMemory();
    errorsOfWorkers();
    statisticsAreOfTheFrameWaitedFor();
    oneFrameBufferForAll();
    besideRtStartRendering();
    ends();
    startPicture();
    rtQueueFrame(); /* the process ends with a frame in flight */
    return failureCount;
}

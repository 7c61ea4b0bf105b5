/* SPDX-License-Identifier: MIT */
/* Frames in flight: two scenes, queued in a bunch for each step of an animation; while they are
 * rendered the next step is described and the pictures of the one before last are written.
 *
 *     07_frame_queue [prefix [steps]]      writes prefix_<scene>_<step>.png */
#include <math.h>
#include <stdlib.h>

#include "openrt/rt.h"
#include "samples/common/refuse_options.h"
#include "samples/common/write_png.h"

enum { kWidth = 480, kHeight = 360, kScenes = 2, kInFlight = 2, kRings = 16, kSectors = 32 };

static const double kPi = 3.14159265358979323846;
static const char *const kNames[kScenes] = {"wave", "ring"};

/* One step of the animation that is being rendered. */
typedef struct Bunch {
    RTubyte *pixels[kScenes]; /* a frame buffer for each frame in flight */
    RTuint frames[kScenes];
} Bunch;

typedef struct World {
    RTuint scenes[kScenes];
    RTuint sphere, cube, light, sky;
} World;

static void spherePoint(int ring, int sector) {
    const double polar = kPi * ring / kRings, around = 2.0 * kPi * sector / kSectors;
    const double x = sin(polar) * cos(around), y = cos(polar), z = sin(polar) * sin(around);
    rtNormal3d(x, y, z);
    rtVertex3d(x, y, z);
}

static RTuint makeSphere(void) {
    const RTuint object = rtNewObject(RT_DEFINE);
    int ring, sector;
    for (ring = 0; ring < kRings; ++ring) {
        rtBegin(RT_QUAD_STRIP);
        for (sector = 0; sector <= kSectors; ++sector) {
            spherePoint(ring, sector);
            spherePoint(ring + 1, sector);
        }
        rtEnd();
    }
    rtEndObject();
    return object;
}

/* Six turned copies of one side. */
static RTuint makeCube(void) {
    static const float turns[6][3] = {{0, 0, 0}, {90, 0, 0}, {180, 0, 0},
                                      {270, 0, 0}, {0, 90, 0}, {0, 270, 0}};
    const RTuint object = rtNewObject(RT_DEFINE);
    int side;
    for (side = 0; side < 6; ++side) {
        rtPushMatrix();
        rtRotatef(turns[side][0], 1, 0, 0);
        rtRotatef(turns[side][1], 0, 1, 0);
        rtBegin(RT_QUADS);
        rtNormal3f(0, 0, 1);
        rtVertex3f(-1, -1, 1);
        rtVertex3f(1, -1, 1);
        rtVertex3f(1, 1, 1);
        rtVertex3f(-1, 1, 1);
        rtEnd();
        rtPopMatrix();
    }
    rtEndObject();
    return object;
}

static World makeWorld(void) {
    World world;
    int i;
    rtGenNewShaderClass("PointLight", NULL);
    world.light = rtGenNewShader();
    rtParameter3f(rtParameterHandle("position"), 8, 14, -4); /* in the space of the eye */
    rtParameter3f(rtParameterHandle("radiance"), 700, 660, 600);
    rtGenNewShaderClass("ConstantEnvironment", NULL);
    world.sky = rtGenNewShader();
    rtParameter3f(rtParameterHandle("radiance"), 0.25f, 0.45f, 0.8f);
    rtGenNewShaderClass("Phong", NULL);
    rtGenNewShader();
    rtParameter3f(rtParameterHandle("diffuse"), 0.8f, 0.35f, 0.1f);
    rtParameter3f(rtParameterHandle("ambient"), 0.06f, 0.03f, 0.02f);
    world.sphere = makeSphere();
    rtGenNewShader();
    rtParameter3f(rtParameterHandle("diffuse"), 0.2f, 0.6f, 0.4f);
    rtParameter3f(rtParameterHandle("ambient"), 0.02f, 0.05f, 0.04f);
    world.cube = makeCube();
    for (i = 0; i < kScenes; ++i) world.scenes[i] = rtGenScene();
    return world;
}

static void place(RTuint object, double x, double y, double z, double size, double turn) {
    rtPushMatrix();
    rtTranslated(x, y, z);
    rtRotated(turn, 0, 1, 0);
    rtScaled(size, size, size);
    rtInstantiateObject(object);
    rtPopMatrix();
}

static void describeWave(const World *world, double time) {
    int x, z;
    rtUseLight(world->light);
    rtUseEnvironmentShader(world->sky);
    for (x = -8; x <= 8; ++x)
        for (z = -8; z <= 8; ++z)
            place(world->sphere, x, 0.5 * sin(0.6 * x + time) * cos(0.5 * z + time), z, 0.42, 0);
}

static void describeRing(const World *world, double time) {
    int i;
    rtUseLight(world->light);
    for (i = 0; i < 24; ++i) {
        const double angle = 2.0 * kPi * i / 24 + 0.3 * time;
        place(world->cube, 7 * cos(angle), sin(3 * angle), 7 * sin(angle), 0.6, 20 * time + 15 * i);
    }
    place(world->sphere, 0, 0, 0, 3, 0);
}

/* Describes both scenes and queues their frames; returns at once while the queue has room. */
static void queueBunch(const World *world, Bunch *bunch, double time) {
    int i;
    for (i = 0; i < kScenes; ++i) {
        rtBindScene(world->scenes[i]);
        rtSetFrameBuffer(bunch->pixels[i], kWidth, kHeight, RT_RGBA_8);
        if (i == 0)
            describeWave(world, time);
        else
            describeRing(world, time);
        bunch->frames[i] = rtQueueFrame();
    }
}

static int writeBunch(const Bunch *bunch, const char *prefix, int step) {
    char path[512];
    int i, good = 1;
    for (i = 0; i < kScenes; ++i) {
        good = rtWaitFrame(bunch->frames[i]) && good;
        snprintf(path, sizeof path, "%s_%s_%02d.png", prefix, kNames[i], step);
        good = good && writePng(path, bunch->pixels[i], kWidth, kHeight);
    }
    return good;
}

int main(int argc, char *argv[]) {
    Bunch bunches[kInFlight];
    World world;
    const char *prefix;
    int step, i, steps, good = 1;
    RTenum error;

    rtInit(&argc, argv);
    refuseOptions(argc, argv, "07_frame_queue [PREFIX [STEPS]]");
    prefix = argc > 1 ? argv[1] : "07_frame_queue";
    steps = argc > 2 ? atoi(argv[2]) : 4;
    for (step = 0; step < kInFlight; ++step)
        for (i = 0; i < kScenes; ++i)
            if (!(bunches[step].pixels[i] = malloc(4 * kWidth * kHeight))) return 1;

    rtFrameDepth(kInFlight * kScenes);
    rtEnable(RT_FRAMEBUFFER_SRGB);
    rtClearColor(0.02f, 0.03f, 0.05f, 1);
    rtMatrixMode(RT_PROJECTION);
    rtPerspective(40, (double)kWidth / kHeight, 0.1, 100);
    rtMatrixMode(RT_MODELVIEW);
    rtLookAt(0, 9, 18, 0, 0, 0, 0, 1, 0);
    world = makeWorld();

    for (step = 0; good && step < steps + kInFlight; ++step) {
        Bunch *bunch = &bunches[step % kInFlight];
        if (step >= kInFlight) good = writeBunch(bunch, prefix, step - kInFlight);
        if (step < steps) queueBunch(&world, bunch, 0.4 * step);
    }

    error = rtGetError();
    if (error != RT_NO_ERROR) fprintf(stderr, "07_frame_queue: %s\n", rtGetErrorText());
    rtExit(); /* waits for the frames, and only then their memory may go */
    for (step = 0; step < kInFlight; ++step)
        for (i = 0; i < kScenes; ++i) free(bunches[step].pixels[i]);
    return good && error == RT_NO_ERROR ? 0 : 1;
}

/* SPDX-License-Identifier: MIT */
/* day_and_night: two scenes of the same objects, rendered in a bunch. For each step both are
 * described and queued together; while their frames are rendered the next step is described. The
 * scenes are of a context of their own, whose pictures the window shows beside each other.
 * Usage: day_and_night [--trees N] [--fps] [rtut's options, as --rt-offscreen N] */
#include <math.h>

#include "openrt/rt.h"
#include "openrt/rtut.h"
#include "samples/changing/frame_rate.h"
#include "samples/changing/options.h"

enum { kDay, kNight, kScenes, kInFlight = 2, kLanterns = 4 };

/* The frames of one step, and their memory. */
typedef struct Bunch {
    RTubyte *pixels[kScenes];
    RTuint frames[kScenes];
} Bunch;

static const double kTwoPi = 6.283185307179586;

static long trees = 160, printsRate;
static RTcontext shown, drawn; /* the window's context, and that of the scenes */
static RTuint scenes[kScenes];
static RTuint meadow, tree, house, wings, moonlet;
static Bunch bunches[kInFlight];
static long step;
static int width, height; /* of one picture */

static double chance(unsigned what) {
    what = (what ^ (what >> 15)) * 2246822519u + 374761393u;
    what = (what ^ (what >> 13)) * 3266489917u;
    return (double)(what ^ (what >> 16)) / 4294967296.0;
}

/* ---- Objects ---------------------------------------------------------------------------- */

static double hill(double x, double z) {
    return 0.35 * sin(0.5 * x + 1) * cos(0.4 * z) + 0.012 * (x * x + z * z);
}

static RTuint makeMeadow(void) {
    enum { kCells = 40 };
    const double half = 10, cell = 2 * half / kCells;
    const RTuint object = rtNewObject(RT_DEFINE);
    int i, k, row;
    for (i = 0; i < kCells; ++i) {
        rtBegin(RT_QUAD_STRIP);
        for (k = 0; k <= kCells; ++k) {
            for (row = 0; row < 2; ++row) {
                const double x = cell * (i + row) - half, z = cell * k - half, h = 0.05;
                rtNormal3d(hill(x - h, z) - hill(x + h, z), 2 * h, hill(x, z - h) - hill(x, z + h));
                rtVertex3d(x, hill(x, z), z);
            }
        }
        rtEnd();
    }
    rtEndObject();
    return object;
}

/* A cone, or between two radii a part of one, about the y axis. */
static void cone(double y0, double r0, double y1, double r1) {
    enum { kSides = 14 };
    int side;
    rtBegin(RT_QUAD_STRIP);
    for (side = 0; side <= kSides; ++side) {
        const double x = cos(kTwoPi * side / kSides), z = sin(kTwoPi * side / kSides);
        rtNormal3d(x * (y1 - y0), r0 - r1, z * (y1 - y0));
        rtVertex3d(r1 * x, y1, r1 * z);
        rtVertex3d(r0 * x, y0, r0 * z);
    }
    rtEnd();
}

static RTuint makeTree(void) {
    const RTuint object = rtNewObject(RT_DEFINE);
    int layer;
    rtColor3f(0.36f, 0.24f, 0.14f);
    cone(0, 0.09, 0.45, 0.07);
    rtColor3f(0.16f, 0.42f, 0.16f);
    for (layer = 0; layer < 3; ++layer)
        cone(0.3 + 0.33 * layer, 0.46 - 0.1 * layer, 0.9 + 0.33 * layer, 0);
    rtEndObject();
    return object;
}

/* A mill without its wings. */
static RTuint makeHouse(void) {
    const RTuint object = rtNewObject(RT_DEFINE);
    rtColor3f(0.9f, 0.86f, 0.78f);
    cone(-0.3, 0.95, 2.4, 0.62);
    rtColor3f(0.62f, 0.22f, 0.16f);
    cone(2.35, 0.8, 3.25, 0);
    rtEndObject();
    return object;
}

static RTuint makeWings(void) {
    const RTuint object = rtNewObject(RT_DEFINE);
    int wing;
    rtColor3f(0.85f, 0.8f, 0.7f);
    for (wing = 0; wing < 4; ++wing) {
        rtRotatef(90, 0, 0, 1);
        rtBegin(RT_QUADS);
        rtNormal3f(0, 0, 1);
        rtVertex3f(0.25f, -0.05f, 0.05f);
        rtVertex3f(1.75f, -0.08f, 0.05f);
        rtVertex3f(1.75f, 0.3f, -0.02f);
        rtVertex3f(0.25f, 0.2f, -0.02f);
        rtEnd();
    }
    rtEndObject();
    return object;
}

static void makeObjects(void) {
    meadow = makeMeadow();
    tree = makeTree();
    house = makeHouse();
    wings = makeWings();
    moonlet = rtNewObject(RT_DEFINE);
    rtutSolidSphere(0.11, 16, 12);
    rtEndObject();
}

/* ---- Scenes ----------------------------------------------------------------------------- */

static void place(RTuint object, double x, double y, double z, double turn, double size) {
    rtPushMatrix();
    rtTranslated(x, y, z);
    rtRotated(turn, 0, 1, 0);
    rtScaled(size, size, size);
    rtInstantiateObject(object);
    rtPopMatrix();
}

/* What both scenes have: the same models, here as there. */
static void describeLand(double time) {
    unsigned i;
    rtColor3f(0.36f, 0.55f, 0.2f);
    rtInstantiateObject(meadow);
    for (i = 0; i < (unsigned)trees; ++i) {
        const double angle = kTwoPi * chance(3 * i), far = 2.6 + 6.8 * sqrt(chance(3 * i + 1));
        const double x = far * cos(angle), z = far * sin(angle);
        place(tree, x, hill(x, z) - 0.03, z, 0, 0.6 + 0.8 * chance(3 * i + 2));
    }
    place(house, 0, hill(0, 0), 0, 0, 1);
    rtPushMatrix();
    rtTranslated(0, 2.25, 0.85);
    rtRotated(40 * time, 0, 0, 1);
    rtInstantiateObject(wings);
    rtPopMatrix();
}

static void light(int number, const RTfloat *position, const RTfloat *color, RTfloat fading) {
    const RTenum name = RT_LIGHT0 + (RTenum)number;
    rtEnable(name);
    rtLightfv(name, RT_POSITION, position);
    rtLightfv(name, RT_DIFFUSE, color);
    rtLightf(name, RT_QUADRATIC_ATTENUATION, fading);
}

static void describeDay(double time) {
    static const RTfloat white[] = {1, 0.96f, 0.85f, 1}, blue[] = {0.34f, 0.4f, 0.5f, 1};
    const RTfloat sun[] = {(RTfloat)(12 * cos(0.3 * time)), 10, (RTfloat)(8 * sin(0.3 * time)) + 5,
                           0};
    int i;
    rtClearColor(0.52f, 0.7f, 0.9f, 1);
    rtLightModelfv(RT_LIGHT_MODEL_AMBIENT, blue);
    for (i = 1; i < kLanterns; ++i) rtDisable(RT_LIGHT0 + (RTenum)i);
    light(0, sun, white, 0);
    describeLand(time);
}

/* Lanterns that fly round the mill light what the sun does by day. */
static void describeNight(double time) {
    static const RTfloat dark[] = {0.045f, 0.06f, 0.11f, 1};
    static const RTfloat colors[kLanterns][4] = {{1, 0.6f, 0.22f, 1}, {0.45f, 0.6f, 1, 1},
                                                 {1, 0.35f, 0.4f, 1}, {0.5f, 1, 0.6f, 1}};
    RTfloat positions[kLanterns][4];
    int i;
    rtClearColor(0.015f, 0.02f, 0.05f, 1);
    rtLightModelfv(RT_LIGHT_MODEL_AMBIENT, dark);
    for (i = 0; i < kLanterns; ++i) {
        const double angle = kTwoPi * i / kLanterns + 0.5 * time;
        positions[i][0] = (RTfloat)(3.0 * cos(angle));
        positions[i][1] = (RTfloat)(1.9 + 0.5 * sin(2 * time + i));
        positions[i][2] = (RTfloat)(3.0 * sin(angle));
        positions[i][3] = 1;
        light(i, positions[i], colors[i], 0.16f);
    }
    describeLand(time);
    rtDisable(RT_LIGHTING); /* lanterns shine by themselves, and their light comes from within */
    for (i = 0; i < kLanterns; ++i) {
        rtColor3fv(colors[i]);
        place(moonlet, positions[i][0], positions[i][1] + 0.2, positions[i][2], 0, 1);
    }
    rtEnable(RT_LIGHTING);
}

/* Describes both scenes and queues their frames, which are rendered one with the other. */
static void queueBunch(Bunch *bunch, double time) {
    int scene;
    for (scene = 0; scene < kScenes; ++scene) {
        rtBindScene(scenes[scene]);
        rtSetFrameBuffer(bunch->pixels[scene], (RTuint)width, (RTuint)height, RT_RGBA_8);
        rtMatrixMode(RT_PROJECTION);
        rtLoadIdentity();
        rtPerspective(40, (RTdouble)width / height, 0.1, 100);
        rtMatrixMode(RT_MODELVIEW);
        rtLoadIdentity();
        rtLookAt(9.5 * cos(0.1 * time + 0.9), 4.6, 9.5 * sin(0.1 * time + 0.9), 0, 1.1, 0, 0, 1, 0);
        if (scene == kDay)
            describeDay(time);
        else
            describeNight(time);
        bunch->frames[scene] = rtQueueFrame();
    }
}

/* ---- The window ------------------------------------------------------------------------- */

static void freePictures(void) {
    int i, scene;
    for (i = 0; i < kInFlight; ++i) {
        for (scene = 0; scene < kScenes; ++scene) {
            if (bunches[i].frames[scene]) rtWaitFrame(bunches[i].frames[scene]);
            free(bunches[i].pixels[scene]);
        }
    }
    memset(bunches, 0, sizeof bunches);
}

static void showBunch(const Bunch *bunch) {
    int scene;
    for (scene = 0; scene < kScenes; ++scene) {
        rtWaitFrame(bunch->frames[scene]);
        rtWindowPos2i(scene * width, 0);
        rtDrawPixels(width, height, RT_RGBA, RT_UNSIGNED_BYTE, bunch->pixels[scene]);
    }
}

static void display(void) {
    Bunch *bunch = &bunches[step % kInFlight];
    const double time = 1e-3 * rtutGet(RTUT_ELAPSED_TIME);
    frameBegins();
    rtMakeCurrent(drawn);
    queueBunch(bunch, time);
    if (rtGetError() != RT_NO_ERROR) {
        fprintf(stderr, "day_and_night: %s\n", rtGetErrorText());
        exit(1);
    }
    rtMakeCurrent(shown);
    frameIsDescribed();
    rtClear(RT_COLOR_BUFFER_BIT);
    showBunch(step > 0 ? &bunches[(step - 1) % kInFlight] : bunch);
    ++step;
    rtutSwapBuffers();
}

static void reshape(int newWidth, int newHeight) {
    int i, scene;
    rtViewport(0, 0, (RTsizei)newWidth, (RTsizei)newHeight);
    freePictures();
    step = 0;
    width = newWidth / kScenes > 0 ? newWidth / kScenes : 1;
    height = newHeight;
    for (i = 0; i < kInFlight; ++i)
        for (scene = 0; scene < kScenes; ++scene)
            if (!(bunches[i].pixels[scene] = malloc(4 * (size_t)width * (size_t)height))) exit(1);
}

int main(int argc, char **argv) {
    const Option options[] = {{"--trees", &trees, 0, 1000000, 0},
                              {"--fps", &printsRate, 0, 1, 1}};
    int scene;
    rtutInitWindowSize(1000, 500);
    rtutInit(&argc, argv);
    readOptions(argc, argv, options, 2);
    rtutInitDisplayMode(RTUT_RGB | RTUT_DOUBLE);
    rtutCreateWindow("day_and_night");
    if (printsRate) countFrames("day_and_night");
    shown = rtGetCurrentContext();
    if (!(drawn = rtCreateContext())) return 1;
    rtMakeCurrent(drawn);
    rtFrameDepth(kInFlight * kScenes);
    rtEnable(RT_LIGHTING);
    rtEnable(RT_COLOR_MATERIAL);
    rtEnable(RT_NORMALIZE);
    rtEnable(RT_SHADOWS);
    makeObjects();
    for (scene = 0; scene < kScenes; ++scene) scenes[scene] = rtGenScene();
    rtMakeCurrent(shown);
    rtutDisplayFunc(display);
    rtutReshapeFunc(reshape);
    rtutIdleFunc(rtutPostRedisplay);
    rtutMainLoop();
    return 0;
}

/* SPDX-License-Identifier: MIT */
/* flight: over a landscape without end. A thread of the program's own makes the pieces that come
 * into view; the thread with the context makes objects of those that are ready, between two frames
 * and while earlier ones are rendered, and removes what lies behind. Frames that are under way keep
 * what they show. Pieces that are not ready yet are missing: only the first frame waits.
 * Usage: flight [--cells N] [--pieces N] [--wait] [--fps] [rtut's options, as --rt-offscreen N]
 *   --cells   a piece has so many by so many
 *   --pieces  to be seen in each direction
 *   --wait    each frame waits for all its pieces, so that its picture is always the same */
#include <math.h>
#include <pthread.h>

#include "openrt/rt.h"
#include "openrt/rtut.h"
#include "samples/changing/frame_rate.h"
#include "samples/changing/options.h"

enum { kMaxPieces = 12, kRing = 2 * kMaxPieces + 1, kPlaces = kRing * kRing, kAtATime = 4 };

typedef struct Vertex {
    RTfloat position[3], normal[3], color[3];
} Vertex;

/* A piece of the landscape, at (x, z) in units of its size. */
typedef struct Piece {
    enum { Unused, Wanted, InTheMaking, Ready, Shown } state;
    long x, z;
    Vertex *vertices; /* of (cells + 1)^2 points; from Ready to Shown */
    RTuint object;    /* from Shown on */
} Piece;

static long cells = 48, reach = 7, waits, printsRate;
static RTuint water;

/* The piece at (x, z) has the place (x mod kRing, z mod kRing). Both threads use this. */
static Piece pieces[kPlaces];
static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
static pthread_cond_t changed = PTHREAD_COND_INITIALIZER;
static int leaving;
static long viewerX, viewerZ; /* the piece below the camera: near ones are made first */

/* ---- The landscape ---------------------------------------------------------------------- */

static double lattice(long x, long z) {
    unsigned long n = (unsigned long)x * 374761393UL + (unsigned long)z * 668265263UL;
    n = (n ^ (n >> 13)) * 1274126177UL;
    return (double)((n ^ (n >> 16)) & 0xFFFF) / 65535.0;
}

static double noise(double x, double z) {
    const double fx = floor(x), fz = floor(z);
    double u = x - fx, v = z - fz;
    const long i = (long)fx, k = (long)fz;
    u = u * u * u * (u * (6 * u - 15) + 10);
    v = v * v * v * (v * (6 * v - 15) + 10);
    return (1 - v) * ((1 - u) * lattice(i, k) + u * lattice(i + 1, k)) +
           v * ((1 - u) * lattice(i, k + 1) + u * lattice(i + 1, k + 1));
}

static double heightAt(double x, double z) {
    double height = 0, share = 1, scale = 0.35;
    int octave;
    for (octave = 0; octave < 7; ++octave) {
        const double n = noise(scale * x + 17.3 * octave, scale * z - 9.1 * octave);
        height += share * (octave < 2 ? n : 1 - fabs(2 * n - 1)) * (octave < 2 ? 1 : 0.55);
        share *= 0.47;
        scale *= 2.03;
    }
    return 2.6 * (height - 0.84);
}

static void colorAt(double height, double flat, RTfloat *color) {
    static const RTfloat sand[3] = {0.72f, 0.62f, 0.42f}, grass[3] = {0.2f, 0.36f, 0.1f},
                         rock[3] = {0.38f, 0.34f, 0.31f}, snow[3] = {0.92f, 0.94f, 0.98f};
    const RTfloat *low = height < 0.09 ? sand : flat > 0.62 ? grass : rock;
    const double white = fmin(fmax((height - 0.95) * 3, 0), 1) * (flat > 0.45 ? 1 : 0.4);
    int i;
    for (i = 0; i < 3; ++i) color[i] = (RTfloat)(low[i] + white * (snow[i] - low[i]));
}

static void makeVertices(const Piece *piece, Vertex *vertices) {
    const double step = 1.0 / (double)cells, h = 0.5 * step;
    long i, k;
    for (i = 0; i <= cells; ++i) {
        for (k = 0; k <= cells; ++k) {
            const double x = (double)piece->x + step * (double)i;
            const double z = (double)piece->z + step * (double)k;
            const double y = heightAt(x, z);
            const double nx = heightAt(x - h, z) - heightAt(x + h, z), ny = 2 * h;
            const double nz = heightAt(x, z - h) - heightAt(x, z + h);
            const double length = sqrt(nx * nx + ny * ny + nz * nz);
            Vertex *v = &vertices[i * (cells + 1) + k];
            v->position[0] = (RTfloat)(x - (double)piece->x); /* the instance puts it in place */
            v->position[1] = (RTfloat)y;
            v->position[2] = (RTfloat)(z - (double)piece->z);
            v->normal[0] = (RTfloat)(nx / length);
            v->normal[1] = (RTfloat)(ny / length);
            v->normal[2] = (RTfloat)(nz / length);
            colorAt(y, ny / length, v->color);
        }
    }
}

/* ---- The thread that makes pieces ------------------------------------------------------- */

/* With the mutex held: the nearest piece that is wanted. */
static Piece *nextWanted(void) {
    Piece *best = NULL;
    long nearest = 0;
    int i;
    for (i = 0; i < kPlaces; ++i) {
        Piece *piece = &pieces[i];
        const long dx = piece->x - viewerX, dz = piece->z - viewerZ, far = dx * dx + dz * dz;
        if (piece->state != Wanted || (best && far >= nearest)) continue;
        best = piece;
        nearest = far;
    }
    return best;
}

static void *makePieces(void *unused) {
    (void)unused;
    pthread_mutex_lock(&mutex);
    while (!leaving) {
        Piece *piece = nextWanted();
        Vertex *vertices;
        if (!piece) {
            pthread_cond_wait(&changed, &mutex);
            continue;
        }
        piece->state = InTheMaking; /* now it stays where it is */
        pthread_mutex_unlock(&mutex);
        vertices = malloc((size_t)((cells + 1) * (cells + 1)) * sizeof *vertices);
        if (!vertices) exit(1);
        makeVertices(piece, vertices);
        pthread_mutex_lock(&mutex);
        piece->vertices = vertices;
        piece->state = Ready;
        pthread_cond_broadcast(&changed);
    }
    pthread_mutex_unlock(&mutex);
    return NULL;
}

/* ---- The thread with the context -------------------------------------------------------- */

static Piece *placeOf(long x, long z) {
    return &pieces[((x % kRing) + kRing) % kRing * kRing + ((z % kRing) + kRing) % kRing];
}

static int isInReach(long x, long z) {
    return labs(x - viewerX) <= reach && labs(z - viewerZ) <= reach;
}

static void makeObject(Piece *piece) {
    const Vertex *vertices = piece->vertices;
    long i, k;
    int row;
    piece->object = rtNewObject(RT_DEFINE);
    for (i = 0; i < cells; ++i) {
        rtBegin(RT_QUAD_STRIP);
        for (k = 0; k <= cells; ++k) {
            for (row = 0; row < 2; ++row) {
                const Vertex *v = &vertices[(i + row) * (cells + 1) + k];
                rtColor3fv(v->color);
                rtNormal3fv(v->normal);
                rtVertex3fv(v->position);
            }
        }
        rtEnd();
    }
    rtEndObject();
}

/* Asks for what came into reach, and forgets what left it. With the mutex held. */
static void moveOn(void) {
    long x, z;
    int i;
    for (i = 0; i < kPlaces; ++i) {
        Piece *piece = &pieces[i];
        if (piece->state == Unused || piece->state == InTheMaking || isInReach(piece->x, piece->z))
            continue;
        if (piece->state == Shown) rtRemoveObject(piece->object);
        free(piece->vertices);
        memset(piece, 0, sizeof *piece);
    }
    for (x = viewerX - reach; x <= viewerX + reach; ++x) {
        for (z = viewerZ - reach; z <= viewerZ + reach; ++z) {
            Piece *piece = placeOf(x, z);
            if (piece->state != Unused) continue;
            piece->x = x;
            piece->z = z;
            piece->state = Wanted;
        }
    }
    pthread_cond_broadcast(&changed);
}

/* Makes objects of pieces that are ready: a few, so that no frame waits long for its description,
 * or all, waiting for the other thread. With the mutex held. */
static void takePieces(int all) {
    int i, taken = 0, open, news;
    do {
        open = news = 0;
        for (i = 0; i < kPlaces && (all || taken < kAtATime); ++i) {
            Piece *piece = &pieces[i];
            Vertex *vertices = piece->vertices;
            open |= piece->state == Wanted || piece->state == InTheMaking;
            if (piece->state != Ready) continue;
            pthread_mutex_unlock(&mutex); /* a piece that is ready is this thread's */
            makeObject(piece);
            pthread_mutex_lock(&mutex);
            piece->state = Shown;
            piece->vertices = NULL;
            free(vertices);
            ++taken;
            news = 1; /* the mutex was given away: look again before waiting */
        }
        if (all && open && !news) pthread_cond_wait(&changed, &mutex);
    } while (all && (open || news));
}

static void instantiatePieces(int isWater) {
    int i;
    for (i = 0; i < kPlaces; ++i) {
        const Piece *piece = &pieces[i];
        if (piece->state != Shown || !isInReach(piece->x, piece->z)) continue;
        rtPushMatrix();
        rtTranslated((double)piece->x, 0, (double)piece->z);
        rtInstantiateObject(isWater ? water : piece->object);
        rtPopMatrix();
    }
}

static RTuint makeWater(void) {
    static const RTfloat blue[] = {0.03f, 0.1f, 0.14f, 1};
    const RTuint object = rtNewObject(RT_DEFINE);
    rtMaterialfv(RT_FRONT_AND_BACK, RT_AMBIENT_AND_DIFFUSE, blue);
    rtMaterialf(RT_FRONT_AND_BACK, RT_REFLECTION, 0.55f);
    rtBegin(RT_QUADS);
    rtNormal3f(0, 1, 0);
    rtVertex3f(0, 0, 0);
    rtVertex3f(0, 0, 1);
    rtVertex3f(1, 0, 1);
    rtVertex3f(1, 0, 0);
    rtEnd();
    rtEndObject();
    return object;
}

static void display(void) {
    static const RTfloat sun[] = {0.55f, 0.5f, 0.25f, 0};
    static int isFirst = 1;
    const double time = 1e-3 * rtutGet(RTUT_ELAPSED_TIME);
    const double x = 0.5 + 1.1 * time, z = 2.5 * sin(0.21 * time);
    const double course = atan2(2.5 * 0.21 * cos(0.21 * time), 1.1);
    frameBegins();
    pthread_mutex_lock(&mutex);
    viewerX = (long)floor(x);
    viewerZ = (long)floor(z);
    moveOn();
    takePieces(waits || isFirst);
    isFirst = 0;
    rtClear(RT_COLOR_BUFFER_BIT | RT_DEPTH_BUFFER_BIT);
    rtLoadIdentity();
    rtRotated(-18 * cos(0.21 * time + 0.4), 0, 0, 1);
    rtLookAt(x, 1.9, z, x + cos(course), 1.5, z + sin(course), 0, 1, 0);
    rtLightfv(RT_LIGHT0, RT_POSITION, sun);
    rtEnable(RT_COLOR_MATERIAL);
    instantiatePieces(0);
    rtDisable(RT_COLOR_MATERIAL);
    instantiatePieces(1);
    pthread_mutex_unlock(&mutex);
    frameIsDescribed();
    rtutSwapBuffers();
}

static void reshape(int width, int height) {
    rtViewport(0, 0, (RTsizei)width, (RTsizei)height);
    rtMatrixMode(RT_PROJECTION);
    rtLoadIdentity();
    rtPerspective(50, (RTdouble)width / height, 0.05, 100);
    rtMatrixMode(RT_MODELVIEW);
}

static pthread_t making;

static void stopMaking(void) {
    pthread_mutex_lock(&mutex);
    leaving = 1;
    pthread_cond_broadcast(&changed);
    pthread_mutex_unlock(&mutex);
    pthread_join(making, NULL);
}

int main(int argc, char **argv) {
    static const RTfloat sky[] = {0.6f, 0.73f, 0.87f, 1}, light[] = {1, 0.93f, 0.8f, 1},
                         dim[] = {0.33f, 0.37f, 0.45f, 1};
    const Option options[] = {{"--cells", &cells, 2, 1000, 0},
                              {"--pieces", &reach, 1, kMaxPieces, 0},
                              {"--wait", &waits, 0, 1, 1},
                              {"--fps", &printsRate, 0, 1, 1}};
    rtutInitWindowSize(800, 600);
    rtutInit(&argc, argv);
    readOptions(argc, argv, options, 4);
    rtutInitDisplayMode(RTUT_RGB | RTUT_DEPTH | RTUT_DOUBLE);
    rtutCreateWindow("flight");
    if (printsRate) countFrames("flight");
    rtClearColor(sky[0], sky[1], sky[2], 1);
    rtEnable(RT_DEPTH_TEST);
    rtEnable(RT_LIGHTING);
    rtEnable(RT_LIGHT0);
    rtEnable(RT_SHADOWS);
    rtEnable(RT_REFLECTIONS);
    rtLightfv(RT_LIGHT0, RT_DIFFUSE, light);
    rtLightModelfv(RT_LIGHT_MODEL_AMBIENT, dim);
    rtEnable(RT_FOG);
    rtFogi(RT_FOG_MODE, RT_LINEAR);
    rtFogf(RT_FOG_START, 0.3f * (RTfloat)reach);
    rtFogf(RT_FOG_END, (RTfloat)reach);
    rtFogfv(RT_FOG_COLOR, sky);
    rtObjectHint(RT_BUILD_QUALITY, RT_FASTEST);
    rtObjectHint(RT_LAZY_BUILD, RT_TRUE);
    water = makeWater();
    if (pthread_create(&making, NULL, makePieces, NULL) != 0) return 1;
    atexit(stopMaking);
    rtutDisplayFunc(display);
    rtutReshapeFunc(reshape);
    rtutIdleFunc(rtutPostRedisplay);
    rtutMainLoop();
    return 0;
}

/* SPDX-License-Identifier: MIT */
/* What recordings have to get right, in small frames: contexts, threads, arrays, buffers, textures,
 * lists, queued frames, quadrics, tessellation, misuse. */
#include <math.h>
#include <openrt/rt.h>
#include <openrt/rtu.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 40, HEIGHT = 30 };

static RTubyte pixels[4][WIDTH * HEIGHT * 4 + 64 * HEIGHT];
static float depth[WIDTH * HEIGHT];

static void view(void)
{
    rtViewport(0, 0, WIDTH, HEIGHT);
    rtMatrixMode(RT_PROJECTION);
    rtLoadIdentity();
    rtPerspective(60, (double)WIDTH / HEIGHT, 0.1, 100);
    rtMatrixMode(RT_MODELVIEW);
    rtLoadIdentity();
    rtLookAt(0, 1, 5, 0, 0, 0, 0, 1, 0);
}

static void immediate(void)
{
    static const RTfloat corner[3] = {0, 1, 0};
    rtBegin(RT_TRIANGLES);
    rtColor3ub(255, 128, 0);
    rtVertex3f(-1, -1, 0);
    rtColor3f(0, 1, 0);
    rtVertex3d(1, -1, 0);
    rtVertex3fv(corner);
    rtEnd();
}

static void arrays(void)
{
    RTfloat *positions = malloc(6 * 3 * sizeof(RTfloat));
    RTubyte colors[6][4];
    static const RTushort indices[] = {3, 4, 5, 0, 1, 2};
    for (int i = 0; i < 6; ++i) {
        positions[3 * i] = (RTfloat)cos(i);
        positions[3 * i + 1] = (RTfloat)sin(i);
        positions[3 * i + 2] = -0.25f * (RTfloat)i;
        for (int k = 0; k < 4; ++k) colors[i][k] = (RTubyte)(40 * i + k);
    }
    rtEnableClientState(RT_VERTEX_ARRAY);
    rtEnableClientState(RT_COLOR_ARRAY);
    rtVertexPointer(3, RT_FLOAT, 0, positions);
    rtColorPointer(4, RT_UNSIGNED_BYTE, 4, colors);
    rtDrawArrays(RT_TRIANGLES, 3, 3);
    rtDrawElements(RT_TRIANGLES, 6, RT_UNSIGNED_SHORT, indices);
    rtBegin(RT_TRIANGLES);
    for (int i = 0; i < 3; ++i) rtArrayElement(i);
    rtEnd();
    RTuint buffers[2];
    rtGenBuffers(2, buffers);
    rtBindBuffer(RT_ARRAY_BUFFER, buffers[0]);
    rtBufferData(RT_ARRAY_BUFFER, 6 * 3 * sizeof(RTfloat), NULL, RT_STATIC_DRAW);
    void *mapped = rtMapBuffer(RT_ARRAY_BUFFER, RT_WRITE_ONLY);
    if (mapped) memcpy(mapped, positions, 6 * 3 * sizeof(RTfloat));
    rtUnmapBuffer(RT_ARRAY_BUFFER);
    rtVertexPointer(3, RT_FLOAT, 0, NULL);
    rtBindBuffer(RT_ELEMENT_ARRAY_BUFFER, buffers[1]);
    rtBufferData(RT_ELEMENT_ARRAY_BUFFER, sizeof indices, indices, RT_STATIC_DRAW);
    rtDrawElements(RT_TRIANGLES, 3, RT_UNSIGNED_SHORT, (const void *)6);
    rtBindBuffer(RT_ELEMENT_ARRAY_BUFFER, 0);
    rtBindBuffer(RT_ARRAY_BUFFER, 0);
    rtInterleavedArrays(RT_V3F, 0, positions);
    rtDrawArrays(RT_TRIANGLES, 0, 3);
    rtDisableClientState(RT_VERTEX_ARRAY);
    rtDisableClientState(RT_COLOR_ARRAY);
    memset(positions, 0, 6 * 3 * sizeof(RTfloat));
    free(positions);
}

/* Two texture units; while arrays are drawn another one is the client's. */
static void units(RTuint name)
{
    static const RTfloat positions[][3] = {{0, -2, -1}, {2, -2, -1}, {0, 0, -1}, {2, 0, -1}};
    static const RTshort places[][2] = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
    static const RTfloat others[][4] = {{0, 1, 0, 1}, {2, 3, 0, 1}, {1, 0, 0, 1}, {2, 0, 0, 2}};
    rtActiveTexture(RT_TEXTURE2);
    rtBindTexture(RT_TEXTURE_2D, name);
    rtEnable(RT_TEXTURE_2D);
    rtEnableClientState(RT_VERTEX_ARRAY);
    rtVertexPointer(3, RT_FLOAT, 0, positions);
    rtEnableClientState(RT_TEXTURE_COORD_ARRAY);
    rtTexCoordPointer(2, RT_SHORT, 0, places);
    rtClientActiveTexture(RT_TEXTURE2);
    rtEnableClientState(RT_TEXTURE_COORD_ARRAY);
    rtTexCoordPointer(4, RT_FLOAT, 0, others);
    rtClientActiveTexture(RT_TEXTURE1);
    rtDrawArrays(RT_TRIANGLE_STRIP, 0, 4);
    rtBegin(RT_TRIANGLES);
    for (int i = 3; i > 0; --i) rtArrayElement(i);
    rtEnd();
    rtTexCoordPointer(2, RT_SHORT, 0, NULL);
    for (RTenum unit = RT_TEXTURE2; unit >= RT_TEXTURE0; unit -= 2) {
        rtClientActiveTexture(unit);
        rtDisableClientState(RT_TEXTURE_COORD_ARRAY);
    }
    rtDisableClientState(RT_VERTEX_ARRAY);
    rtMultiTexCoord2f(RT_TEXTURE2, 0, 0);
    rtDisable(RT_TEXTURE_2D);
    rtActiveTexture(RT_TEXTURE0);
}

static void texture(void)
{
    RTubyte image[3][8];
    RTuint names[2];
    for (int y = 0; y < 3; ++y)
        for (int i = 0; i < 8; ++i) image[y][i] = (RTubyte)(30 * i + 10 * y);
    rtGenTextures(2, names);
    rtBindTexture(RT_TEXTURE_2D, names[1]);
    rtPixelStorei(RT_UNPACK_ROW_LENGTH, 2);
    rtPixelStorei(RT_UNPACK_ALIGNMENT, 4);
    rtPixelStorei(RT_UNPACK_SKIP_ROWS, 1);
    rtTexImage2D(RT_TEXTURE_2D, 0, RT_RGB, 2, 2, 0, RT_RGB, RT_UNSIGNED_BYTE, image);
    rtPixelStorei(RT_UNPACK_ROW_LENGTH, 0);
    rtPixelStorei(RT_UNPACK_SKIP_ROWS, 0);
    rtTexImage2D(RT_PROXY_TEXTURE_2D, 0, RT_RGB, 1 << 23, 1 << 23, 0, RT_RGB, RT_UNSIGNED_BYTE,
                 (const void *)1); /* whose pixels nobody reads */
    rtTexParameteri(RT_TEXTURE_2D, RT_TEXTURE_MIN_FILTER, RT_NEAREST);
    rtEnable(RT_TEXTURE_2D);
    rtBegin(RT_QUADS);
    rtTexCoord2f(0, 0);
    rtVertex3f(-2, 0, -1);
    rtTexCoord2f(1, 0);
    rtVertex3f(0, 0, -1);
    rtTexCoord2f(1, 1);
    rtVertex3f(0, 2, -1);
    rtTexCoord2f(0, 1);
    rtVertex3f(-2, 2, -1);
    rtEnd();
    units(names[1]);
    rtDisable(RT_TEXTURE_2D);
    rtDeleteTextures(1, names);
}

static void RTAPIENTRY drawVertex(void *data) { rtVertex3dv(data); }

static void shapes(void)
{
    static RTdouble square[4][3] = {{1, 1, -2}, {2, 1, -2}, {2, 2, -2}, {1, 2, -2}};
    RTUquadric *quadric = rtuNewQuadric();
    rtuQuadricDrawStyle(quadric, RTU_FILL);
    rtuSphere(quadric, 0.3, 8, 6);
    rtuDeleteQuadric(quadric);
    RTUtesselator *tess = rtuNewTess();
    rtuTessCallback(tess, RTU_TESS_BEGIN, (RTUfuncptr)rtBegin);
    rtuTessCallback(tess, RTU_TESS_VERTEX, (RTUfuncptr)drawVertex);
    rtuTessCallback(tess, RTU_TESS_END, (RTUfuncptr)rtEnd);
    rtuTessProperty(tess, 12345, 1); /* no such property */
    rtuTessBeginPolygon(tess, NULL);
    rtuTessBeginContour(tess);
    for (int i = 0; i < 4; ++i) rtuTessVertex(tess, square[i], square[i]);
    rtuTessEndContour(tess);
    rtuTessEndPolygon(tess);
    rtuDeleteTess(tess);
}

static int heard;

static void RTAPIENTRY hear(RTenum code, const char *function, const char *text, void *user)
{
    (void)code, (void)function, (void)text, (void)user;
    ++heard;
    rtGetErrorText();
    if (heard == 2) rtGetError();
}

static void misuse(void)
{
    rtErrorCallback(hear, NULL);
    rtEnd();
    rtBegin(77);
    rtEnable(0x7777);
    rtInstantiateObject(999);
    rtVertex3fv(NULL);
    rtTexImage2D(RT_TEXTURE_2D, 0, RT_RGB, -1, 2, 0, RT_RGB, RT_UNSIGNED_BYTE, NULL);
    rtBegin(RT_TRIANGLES);
    rtClear(RT_COLOR_BUFFER_BIT);
    rtEnd();
    rtLightfv(RT_LIGHT0, 0x7777, (const RTfloat *)1);
    rtBufferData(RT_ARRAY_BUFFER, 100, NULL, RT_STATIC_DRAW);
    rtWaitFrame(4000000);
    rtMakeCurrent((RTcontext)(size_t)4000000);
    while (rtGetError() != RT_NO_ERROR) {
    }
    rtErrorCallback(NULL, NULL);
}

static void queue(RTuint object)
{
    RTuint frames[2];
    rtFrameDepth(3);
    for (int i = 0; i < 2; ++i) {
        rtSetFrameBuffer(pixels[i], WIDTH, HEIGHT, RT_RGB_8);
        rtInstantiateObject(object);
        frames[i] = rtQueueFrame();
    }
    for (int i = 0; i < 2; ++i) rtWaitFrame(frames[i]);
}

static void intersections(void)
{
    static const RTray rays[2] = {{{0, 0, 5}, 0, {0, 0, -1}, 100}, {{9, 9, 9}, 0, {1, 0, 0}, 9}};
    RThit hits[2];
    RTubyte blocked[2];
    const RTuint scene = rtCompileScene();
    rtIntersect(scene, rays, hits, 2, RT_INCOHERENT);
    rtOccluded(scene, rays, blocked, 2, RT_INCOHERENT);
    rtReleaseScene(scene);
}

static void *otherThread(void *context)
{
    rtMakeCurrent(context);
    rtSetFrameBuffer(pixels[3], WIDTH, HEIGHT, RT_BGRA_8);
    view();
    immediate();
    rtRender();
    rtMakeCurrent(NULL);
    return NULL;
}

static void *waitForFrame(void *frame)
{
    rtWaitFrame(*(RTuint *)frame);
    return NULL;
}

/* Frames that go to the same memory: two are queued and waited for in a way, five follow. */
static void sameMemory(const char *way)
{
    RTuint frames[2];
    pthread_t thread;
    rtSetFrameBuffer(pixels[0], WIDTH, HEIGHT, RT_RGBA_8);
    view();
    for (int i = 0; i < 2; ++i) {
        immediate();
        frames[i] = rtQueueFrame();
    }
    if (strcmp(way, "finished") == 0) rtFinish();
    if (strcmp(way, "read") == 0) rtReadPixels(0, 0, 1, 1, RT_RGBA, RT_UNSIGNED_BYTE, pixels[1]);
    if (strcmp(way, "forwards") == 0) rtWaitFrame(frames[0]);
    if (strcmp(way, "forwards") == 0 || strcmp(way, "backwards") == 0) rtWaitFrame(frames[1]);
    if (strcmp(way, "backwards") == 0) rtWaitFrame(frames[0]);
    if (strcmp(way, "elsewhere") == 0) {
        pthread_create(&thread, NULL, waitForFrame, &frames[1]);
        pthread_join(thread, NULL);
    }
    if (strcmp(way, "painted over") == 0) {
        while (rtFrameStatus(frames[1]) != RT_DONE) {
        }
        pixels[0][0] ^= 255;
        rtWaitFrame(frames[1]);
    }
    if (strcmp(way, "another context") == 0) {
        rtInit(NULL, NULL);
        rtSetFrameBuffer(pixels[0], WIDTH, HEIGHT, RT_RGBA_8);
    }
    for (int i = 0; i < 5 && strcmp(way, "never") != 0; ++i) {
        view();
        immediate();
        rtRender();
    }
    rtExit();
}

static void *ask(void *none)
{
    rtGetError();
    return none;
}

/* More than a recording has numbers for, one after the other. */
static void manyThreads(void)
{
    pthread_t thread;
    for (int i = 0; i < 65536; ++i)
        if (pthread_create(&thread, NULL, ask, NULL) == 0) pthread_join(thread, NULL);
}

int main(int argc, char **argv)
{
    rtInit(&argc, argv);
    if (argc > 1 && strcmp(argv[1], "many threads") == 0) {
        manyThreads();
        return 0;
    }
    if (argc > 1 && strcmp(argv[1], "threads") != 0) {
        sameMemory(argv[1]);
        return 0;
    }
    rtThreads(1);
    rtSetFrameBuffer(pixels[0], WIDTH, HEIGHT, RT_RGBA_8);
    rtFrameBufferStride(WIDTH * 4 + 64);
    rtSetAuxBuffer(RT_DEPTH, depth, RT_FLOAT);
    view();
    const RTuint object = rtNewObject(RT_DEFINE);
    immediate();
    rtEndObject();
    const RTuint list = rtGenLists(2);
    rtNewList(list, RT_COMPILE);
    immediate();
    arrays();
    rtEndList();
    rtInstantiateObject(object);
    rtCallLists(1, RT_UNSIGNED_INT, &list);
    intersections();
    rtRender();
    rtGenNewShaderClass("Phong", NULL);
    const RTuint shader = rtGenNewShader();
    rtParameter3f(rtParameterHandle("diffuse"), 1, 0.5f, 0.25f);
    arrays();
    texture();
    shapes();
    rtBindShader(0);
    rtRemoveShader(shader);
    misuse();
    RTubyte read[6 * 5 * 4];
    rtReadPixels(10, 10, 6, 5, RT_RGBA, RT_UNSIGNED_BYTE, read);
    rtFinish();
    rtSetAuxBuffer(RT_DEPTH, NULL, 0);
    rtFrameBufferStride(0);
    queue(object);
    const RTcontext first = rtGetCurrentContext(), second = rtCreateContext();
    if (argc > 1) {
        pthread_t thread;
        pthread_create(&thread, NULL, otherThread, second);
        rtMakeCurrent(first);
        rtInstantiateObject(object);
        pthread_join(thread, NULL);
        rtStartRendering();
        rtEndRendering();
    } else {
        otherThread(second);
        rtMakeCurrent(first);
    }
    rtDestroyContext(second);
    rtExit();
    return 0;
}

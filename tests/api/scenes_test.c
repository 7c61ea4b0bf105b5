/* SPDX-License-Identifier: MIT */
/* Several scenes in one context: what fills them, what they share, how they end. */
#include "check.h"
#include "picture.h"

static RTint bound(void) {
    RTint scene = -1;
    rtGetIntegerv(RT_SCENE_BINDING, &scene);
    return scene;
}

static RTint instances(void) {
    RTint count = -1;
    rtGetIntegerv(RT_STAT_INSTANCES, &count);
    return count;
}

/* Each scene holds what was given while it was bound, and is empty after its frame. */
static void everythingGoesToTheBoundScene(void) {
    RTuint a, b, object;
    startPicture();
    CHECK(bound() == 0);
    a = rtGenScene();
    b = rtGenScene();
    CHECK(a == 1 && b == 2 && bound() == 0);
    object = rtNewObject(RT_DEFINE);
    square(-1, -1, 0, 0, 0);
    rtEndObject();

    square(0, 0, 1, 1, 0); /* scene 0: the upper right, loose */
    rtBindScene(a);
    CHECK(bound() == 1);
    rtColor3f(1, 0, 0);
    rtInstantiateObject(object); /* a: the lower left */
    rtBindScene(b);
    rtColor3f(0, 1, 0);
    square(-1, 0, 0, 1, 0); /* b: the upper left, and the object */
    rtInstantiateObject(object);
    rtBindScene(a);
    rtRender();
    CHECK(isColor(at(-0.5f, -0.5f), 1, 0, 0) && isColor(at(0.5f, 0.5f), 0, 0, 0));
    CHECK(isColor(at(-0.5f, 0.5f), 0, 0, 0) && instances() == 1);
    rtRender();
    CHECK(instances() == 0 && isColor(at(-0.5f, -0.5f), 0, 0, 0));
    rtBindScene(b);
    rtRender();
    CHECK(instances() == 2 && isColor(at(-0.5f, 0.5f), 0, 1, 0));
    CHECK(isColor(at(-0.5f, -0.5f), 0, 1, 0));
    rtBindScene(0);
    rtRender();
    CHECK(instances() == 1 && isColor(at(0.5f, 0.5f), 1, 1, 1));
    CHECK(isColor(at(-0.5f, 0.5f), 0, 0, 0));
    CHECK_ERROR(RT_NO_ERROR);
}

/* Lights, camera, environment and rendering object are the scene's; each may be used in several. */
static void shadersOfAScene(void) {
    RTuint environment, light, scene;
    startPicture();
    rtGenNewShaderClass("ConstantEnvironment", NULL);
    environment = rtGenNewShader();
    rtParameter3f(rtParameterHandle("radiance"), 0, 0, 1);
    rtGenNewShaderClass("PointLight", NULL);
    light = rtGenNewShader();
    scene = rtGenScene();
    rtUseEnvironmentShader(environment);
    rtUseLight(light);
    rtBindScene(scene);
    rtUseLight(light);
    CHECK_ERROR(RT_NO_ERROR);
    rtUseLight(light);
    CHECK_ERROR(RT_INVALID_OPERATION);
    rtRender();
    CHECK(isColor(at(0, 0), 0, 0, 0));
    rtBindScene(0);
    rtUseLight(light);
    CHECK_ERROR(RT_INVALID_OPERATION);
    rtRender();
    CHECK(isColor(at(0, 0), 0, 0, 1));
    rtUseEnvironmentShader(environment);
    CHECK_ERROR(RT_NO_ERROR);
}

/* Matrices, current values and hints belong to the context. */
static void theContextsStateIsShared(void) {
    RTfloat color[4];
    RTuint scene;
    startPicture();
    scene = rtGenScene();
    rtColor3f(0.5f, 0.25f, 0);
    rtTranslatef(0.5f, 0, 0);
    rtBindScene(scene);
    rtGetFloatv(RT_CURRENT_COLOR, color);
    CHECK(color[0] == 0.5f && color[1] == 0.25f);
    square(-0.5f, -1, 0.5f, 1, 0);
    rtRender();
    CHECK(isColor(at(0.1f, 0), 0.5f, 0.25f, 0) && isColor(at(-0.1f, 0), 0, 0, 0));
    CHECK_ERROR(RT_NO_ERROR);
}

/* A run of loose primitives goes on where it was left, with the attributes of the moment. */
static void looseRunsGoOn(void) {
    RTuint scene;
    startPicture();
    scene = rtGenScene();
    rtColor3f(1, 0, 0);
    square(-1, -1, 0, 0, 0);
    rtBindScene(scene);
    rtColor3f(0, 1, 0); /* while another scene is bound */
    square(-1, -1, 1, 1, 0);
    rtBindScene(0);
    square(0, 0, 1, 1, 0);
    rtColor3f(1, 0, 0);
    square(-1, 0, 0, 1, 0);
    rtRender();
    CHECK(instances() == 1);
    CHECK(isColor(at(-0.5f, -0.5f), 1, 0, 0) && isColor(at(0.5f, 0.5f), 0, 1, 0));
    CHECK(isColor(at(-0.5f, 0.5f), 1, 0, 0) && isColor(at(0.5f, -0.5f), 0, 0, 0));
    CHECK_ERROR(RT_NO_ERROR);
}

/* The same for normals and texture coordinates, seen by a shader that shows the normal. */
static void looseRunsKeepTheirNormals(void) {
    static float normals[PICTURE_SIZE][PICTURE_SIZE][3];
    RTuint scene;
    startPicture();
    rtSetAuxBuffer(RT_NORMAL, normals, RT_RGB_32F);
    scene = rtGenScene();
    square(-1, -1, 0, 1, 0); /* no normal so far: the triangle's own */
    rtBindScene(scene);
    rtNormal3f(0.6f, 0, 0.8f);
    rtBindScene(0);
    square(0, -1, 1, 1, 0);
    rtRender();
    CHECK(normals[8][4][0] == 0 && normals[8][4][2] == 1);
    CHECK(fabsf(normals[8][12][0] - 0.6f) < 1e-5f && fabsf(normals[8][12][2] - 0.8f) < 1e-5f);
    CHECK_ERROR(RT_NO_ERROR);
}

static void deleting(void) {
    RTuint a, b;
    startPicture();
    a = rtGenScene();
    b = rtGenScene();
    square(-1, -1, 1, 1, 0);
    rtBindScene(b);
    rtDeleteScene(a);
    CHECK(bound() == (RTint)b);
    rtBindScene(a);
    CHECK_ERROR(RT_INVALID_VALUE);
    CHECK(bound() == (RTint)b);
    rtDeleteScene(a);
    CHECK_ERROR(RT_INVALID_VALUE);
    square(-1, -1, 0, 0, 0);
    rtDeleteScene(b); /* the bound one */
    CHECK(bound() == 0);
    rtDeleteScene(0); /* ignored, with all that is in it */
    CHECK(bound() == 0);
    CHECK_ERROR(RT_NO_ERROR);
    rtRender();
    CHECK(isColor(at(0.5f, 0.5f), 1, 1, 1));
    CHECK(rtGenScene() == 3); /* ids are not used again */
    CHECK_ERROR(RT_NO_ERROR);
}

/* rtFinish knows for each scene what its picture shows already. */
static void finishing(void) {
    RTuint scene;
    startPicture();
    scene = rtGenScene();
    square(-1, -1, 0, 0, 0);
    rtFinish();
    rtBindScene(scene);
    square(0, 0, 1, 1, 0);
    rtFinish();
    CHECK(isColor(at(0.5f, 0.5f), 1, 1, 1) && isColor(at(-0.5f, -0.5f), 0, 0, 0));
    memset(picture, 0, sizeof picture);
    rtBindScene(0);
    rtFinish(); /* nothing new in either */
    rtBindScene(scene);
    rtFinish();
    CHECK(isColor(at(0.5f, 0.5f), 0, 0, 0) && isColor(at(-0.5f, -0.5f), 0, 0, 0));
    CHECK_ERROR(RT_NO_ERROR);
}

/* Compiled scenes are of the bound one, and stay when it goes. */
static void queries(void) {
    const RTray ray = {{0.5f, 0.5f, 5}, 0, {0, 0, -1}, 100};
    RThit hit;
    RTuint scene, empty, full;
    startPicture();
    scene = rtGenScene();
    rtBindScene(scene);
    square(0, 0, 1, 1, 2);
    full = rtCompileScene();
    rtBindScene(0);
    empty = rtCompileScene();
    rtDeleteScene(scene);
    rtIntersect(full, &ray, &hit, 1, RT_INCOHERENT);
    CHECK(hit.t == 3 && hit.instance == 0);
    rtIntersect(empty, &ray, &hit, 1, RT_INCOHERENT);
    CHECK(hit.instance == RT_INVALID);
    rtReleaseScene(full);
    rtReleaseScene(empty);
    CHECK_ERROR(RT_NO_ERROR);
}

/* Ids of one context mean nothing in another. */
static void otherContexts(void) {
    RTcontext first, second;
    RTuint scene;
    startPicture();
    first = rtGetCurrentContext();
    rtGenScene();
    scene = rtGenScene();
    second = rtCreateContext();
    rtMakeCurrent(second);
    rtBindScene(scene);
    CHECK_ERROR(RT_INVALID_VALUE);
    CHECK(rtGenScene() == 1);
    rtDestroyContext(second);
    rtMakeCurrent(first);
    rtBindScene(scene);
    CHECK_ERROR(RT_NO_ERROR);
}

int main(void) {
    CHECK(rtGenScene() == RT_INVALID); /* no context */
    rtBindScene(0);
    rtDeleteScene(0);
    everythingGoesToTheBoundScene();
    shadersOfAScene();
    theContextsStateIsShared();
    looseRunsGoOn();
    looseRunsKeepTheirNormals();
    deleting();
    finishing();
    queries();
    otherContexts();
    rtExit();
    return failureCount;
}

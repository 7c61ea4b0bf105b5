/* SPDX-License-Identifier: MIT */
/* Objects and instances: coordinates, attributes, nesting, reshading, redefinition, order. */
#include "check.h"
#include "picture.h"

static RTuint constant(float r, float g, float b) {
    RTuint shader;
    rtGenNewShaderClass("ConstantShader", NULL);
    shader = rtGenNewShader();
    rtParameter3f(rtParameterHandle("value"), r, g, b);
    rtBindShaderClass(0);
    return shader;
}

static RTuint unitSquare(void) {
    const RTuint object = rtNewObject(RT_DEFINE);
    square(0, 0, 1, 1, 0);
    rtEndObject();
    return object;
}

static RTint statistic(RTenum name) {
    RTint value = -1;
    rtGetIntegerv(name, &value);
    return value;
}

/* The hit of a ray along -z through a point of the view. */
static RThit hitAt(float x, float y) {
    RTray ray = {{0, 0, 20}, 0, {0, 0, -1}, INFINITY};
    RThit hit;
    const RTuint scene = rtCompileScene();
    ray.origin[0] = x;
    ray.origin[1] = y;
    rtIntersect(scene, &ray, &hit, 1, RT_INCOHERENT);
    rtReleaseScene(scene);
    return hit;
}

static void coordinates(void) {
    RTuint object, both;
    RTfloat m[16], color[4];
    startPicture();
    rtTranslatef(5, 5, 5); /* the matrix in force at rtNewObject is not the object's */
    rtColor3f(0.5f, 0.5f, 0.5f);
    rtMatrixMode(RT_PROJECTION);
    object = rtNewObject(RT_DEFINE);
    CHECK(statistic(RT_MATRIX_MODE) == RT_MODELVIEW);
    rtGetFloatv(RT_MODELVIEW_MATRIX, m);
    CHECK(m[12] == 0 && m[0] == 1);
    rtColor3f(0, 1, 0);
    rtTranslatef(-1, -1, 0); /* places a part of the object */
    square(0, 0, 1, 1, 0);
    rtPushMatrix(); /* what stays pushed is forgotten */
    rtEndObject();
    CHECK(statistic(RT_MATRIX_MODE) == RT_PROJECTION);
    CHECK(statistic(RT_MODELVIEW_STACK_DEPTH) == 1);
    rtGetFloatv(RT_MODELVIEW_MATRIX, m);
    CHECK(m[12] == 5);
    rtGetFloatv(RT_CURRENT_COLOR, color);
    CHECK(color[0] == 0.5f && color[1] == 0.5f);
    rtMatrixMode(RT_MODELVIEW);
    rtLoadIdentity();
    rtInstantiateObject(object);

    /* RT_DEFINE_AND_INSTANTIATE: with the matrix in force at rtNewObject. */
    rtTranslatef(0, 0, 1);
    rtColor3f(0, 0, 1);
    both = rtNewObject(RT_DEFINE_AND_INSTANTIATE);
    rtTranslatef(0, 0, -3);
    square(0, 0, 1, 1, 0);
    rtEndObject();
    CHECK(hitAt(0.5f, 0.5f).t == 22 && hitAt(0.5f, 0.5f).object == both);
    rtRender();
    CHECK(isColor(at(-0.5f, -0.5f), 0, 1, 0));
    CHECK(isColor(at(0.5f, 0.5f), 0, 0, 1)); /* its colour is that at rtNewObject */
    CHECK(isColor(at(0.5f, -0.5f), 0, 0, 0));
    CHECK_ERROR(RT_NO_ERROR);
}

/* Attributes that the object does not set come from the instance; after it sets them, its own. */
static void inheritance(void) {
    RTuint object, outer;
    startPicture();
    object = rtNewObject(RT_DEFINE);
    square(-1, -1, 0, 0, 0);
    rtColor3f(1, 0, 0);
    square(0, -1, 1, 0, 0);
    rtEndObject();
    rtColor3f(0, 0, 1);
    rtInstantiateObject(object);
    rtColor3f(0, 1, 0);
    rtTranslatef(0, 1, 0);
    rtInstantiateObject(object);
    rtRender();
    CHECK(isColor(at(-0.5f, -0.5f), 0, 0, 1) && isColor(at(0.5f, -0.5f), 1, 0, 0));
    CHECK(isColor(at(-0.5f, 0.5f), 0, 1, 0) && isColor(at(0.5f, 0.5f), 1, 0, 0));

    /* Through a level of nesting: the outer object's colour where it has set one, else that of
     * its instance. */
    rtLoadIdentity();
    outer = rtNewObject(RT_DEFINE);
    rtInstantiateObject(object);
    rtColor3f(1, 1, 0);
    rtTranslatef(0, 1, 0);
    rtInstantiateObject(object);
    rtEndObject();
    rtColor3f(0, 1, 1);
    rtInstantiateObject(outer);
    rtRender();
    CHECK(isColor(at(-0.5f, -0.5f), 0, 1, 1) && isColor(at(0.5f, -0.5f), 1, 0, 0));
    CHECK(isColor(at(-0.5f, 0.5f), 1, 1, 0) && isColor(at(0.5f, 0.5f), 1, 0, 0));
    CHECK_ERROR(RT_NO_ERROR);
}

static void nesting(void) {
    RTuint objects[10], top;
    RThit hit;
    int level;
    startPicture();
    objects[0] = unitSquare();
    for (level = 1; level < 8; ++level) {
        objects[level] = rtNewObject(RT_DEFINE);
        rtTranslatef(0, 0, 1);
        rtInstantiateObject(objects[level - 1]);
        rtEndObject();
    }
    CHECK_ERROR(RT_NO_ERROR);
    rtInstantiateObject(objects[7]);
    hit = hitAt(0.5f, 0.25f);
    CHECK(hit.t == 13 && hit.object == objects[0] && hit.instance == 0 && hit.primitive == 0);

    /* One more level is too many; the object under definition stays open and sound. */
    top = rtNewObject(RT_DEFINE);
    rtInstantiateObject(objects[7]);
    CHECK_ERROR(RT_STACK_OVERFLOW);
    rtInstantiateObject(top);
    CHECK_ERROR(RT_INVALID_OPERATION);
    rtTranslatef(0, 0, 2);
    rtInstantiateObject(objects[6]);
    rtEndObject();
    CHECK_ERROR(RT_NO_ERROR);
    rtRotatef(180, 0, 0, 1);
    rtInstantiateObject(top);
    hit = hitAt(-0.5f, -0.25f);
    CHECK(hit.t == 12 && hit.object == objects[0] && hit.instance == 1);
}

static void redefinition(void) {
    RTuint object, user;
    RThit hit;
    startPicture();
    object = unitSquare();
    user = rtNewObject(RT_DEFINE);
    rtInstantiateObject(object);
    rtEndObject();
    rtInstantiateObject(object); /* this frame's instance keeps the geometry of now */

    rtReplaceObject(object);
    square(0, 0, 1, 1, 7);
    CHECK(hitAt(0.5f, 0.25f).t == 20); /* the old one stands until the end */
    rtInstantiateObject(object);
    CHECK_ERROR(RT_INVALID_OPERATION);
    rtEndObject();
    CHECK(hitAt(0.5f, 0.25f).t == 20);
    rtTranslatef(-1, 0, 0);
    rtInstantiateObject(object);
    CHECK(hitAt(-0.5f, 0.25f).t == 13);
    rtTranslatef(0, -1, 0);
    rtInstantiateObject(user); /* nests the old one */
    hit = hitAt(-0.5f, -0.25f);
    CHECK(hit.t == 20 && hit.object == object && hit.instance == 2);

    /* A removed object lives on where it is used; its id is never used again. */
    rtRemoveObject(object);
    rtInstantiateObject(object);
    CHECK_ERROR(RT_INVALID_VALUE);
    rtRemoveObject(object);
    CHECK_ERROR(RT_INVALID_VALUE);
    CHECK(hitAt(-0.5f, 0.25f).object == object);
    CHECK(unitSquare() > user);
    rtRender();
    CHECK(at(0.5f, 0.5f)[0] == 1);
    CHECK_ERROR(RT_NO_ERROR);
}

static void reshading(void) {
    RTuint red, green, blue, object, outer, set[2];
    RTint count = 0, list[4] = {0};
    RTint built;
    startPicture();
    red = constant(1, 0, 0);
    green = constant(0, 1, 0);
    blue = constant(0, 0, 1);
    object = rtNewObject(RT_DEFINE);
    rtBindShader(red);
    square(-1, -1, 0, 0, 0);
    rtBindShader(green);
    square(0, -1, 1, 0, 0);
    rtBindShader(red);
    square(-1, 0, 0, 1, 0);
    rtEndObject();
    rtGetObjectiv(object, RT_OBJECT_SHADER_COUNT, &count);
    rtGetObjectiv(object, RT_OBJECT_SHADERS, list);
    CHECK(count == 2 && list[0] == (RTint)red && list[1] == (RTint)green && list[2] == 0);

    built = statistic(RT_STAT_MODELS_BUILT);
    rtInstantiateObjectShader(object, blue);
    rtRender();
    CHECK(isColor(at(-0.5f, -0.5f), 0, 0, 1) && isColor(at(0.5f, -0.5f), 0, 0, 1));

    set[0] = 0;
    set[1] = blue;
    rtInstantiateObjectShaders(object, 2, set);
    rtRender();
    CHECK(isColor(at(-0.5f, -0.5f), 1, 0, 0) && isColor(at(0.5f, -0.5f), 0, 0, 1));
    CHECK(isColor(at(-0.5f, 0.5f), 1, 0, 0));

    set[0] = green;
    rtInstantiateObjectShaders(object, 1, set);
    rtRender();
    CHECK(isColor(at(-0.5f, -0.5f), 0, 1, 0) && isColor(at(-0.5f, 0.5f), 0, 1, 0));
    rtInstantiateObjectShaders(object, 0, NULL);
    rtRender();
    CHECK(isColor(at(-0.5f, -0.5f), 1, 0, 0));
    CHECK(statistic(RT_STAT_MODELS_BUILT) == built); /* nothing was built for any of it */

    /* Nested objects inherit the replacement by shader. */
    outer = rtNewObject(RT_DEFINE);
    rtInstantiateObject(object);
    rtEndObject();
    rtGetObjectiv(outer, RT_OBJECT_SHADER_COUNT, &count);
    CHECK(count == 2);
    set[0] = blue;
    set[1] = 0;
    rtInstantiateObjectShaders(outer, 2, set);
    rtRender();
    CHECK(isColor(at(-0.5f, -0.5f), 0, 0, 1) && isColor(at(0.5f, -0.5f), 0, 1, 0));

    /* A removed shader lives on in the object. */
    rtRemoveShader(red);
    rtInstantiateObject(object);
    rtRender();
    CHECK(isColor(at(-0.5f, -0.5f), 1, 0, 0));
    CHECK_ERROR(RT_NO_ERROR);
}

/* Loose primitives: each longest run between instances is one, in its place. */
static void looseGeometry(void) {
    RTuint object;
    RThit hit;
    startPicture();
    object = unitSquare();
    rtColor3f(1, 0, 0);
    square(-1, -1, -0.5f, -0.5f, 0); /* instance 0, primitives 0 and 1 */
    rtColor3f(0, 1, 0);
    rtTranslatef(0.5f, 0, 0);
    square(-1, -1, -0.5f, -0.5f, 0); /* the same run: primitives 2 and 3 */
    CHECK(hitAt(-0.25f, -0.75f).primitive >= 2 && hitAt(-0.25f, -0.75f).instance == 0);
    unitSquare(); /* definitions do not end a run, nor does rtCompileScene */
    rtColor3f(0, 0, 1);
    rtTranslatef(0.5f, 0, 0);
    square(-1, -1, -0.5f, -0.5f, 0);
    hit = hitAt(0.2f, -0.7f);
    CHECK(hit.object == 0 && hit.instance == 0 && hit.primitive == 5);
    rtLoadIdentity();
    rtInstantiateObject(object); /* instance 1 */
    rtBegin(RT_TRIANGLES);       /* no complete triangle: no instance */
    rtVertex3f(0, 0, 0);
    rtEnd();
    rtInstantiateObject(object); /* instance 2: the same place, so 1 is hit first */
    rtColor3f(1, 1, 1);
    square(-1, 0, 0, 1, 0); /* instance 3 */
    hit = hitAt(0.5f, 0.25f);
    CHECK(hit.object == object && hit.instance == 1 && hit.primitive == 0);
    hit = hitAt(-0.5f, 0.25f);
    CHECK(hit.object == 0 && hit.instance == 3);
    rtRender();
    CHECK(isColor(at(-0.75f, -0.75f), 1, 0, 0) && isColor(at(-0.25f, -0.75f), 0, 1, 0));
    CHECK(isColor(at(0.25f, -0.75f), 0, 0, 1) && isColor(at(-0.5f, 0.5f), 1, 1, 1));
    CHECK(statistic(RT_STAT_INSTANCES) == 4);
    rtRender(); /* given anew every frame */
    CHECK(isColor(at(-0.75f, -0.75f), 0, 0, 0));
    CHECK(statistic(RT_STAT_INSTANCES) == 0);
    CHECK_ERROR(RT_NO_ERROR);
}

/* Vertices that are not finite drop their triangles, which keep their numbers. */
static void droppedTriangles(void) {
    startPicture();
    rtBegin(RT_TRIANGLES);
    rtVertex3f(-1, -1, 0);
    rtVertex3f(0, -1, 0);
    rtVertex3f(-1, NAN, 0);
    rtVertex4f(0, 0, 0, 0);
    rtVertex3f(1, 0, 0);
    rtVertex3f(0, 1, 0);
    rtVertex4f(0, 0, 0, 2);
    rtVertex4f(2, 0, 0, 2);
    rtVertex4f(0, 2, 0, 2);
    rtVertex3d(0, 0, 1e300);
    rtVertex3d(1, 0, 0);
    rtVertex3d(1, 1, 0);
    rtEnd();
    CHECK(hitAt(0.25f, 0.25f).primitive == 2);
    CHECK(hitAt(-0.75f, -0.75f).primitive == RT_INVALID);
    rtRender();
    CHECK(statistic(RT_STAT_DROPPED_TRIANGLES) == 3);
    CHECK_ERROR(RT_NO_ERROR);

    /* A matrix without an inverse: never hit, counted, and it keeps its number. */
    {
        const RTuint object = unitSquare();
        RTuint empty;
        rtScalef(1, 0, 1);
        rtInstantiateObject(object);
        rtLoadIdentity();
        empty = rtNewObject(RT_DEFINE);
        rtEndObject();
        rtInstantiateObject(empty);
        rtInstantiateObject(object);
        CHECK(hitAt(0.5f, 0.25f).instance == 2);
        rtRender();
        CHECK(statistic(RT_STAT_DROPPED_INSTANCES) == 1);
        CHECK_ERROR(RT_NO_ERROR);
    }
}

/* The triangles of each kind of primitive, in the order given. */
static void primitives(void) {
    static const struct {
        RTenum mode;
        float xy[6][2];
        int count;
        RTuint primitive; /* at (0.7, 0.2) */
    } cases[] = {
        {RT_TRIANGLES, {{-1, 0}, {-1, -1}, {0, -1}, {0, 0}, {1, 0}, {1, 1}}, 6, 1},
        {RT_TRIANGLE_STRIP, {{0, 1}, {0, 0}, {1, 1}, {1, 0}}, 4, 1},
        {RT_TRIANGLE_FAN, {{0, 0}, {0, 1}, {1, 1}, {1, 0}}, 4, 1},
        {RT_QUADS, {{0, 1}, {0, 0}, {1, 0}, {1, 1}, {9, 9}, {9, 8}}, 6, 0},
        {RT_QUAD_STRIP, {{0, 1}, {0, 0}, {1, 1}, {1, 0}, {2, 2}}, 5, 0},
        {RT_POLYGON, {{0, 0}, {0, 1}, {1, 1}, {1, 0}}, 4, 1}};
    int i, k;
    for (i = 0; i < (int)(sizeof cases / sizeof cases[0]); ++i) {
        startPicture();
        rtBegin(cases[i].mode);
        for (k = 0; k < cases[i].count; ++k) rtVertex2f(cases[i].xy[k][0], cases[i].xy[k][1]);
        rtEnd();
        CHECK(hitAt(0.7f, 0.2f).primitive == cases[i].primitive);
        CHECK(hitAt(0.7f, -0.2f).primitive == RT_INVALID);
        CHECK_ERROR(RT_NO_ERROR);
    }
}

int main(void) {
    coordinates();
    inheritance();
    nesting();
    redefinition();
    reshading();
    looseGeometry();
    droppedTriangles();
    primitives();
    rtExit();
    return failureCount;
}

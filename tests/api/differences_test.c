/* SPDX-License-Identifier: MIT */
/* Where the library deliberately differs from SMART (2009): one function for each difference. */
#include "check.h"
#include "openrt/rts.h"
#include "picture.h"

/* The surface's colour, light half of which passes; and where its transparency was asked. */
static int transparencyCalls;
static int constructNothing(void *shader, void *triangle, void *vertex) {
    (void)shader, (void)triangle, (void)vertex;
    return 0;
}
static int shadeBlue(const void *shader, RTSstate *state) {
    (void)shader;
    rtsResultColor(state, 0, 0, 1);
    return 0;
}
static int halfTransparent(const void *shader, RTSstate *state, float rgb[3]) {
    (void)shader, (void)state;
    __atomic_add_fetch(&transparencyCalls, 1, __ATOMIC_RELAXED);
    rgb[0] = 0.5f, rgb[1] = 0.25f, rgb[2] = 1;
    return 0;
}
static int neverIlluminates(const void *shader, const float position[3], RTSlightsample *sample) {
    (void)shader, (void)position;
    sample->direction[0] = sample->direction[1] = 0;
    sample->direction[2] = 1;
    sample->distance = INFINITY;
    sample->radiance[0] = sample->radiance[1] = sample->radiance[2] = 1000;
    return 0;
}
/* Traces on with the weight of a shader parameter, and adds one. */
static int traceOn(const void *shader, RTSstate *state) {
    const float back[3] = {0, 0, 1}, forth[3] = {0, 0, -1};
    float radiance[3] = {0, 0, 0};
    const float weight = state->weight * *(const float *)shader;
    rtsTraceRay(state, state->position, state->rayDirection[2] < 0 ? back : forth, weight,
                radiance);
    rtsResultColor(state, radiance[0] + 1, 0, 0);
    return 0;
}
static int constructWeight(void *shader, void *triangle, void *vertex) {
    (void)triangle, (void)vertex;
    *(float *)shader = 1;
    return 0;
}

static RTshaderclass classOf(const char *name, RTenum kind) {
    RTshaderclass c = {0};
    c.structSize = sizeof c;
    c.interfaceVersion = RTS_INTERFACE_VERSION;
    c.kind = kind;
    c.name = name;
    c.alignment = 4;
    c.construct = constructNothing;
    return c;
}

static RTuint pointLight(float x, float y, float z, float radiance) {
    RTuint light;
    rtGenNewShaderClass("SpotLightShader", NULL);
    light = rtGenNewShader();
    rtParameter3f(rtParameterHandle("position"), x, y, z);
    rtParameter3f(rtParameterHandle("radiance"), radiance, radiance, radiance);
    return light;
}
static RTuint diffuse(const char *className, const char *color) {
    RTuint shader;
    rtGenNewShaderClass(className, NULL);
    shader = rtGenNewShader();
    rtParameter3f(rtParameterHandle(color), 1, 1, 1);
    return shader;
}
static RTint get(RTenum name) {
    RTint value = -1;
    rtGetIntegerv(name, &value);
    return value;
}
static RThit hitFrom(float x, float y, float z, float dz) {
    const RTray ray = {{x, y, z}, 0, {0, 0, dz}, INFINITY};
    RThit hit;
    const RTuint scene = rtCompileScene();
    rtIntersect(scene, &ray, &hit, 1, RT_INCOHERENT);
    rtReleaseScene(scene);
    return hit;
}

static void errorsAreCleared(void) {
    startPicture();
    rtEnd();
    CHECK(rtGetError() == RT_INVALID_OPERATION && rtGetError() == RT_NO_ERROR);
}

static void defineAndInstantiateInstantiates(void) {
    startPicture();
    rtNewObject(RT_COMPILE_AND_EXECUTE);
    square(-1, -1, 1, 1, 0);
    rtEndObject();
    rtRender();
    CHECK(at(0, 0)[0] == 1);
}

static void looseGeometryIsVisible(void) {
    startPicture(); /* and needs no shader, camera, light or environment */
    rtClearColor(0, 0.5f, 0, 1);
    square(-1, -1, 0, 1, 0);
    rtRender();
    CHECK(isColor(at(-0.5f, 0), 1, 1, 1) && isColor(at(0.5f, 0), 0, 0.5f, 0));
    CHECK_ERROR(RT_NO_ERROR);
}

static void namesCompareByText(void) {
    char name[] = {'v', 'a', 'l', 'u', 'e', 0};
    startPicture();
    rtGenNewShaderClass("ConstantShader", NULL);
    CHECK(rtParameterHandle(name) == rtParameterHandle("value"));
    CHECK_ERROR(RT_NO_ERROR);
}

static void transparencyIsAskedByShadowRays(void) {
    RTshaderclass glass = classOf("HalfGlass", RT_SURFACE_SHADER);
    RTuint light, floor, object;
    float unshadowed;
    int shadowed;
    startPicture();
    light = pointLight(0, 0, 100, 10000);
    floor = diffuse("Phong", "diffuse");
    glass.shade = shadeBlue;
    glass.transparency = halfTransparent;
    rtRegisterShaderClass(&glass);
    rtGenNewShader();
    object = rtNewObject(RT_DEFINE); /* above the view */
    square(-1, -1, 1, 1, 20);
    rtEndObject();
    rtBindShader(floor);
    for (shadowed = 0; shadowed < 2; ++shadowed) {
        transparencyCalls = 0;
        rtUseLight(light);
        square(-1, -1, 1, 1, 0);
        if (shadowed) rtInstantiateObject(object);
        rtRender();
        if (shadowed) break;
        unshadowed = at(0, 0)[0];
        CHECK(unshadowed > 0.1f && transparencyCalls == 0);
    }
    CHECK(transparencyCalls > 0);
    CHECK(fabsf(at(0, 0)[0] - 0.5f * unshadowed) < 1e-4f);
    CHECK(fabsf(at(0, 0)[1] - 0.25f * unshadowed) < 1e-4f);
    CHECK(fabsf(at(0, 0)[2] - unshadowed) < 1e-4f);
    CHECK_ERROR(RT_NO_ERROR);
}

static void normalsUseTheInverseTranspose(void) {
    /* A slope of 45 degrees with its normal, flattened to a tenth: the normal turns to the
     * viewer. Diffuse light straight from the viewer shows the cosine. */
    const float expected = 10 / sqrtf(101);
    int nested;
    for (nested = 0; nested < 2; ++nested) {
        RTuint light, object;
        startPicture();
        light = pointLight(0, 0, 1000, 1000000);
        diffuse("DiffuseShader", "color");
        if (nested) {
            object = rtNewObject(RT_DEFINE);
        } else {
            rtScalef(1, 1, 0.1f);
        }
        rtNormal3f(-1, 0, 1);
        rtBegin(RT_QUADS);
        rtVertex3f(-1, -1, -1);
        rtVertex3f(1, -1, 1);
        rtVertex3f(1, 1, 1);
        rtVertex3f(-1, 1, -1);
        rtEnd();
        if (nested) {
            rtEndObject();
            rtScalef(1, 1, 0.1f);
            rtInstantiateObject(object);
        }
        rtUseLight(light);
        rtRender();
        CHECK(fabsf(at(0, 0)[0] - expected) < 2e-3f);
        CHECK_ERROR(RT_NO_ERROR);
    }
}

static void oddStripTrianglesAreTurned(void) {
    RThit even, odd;
    startPicture();
    rtBegin(RT_TRIANGLE_STRIP);
    rtVertex2f(0, 0);
    rtVertex2f(1, 0);
    rtVertex2f(0, 1);
    rtVertex2f(1, 1);
    rtEnd();
    even = hitFrom(0.25f, 0.25f, 1, -1);
    odd = hitFrom(0.75f, 0.75f, 1, -1);
    CHECK(even.primitive == 0 && even.normal[2] == 1);
    CHECK(odd.primitive == 1 && odd.normal[2] == 1 && odd.flags == 0);
}

static void quadsSplitAlongFirstAndThird(void) {
    startPicture();
    square(0, 0, 1, 1, 0);
    CHECK(hitFrom(0.75f, 0.25f, 1, -1).primitive == 0);
    CHECK(hitFrom(0.25f, 0.75f, 1, -1).primitive == 1);
}

static void noTriangleIsTooSmall(void) {
    static const float scales[] = {1e-18f, 1e-9f, 1, 1e9f, 1e15f};
    int i;
    for (i = 0; i < 5; ++i) {
        const float s = scales[i];
        RThit hit;
        startPicture();
        rtBegin(RT_TRIANGLES);
        rtVertex3f(0, 0, 0);
        rtVertex3f(s, 0, 0);
        rtVertex3f(0, s, 0);
        rtEnd();
        hit = hitFrom(0.25f * s, 0.25f * s, s, -s);
        CHECK(hit.primitive == 0 && hit.t == 1);
    }
}

/* No absolute epsilon: a shadow at any scale. */
static void shadowsHaveNoScale(void) {
    static const float scales[] = {1e-6f, 1, 1e6f};
    int i;
    for (i = 0; i < 3; ++i) {
        const float s = scales[i];
        RTuint light;
        startPicture();
        rtMatrixMode(RT_PROJECTION);
        rtLoadIdentity();
        rtOrtho(-s, s, -s, s, -10 * s, 10 * s);
        rtMatrixMode(RT_MODELVIEW);
        light = pointLight(-3 * s, 0, 3 * s, 18 * s * s);
        diffuse("Phong", "diffuse");
        rtScalef(s, s, s);
        square(-1, -1, 1, 1, 0);
        rtBegin(RT_QUADS); /* a wall from which a shadow falls to the right */
        rtVertex3f(-0.5f, -1, 0);
        rtVertex3f(-0.5f, 1, 0);
        rtVertex3f(-0.5f, 1, 0.5f);
        rtVertex3f(-0.5f, -1, 0.5f);
        rtEnd();
        rtUseLight(light);
        rtRender();
        CHECK(at(-0.8f, 0)[0] > 0.3f);
        CHECK(at(-0.2f, 0)[0] < 0.1f * at(-0.8f, 0)[0]);
        CHECK(at(0.8f, 0)[0] > 0.2f);
        CHECK_ERROR(RT_NO_ERROR);
    }
}

static void picturesOfAnySizeAreComplete(void) {
    static const int sizes[][2] = {{1, 1}, {37, 5}, {5, 37}, {33, 64}, {1, 70}};
    static float memory[64 * 70 * 3];
    int i, k;
    for (i = 0; i < 5; ++i) {
        const int n = 3 * sizes[i][0] * sizes[i][1];
        int wrong = 0;
        startPicture();
        memset(memory, 0, sizeof memory);
        rtSetFrameBuffer((RTubyte *)memory, (RTuint)sizes[i][0], (RTuint)sizes[i][1], RT_BGR_32);
        square(-1, -1, 1, 1, 0);
        rtRender();
        for (k = 0; k < (int)(sizeof memory / sizeof *memory); ++k)
            wrong += memory[k] != (k < n ? 1.0f : 0.0f);
        CHECK(wrong == 0);
    }
}

static void samplesAreAtPixelCentres(void) {
    startPicture();
    square(-1, -1, 0.0624f, 1, 0); /* pixel 8 is from 0 to 0.125 */
    rtRender();
    CHECK(at(0.01f, 0)[0] == 0);
    square(-1, -1, 0.0626f, 1, 0);
    rtRender();
    CHECK(at(0.01f, 0)[0] == 1);
}

static void radianceAdds(void) {
    float one[2], both = 0;
    int i;
    for (i = 0; i < 3; ++i) {
        RTuint lights[2];
        startPicture();
        lights[0] = pointLight(-5, 1, 5, 20);
        lights[1] = pointLight(4, -2, 6, 30);
        diffuse("DiffuseShader", "color");
        square(-1, -1, 1, 1, 0);
        if (i != 1) rtUseLight(lights[0]);
        if (i != 0) rtUseLight(lights[1]);
        rtRender();
        if (i < 2)
            one[i] = at(0, 0)[0];
        else
            both = at(0, 0)[0];
    }
    CHECK(one[0] > 0.01f && one[1] > 0.01f && fabsf(both - one[0] - one[1]) < 1e-6f);
}

static void textureRepeatHasNoSeam(void) {
    static const RTubyte texels[] = {0, 0, 0, 255, 255, 255, 255, 255};
    RTuint texture = 1;
    RTfloat s[3] = {-0.001f, 0, 0.001f}, seen[3];
    int i;
    startPicture();
    rtBindTexture(RT_TEXTURE_2D, texture);
    rtTexImage2D(RT_TEXTURE_2D, 0, RT_RGBA, 2, 1, 0, RT_RGBA, RT_UNSIGNED_BYTE, texels);
    rtGenNewShaderClass("TextureShader", NULL);
    rtGenNewShader();
    rtParameter1i(rtParameterHandle("texture"), (RTint)texture);
    for (i = 0; i < 3; ++i) {
        rtTexCoord2f(s[i], 0.5f);
        square(-1, -1, 1, 1, 0);
        rtRender();
        seen[i] = at(0, 0)[0];
    }
    CHECK(fabsf(seen[1] - 0.5f) < 1e-4f); /* halfway between the last texel and the first */
    CHECK(fabsf(seen[0] - 0.502f) < 1e-4f && fabsf(seen[2] - 0.498f) < 1e-4f);
}

static void anyNumberOfThreadsWorks(void) {
    static float first[PICTURE_SIZE][PICTURE_SIZE][4];
    RTuint threads;
    for (threads = 0; threads < 5; ++threads) {
        startPicture();
        rtThreads(threads);
        rtColor3f(1, 0.5f, 0.25f);
        square(-0.5f, -0.5f, 0.7f, 0.9f, 0);
        rtRender();
        if (threads == 0) memcpy(first, picture, sizeof first);
        CHECK(memcmp(first, picture, sizeof first) == 0);
    }
}

static void theTopLevelIsATree(void) {
    RTuint object;
    RTint few, many;
    int i;
    startPicture();
    object = rtNewObject(RT_DEFINE);
    square(0, 0, 1, 1, 0);
    rtEndObject();
    rtInstantiateObject(object);
    rtRender();
    few = get(RT_STAT_NODES);
    for (i = 0; i < 1000; ++i) {
        rtLoadIdentity();
        rtTranslatef(3.0f * (float)(i % 10), 3.0f * (float)(i / 10 % 10), 3.0f * (float)(i / 100));
        rtInstantiateObject(object);
    }
    rtRender();
    many = get(RT_STAT_NODES);
    CHECK(many > few + 100);
    CHECK(get(RT_STAT_TRIANGLES) == 2 && get(RT_STAT_INSTANCES) == 1000);
}

static void parameterSizesAreChecked(void) {
    RTuint handle;
    startPicture();
    rtGenNewShaderClass("ConstantShader", NULL);
    rtGenNewShader();
    handle = rtParameterHandle("value");
    rtParameter3f(handle, 0, 1, 0);
    rtParameter16f(handle, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1);
    CHECK_ERROR(RT_INVALID_OPERATION);
    square(-1, -1, 1, 1, 0);
    rtRender();
    CHECK(isColor(at(0, 0), 0, 1, 0));
}

static void aLightAtTheSurfaceIsHarmless(void) {
    static const char *const names[][2] = {{"DiffuseShader", "color"}, {"Phong", "diffuse"}};
    int i, k, wrong = 0;
    for (i = 0; i < 2; ++i) {
        RTuint light;
        startPicture();
        /* Exactly at the centre of a pixel. */
        light = pointLight(0.0625f, 0.0625f, 0, 1);
        diffuse(names[i][0], names[i][1]);
        square(-1, -1, 1, 1, 0);
        rtUseLight(light);
        rtRender();
        for (k = 0; k < PICTURE_SIZE * PICTURE_SIZE * 4; ++k)
            wrong += !isfinite((&picture[0][0][0])[k]);
        CHECK(wrong == 0 && get(RT_STAT_BAD_PIXELS) == 0);
    }
}

static void illuminateMayDecline(void) {
    RTshaderclass dark = classOf("Dark", RT_LIGHT_SHADER);
    RTuint light;
    startPicture();
    dark.illuminate = neverIlluminates;
    rtRegisterShaderClass(&dark);
    light = rtGenNewShader();
    diffuse("DiffuseShader", "color");
    square(-1, -1, 1, 1, 0);
    rtUseLight(light);
    rtRender();
    CHECK(at(0, 0)[0] == 0);
    CHECK_ERROR(RT_NO_ERROR);
}

static void recursionHasLimits(void) {
    static const struct {
        RTuint limit;
        float cutoff, weight, expected; /* surfaces that the pixel sees */
    } cases[] = {{0, 0, 1, 1},        {1, 0, 1, 2},         {8, 0, 1, 9},
                 {100, 0.3f, 0.5f, 2}, {100, 0.2f, 0.5f, 3}, {100, 1, 1, 101}};
    const RTSparameter weight = {"weight", RTS_PER_SHADER, RTS_FLOAT1, 0, 4};
    int i;
    for (i = 0; i < (int)(sizeof cases / sizeof cases[0]); ++i) {
        RTshaderclass mirrors = classOf("TraceOn", RT_SURFACE_SHADER);
        startPicture();
        mirrors.shaderSize = sizeof(float);
        mirrors.parameters = &weight;
        mirrors.parameterCount = 1;
        mirrors.construct = constructWeight;
        mirrors.shade = traceOn;
        rtRegisterShaderClass(&mirrors);
        rtGenNewShader();
        rtParameter1f(rtParameterHandle("weight"), cases[i].weight);
        rtRecursionLimit(cases[i].limit);
        rtWeightCutoff(cases[i].cutoff);
        square(-1, -1, 1, 1, 0);
        square(-1, -1, 1, 1, 20); /* behind the viewer: rays go to and fro */
        rtRender();
        if (at(0, 0)[0] != cases[i].expected)
            fprintf(stderr, "case %d: %g surfaces\n", i, at(0, 0)[0]);
        CHECK(at(0, 0)[0] == cases[i].expected);
        CHECK_ERROR(RT_NO_ERROR);
    }
}

static void idsCountFromOne(void) {
    startPicture();
    CHECK(rtNewObject(RT_DEFINE) == 1);
    rtEndObject();
    CHECK(rtGenNewShaderClass("ConstantShader", NULL) == 1 && rtGenNewShader() == 1);
    CHECK(rtParameterHandle("value") == 1);
    rtBindShader(0);
    rtInstantiateObject(0);
    CHECK_ERROR(RT_INVALID_VALUE);
    rtUseLight(99);
    CHECK_ERROR(RT_INVALID_VALUE);
    rtRemoveObject(2);
    CHECK_ERROR(RT_INVALID_VALUE);
}

static void attributesAreLegalOutsidePrimitives(void) {
    startPicture();
    rtNormal3f(0, 1, 0);
    rtTexCoord2f(0.5f, 0.5f);
    CHECK_ERROR(RT_NO_ERROR);
}

int main(void) {
    errorsAreCleared();
    defineAndInstantiateInstantiates();
    looseGeometryIsVisible();
    namesCompareByText();
    transparencyIsAskedByShadowRays();
    normalsUseTheInverseTranspose();
    oddStripTrianglesAreTurned();
    quadsSplitAlongFirstAndThird();
    noTriangleIsTooSmall();
    shadowsHaveNoScale();
    picturesOfAnySizeAreComplete();
    samplesAreAtPixelCentres();
    radianceAdds();
    textureRepeatHasNoSeam();
    anyNumberOfThreadsWorks();
    theTopLevelIsATree();
    parameterSizesAreChecked();
    aLightAtTheSurfaceIsHarmless();
    illuminateMayDecline();
    recursionHasLimits();
    idsCountFromOne();
    attributesAreLegalOutsidePrimitives();
    rtExit();
    return failureCount;
}

/* SPDX-License-Identifier: MIT */
/* Classes, shaders and parameters: scopes, types, defaults, handles, lives. */
#include <stddef.h>

#include "check.h"
#include "openrt/rts.h"
#include "picture.h"

/* A class with a parameter of every scope and type; shows red per shader, green per triangle,
 * blue per vertex. */
typedef struct PerShader {
    float red;
    RTint ints[6];
    float floats[4 + 16];
    unsigned char raw[5];
    const char *text;
} PerShader;

static char textSeen[32];
static PerShader shaderSeen;

static int construct(void *shader, void *triangle, void *vertex) {
    PerShader *s = shader;
    memset(s, 0, sizeof *s);
    s->red = 0.125f;
    s->text = "none";
    *(float *)triangle = 0.25f;
    *(float *)vertex = 0.5f;
    return 0;
}
static int shade(const void *shader, RTSstate *state) {
    const PerShader *s = shader;
    shaderSeen = *s;
    strncpy(textSeen, s->text, sizeof textSeen - 1);
    rtsResultColor(state, s->red, *(const float *)state->triangleParam,
                   *(const float *)state->vertexParam);
    return 0;
}

#define P(name, scope, type, offset, size) {name, scope, type, (RTuint)(offset), (RTuint)(size)}
static const RTSparameter parameters[] = {
    P("red", RTS_PER_SHADER, RTS_FLOAT1, offsetof(PerShader, red), 4),
    P("green", RTS_PER_TRIANGLE, RTS_FLOAT1, 0, 4),
    P("blue", RTS_PER_VERTEX, RTS_FLOAT1, 0, 4),
    P("i1", RTS_PER_SHADER, RTS_INT1, offsetof(PerShader, ints), 4),
    P("i2", RTS_PER_SHADER, RTS_INT2, offsetof(PerShader, ints) + 4, 8),
    P("i3", RTS_PER_SHADER, RTS_INT3, offsetof(PerShader, ints) + 12, 12),
    P("f4", RTS_PER_SHADER, RTS_FLOAT4, offsetof(PerShader, floats), 16),
    P("f16", RTS_PER_SHADER, RTS_FLOAT16, offsetof(PerShader, floats) + 16, 64),
    P("raw", RTS_PER_SHADER, RTS_RAW, offsetof(PerShader, raw), 5),
    P("text", RTS_PER_SHADER, RTS_STRING, offsetof(PerShader, text), sizeof(char *))};

static RTuint registerProbe(const char *name) {
    RTshaderclass probe = {0};
    probe.structSize = sizeof probe;
    probe.interfaceVersion = RTS_INTERFACE_VERSION;
    probe.kind = RT_SURFACE_SHADER;
    probe.name = name;
    probe.shaderSize = sizeof(PerShader);
    probe.triangleSize = probe.vertexSize = sizeof(float);
    probe.alignment = 8;
    probe.parameters = parameters;
    probe.parameterCount = sizeof parameters / sizeof parameters[0];
    probe.construct = construct;
    probe.shade = shade;
    return rtRegisterShaderClass(&probe);
}

static void scopes(void) {
    RTuint red, green, blue, object;
    startPicture();
    CHECK(registerProbe("Probe") != RT_INVALID);
    rtGenNewShader();
    red = rtParameterHandle("red");
    green = rtParameterHandle("green");
    blue = rtParameterHandle("blue");

    /* The class's defaults. */
    square(-1, -1, 1, 1, 0);
    rtRender();
    CHECK(isColor(at(0, 0), 0.125f, 0.25f, 0.5f));

    /* Per triangle: the value when its last vertex is given, constant over it. Per vertex:
     * interpolated. Per shader: the last of all. */
    rtParameter1f(red, 0.75f);
    object = rtNewObject(RT_DEFINE);
    rtBegin(RT_TRIANGLES);
    rtParameter1f(green, 9);
    rtParameter1f(blue, 0);
    rtVertex3f(-1, -1, 0);
    rtParameter1f(blue, 1);
    rtVertex3f(1, -1, 0);
    rtParameter1f(blue, 0);
    rtParameter1f(green, 0.5f);
    rtVertex3f(-1, 1, 0);
    rtParameter1f(green, 1);
    rtVertex3f(1, -1, 0);
    rtVertex3f(1, 1, 0);
    rtVertex3f(-1, 1, 0);
    rtEnd();
    rtEndObject();
    rtParameter1f(red, 1);
    rtParameter1f(green, 7);
    rtInstantiateObject(object);
    rtRender();
    {
        const float *p = at(-0.9375f, -0.9375f); /* pixel centre: u = 1/32 */
        CHECK(isColor(p, 1, 0.5f, 1 / 32.0f));
        p = at(0.0f, -0.9375f);
        CHECK(isColor(p, 1, 0.5f, 17 / 32.0f));
        CHECK(isColor(at(0.5f, 0.5f), 1, 1, 0));
    }

    /* Of a quad: the value at its fourth vertex, for both triangles. */
    rtBegin(RT_QUADS);
    rtVertex3f(-1, -1, 0);
    rtVertex3f(1, -1, 0);
    rtVertex3f(1, 1, 0);
    rtParameter1f(green, 0.125f);
    rtVertex3f(-1, 1, 0);
    rtEnd();
    rtRender();
    CHECK(isColor(at(0.5f, -0.5f), 1, 0.125f, 0) && isColor(at(-0.5f, 0.5f), 1, 0.125f, 0));

    /* Another shader of the class has its own values. */
    rtGenNewShader();
    square(-1, -1, 1, 1, 0);
    rtRender();
    CHECK(isColor(at(0, 0), 0.125f, 0.25f, 0.5f));
    CHECK_ERROR(RT_NO_ERROR);

    /* A model with shaders that have such parameters and one that has none. */
    rtParameter1f(green, 1);
    square(-1, -1, 0, 0, 0);
    rtBindShader(0);
    rtColor3f(0.5f, 0.25f, 1);
    square(0, 0, 1, 1, 0);
    rtRender();
    CHECK(isColor(at(-0.5f, -0.5f), 0.125f, 1, 0.5f) && isColor(at(0.5f, 0.5f), 0.5f, 0.25f, 1));
    CHECK_ERROR(RT_NO_ERROR);
}

static void types(void) {
    char name[8] = "i3", text[8] = "first";
    const RTubyte raw[5] = {1, 2, 3, 4, 5};
    RTfloat m[16];
    int i;
    startPicture();
    registerProbe("Probe");
    rtGenNewShader();
    rtParameter1i(rtParameterHandle("i1"), -1);
    rtParameter2i(rtParameterHandle("i2"), 2, 3);
    rtParameter3i(rtParameterHandle(name), 4, 5, 6);
    rtParameter4f(rtParameterHandle("f4"), 1, 2, 3, 4);
    for (i = 0; i < 16; ++i) m[i] = (float)i;
    rtParameter16fv(rtParameterHandle("f16"), m);
    rtParameterRaw(rtParameterHandle("raw"), raw, sizeof raw);
    rtParameterString(rtParameterHandle("text"), text);
    memset(name, 'x', sizeof name); /* names and strings are copied */
    memset(text, 'x', sizeof text);
    square(-1, -1, 1, 1, 0);
    rtRender();
    CHECK_ERROR(RT_NO_ERROR);
    for (i = 0; i < 6; ++i) CHECK(shaderSeen.ints[i] == (i ? i + 1 : -1));
    for (i = 0; i < 4; ++i) CHECK(shaderSeen.floats[i] == (float)(i + 1));
    for (i = 0; i < 16; ++i) CHECK(shaderSeen.floats[4 + i] == (float)i);
    CHECK(memcmp(shaderSeen.raw, raw, sizeof raw) == 0);
    CHECK(strcmp(textSeen, "first") == 0);

    rtParameter16f(rtParameterHandle("f16"), 15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0);
    rtParameterString(rtParameterHandle("text"), "");
    square(-1, -1, 1, 1, 0);
    rtRender();
    CHECK(shaderSeen.floats[4] == 15 && shaderSeen.floats[19] == 0);
    CHECK(strcmp(textSeen, "") == 0);
    rtParameterRaw(rtParameterHandle("raw"), raw, 4);
    CHECK_ERROR(RT_INVALID_OPERATION);
    rtParameterRaw(rtParameterHandle("text"), raw, 5);
    CHECK_ERROR(RT_INVALID_OPERATION);
}

static void handlesAndLives(void) {
    RTuint constant, again, phong, value, diffuse, shader, other;
    RTint bound = -1;
    startPicture();
    constant = rtGenNewShaderClass("ConstantShader", NULL);
    value = rtParameterHandle("value");
    CHECK(constant != RT_INVALID && value != RT_INVALID && value != 0);
    CHECK(rtParameterHandle("value") == value);
    again = rtGenNewShaderClass("ConstantShader", NULL);
    CHECK(again != constant);
    phong = rtGenNewShaderClass("Phong", NULL);
    diffuse = rtParameterHandle("diffuse");
    CHECK(phong != RT_INVALID && diffuse != value);
    rtGetIntegerv(RT_SHADER_CLASS_BINDING, &bound);
    CHECK(bound == (RTint)phong);
    rtGetIntegerv(RT_SHADER_BINDING, &bound);
    CHECK(bound == 0);
    other = rtGenNewShader();
    rtBindShaderClass(constant);
    shader = rtGenNewShader();
    rtGetIntegerv(RT_SHADER_BINDING, &bound);
    CHECK(bound == (RTint)shader && shader != other && shader != 0);
    rtParameter3f(value, 0, 1, 0);
    rtBindShader(other); /* binds its class too */
    rtGetIntegerv(RT_SHADER_CLASS_BINDING, &bound);
    CHECK(bound == (RTint)phong);
    rtParameter3f(diffuse, 1, 1, 1);
    CHECK_ERROR(RT_NO_ERROR);

    /* Removed ids are forgotten; what uses them goes on. */
    rtBindShader(shader);
    square(-1, -1, 1, 1, 0);
    rtRemoveShader(shader);
    rtGetIntegerv(RT_SHADER_BINDING, &bound);
    CHECK(bound == 0);
    rtBindShader(shader);
    CHECK_ERROR(RT_INVALID_VALUE);
    rtRender();
    CHECK(isColor(at(0, 0), 0, 1, 0));
    rtBindShader(other);
    rtRemoveShaderClass(phong);
    rtGetIntegerv(RT_SHADER_CLASS_BINDING, &bound);
    CHECK(bound == 0);
    rtBindShaderClass(phong);
    CHECK_ERROR(RT_INVALID_VALUE);
    rtParameter3f(diffuse, 0, 0, 0); /* its shaders live */
    CHECK_ERROR(RT_NO_ERROR);

    /* A light that is removed stays in the frame it was given to. */
    rtGenNewShaderClass("PointLight", NULL);
    shader = rtGenNewShader();
    rtUseLight(shader);
    rtRemoveShader(shader);
    rtUseLight(shader);
    CHECK_ERROR(RT_INVALID_VALUE);
    rtRender();
    CHECK_ERROR(RT_NO_ERROR);

    /* The program's own class hides a built-in one of the same name, the newest an older one. */
    CHECK(registerProbe("Phong") != RT_INVALID);
    CHECK(rtGenNewShaderClass("Phong", NULL) != RT_INVALID);
    CHECK(rtParameterHandle("green") != RT_INVALID);
    CHECK_ERROR(RT_NO_ERROR);
}

int main(void) {
    scopes();
    types();
    handlesAndLives();
    rtExit();
    return failureCount;
}

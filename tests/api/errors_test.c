/* SPDX-License-Identifier: MIT */
/* The error rule: the first one sticks until it is read; texts and the callback. */
#include <string.h>

#include "check.h"

static int calls;
static RTenum lastCode;
static char lastFunction[64], lastText[256];

static void RTAPIENTRY remember(RTenum code, const char *function, const char *text, void *user) {
    CHECK(user == &calls);
    ++calls;
    lastCode = code;
    strncpy(lastFunction, function, sizeof lastFunction - 1);
    strncpy(lastText, text, sizeof lastText - 1);
    rtEnd(); /* an error inside the callback does not call it again */
}

static void RTAPIENTRY leave(RTenum code, const char *function, const char *text, void *user) {
    (void)code, (void)function, (void)text, (void)user;
    ++calls;
    rtExit();
}

int main(void) {
    /* Without a context nothing happens. */
    CHECK(rtGetError() == RT_INVALID_OPERATION);
    CHECK(rtGetError() == RT_INVALID_OPERATION);
    CHECK(strlen(rtGetErrorText()) > 0);
    CHECK(rtNewObject(RT_DEFINE) == RT_INVALID);
    CHECK(rtGenNewShader() == RT_INVALID && rtCompileScene() == RT_INVALID);
    CHECK(rtGetString(RT_VERSION) == NULL && rtIsTexture(1) == RT_FALSE);
    CHECK(rtGetCurrentContext() == NULL);
    rtBegin(RT_TRIANGLES);
    rtVertex3f(0, 0, 0);
    rtRender();
    rtClear(RT_COLOR_BUFFER_BIT);
    rtExit();

    rtInit(NULL, NULL);
    CHECK_ERROR(RT_NO_ERROR);
    CHECK(strcmp(rtGetErrorText(), "") == 0);

    /* The first sticks, later ones are dropped; reading clears, the text stays readable. */
    rtEnd();
    rtBindShader(4711);
    CHECK(strstr(rtGetErrorText(), "begin") != NULL);
    CHECK_ERROR(RT_INVALID_OPERATION);
    CHECK_ERROR(RT_NO_ERROR);
    CHECK(strstr(rtGetErrorText(), "begin") != NULL);
    rtBindShader(4711);
    CHECK(strstr(rtGetErrorText(), "4711") != NULL);
    CHECK_ERROR(RT_INVALID_VALUE);

    /* Between rtBegin and rtEnd rtGetError itself is an error. */
    rtBegin(RT_TRIANGLES);
    CHECK(rtGetError() == RT_NO_ERROR);
    rtEnd();
    CHECK_ERROR(RT_INVALID_OPERATION);

    /* The callback hears of every error. */
    rtErrorCallback(remember, &calls);
    rtEnd();
    CHECK(calls == 1 && lastCode == RT_INVALID_OPERATION && strcmp(lastFunction, "rtEnd") == 0);
    rtBindShader(4711);
    CHECK(calls == 2 && lastCode == RT_INVALID_VALUE && strcmp(lastFunction, "rtBindShader") == 0);
    CHECK(strstr(lastText, "4711") != NULL);
    rtAccum(RT_ACCUM, 1);
    rtAccum(RT_ACCUM, 1); /* once for each function */
    CHECK(calls == 3 && strcmp(lastFunction, "rtAccum") == 0);
    CHECK(strstr(lastText, "rtAccum is not part of this release") != NULL);
    CHECK_ERROR(RT_INVALID_OPERATION);
    rtErrorCallback(NULL, NULL);
    rtEnd();
    CHECK(calls == 3);
    CHECK_ERROR(RT_INVALID_OPERATION);

    /* What is legal between rtBegin and rtEnd is refused there once too. */
    rtBegin(RT_POINTS);
    rtEvalPoint1(1);
    rtEnd();
    CHECK(strstr(rtGetErrorText(), "rtEvalPoint1 is not part of this release") != NULL);
    CHECK_ERROR(RT_INVALID_OPERATION);
    rtBegin(RT_POINTS);
    rtEvalPoint1(1);
    rtEnd();
    CHECK_ERROR(RT_NO_ERROR);

    /* A text longer than its place is cut, not more. */
    {
        char name[2000];
        memset(name, 'x', sizeof name - 1);
        name[sizeof name - 1] = 0;
        CHECK(rtGenNewShaderClass(name, NULL) == RT_INVALID);
        CHECK(strlen(rtGetErrorText()) < 1000 && strstr(rtGetErrorText(), "xxx") != NULL);
        CHECK_ERROR(RT_INVALID_VALUE);
    }

    /* A callback that ends everything. */
    rtErrorCallback(leave, NULL);
    rtEnd();
    CHECK(calls == 4);
    CHECK(rtGetCurrentContext() == NULL);
    CHECK(rtGetError() == RT_INVALID_OPERATION);

    /* rtInit may be repeated: each time a fresh context. */
    rtInit(NULL, NULL);
    rtColor3f(0.5f, 0, 0);
    rtEnd();
    rtInit(NULL, NULL);
    {
        RTfloat color[4];
        rtGetFloatv(RT_CURRENT_COLOR, color);
        CHECK(color[0] == 1);
        CHECK_ERROR(RT_NO_ERROR);
    }
    /* rtExit is legal anywhere, and twice. */
    rtBegin(RT_TRIANGLES);
    rtExit();
    rtExit();
    rtInit(NULL, NULL); /* left running: a process may end so */
    return failureCount;
}

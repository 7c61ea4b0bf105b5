/* SPDX-License-Identifier: MIT */
/* rtInit takes its arguments out of argv, and bad values do no harm. */
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "openrt/rtu.h"

static RTint get(RTenum name) {
    RTint value = -1;
    rtGetIntegerv(name, &value);
    return value;
}

static RTboolean hasExtension(const char *name) {
    return rtuCheckExtension((const RTubyte *)name, rtGetString(RT_EXTENSIONS));
}

int main(void) {
    {
        char *argv[] = {"program", "--rt-threads", "2",    "scene.glb", "--rt-samples",
                        "9",       "--rt-isa",     "generic", "-v",     "--rt-precision",
                        "fast",    NULL};
        int argc = 11;
        rtInit(&argc, argv);
        CHECK(argc == 3);
        CHECK(strcmp(argv[0], "program") == 0 && strcmp(argv[1], "scene.glb") == 0);
        CHECK(strcmp(argv[2], "-v") == 0 && argv[3] == NULL);
        CHECK(get(RT_SAMPLES) == 9);
        CHECK(get(RT_PRECISION_HINT) == RT_FASTEST);
        CHECK(strcmp((const char *)rtGetString(RT_ISA), "generic") == 0);
        CHECK_ERROR(RT_NO_ERROR);
    }
    { /* Bad values, and one missing: each a line on stderr, nothing else. */
        char *argv[] = {"program",    "--rt-threads", "many",       "--rt-samples",   "0",
                        "--rt-isa",   "z80",          "--rt-size",  "wide",           "--rt-precision",
                        "exact",      "--rt-offscreen", "3",        "--rt-output",    "a%d.png",
                        "--rt-depth", "d%d.pfm",      "--rt-threads", NULL};
        int argc = 18;
        rtInit(&argc, argv);
        CHECK(argc == 1 && argv[1] == NULL);
        CHECK(get(RT_SAMPLES) == 1);
        CHECK(get(RT_PRECISION_HINT) == RT_DONT_CARE);
        CHECK_ERROR(RT_NO_ERROR);
    }
    {
        char *argv[] = {"program", "--rt-precision", "precise", NULL};
        int argc = 3;
        rtInit(&argc, argv);
        CHECK(argc == 1 && argv[1] == NULL);
        CHECK(get(RT_PRECISION_HINT) == RT_NICEST);
        CHECK_ERROR(RT_NO_ERROR);
    }
    { /* Without any, argv is as before. */
        char *argv[] = {"program", "a", NULL};
        int argc = 2, none = 0;
        rtInit(&argc, argv);
        CHECK(argc == 2 && strcmp(argv[1], "a") == 0);
        rtInit(&none, argv);
        rtInit(NULL, argv);
        rtInit(&argc, NULL);
        CHECK_ERROR(RT_NO_ERROR);
    }
    setenv("OPENRT_THREADS", "nonsense", 1);
    rtInit(NULL, NULL);
    CHECK_ERROR(RT_NO_ERROR);
    CHECK(strlen((const char *)rtGetString(RT_VENDOR)) > 0);
    CHECK(strlen((const char *)rtGetString(RT_RENDERER)) > 0);
    CHECK(hasExtension("GL_ARB_vertex_buffer_object") && hasExtension("GL_SGIS_texture_lod"));
    CHECK(!hasExtension("GL_ARB_vertex") && !hasExtension("GL_ARB_texture_cube_map"));
    CHECK(strcmp((const char *)rtGetString(RT_VERSION), "1.5 OpenRT " OPENRT_VERSION_STRING) == 0);
    rtExit();
    return failureCount;
}

/* SPDX-License-Identifier: MIT */
/* Surface shaders in C that do what they should not; also in the plug-in of misbehaving.c. */
#ifndef OPENRT_TESTS_SHADERS_MISBEHAVING_H
#define OPENRT_TESTS_SHADERS_MISBEHAVING_H

#include "openrt/rts.h"

#ifdef __cplusplus
extern "C" {
#endif

/* "ReturnsFault", "ReturnsFaultInPacket", "DividesByZero"; NULL for another name. */
const RTshaderclass *misbehavingClass(const char *name);

#ifdef __cplusplus
}
#endif
#endif

/* SPDX-License-Identifier: MIT */
/* Two of the shader libraries for programs that contain them instead: their classes are handed to
 * rtRegisterShaderClass. */
#ifndef OPENRT_SAMPLE_SHADERS_H
#define OPENRT_SAMPLE_SHADERS_H

#include "openrt/rts.h"

#ifdef __cplusplus
extern "C" {
#endif

/* "Checker", written in C: a chequered surface. */
const RTshaderclass *checkerClass(void);

/* "Wood", written in C++: rings around an axis. */
const RTshaderclass *woodClass(void);

#ifdef __cplusplus
}
#endif
#endif

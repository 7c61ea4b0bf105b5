/* SPDX-License-Identifier: MIT */
/* Classes of shaders to learn from, one file each; hand them to rtRegisterShaderClass. */
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

/* SPDX-License-Identifier: MIT */
#ifndef OPENRT_GL_GL_GLU_H
#define OPENRT_GL_GL_GLU_H

#include "openrt/gl.h"

#endif

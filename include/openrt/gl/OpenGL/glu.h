/* SPDX-License-Identifier: MIT */
#ifndef OPENRT_GL_OPENGL_GLU_H
#define OPENRT_GL_OPENGL_GLU_H

#include "openrt/gl.h"

#endif

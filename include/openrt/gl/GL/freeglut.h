/* SPDX-License-Identifier: MIT */
#ifndef OPENRT_GL_GL_FREEGLUT_H
#define OPENRT_GL_GL_FREEGLUT_H

#include "openrt/gl.h"

#endif

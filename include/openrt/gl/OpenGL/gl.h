/* SPDX-License-Identifier: MIT */
#ifndef OPENRT_GL_OPENGL_GL_H
#define OPENRT_GL_OPENGL_GL_H

#include "openrt/gl.h"

#endif

/* SPDX-License-Identifier: MIT */
#ifndef OPENRT_GL_GLUT_GLUT_H
#define OPENRT_GL_GLUT_GLUT_H

#include "openrt/gl.h"

#endif

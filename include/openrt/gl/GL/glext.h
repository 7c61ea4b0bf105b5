/* SPDX-License-Identifier: MIT */
#ifndef OPENRT_GL_GL_GLEXT_H
#define OPENRT_GL_GL_GLEXT_H

#include "openrt/gl.h"

#endif

/* SPDX-License-Identifier: MIT */
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#define drawPixelScene drawPixelSceneOpenGl
#include "tests/images/pixel_scenes.inc"

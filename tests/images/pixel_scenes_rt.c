/* SPDX-License-Identifier: MIT */
#include "openrt/gl.h"

#define drawPixelScene drawPixelSceneOpenRt
#include "tests/images/pixel_scenes.inc"

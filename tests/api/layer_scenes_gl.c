/* SPDX-License-Identifier: MIT */
#include <GL/gl.h>

#define SCENES glLayerScenes
#define READ_PICTURE glReadPicture
#include "layer_scenes.inc"

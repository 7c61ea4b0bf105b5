/* SPDX-License-Identifier: MIT */
#include "openrt/gl.h"

#define SCENES rtLayerScenes
#define READ_PICTURE rtReadPicture
#include "layer_scenes.inc"

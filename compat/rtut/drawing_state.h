/* SPDX-License-Identifier: MIT */
#pragma once

#include "compat/rtut/drawing_names.h"

/* Whether something can be drawn; in a primitive this records the error, and tells nothing. */
static inline int isOutsidePrimitive(void) {
    RTint depth = -1;
    rtGetIntegerv(RT_ATTRIB_STACK_DEPTH, &depth);
    return depth >= 0;
}

/* Whether there is state to be changed: the geometry of an object has none. */
static inline int hasState(void) {
#ifdef RTUT_ON_OPENGL
    return 1;
#else
    RTint object = 0;
    rtGetIntegerv(RT_OBJECT_INDEX, &object);
    return object == 0;
#endif
}

/* Whether attributes can be pushed. It is better than to restore them by hand: a display list that
 * is compiled then restores what is so when it is called. */
static inline int attributesFit(void) {
    RTint depth = 0, most = 0;
    rtGetIntegerv(RT_ATTRIB_STACK_DEPTH, &depth);
    rtGetIntegerv(RT_MAX_ATTRIB_STACK_DEPTH, &most);
    return depth < most;
}

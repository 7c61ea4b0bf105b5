/* SPDX-License-Identifier: MIT */
/* What a shader library (plug-in) shows to the library: one data symbol, `rtsPlugin`. Authors of
 * shaders include rts_plugin.h (C) or plugin.hpp (C++), whose macros make it.
 *
 * The numbers of RTSplugin are read from the file before it is loaded: a file that is no plug-in,
 * or one that this library can not serve, is refused before any code in it runs.
 */
#ifndef OPENRT_RTS_PLUGIN_FORMAT_H
#define OPENRT_RTS_PLUGIN_FORMAT_H

#include "openrt/rts.h"

#ifdef __cplusplus
extern "C" {
#endif

#define RTS_PLUGIN_SYMBOL "rtsPlugin"
#define RTS_PLUGIN_MAGIC "OpenRTS"

/* RTS_INTERFACE_VERSION changes when old plug-ins can no longer be served; it must be equal.
 * The revision grows whenever a structure of rts.h, rts_packet.h or this file grows at its end, or
 * something that was reserved gets a meaning. A plug-in of an older revision is always served. One
 * that needs a newer revision than the library has is refused, as it may call functions that are
 * not there. An author who looks at the structSize of a table before using what is new in it may
 * ask for less than the headers' revision: see rts_plugin.h. */
#define RTS_INTERFACE_REVISION 2u

/* A class of a shader library. */
typedef struct RTSpluginclass {
    RTuint structSize;
    const char *name; /* by which rtGenNewShaderClass finds it; NULL: that of the descriptor */
    const RTshaderclass *descriptor; /* NULL: `describe` makes it */
    /* Returns the descriptor, which stays as it is until the library is unloaded; or NULL, and
     * says why in at most reasonSize characters, the final zero included. Must not throw. */
    const RTshaderclass *(*describe)(const struct RTSpluginclass *self, char *reason,
                                     RTuint reasonSize);
} RTSpluginclass;

typedef struct RTSplugin {
    char magic[8]; /* RTS_PLUGIN_MAGIC */
    RTuint structSize;
    RTuint interfaceVersion; /* RTS_INTERFACE_VERSION */
    RTuint neededRevision;   /* the least revision that serves the plug-in */
    RTuint classSize;        /* sizeof(RTshaderclass) as the plug-in has it */
    /* The classes, from the first to before the last. */
    const RTSpluginclass *const *first, *const *last;
} RTSplugin;

#ifdef __cplusplus
}
#endif
#endif

/* SPDX-License-Identifier: MIT */
/* Makes a shader library (plug-in) of shader classes in C:
 *
 *     static const RTshaderclass checker = {sizeof(RTshaderclass), ...};
 *     RTS_PLUGIN(checker);
 *
 *     cc -O2 -shared -fPIC $(pkg-config --cflags openrt) checker.c -o checker.so
 *
 * RTS_PLUGIN may be used for several classes, in several source files of one library. Nothing is
 * linked. The class is found by the name in its descriptor: rtGenNewShaderClass("Checker",
 * "./checker.so"). In C++ include plugin.hpp.
 *
 * A plug-in is served by every library whose revision of the interface is not older than that of
 * the headers it was compiled with. One that looks at structSize before it uses what is newer may
 * define RTS_PLUGIN_NEEDS_REVISION as a lower number before it includes this, in all its sources.
 */
#ifndef OPENRT_RTS_PLUGIN_H
#define OPENRT_RTS_PLUGIN_H

#include "openrt/rts_plugin_format.h"

#if !defined(__ELF__) || !defined(__GNUC__)
#error "shader libraries need the ELF file format and GCC or a compiler compatible with it"
#endif

#ifndef RTS_PLUGIN_NEEDS_REVISION
#define RTS_PLUGIN_NEEDS_REVISION RTS_INTERFACE_REVISION
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* Classes are listed in a section of their own, whose ends the linker names so. */
__attribute__((weak, visibility("hidden"))) extern const RTSpluginclass *const
    __start_rts_classes[];
__attribute__((weak, visibility("hidden"))) extern const RTSpluginclass *const
    __stop_rts_classes[];

__attribute__((weak, visibility("default"))) extern const RTSplugin rtsPlugin;
const RTSplugin rtsPlugin = {RTS_PLUGIN_MAGIC,
                             sizeof(RTSplugin),
                             RTS_INTERFACE_VERSION,
                             RTS_PLUGIN_NEEDS_REVISION,
                             sizeof(RTshaderclass),
                             __start_rts_classes,
                             __stop_rts_classes};

#ifdef __cplusplus
}
#endif

#if defined(__has_attribute)
#if __has_attribute(retain)
#define RTS_PLUGIN_RETAINED , retain /* by linkers that drop unreferenced sections */
#endif
#endif
#ifndef RTS_PLUGIN_RETAINED
#define RTS_PLUGIN_RETAINED
#endif
#define RTS_PLUGIN_LISTED __attribute__((section("rts_classes"), used RTS_PLUGIN_RETAINED))

/* `descriptor` is the name of an RTshaderclass with static storage. */
#define RTS_PLUGIN(descriptor)                                                                     \
    static const RTSpluginclass rtsPluginClass_##descriptor = {sizeof(RTSpluginclass), 0,          \
                                                               &descriptor, 0};                    \
    RTS_PLUGIN_LISTED static const RTSpluginclass *const rtsPluginEntry_##descriptor =             \
        &rtsPluginClass_##descriptor

#endif

/* SPDX-License-Identifier: MIT */
/* The types of the OpenRT interface: those of OpenGL, and a few of our own. C99 and C++. */
#ifndef OPENRT_TYPES_H
#define OPENRT_TYPES_H

#include <stddef.h>
#include <stdint.h>

#include "openrt/enums.h"

/* RTAPI marks an exported function; RTAPIENTRY is the calling convention. OpenRT_EXPORTS is
 * defined only while the library itself is compiled. */
#if defined(_WIN32)
#    if defined(OpenRT_EXPORTS)
#        define RTAPI __declspec(dllexport)
#    else
#        define RTAPI __declspec(dllimport)
#    endif
#    define RTAPIENTRY __stdcall
#elif defined(__GNUC__)
#    define RTAPI __attribute__((visibility("default")))
#    define RTAPIENTRY
#else
#    define RTAPI
#    define RTAPIENTRY
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* The namesakes of OpenGL's types. */
typedef unsigned int RTenum;
typedef unsigned char RTboolean;
typedef unsigned int RTbitfield;
typedef void RTvoid;
typedef signed char RTbyte;
typedef short RTshort;
typedef int RTint;
typedef unsigned char RTubyte;
typedef unsigned short RTushort;
typedef unsigned int RTuint;
typedef int RTsizei;
typedef float RTfloat;
typedef float RTclampf;
typedef double RTdouble;
typedef double RTclampd;
typedef ptrdiff_t RTintptr;
typedef ptrdiff_t RTsizeiptr;

typedef int64_t RTint64;
typedef uint64_t RTuint64;

/* Spellings of the 2009 interface. */
typedef long RTlong;
typedef unsigned long RTulong;
typedef unsigned char RTbool;
typedef unsigned char RTuchar;

/* A rendering context: its state, its objects and its worker threads. */
typedef struct RTcontextRec *RTcontext;

#ifdef __cplusplus
}
#endif

#endif

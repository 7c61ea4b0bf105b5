/* SPDX-License-Identifier: MIT */
/* The tokens of the OpenRT interface. Those that OpenGL 1.5 has too are in rt_gl_enums_1_1.h and
 * rt_gl_enums_1_5.h, with OpenGL's values; here are the ones whose value the SMART header of 2009
 * fixed, and the library's own, from 0x7F000 on. A value is unique for the parameter that takes
 * it, not over all tokens. Values never change once released. */
#ifndef OPENRT_ENUMS_H
#define OPENRT_ENUMS_H

#include "openrt/rt_gl_enums_1_1.h"
#include "openrt/rt_gl_enums_1_5.h"

/* Errors (rtGetError) */
#define RT_NO_ERROR 0
#define RT_INVALID_ENUM 0xFFFFFE01
#define RT_INVALID_VALUE 0xFFFFFE02
#define RT_INVALID_OPERATION 0xFFFFFE03
#define RT_STACK_OVERFLOW 0xFFFFFE04
#define RT_STACK_UNDERFLOW 0xFFFFFE05
#define RT_OUT_OF_MEMORY 0xFFFFFE06

/* What a call that makes or names an id returns on failure, and the id of a missed ray */
#define RT_INVALID 0xFFFFFFFF

/* Primitives (rtBegin) */
#define RT_TRIANGLES 0x100
#define RT_TRIANGLE_STRIP 0x101
#define RT_TRIANGLE_FAN 0x102
#define RT_QUADS 0x103
#define RT_QUAD_STRIP 0x104
#define RT_POLYGON 0x105

/* Object modes (rtNewObject) */
#define RT_DEFINE 0x200
#define RT_COMPILE 0x200
#define RT_DEFINE_AND_INSTANTIATE 0x201
#define RT_COMPILE_AND_EXECUTE 0x201

/* Shader kinds */
#define RT_SURFACE_SHADER 0x400
#define RT_ENV_SHADER 0x401
#define RT_LIGHT_SHADER 0x402
#define RT_CAMERA_SHADER 0x403
#define RT_RENDERING_OBJECT_SHADER 0x404 /* decides which primary rays make a pixel */

/* Data types */
#define RT_BYTE 0x1400
#define RT_UNSIGNED_BYTE 0x1401
#define RT_SHORT 0x1402
#define RT_UNSIGNED_SHORT 0x1403
#define RT_INT 0x1404
#define RT_UNSIGNED_INT 0x1405
#define RT_FLOAT 0x1406
#define RT_2_BYTES 0x1407
#define RT_3_BYTES 0x1408
#define RT_4_BYTES 0x1409
#define RT_DOUBLE 0x140A
#define RT_HALF_FLOAT 0x140B /* 16 bits, IEEE 754; with OpenGL 3.0's value */

/* What ray tracing adds to OpenGL's state (rtEnable, rtMaterial, rtShadeModel) */
#define RT_SHADOWS 0x7F000     /* enable: lights of the fixed-function surface cast shadows */
#define RT_REFLECTIONS 0x7F001 /* enable: fixed-function surfaces reflect by their RT_REFLECTION */
#define RT_REFLECTION 0x7F002  /* material: share of the mirrored ray, 0 to 1 */
#define RT_PHONG 0x7F003       /* shade model: the lighting equation at every hit point */
#define RT_FRAMEBUFFER_SRGB 0x8DB9 /* enable: 8-bit frame buffers are stored sRGB-encoded */

/* Frame buffer formats (rtSetFrameBuffer, rtSetAuxBuffer) */
#define RT_BGR_32 0x300     /* three floats a pixel in the order blue, green, red */
#define RT_RGB_8 0x7F010    /* three bytes a pixel: red, green, blue */
#define RT_RGBA_8 0x7F011   /* four bytes a pixel: red, green, blue, alpha */
#define RT_BGRA_8 0x7F012   /* four bytes a pixel: blue, green, red, alpha */
#define RT_RGB_32F 0x7F013  /* three floats a pixel: red, green, blue */
#define RT_RGBA_32F 0x7F014 /* four floats a pixel: red, green, blue, alpha */

/* Internal formats of images with sRGB-encoded bytes (rtTexImage2D), with OpenGL 2.1's values */
#define RT_SRGB 0x8C40
#define RT_SRGB8 0x8C41
#define RT_SRGB_ALPHA 0x8C42
#define RT_SRGB8_ALPHA8 0x8C43

/* Auxiliary buffers beside the colour (rtSetAuxBuffer); RT_DEPTH, window depth, is OpenGL's */
#define RT_DISTANCE 0x7F020     /* distance along the primary ray; a miss is infinity */
#define RT_NORMAL 0x7F021       /* shading normal in world space; a miss is 0 */
#define RT_ALBEDO 0x7F022       /* surface colour without lighting; a miss is 0 */
#define RT_OBJECT_ID 0x7F023    /* id of the object hit; a miss is RT_INVALID */
#define RT_INSTANCE_ID 0x7F024  /* number of the instance hit; a miss is RT_INVALID */
#define RT_PRIMITIVE_ID 0x7F025 /* number of the triangle in its object; a miss is RT_INVALID */

/* Ray queries (rtIntersect, rtOccluded and their stream forms) */
#define RT_COHERENT 0x7F030   /* runs of 16 and more consecutive rays are neighbours */
#define RT_INCOHERENT 0x7F031 /* consecutive rays have nothing in common */
#define RT_COMMON_ORIGIN 0x1  /* RTraystream.flags: ox, oy, oz hold one value for all rays */
#define RT_HIT_BACK 0x1       /* RThit.flags: the ray leaves through the back of the triangle */

/* Hints, object hints and queries */
#define RT_PRECISION_HINT 0x7F040   /* rtHint: fast, watertight (RT_DONT_CARE) or precise */
#define RT_BUILD_QUALITY 0x7F041    /* rtObjectHint: how much work goes into an object's tree */
#define RT_LAZY_BUILD 0x7F042       /* rtObjectHint: build the tree when the first ray arrives */
#define RT_OBJECT_SHADERS 0x7F043   /* rtGetObjectiv: shaders of an object by first use */
#define RT_MAX_OBJECT_DEPTH 0x7F044 /* rtGetIntegerv: how deep objects may nest */
#define RT_ISA 0x7F045              /* rtGetString: the instruction set of the kernels in use */
#define RT_SHADER_BINDING 0x7F046       /* rtGetIntegerv: the bound shader */
#define RT_SHADER_CLASS_BINDING 0x7F047 /* rtGetIntegerv: the bound shader class */
#define RT_OBJECT_SHADER_COUNT 0x7F048  /* rtGetObjectiv: how many shaders an object uses */
#define RT_ISA_NAMES 0x7F049      /* rtGetString: the instruction sets that can be used */
#define RT_SHADER_FOLDERS 0x7F04A /* rtGetString: where shader libraries are looked for */
#define RT_OBJECT_INDEX 0x7F04B   /* rtGetIntegerv: the object that is being defined; 0: none */
#define RT_KD_TREE 0x7F04C        /* RT_BUILD_QUALITY: a kd-tree instead of a tree of boxes */

/* Frames (rtFrameStatus, rtSetFrameCallback) */
#define RT_QUEUED 0x7F050         /* no tile of the frame has been started */
#define RT_RENDERING 0x7F051      /* some tiles are under way */
#define RT_DONE 0x7F052           /* every pixel is in the frame buffer */
#define RT_CANCELLED 0x7F053      /* rtCancelFrame came before the last tile */
#define RT_FAILED 0x7F054         /* the library could not finish the frame */
#define RT_FRAME_PROGRESS 0x7F055 /* callback event: a tile has been delivered */
#define RT_FRAME_DEPTH 0x7F056    /* rtGetIntegerv: how many frames may be in flight */
#define RT_SCENE_BINDING 0x7F057  /* rtGetIntegerv: the bound scene */

/* Statistics (rtGetIntegerv, rtGetInteger64v) */
#define RT_STAT_TRIANGLES 0x7F100          /* triangles of the last frame, each model once */
#define RT_STAT_INSTANCES 0x7F101          /* instances of the last frame's scene */
#define RT_STAT_NODES 0x7F102              /* tree nodes, both levels */
#define RT_STAT_LEAVES 0x7F103             /* leaves among them */
#define RT_STAT_REFERENCES 0x7F104         /* references from leaves to triangles */
#define RT_STAT_BYTES 0x7F105              /* trees, triangles and shading data held now */
#define RT_STAT_PEAK_BYTES 0x7F106         /* the most RT_STAT_BYTES has been */
#define RT_STAT_DROPPED_TRIANGLES 0x7F107  /* triangles dropped: not finite, or degenerate */
#define RT_STAT_RAYS 0x7F108               /* rays of the last frame, all kinds */
#define RT_STAT_BAD_PIXELS 0x7F109         /* pixels of the last frame lost to a shader's fault */
#define RT_STAT_MODELS_BUILT 0x7F10A       /* trees of objects built since the context was made */
#define RT_STAT_PRIMARY_RAYS 0x7F10B       /* camera rays of the last frame */
#define RT_STAT_SHADOW_RAYS 0x7F10C        /* rays towards lights of the last frame */
#define RT_STAT_SECONDARY_RAYS 0x7F10D     /* rays spawned by shaders in the last frame */
#define RT_STAT_DROPPED_INSTANCES 0x7F10E  /* instances dropped for a matrix without an inverse */
#define RT_STAT_BUILD_MICROSECONDS 0x7F10F /* building trees since the context was made */
/* Of the last frame waited for, summed over the threads that rendered it: at work on its tiles; and
 * from the end of one tile to the start of the next, waiting included. */
#define RT_STAT_BUSY_MICROSECONDS 0x7F118
#define RT_STAT_IDLE_MICROSECONDS 0x7F119

#endif

/* SPDX-License-Identifier: MIT */
/* Include this in place of the headers of OpenGL, GLU and GLUT, and a program in their names is one
 * of this library: types, tokens and functions of OpenGL 1.5, GLU 1.3 and GLUT 3.7 are macros and
 * types for those of openrt/rt.h, rtu.h and rtut.h; so are names that extensions had for what
 * became core, as GL_BGR_EXT and glActiveTextureARB. Or leave the program as it is and compile it
 * with `-include openrt/gl.h`: <GL/gl.h>, <GL/glu.h>, <GL/glut.h> and the like are then empty, as
 * this header defines what guards them. Where the system has no such headers, add the folder
 * openrt/gl to the compiler's search path: its GL/gl.h, GL/glu.h, GL/glut.h include this one.
 * docs/porting.md says what each function does here, and what differs. C99, usable from C++. */
#ifndef OPENRT_GL_H
#define OPENRT_GL_H

#if defined(__gl_h_) || defined(__GL_H__) || defined(__glu_h__) || defined(__GLU_H__) ||         \
    defined(__glut_h__) || defined(__GLUT_H__) || defined(__FREEGLUT_STD_H__)
#    error "openrt/gl.h comes before the headers of OpenGL, GLU and GLUT"
#endif

/* For the lines of a port that are for this library only. */
#define OPENRT 1

#include "openrt/gl/extensions.h"
#include "openrt/gl/functions.h"
#include "openrt/gl/glu_names.h"
#include "openrt/gl/glut_names.h"
#include "openrt/gl/tokens_1_1.h"
#include "openrt/gl/tokens_1_5.h"
#include "openrt/rt.h"
#include "openrt/rtu.h"
#include "openrt/rtut.h"

/* The guards of the headers of Mesa, GLVND, Apple, Microsoft, freeglut, GLUT and GLEW. */
#define __gl_h_
#define __GL_H__
#define __gl_glext_h_
#define __glext_h_
#define __GLEXT_H_
#define __glu_h__
#define __GLU_H__
#define __glut_h__
#define __GLUT_H__
#define __FREEGLUT_H__
#define __FREEGLUT_STD_H__
#define __FREEGLUT_EXT_H__
#define __OPENGLUT_H__

/* What those headers say about calling conventions. */
#ifndef APIENTRY
#    define APIENTRY RTAPIENTRY
#endif
#ifndef CALLBACK
#    define CALLBACK RTAPIENTRY
#endif
#define GLAPI RTAPI
#define GLAPIENTRY RTAPIENTRY
#define GLAPIENTRYP RTAPIENTRY *
#define APIENTRYP RTAPIENTRY *
#define GLUAPI RTAPI
#define GLUTAPI RTAPI
#define GLUTAPIENTRY RTAPIENTRY
#define GLUTCALLBACK RTAPIENTRY

#ifdef __cplusplus
extern "C" {
#endif

typedef RTenum GLenum;
typedef RTboolean GLboolean;
typedef RTbitfield GLbitfield;
typedef RTvoid GLvoid;
typedef RTbyte GLbyte;
typedef RTshort GLshort;
typedef RTint GLint;
typedef RTubyte GLubyte;
typedef RTushort GLushort;
typedef RTuint GLuint;
typedef RTsizei GLsizei;
typedef RTfloat GLfloat;
typedef RTclampf GLclampf;
typedef RTdouble GLdouble;
typedef RTclampd GLclampd;
typedef RTintptr GLintptr, GLintptrARB;
typedef RTsizeiptr GLsizeiptr, GLsizeiptrARB;

typedef RTUquadric GLUquadric;
typedef RTUquadricObj GLUquadricObj;
typedef RTUtesselator GLUtesselator;
typedef RTUtesselatorObj GLUtesselatorObj;
typedef RTUtriangulatorObj GLUtriangulatorObj;
typedef RTUnurbs GLUnurbs;
typedef RTUnurbsObj GLUnurbsObj;
typedef RTUfuncptr _GLUfuncptr;

#ifdef __cplusplus
}
#endif

#endif

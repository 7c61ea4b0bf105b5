/* SPDX-License-Identifier: MIT */
/* Shapes and fonts are written in the names of OpenRT. Compiled with RTUT_ON_OPENGL they draw with
 * OpenGL and GLU instead, under the names of GLUT, so that pictures of both can be compared. */
#pragma once

#ifdef RTUT_ON_OPENGL
#    include <GL/glut.h>

#    define RTAPI
#    define RTAPIENTRY
typedef GLenum RTenum;
typedef GLint RTint;
typedef GLfloat RTfloat;
typedef GLdouble RTdouble;
typedef GLubyte RTubyte;
typedef GLUquadric RTUquadric;

#    define RT_LINES GL_LINES
#    define RT_LINE_LOOP GL_LINE_LOOP
#    define RT_LINE_STRIP GL_LINE_STRIP
#    define RT_TRIANGLES GL_TRIANGLES
#    define RT_TRIANGLE_FAN GL_TRIANGLE_FAN
#    define RT_QUADS GL_QUADS
#    define RT_QUAD_STRIP GL_QUAD_STRIP
#    define RT_ENABLE_BIT GL_ENABLE_BIT
#    define RT_POLYGON_BIT GL_POLYGON_BIT
#    define RT_NORMALIZE GL_NORMALIZE
#    define RT_FRONT_AND_BACK GL_FRONT_AND_BACK
#    define RT_FRONT GL_FRONT
#    define RT_BACK GL_BACK
#    define RT_LINE GL_LINE
#    define RT_FILL GL_FILL
#    define RT_POLYGON_MODE GL_POLYGON_MODE
#    define RT_ATTRIB_STACK_DEPTH GL_ATTRIB_STACK_DEPTH
#    define RT_MAX_ATTRIB_STACK_DEPTH GL_MAX_ATTRIB_STACK_DEPTH
#    define RT_UNPACK_SWAP_BYTES GL_UNPACK_SWAP_BYTES
#    define RT_UNPACK_LSB_FIRST GL_UNPACK_LSB_FIRST
#    define RT_UNPACK_ROW_LENGTH GL_UNPACK_ROW_LENGTH
#    define RT_UNPACK_SKIP_ROWS GL_UNPACK_SKIP_ROWS
#    define RT_UNPACK_SKIP_PIXELS GL_UNPACK_SKIP_PIXELS
#    define RT_UNPACK_ALIGNMENT GL_UNPACK_ALIGNMENT
#    define RTU_FILL GLU_FILL
#    define RTU_LINE GLU_LINE

#    define rtBegin glBegin
#    define rtEnd glEnd
#    define rtVertex2f glVertex2f
#    define rtVertex3f glVertex3f
#    define rtVertex3d glVertex3d
#    define rtNormal3f glNormal3f
#    define rtNormal3d glNormal3d
#    define rtTexCoord2d glTexCoord2d
#    define rtTranslatef glTranslatef
#    define rtPushAttrib glPushAttrib
#    define rtPopAttrib glPopAttrib
#    define rtPolygonMode glPolygonMode
#    define rtEnable glEnable
#    define rtDisable glDisable
#    define rtIsEnabled glIsEnabled
#    define rtBitmap glBitmap
#    define rtGetIntegerv glGetIntegerv
#    define rtPixelStorei glPixelStorei
#    define rtuNewQuadric gluNewQuadric
#    define rtuDeleteQuadric gluDeleteQuadric
#    define rtuQuadricDrawStyle gluQuadricDrawStyle
#    define rtuSphere gluSphere
#    define rtuCylinder gluCylinder

#    define rtutWireSphere glutWireSphere
#    define rtutSolidSphere glutSolidSphere
#    define rtutWireCone glutWireCone
#    define rtutSolidCone glutSolidCone
#    define rtutWireCube glutWireCube
#    define rtutSolidCube glutSolidCube
#    define rtutWireTorus glutWireTorus
#    define rtutSolidTorus glutSolidTorus
#    define rtutWireDodecahedron glutWireDodecahedron
#    define rtutSolidDodecahedron glutSolidDodecahedron
#    define rtutWireOctahedron glutWireOctahedron
#    define rtutSolidOctahedron glutSolidOctahedron
#    define rtutWireTetrahedron glutWireTetrahedron
#    define rtutSolidTetrahedron glutSolidTetrahedron
#    define rtutWireIcosahedron glutWireIcosahedron
#    define rtutSolidIcosahedron glutSolidIcosahedron
#    define rtutWireTeapot glutWireTeapot
#    define rtutSolidTeapot glutSolidTeapot
#    define rtutBitmapCharacter glutBitmapCharacter
#    define rtutBitmapWidth glutBitmapWidth
#    define rtutBitmapLength glutBitmapLength
#    define rtutStrokeCharacter glutStrokeCharacter
#    define rtutStrokeWidth glutStrokeWidth
#    define rtutStrokeLength glutStrokeLength
#else
#    include "openrt/rt.h"
#    include "openrt/rtu.h"
#    include "openrt/rtut.h"
#endif

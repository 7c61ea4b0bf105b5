/* SPDX-License-Identifier: MIT */
/* The part of GLUT 3.7 that the sample ports use, for the off-screen driver of OSMesa
 * (tests/conformance/osmesa_glut.c). Names, signatures and values are GLUT's. */
#ifndef OPENRT_CONFORMANCE_GLUT_H
#define OPENRT_CONFORMANCE_GLUT_H

#include <GL/gl.h>
#include <GL/glu.h>

#define GLUT_RGB 0
#define GLUT_RGBA 0
#define GLUT_INDEX 1
#define GLUT_SINGLE 0
#define GLUT_DOUBLE 2
#define GLUT_ACCUM 4
#define GLUT_ALPHA 8
#define GLUT_DEPTH 16
#define GLUT_STENCIL 32
#define GLUT_MULTISAMPLE 128

#define GLUT_WINDOW_WIDTH 102
#define GLUT_WINDOW_HEIGHT 103
#define GLUT_WINDOW_DEPTH_SIZE 106
#define GLUT_WINDOW_DOUBLEBUFFER 115
#define GLUT_INIT_WINDOW_WIDTH 502
#define GLUT_INIT_WINDOW_HEIGHT 503
#define GLUT_INIT_DISPLAY_MODE 504
#define GLUT_ELAPSED_TIME 700

#define GLUT_NOT_VISIBLE 0
#define GLUT_VISIBLE 1
#define GLUT_KEY_LEFT 100
#define GLUT_KEY_UP 101
#define GLUT_KEY_RIGHT 102
#define GLUT_KEY_DOWN 103

#define GLUT_STROKE_ROMAN ((void *)0)
#define GLUT_STROKE_MONO_ROMAN ((void *)1)
#define GLUT_BITMAP_9_BY_15 ((void *)2)
#define GLUT_BITMAP_8_BY_13 ((void *)3)
#define GLUT_BITMAP_TIMES_ROMAN_10 ((void *)4)
#define GLUT_BITMAP_TIMES_ROMAN_24 ((void *)5)
#define GLUT_BITMAP_HELVETICA_10 ((void *)6)
#define GLUT_BITMAP_HELVETICA_12 ((void *)7)
#define GLUT_BITMAP_HELVETICA_18 ((void *)8)

#ifdef __cplusplus
extern "C" {
#endif

void glutInit(int *argc, char **argv);
void glutInitDisplayMode(unsigned int mode);
void glutInitWindowSize(int width, int height);
void glutInitWindowPosition(int x, int y);
int glutCreateWindow(const char *title);
void glutMainLoop(void);
void glutPostRedisplay(void);
void glutSwapBuffers(void);
int glutGet(GLenum state);

void glutDisplayFunc(void (*callback)(void));
void glutReshapeFunc(void (*callback)(int width, int height));
void glutIdleFunc(void (*callback)(void));
void glutTimerFunc(unsigned int milliseconds, void (*callback)(int value), int value);
void glutVisibilityFunc(void (*callback)(int state));
void glutKeyboardFunc(void (*callback)(unsigned char key, int x, int y));
void glutSpecialFunc(void (*callback)(int key, int x, int y));
void glutMouseFunc(void (*callback)(int button, int state, int x, int y));
void glutMotionFunc(void (*callback)(int x, int y));

void glutBitmapCharacter(void *font, int character);
int glutBitmapWidth(void *font, int character);
int glutBitmapLength(void *font, const unsigned char *text);
void glutStrokeCharacter(void *font, int character);
int glutStrokeWidth(void *font, int character);
int glutStrokeLength(void *font, const unsigned char *text);

void glutWireSphere(GLdouble radius, GLint slices, GLint stacks);
void glutSolidSphere(GLdouble radius, GLint slices, GLint stacks);
void glutWireCone(GLdouble base, GLdouble height, GLint slices, GLint stacks);
void glutSolidCone(GLdouble base, GLdouble height, GLint slices, GLint stacks);
void glutWireCube(GLdouble size);
void glutSolidCube(GLdouble size);
void glutWireTorus(GLdouble innerRadius, GLdouble outerRadius, GLint sides, GLint rings);
void glutSolidTorus(GLdouble innerRadius, GLdouble outerRadius, GLint sides, GLint rings);
void glutWireDodecahedron(void);
void glutSolidDodecahedron(void);
void glutWireTeapot(GLdouble size);
void glutSolidTeapot(GLdouble size);
void glutWireOctahedron(void);
void glutSolidOctahedron(void);
void glutWireTetrahedron(void);
void glutSolidTetrahedron(void);
void glutWireIcosahedron(void);
void glutSolidIcosahedron(void);

#ifdef __cplusplus
}
#endif

#endif

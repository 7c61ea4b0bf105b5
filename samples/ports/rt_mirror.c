/* SPDX-License-Identifier: MIT */
/* rt_mirror: what the port `mirror` does with a stencil, in the library's own style: the floor and
 * a ball reflect the world and each other, with shadows and four samples a pixel.
 * Usage: rt_mirror [--rt-offscreen N --rt-output frame%03d.png] */
#include "openrt/rt.h"
#include "openrt/rtu.h"
#include "openrt/rtut.h"

static RTuint cube, ball;

static void makeObjects(void) {
    RTUquadric* quadric = rtuNewQuadric();
    cube = rtNewObject(RT_DEFINE);
    rtutSolidCube(0.9);
    rtEndObject();
    ball = rtNewObject(RT_DEFINE);
    rtuSphere(quadric, 0.6, 96, 64);
    rtEndObject();
    rtuDeleteQuadric(quadric);
}

static void surface(RTfloat red, RTfloat green, RTfloat blue, RTfloat reflection) {
    const RTfloat color[] = {red, green, blue, 1.0f};
    rtMaterialfv(RT_FRONT_AND_BACK, RT_AMBIENT_AND_DIFFUSE, color);
    rtMaterialf(RT_FRONT_AND_BACK, RT_REFLECTION, reflection);
}

static void place(RTuint object, RTfloat x, RTfloat y, RTfloat z, RTfloat turn) {
    rtPushMatrix();
    rtTranslatef(x, y, z);
    rtRotatef(turn, 0.2f, 1.0f, 0.0f);
    rtInstantiateObject(object);
    rtPopMatrix();
}

static void tile(int column, int row) {
    const RTfloat x = (RTfloat)column, z = (RTfloat)row,
                  shade = (column + row) % 2 == 0 ? 0.7f : 0.3f;
    surface(shade, shade, 0.9f * shade, 0.35f);
    rtNormal3f(0.0f, 1.0f, 0.0f);
    rtBegin(RT_QUADS);
    rtVertex3f(x, 0.0f, z + 1.0f);
    rtVertex3f(x + 1.0f, 0.0f, z + 1.0f);
    rtVertex3f(x + 1.0f, 0.0f, z);
    rtVertex3f(x, 0.0f, z);
    rtEnd();
}

static void display(void) {
    static const RTfloat light[] = {2.5f, 5.0f, 3.0f, 1.0f};
    const RTfloat turn = 30.0f + 0.05f * (RTfloat)rtutGet(RTUT_ELAPSED_TIME);
    rtClear(RT_COLOR_BUFFER_BIT | RT_DEPTH_BUFFER_BIT);
    rtPushMatrix();
    rtRotatef(15.0f, 0.0f, 1.0f, 0.0f);
    rtLightfv(RT_LIGHT0, RT_POSITION, light);
    for (int row = -3; row < 3; ++row)
        for (int column = -3; column < 3; ++column) tile(column, row);
    surface(0.9f, 0.4f, 0.2f, 0.0f);
    place(cube, -0.9f, 0.8f, 0.0f, turn);
    surface(0.2f, 0.2f, 0.25f, 0.7f);
    place(ball, 0.8f, 0.7f, 0.2f, 0.0f);
    rtPopMatrix();
    rtutSwapBuffers();
}

static void reshape(int width, int height) {
    rtViewport(0, 0, (RTsizei)width, (RTsizei)height);
    rtMatrixMode(RT_PROJECTION);
    rtLoadIdentity();
    rtPerspective(40.0, (RTdouble)width / height, 1.0, 30.0);
    rtMatrixMode(RT_MODELVIEW);
    rtLoadIdentity();
    rtLookAt(0.0, 2.6, 5.5, 0.0, 0.4, 0.0, 0.0, 1.0, 0.0);
}

int main(int argc, char** argv) {
    rtutInitWindowSize(600, 450);
    rtutInit(&argc, argv);
    rtutInitDisplayMode(RTUT_RGB | RTUT_DEPTH | RTUT_DOUBLE | RTUT_MULTISAMPLE);
    rtutCreateWindow("rt_mirror");
    rtClearColor(0.4f, 0.5f, 0.7f, 1.0f);
    rtEnable(RT_DEPTH_TEST);
    rtEnable(RT_LIGHTING);
    rtEnable(RT_LIGHT0);
    rtEnable(RT_SHADOWS);
    rtEnable(RT_REFLECTIONS);
    rtShadeModel(RT_PHONG);
    makeObjects();
    rtutDisplayFunc(display);
    rtutReshapeFunc(reshape);
    rtutIdleFunc(rtutPostRedisplay);
    rtutMainLoop();
    return 0;
}

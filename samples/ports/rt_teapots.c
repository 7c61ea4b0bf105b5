/* SPDX-License-Identifier: MIT */
/* rt_teapots: 24 materials on one teapot, in the library's own style. The teapot is compiled once,
 * an object; each instance takes the material that is current when it is placed. Lighting is
 * computed at every hit point (RT_PHONG), and rays find the shadows.
 * Usage: rt_teapots [--rt-offscreen N --rt-output frame%03d.png] */
#include "openrt/rt.h"
#include "openrt/rtu.h"
#include "openrt/rtut.h"

enum { kColumns = 6, kRows = 4 };

typedef struct {
    RTfloat diffuse[4], specular[4], shininess;
} Material;

static const Material stones[kRows] = {
    {{0.54f, 0.89f, 0.63f, 1.0f}, {0.32f, 0.32f, 0.32f, 1.0f}, 12.8f},
    {{0.71f, 0.43f, 0.18f, 1.0f}, {0.39f, 0.27f, 0.17f, 1.0f}, 25.6f},
    {{0.75f, 0.61f, 0.23f, 1.0f}, {0.63f, 0.56f, 0.37f, 1.0f}, 51.2f},
    {{0.61f, 0.04f, 0.04f, 1.0f}, {0.73f, 0.63f, 0.63f, 1.0f}, 76.8f}};

static RTuint teapot;

static RTuint makeTeapot(void) {
    const RTuint object = rtNewObject(RT_DEFINE);
    rtutSolidTeapot(1.0);
    rtEndObject();
    return object;
}

/* From left to right the stone turns to metal: less of the diffuse colour, more of a highlight. */
static void useMaterial(int column, int row) {
    const RTfloat metal = (RTfloat)column / (kColumns - 1);
    const Material* stone = &stones[row];
    RTfloat diffuse[4], specular[4], ambient[4];
    for (int i = 0; i < 4; ++i) {
        diffuse[i] = stone->diffuse[i] * (1.0f - 0.6f * metal);
        specular[i] = stone->specular[i] * (0.3f + 1.2f * metal);
        ambient[i] = stone->diffuse[i] * 0.5f;
    }
    rtMaterialfv(RT_FRONT_AND_BACK, RT_AMBIENT, ambient);
    rtMaterialfv(RT_FRONT_AND_BACK, RT_DIFFUSE, diffuse);
    rtMaterialfv(RT_FRONT_AND_BACK, RT_SPECULAR, specular);
    rtMaterialf(RT_FRONT_AND_BACK, RT_SHININESS, stone->shininess);
}

static void shelf(RTfloat y) {
    static const RTfloat gray[] = {0.6f, 0.6f, 0.6f, 1.0f};
    rtMaterialfv(RT_FRONT_AND_BACK, RT_AMBIENT_AND_DIFFUSE, gray);
    rtNormal3f(0.0f, 1.0f, 0.0f);
    rtBegin(RT_QUADS);
    rtVertex3f(-10.0f, y, 2.0f);
    rtVertex3f(10.0f, y, 2.0f);
    rtVertex3f(10.0f, y, -2.0f);
    rtVertex3f(-10.0f, y, -2.0f);
    rtEnd();
}

static void display(void) {
    static const RTfloat light[] = {-6.0f, 12.0f, 14.0f, 1.0f};
    const RTfloat turn = 0.03f * (RTfloat)rtutGet(RTUT_ELAPSED_TIME);
    rtClear(RT_COLOR_BUFFER_BIT | RT_DEPTH_BUFFER_BIT);
    rtLightfv(RT_LIGHT0, RT_POSITION, light);
    for (int row = 0; row < kRows; ++row) {
        const RTfloat y = -4.5f + 3.0f * (RTfloat)row;
        shelf(y - 0.76f);
        for (int column = 0; column < kColumns; ++column) {
            rtPushMatrix();
            rtTranslatef(-7.8f + 3.1f * (RTfloat)column, y, 0.0f);
            rtRotatef(turn, 0.0f, 1.0f, 0.0f);
            useMaterial(column, row);
            rtInstantiateObject(teapot);
            rtPopMatrix();
        }
    }
    rtutSwapBuffers();
}

static void reshape(int width, int height) {
    rtViewport(0, 0, (RTsizei)width, (RTsizei)height);
    rtMatrixMode(RT_PROJECTION);
    rtLoadIdentity();
    rtPerspective(34.0, (RTdouble)width / height, 1.0, 100.0);
    rtMatrixMode(RT_MODELVIEW);
    rtLoadIdentity();
    rtLookAt(0.0, 5.0, 26.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0);
}

int main(int argc, char** argv) {
    rtutInitWindowSize(800, 600);
    rtutInit(&argc, argv);
    rtutInitDisplayMode(RTUT_RGB | RTUT_DEPTH | RTUT_DOUBLE);
    rtutCreateWindow("rt_teapots");
    rtClearColor(0.15f, 0.18f, 0.22f, 1.0f);
    rtEnable(RT_DEPTH_TEST);
    rtEnable(RT_LIGHTING);
    rtEnable(RT_LIGHT0);
    rtEnable(RT_NORMALIZE);
    rtEnable(RT_SHADOWS);
    rtShadeModel(RT_PHONG);
    teapot = makeTeapot();
    rtutDisplayFunc(display);
    rtutReshapeFunc(reshape);
    rtutIdleFunc(rtutPostRedisplay);
    rtutMainLoop();
    return 0;
}

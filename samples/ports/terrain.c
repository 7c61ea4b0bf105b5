/* SPDX-License-Identifier: MIT */
/* terrain: a height field of triangle strips, coloured by height, lit, in fog, flown over. */
#include <GL/glut.h>
#include <math.h>

enum { kSize = 96, kBands = 8 };

static GLuint terrain;
static GLfloat flight;

static double height(double x, double y) {
    return 0.9 * sin(0.31 * x) * cos(0.27 * y) + 0.4 * sin(0.9 * x + 0.4 * y) +
           0.18 * sin(1.7 * y - 0.8 * x) * cos(1.3 * x);
}

static void vertex(int column, int row) {
    const double x = 0.25 * (column - kSize / 2), y = 0.25 * (row - kSize / 2), step = 0.05;
    const double z = height(x, y);
    const double dx = (height(x + step, y) - height(x - step, y)) / (2.0 * step),
                 dy = (height(x, y + step) - height(x, y - step)) / (2.0 * step);
    if (z < -0.5)
        glColor3f(0.25f, 0.4f, 0.3f);
    else
        glColor3d(0.4 + 0.3 * z, 0.5 + 0.1 * z, 0.2 + 0.3 * z);
    glNormal3d(-dx, 1.0, -dy);
    glVertex3d(x, z, y);
}

/* One list for each band: Mesa 22.3 fails on lists of about 20,000 vertices. */
static void band(int number) {
    const int rows = kSize / kBands;
    glNewList(terrain + (GLuint)number, GL_COMPILE);
    for (int row = number * rows; row < (number + 1) * rows; ++row) {
        glBegin(GL_TRIANGLE_STRIP);
        for (int column = 0; column <= kSize; ++column) {
            vertex(column, row);
            vertex(column, row + 1);
        }
        glEnd();
    }
    glEndList();
}

static void init(void) {
    static const GLfloat sun[] = {1.0f, 1.0f, 0.4f, 0.0f}, sky[] = {0.6f, 0.72f, 0.92f, 1.0f};
    glClearColor(sky[0], sky[1], sky[2], sky[3]);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_NORMALIZE);
    glEnable(GL_COLOR_MATERIAL);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    glEnable(GL_FOG);
    glFogi(GL_FOG_MODE, GL_LINEAR);
    glFogf(GL_FOG_START, 6.0f);
    glFogf(GL_FOG_END, 22.0f);
    glFogfv(GL_FOG_COLOR, sky);
    glLightfv(GL_LIGHT0, GL_POSITION, sun);
    terrain = glGenLists(kBands);
    for (int i = 0; i < kBands; ++i) band(i);
}

static void display(void) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glPushMatrix();
    gluLookAt(0.0, 3.4, 9.0 - flight, 0.0, 0.4, 2.0 - flight, 0.0, 1.0, 0.0);
    for (int i = 0; i < kBands; ++i) glCallList(terrain + (GLuint)i);
    glPopMatrix();
    glutSwapBuffers();
}

static void reshape(int width, int h) {
    glViewport(0, 0, width, h);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(50.0, (GLdouble)width / h, 0.5, 40.0);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

static void idle(void) {
    flight = 0.002f * (GLfloat)glutGet(GLUT_ELAPSED_TIME);
    glutPostRedisplay();
}

int main(int argc, char** argv) {
    glutInitWindowSize(600, 400);
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutCreateWindow("terrain");
    init();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutIdleFunc(idle);
    glutMainLoop();
    return 0;
}

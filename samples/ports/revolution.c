/* SPDX-License-Identifier: MIT */
/* revolution: a vase, a profile curve turned about an axis, with smooth normals; shiny, seen from
 * outside and inside. */
#include <GL/glut.h>
#include <math.h>

#define PI 3.14159265358979323846

enum { kSteps = 28, kTurns = 40 };

static GLuint vase;

static double profile(double t) {
    return 0.6 + 0.3 * sin(2.6 * t + 0.4) - 0.06 * t;
}

static void vertex(int step, int turn) {
    const double t = 2.4 * step / kSteps, h = 1e-4, around = 2.0 * PI * (turn % kTurns) / kTurns;
    const double slope = (profile(t + h) - profile(t - h)) / (2.0 * h), radius = profile(t);
    const double length = sqrt(1.0 + slope * slope);
    glNormal3d(cos(around) / length, -slope / length, sin(around) / length);
    glVertex3d(radius * cos(around), t - 1.2, radius * sin(around));
}

static void makeVase(void) {
    vase = glGenLists(1);
    glNewList(vase, GL_COMPILE);
    for (int step = 0; step < kSteps; ++step) {
        glBegin(GL_TRIANGLE_STRIP);
        for (int turn = 0; turn <= kTurns; ++turn) {
            vertex(step, turn);
            vertex(step + 1, turn);
        }
        glEnd();
    }
    glEndList();
}

static void display(void) {
    const GLfloat turn = 0.04f * (GLfloat)glutGet(GLUT_ELAPSED_TIME);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glPushMatrix();
    glRotatef(35.0f, 1.0f, 0.0f, 0.0f);
    glRotatef(turn, 0.3f, 1.0f, 0.0f);
    glCallList(vase);
    glPopMatrix();
    glutSwapBuffers();
}

static void reshape(int width, int height) {
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(40.0, (GLdouble)width / height, 1.0, 20.0);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(0.0f, 0.0f, -4.2f);
}

int main(int argc, char** argv) {
    static const GLfloat position[] = {2.0f, 2.0f, 3.0f, 1.0f},
                         outside[] = {0.7f, 0.3f, 0.25f, 1.0f},
                         inside[] = {0.3f, 0.35f, 0.5f, 1.0f}, white[] = {0.9f, 0.9f, 0.9f, 1.0f};
    glutInitWindowSize(400, 500);
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutCreateWindow("revolution");
    glClearColor(0.32f, 0.35f, 0.32f, 1.0f);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, inside);
    glMaterialfv(GL_BACK, GL_AMBIENT_AND_DIFFUSE, outside);
    glFrontFace(GL_CCW);
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, white);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 30.0f);
    makeVase();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutIdleFunc(glutPostRedisplay);
    glutMainLoop();
    return 0;
}

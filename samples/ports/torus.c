/* SPDX-License-Identifier: MIT */
/* torus: a coloured torus of quad strips in a display list, without lights. */
#include <GL/glut.h>
#include <math.h>

#define PI 3.14159265358979323846

enum { kRings = 40, kSides = 24 };

static GLuint torus;

static void vertex(int ring, int side) {
    const double around = 2.0 * PI * (ring % kRings) / kRings,
                 tube = 2.0 * PI * (side % kSides) / kSides;
    const double radius = 1.0 + 0.4 * cos(tube);
    glColor3d(0.5 + 0.5 * cos(around), 0.5 + 0.5 * sin(tube), 0.5 - 0.5 * cos(tube));
    glVertex3d(radius * cos(around), radius * sin(around), 0.4 * sin(tube));
}

static GLuint makeTorus(void) {
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    for (int side = 0; side < kSides; ++side) {
        glBegin(GL_QUAD_STRIP);
        for (int ring = 0; ring <= kRings; ++ring) {
            vertex(ring, side + 1);
            vertex(ring, side);
        }
        glEnd();
    }
    glEndList();
    return list;
}

static void display(void) {
    const GLfloat turn = 0.05f * (GLfloat)glutGet(GLUT_ELAPSED_TIME);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glPushMatrix();
    glRotatef(-50.0f + turn, 1.0f, 0.0f, 0.0f);
    glRotatef(turn, 0.0f, 1.0f, 0.0f);
    glCallList(torus);
    glPopMatrix();
    glutSwapBuffers();
}

static void reshape(int width, int height) {
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(35.0, (GLdouble)width / height, 1.0, 50.0);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(0.0, 0.0, 5.5, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0);
}

int main(int argc, char** argv) {
    glutInitWindowSize(400, 400);
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutCreateWindow("torus");
    glEnable(GL_DEPTH_TEST);
    torus = makeTorus();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutIdleFunc(glutPostRedisplay);
    glutMainLoop();
    return 0;
}

/* SPDX-License-Identifier: MIT */
/* varray: one geometry drawn by ArrayElement, DrawArrays, DrawElements and interleaved arrays. */
#include <GL/glut.h>
#include <math.h>

enum { kPoints = 12 };

typedef struct {
    GLfloat color[3];
    GLfloat position[3];
} Vertex;

static Vertex star[kPoints + 2];
static GLfloat angle;

static void makeStar(void) {
    const double pi = 3.14159265358979323846;
    star[0] = (Vertex){{1.0f, 1.0f, 1.0f}, {0.0f, 0.0f, 0.3f}};
    for (int i = 0; i <= kPoints; ++i) {
        const double turn = 2.0 * pi * (i % kPoints) / kPoints, radius = i % 2 ? 0.4 : 0.9;
        star[i + 1] =
            (Vertex){{(GLfloat)(0.5 + 0.5 * cos(turn)), (GLfloat)(0.5 + 0.5 * sin(turn)),
                      i % 2 ? 0.2f : 0.9f},
                     {(GLfloat)(radius * cos(turn)), (GLfloat)(radius * sin(turn)), 0.0f}};
    }
}

static void pointers(void) {
    glEnableClientState(GL_COLOR_ARRAY);
    glEnableClientState(GL_VERTEX_ARRAY);
    glColorPointer(3, GL_FLOAT, sizeof(Vertex), star[0].color);
    glVertexPointer(3, GL_FLOAT, sizeof(Vertex), star[0].position);
}

static void byElement(void) {
    pointers();
    glBegin(GL_TRIANGLE_FAN);
    for (int i = 0; i < kPoints + 2; ++i) glArrayElement(i);
    glEnd();
}

static void byArrays(void) {
    pointers();
    glDrawArrays(GL_TRIANGLE_FAN, 0, kPoints + 2);
}

static void byElements(void) {
    GLushort indices[3 * kPoints];
    pointers();
    for (int i = 0; i < kPoints; ++i) {
        indices[3 * i] = 0;
        indices[3 * i + 1] = (GLushort)(i + 1);
        indices[3 * i + 2] = (GLushort)(i + 2);
    }
    glDrawElements(GL_TRIANGLES, 3 * kPoints, GL_UNSIGNED_SHORT, indices);
}

static void interleaved(void) {
    static const GLubyte indices[] = {0, 1, 3, 0, 3, 5, 0, 5, 7, 0, 7, 9, 0, 9, 11, 0, 11, 13};
    glInterleavedArrays(GL_C3F_V3F, 0, star);
    glDrawElements(GL_TRIANGLES, 18, GL_UNSIGNED_BYTE, indices);
}

static void display(void) {
    static void (*const draws[])(void) = {byElement, byArrays, byElements, interleaved};
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (int i = 0; i < 4; ++i) {
        glPushMatrix();
        glTranslatef(i % 2 ? 1.1f : -1.1f, i < 2 ? 1.1f : -1.1f, 0.0f);
        glRotatef(angle + 20.0f * (GLfloat)i, 0.3f, 1.0f, 0.0f);
        draws[i]();
        glPopMatrix();
    }
    glutSwapBuffers();
}

static void reshape(int width, int height) {
    const GLdouble w = width > height ? 2.2 * width / height : 2.2,
                   h = width > height ? 2.2 : 2.2 * height / width;
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(-w, w, -h, h, -5.0, 5.0);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

static void idle(void) {
    angle = 0.04f * (GLfloat)glutGet(GLUT_ELAPSED_TIME);
    glutPostRedisplay();
}

int main(int argc, char** argv) {
    glutInitWindowSize(400, 400);
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutCreateWindow("varray");
    glClearColor(0.0f, 0.0f, 0.2f, 1.0f);
    glEnable(GL_DEPTH_TEST);
    makeStar();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutIdleFunc(idle);
    glutMainLoop();
    return 0;
}

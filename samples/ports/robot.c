/* SPDX-License-Identifier: MIT */
/* robot: an arm of boxes with a hand of three fingers; the matrix stack as joints. */
#include <GL/glut.h>
#include <math.h>

static GLfloat shoulder, elbow, grip;

static void box(GLfloat length, GLfloat height, GLfloat depth) {
    glPushMatrix();
    glTranslatef(length / 2.0f, 0.0f, 0.0f);
    glScalef(length, height, depth);
    glutSolidCube(1.0);
    glPopMatrix();
}

static void finger(GLfloat z, GLfloat turn) {
    glPushMatrix();
    glTranslatef(0.0f, 0.0f, z);
    glRotatef(turn, 0.0f, 0.0f, 1.0f);
    box(0.4f, 0.1f, 0.12f);
    glTranslatef(0.4f, 0.0f, 0.0f);
    glRotatef(-1.4f * turn, 0.0f, 0.0f, 1.0f);
    box(0.3f, 0.08f, 0.1f);
    glPopMatrix();
}

static void display(void) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glPushMatrix();
    glRotatef(25.0f, 1.0f, 1.0f, 0.0f);
    glTranslatef(-2.0f, 0.0f, 0.0f);
    glColor3f(0.9f, 0.5f, 0.1f);
    glutSolidSphere(0.35, 20, 14);
    glRotatef(shoulder, 0.0f, 0.0f, 1.0f);
    glColor3f(0.3f, 0.5f, 0.8f);
    box(2.0f, 0.4f, 0.8f);
    glTranslatef(2.0f, 0.0f, 0.0f);
    glColor3f(0.9f, 0.5f, 0.1f);
    glutSolidSphere(0.35, 20, 14);
    glRotatef(elbow, 0.0f, 0.0f, 1.0f);
    glColor3f(0.3f, 0.7f, 0.5f);
    box(1.6f, 0.35f, 0.7f);
    glTranslatef(1.6f, 0.0f, 0.0f);
    glColor3f(0.8f, 0.8f, 0.7f);
    finger(0.25f, grip);
    finger(-0.25f, grip);
    finger(0.0f, -grip);
    glPopMatrix();
    glutSwapBuffers();
}

static void reshape(int width, int height) {
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(50.0, (GLdouble)width / height, 1.0, 20.0);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(0.0f, -0.3f, -5.5f);
}

static void step(int tick) {
    shoulder = 20.0f * (GLfloat)sin(0.1 * tick);
    elbow = 40.0f + 25.0f * (GLfloat)cos(0.13 * tick);
    grip = 25.0f + 15.0f * (GLfloat)sin(0.3 * tick);
    glutTimerFunc(40, step, tick + 1);
    glutPostRedisplay();
}

int main(int argc, char** argv) {
    static const GLfloat position[] = {2.0f, 4.0f, 6.0f, 0.0f};
    glutInitWindowSize(500, 400);
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutCreateWindow("robot");
    glClearColor(0.12f, 0.12f, 0.15f, 1.0f);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_NORMALIZE);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_COLOR_MATERIAL);
    glColorMaterial(GL_FRONT, GL_AMBIENT_AND_DIFFUSE);
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    step(0);
    glutMainLoop();
    return 0;
}

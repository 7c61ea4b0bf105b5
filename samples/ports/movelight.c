/* SPDX-License-Identifier: MIT */
/* movelight: a light that the model-view matrix carries around a torus; a small cube marks it. */
#include <GL/glut.h>

static void display(void) {
    static const GLfloat position[] = {0.0f, 0.0f, 1.5f, 1.0f};
    const GLfloat turn = 30.0f + 0.09f * (GLfloat)glutGet(GLUT_ELAPSED_TIME);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glPushMatrix();
    gluLookAt(0.0, 0.0, 5.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0);

    glPushMatrix();
    glRotatef(turn, 1.0f, 0.4f, 0.0f);
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glTranslatef(0.0f, 0.0f, 1.5f);
    glDisable(GL_LIGHTING);
    glColor3f(0.0f, 1.0f, 1.0f);
    glutSolidCube(0.1);
    glEnable(GL_LIGHTING);
    glPopMatrix();

    glRotatef(35.0f, 1.0f, 0.0f, 0.0f);
    glutSolidTorus(0.275, 0.85, 18, 30);
    glPopMatrix();
    glFlush();
}

static void reshape(int width, int height) {
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(40.0, (GLdouble)width / height, 1.0, 20.0);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

int main(int argc, char** argv) {
    glutInitWindowSize(500, 500);
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_SINGLE | GLUT_RGB | GLUT_DEPTH);
    glutCreateWindow("movelight");
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glShadeModel(GL_SMOOTH);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutIdleFunc(glutPostRedisplay);
    glutMainLoop();
    return 0;
}

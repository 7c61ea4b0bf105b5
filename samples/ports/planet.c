/* SPDX-License-Identifier: MIT */
/* planet: a sun, a planet and its moon; the matrix stack as a hierarchy of motions. */
#include <GL/glut.h>

static GLfloat year, day;

static void ball(GLfloat red, GLfloat green, GLfloat blue, GLdouble radius, int detail) {
    glColor3f(red, green, blue);
    glutSolidSphere(radius, detail, detail);
}

static void display(void) {
    static const GLfloat sun[] = {0.0f, 0.0f, 0.0f, 1.0f}, glow[] = {0.9f, 0.7f, 0.2f, 1.0f},
                         dark[] = {0.0f, 0.0f, 0.0f, 1.0f};
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glPushMatrix();
    glRotatef(15.0f, 1.0f, 0.0f, 0.0f);
    glLightfv(GL_LIGHT0, GL_POSITION, sun);

    glMaterialfv(GL_FRONT, GL_EMISSION, glow);
    ball(0.6f, 0.4f, 0.1f, 1.0, 24);
    glMaterialfv(GL_FRONT, GL_EMISSION, dark);

    glRotatef(year, 0.0f, 1.0f, 0.0f);
    glTranslatef(2.2f, 0.0f, 0.0f);
    glPushMatrix();
    glRotatef(day, 0.0f, 1.0f, 0.0f);
    ball(0.2f, 0.4f, 0.9f, 0.4, 16);
    glPopMatrix();

    glRotatef(3.0f * year, 0.0f, 1.0f, 0.2f);
    glTranslatef(0.75f, 0.0f, 0.0f);
    ball(0.8f, 0.8f, 0.8f, 0.12, 12);
    glPopMatrix();
    glutSwapBuffers();
}

static void reshape(int width, int height) {
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(60.0, (GLdouble)width / height, 1.0, 20.0);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(0.0, 0.0, 5.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0);
}

static void idle(void) {
    const int now = glutGet(GLUT_ELAPSED_TIME);
    year = 40.0f + 0.05f * (GLfloat)now;
    day = 0.36f * (GLfloat)now;
    glutPostRedisplay();
}

int main(int argc, char** argv) {
    glutInitWindowSize(500, 500);
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutCreateWindow("planet");
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_COLOR_MATERIAL);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutIdleFunc(idle);
    glutMainLoop();
    return 0;
}

/* SPDX-License-Identifier: MIT */
/* panes: transparent panes sorted from back to front over opaque solids, then additive light. */
#include <GL/glut.h>

static GLfloat angle;

static void pane(GLfloat z, GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha) {
    glColor4f(red, green, blue, alpha);
    glBegin(GL_QUADS);
    glVertex3f(-0.9f, -0.9f, z);
    glVertex3f(0.9f, -0.9f, z);
    glVertex3f(0.9f, 0.9f, z);
    glVertex3f(-0.9f, 0.9f, z);
    glEnd();
}

static void glow(GLfloat x, GLfloat y) {
    glBegin(GL_TRIANGLE_FAN);
    glColor4f(0.8f, 0.72f, 0.32f, 1.0f);
    glVertex3f(x, y, 1.2f);
    glColor4f(0.0f, 0.0f, 0.0f, 1.0f);
    glVertex3f(x + 0.5f, y, 1.2f);
    glVertex3f(x, y + 0.5f, 1.2f);
    glVertex3f(x - 0.5f, y, 1.2f);
    glVertex3f(x, y - 0.5f, 1.2f);
    glVertex3f(x + 0.5f, y, 1.2f);
    glEnd();
}

static void solids(void) {
    glEnable(GL_LIGHTING);
    glPushMatrix();
    glRotatef(angle, 0.3f, 1.0f, 0.0f);
    glColor3f(0.8f, 0.8f, 0.92f);
    glutSolidCube(0.9);
    glPopMatrix();
    glDisable(GL_LIGHTING);
}

static void display(void) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    solids();
    glEnable(GL_BLEND);
    glDepthMask(GL_FALSE);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glPushMatrix();
    glRotatef(25.0f, 0.0f, 1.0f, 0.0f);
    pane(-0.8f, 1.0f, 0.2f, 0.2f, 0.52f);
    pane(0.12f, 0.2f, 1.0f, 0.2f, 0.4f);
    pane(0.92f, 0.2f, 0.4f, 1.0f, 0.32f);
    glPopMatrix();
    glBlendFunc(GL_ONE, GL_ONE);
    glow(-0.7f, 0.6f);
    glow(0.5f, -0.5f);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glutSwapBuffers();
}

static void reshape(int width, int height) {
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(45.0, (GLdouble)width / height, 1.0, 20.0);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(0.0f, 0.0f, -4.0f);
}

static void idle(void) {
    angle = 30.0f + 0.05f * (GLfloat)glutGet(GLUT_ELAPSED_TIME);
    glutPostRedisplay();
}

int main(int argc, char** argv) {
    glutInitWindowSize(400, 400);
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutCreateWindow("panes");
    glClearColor(0.12f, 0.12f, 0.12f, 1.0f);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHT0);
    glEnable(GL_COLOR_MATERIAL);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutIdleFunc(idle);
    glutMainLoop();
    return 0;
}

/* SPDX-License-Identifier: MIT */
/* overlay: a lit scene in space, then panels, bars and a frame in pixel coordinates over it. */
#include <GL/glut.h>
#include <math.h>

static int windowWidth, windowHeight;
static GLfloat angle;

static void scene(void) {
    glEnable(GL_LIGHTING);
    glEnable(GL_DEPTH_TEST);
    glPushMatrix();
    glTranslatef(0.0f, 0.0f, -5.0f);
    glRotatef(angle, 0.4f, 1.0f, 0.0f);
    glutSolidTeapot(1.1);
    glPopMatrix();
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_LIGHTING);
}

static void beginOverlay(void) {
    glMatrixMode(GL_PROJECTION);
    glPushMatrix();
    glLoadIdentity();
    gluOrtho2D(0.0, windowWidth, 0.0, windowHeight);
    glMatrixMode(GL_MODELVIEW);
}

static void endOverlay(void) {
    glMatrixMode(GL_PROJECTION);
    glPopMatrix();
    glMatrixMode(GL_MODELVIEW);
}

static void panel(void) {
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glColor4f(0.12f, 0.12f, 0.32f, 0.6f);
    glRecti(0, 0, windowWidth, windowHeight / 5);
    glDisable(GL_BLEND);
    for (int i = 0; i < 8; ++i) {
        const double value = 0.5 + 0.45 * sin(0.05 * angle + i);
        const GLfloat left = (GLfloat)(windowWidth * (i + 1) / 10),
                      top = (GLfloat)floor(value * windowHeight / 5.0);
        glColor3f(0.32f + 0.08f * (GLfloat)i, 0.8f - 0.05f * (GLfloat)i, 0.4f);
        glRectf(left, 0.0f, left + (GLfloat)(windowWidth / 14), top);
    }
}

static void frame(void) {
    glColor3f(1.0f, 0.92f, 0.2f);
    glLineWidth(3.0f);
    glBegin(GL_LINES);
    glVertex2f(8.5f, 5.5f);
    glVertex2f((GLfloat)windowWidth - 8.5f, 5.5f);
    glVertex2f(8.5f, (GLfloat)windowHeight - 5.5f);
    glVertex2f((GLfloat)windowWidth - 8.5f, (GLfloat)windowHeight - 5.5f);
    glVertex2f(5.5f, 8.5f);
    glVertex2f(5.5f, (GLfloat)windowHeight - 8.5f);
    glVertex2f((GLfloat)windowWidth - 5.5f, 8.5f);
    glVertex2f((GLfloat)windowWidth - 5.5f, (GLfloat)windowHeight - 8.5f);
    glVertex2f(10.5f, 32.5f);
    glVertex2f(20.5f, 32.5f);
    glVertex2f(32.5f, 10.5f);
    glVertex2f(32.5f, 20.5f);
    glEnd();
    glPointSize(7.0f);
    glBegin(GL_POINTS);
    for (int i = 0; i < 5; ++i)
        glVertex2f((GLfloat)(windowWidth / 2 - 30 + 15 * i) + 0.5f, (GLfloat)windowHeight - 19.5f);
    glEnd();
}

static void display(void) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    scene();
    beginOverlay();
    panel();
    frame();
    endOverlay();
    glutSwapBuffers();
}

static void reshape(int width, int height) {
    windowWidth = width;
    windowHeight = height;
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(45.0, (GLdouble)width / height, 1.0, 20.0);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

static void idle(void) {
    angle = 20.0f + 0.05f * (GLfloat)glutGet(GLUT_ELAPSED_TIME);
    glutPostRedisplay();
}

int main(int argc, char** argv) {
    static const GLfloat position[] = {2.0f, 3.0f, 4.0f, 0.0f};
    glutInitWindowSize(500, 400);
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutCreateWindow("overlay");
    glClearColor(0.2f, 0.32f, 0.32f, 1.0f);
    glEnable(GL_LIGHT0);
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutIdleFunc(idle);
    glutMainLoop();
    return 0;
}

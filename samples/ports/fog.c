/* SPDX-License-Identifier: MIT */
/* fog: rows of red spheres in the three kinds of fog, which grows denser. */
#include <GL/glut.h>

static GLfloat density = 0.35f;

static void row(GLint mode, GLfloat y) {
    glFogi(GL_FOG_MODE, mode);
    for (int i = 0; i < 5; ++i) {
        glPushMatrix();
        glTranslatef(-2.2f + 1.05f * (GLfloat)i, y + 0.15f * (GLfloat)i, -2.0f - (GLfloat)i);
        glutSolidSphere(0.5, 24, 18);
        glPopMatrix();
    }
}

static void display(void) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glFogf(GL_FOG_DENSITY, density);
    row(GL_EXP, 1.2f);
    row(GL_EXP2, -0.3f);
    row(GL_LINEAR, -1.8f);
    glFlush();
}

static void reshape(int width, int height) {
    const GLdouble w = width > height ? 2.8 * width / height : 2.8,
                   h = width > height ? 2.8 : 2.8 * height / width;
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(-w, w, -h, h, -10.0, 10.0);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

static void idle(void) {
    density = 0.35f + 0.0002f * (GLfloat)glutGet(GLUT_ELAPSED_TIME);
    glutPostRedisplay();
}

static void init(void) {
    static const GLfloat position[] = {0.5f, 0.5f, 3.0f, 0.0f},
                         color[] = {0.52f, 0.52f, 0.52f, 1.0f},
                         ambient[] = {0.17f, 0.01f, 0.01f, 1.0f},
                         diffuse[] = {0.61f, 0.04f, 0.04f, 1.0f},
                         specular[] = {0.73f, 0.63f, 0.63f, 1.0f};
    glEnable(GL_DEPTH_TEST);
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glMaterialfv(GL_FRONT, GL_AMBIENT, ambient);
    glMaterialfv(GL_FRONT, GL_DIFFUSE, diffuse);
    glMaterialfv(GL_FRONT, GL_SPECULAR, specular);
    glMaterialf(GL_FRONT, GL_SHININESS, 60.0f);
    glEnable(GL_FOG);
    glFogfv(GL_FOG_COLOR, color);
    glHint(GL_FOG_HINT, GL_NICEST);
    glFogf(GL_FOG_START, 1.0f);
    glFogf(GL_FOG_END, 7.0f);
    glClearColor(0.52f, 0.52f, 0.52f, 1.0f);
}

int main(int argc, char** argv) {
    glutInitWindowSize(500, 500);
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_SINGLE | GLUT_RGB | GLUT_DEPTH);
    glutCreateWindow("fog");
    init();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutIdleFunc(idle);
    glutMainLoop();
    return 0;
}

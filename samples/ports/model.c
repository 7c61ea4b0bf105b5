/* SPDX-License-Identifier: MIT */
/* model: the order of transforms, unequal scales and what they do to normals. */
#include <GL/glut.h>

static GLuint shape;
static GLfloat angle;

typedef void (*Transform)(void);

static void turnThenMove(void) {
    glTranslatef(0.6f, 0.0f, 0.0f);
    glRotatef(angle, 0.0f, 0.0f, 1.0f);
}

static void moveThenTurn(void) {
    glRotatef(angle, 0.0f, 0.0f, 1.0f);
    glTranslatef(0.6f, 0.0f, 0.0f);
}

static void stretch(void) {
    glScalef(1.5f, 0.5f, 0.75f);
}

static void mirrorImage(void) {
    glRotatef(angle, 0.0f, 1.0f, 0.0f);
    glScalef(-1.0f, 1.0f, 0.6f);
}

static void shearMatrix(void) {
    static const GLdouble shear[16] = {1.0, 0.0, 0.0, 0.0, 0.6, 1.0, 0.0, 0.0,
                                       0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0};
    glMultMatrixd(shear);
}

static void spin(void) {
    glRotated(angle, 1.0, 1.0, 1.0);
}

static void display(void) {
    static const Transform transforms[] = {turnThenMove, moveThenTurn, stretch,
                                           mirrorImage,  shearMatrix,  spin};
    static const GLfloat colors[6][3] = {{0.9f, 0.3f, 0.3f}, {0.3f, 0.9f, 0.3f},
                                         {0.4f, 0.4f, 0.9f}, {0.9f, 0.9f, 0.3f},
                                         {0.3f, 0.9f, 0.9f}, {0.9f, 0.4f, 0.9f}};
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (int i = 0; i < 6; ++i) {
        glPushMatrix();
        glTranslatef(2.6f * (GLfloat)(i % 3 - 1), i < 3 ? 1.3f : -1.3f, 0.0f);
        glColor3fv(colors[i]);
        transforms[i]();
        glCallList(shape);
        glPopMatrix();
    }
    glutSwapBuffers();
}

static void reshape(int width, int height) {
    const GLdouble halfWidth = 2.6 * width / height;
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    if (halfWidth < 4.0)
        glFrustum(-0.5, 0.5, -0.5 * height / width, 0.5 * height / width, 1.0, 20.0);
    else
        glFrustum(-halfWidth / 8.0, halfWidth / 8.0, -0.325, 0.325, 1.0, 20.0);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(0.0f, 0.0f, -8.0f);
}

static void idle(void) {
    angle = 25.0f + 0.06f * (GLfloat)glutGet(GLUT_ELAPSED_TIME);
    glutPostRedisplay();
}

int main(int argc, char** argv) {
    static const GLfloat position[] = {1.0f, 2.0f, 3.0f, 0.0f};
    glutInitWindowSize(600, 400);
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutCreateWindow("model");
    glClearColor(0.2f, 0.2f, 0.2f, 1.0f);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_NORMALIZE);
    glEnable(GL_COLOR_MATERIAL);
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    shape = glGenLists(1);
    glNewList(shape, GL_COMPILE);
    glutSolidCone(0.7, 1.4, 24, 8);
    glutSolidOctahedron();
    glEndList();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutIdleFunc(idle);
    glutMainLoop();
    return 0;
}

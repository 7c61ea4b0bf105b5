/* SPDX-License-Identifier: MIT */
/* mirror: solids over a polished floor. With OpenGL the world is drawn again upside down where the
 * stencil has the floor; with OpenRT the floor reflects. */
#include <GL/glut.h>

static const GLfloat light[] = {1.5f, 4.0f, 2.5f, 1.0f};
static GLfloat angle;
static int raysReflect;

static void solids(void) {
    glPushMatrix();
    glTranslatef(-0.8f, 0.8f, 0.0f);
    glRotatef(angle, 0.2f, 1.0f, 0.0f);
    glColor3f(0.9f, 0.4f, 0.2f);
    glutSolidCube(0.9);
    glPopMatrix();
    glPushMatrix();
    glTranslatef(0.8f, 0.7f, 0.2f);
    glColor3f(0.3f, 0.5f, 0.9f);
    glutSolidSphere(0.6, 32, 24);
    glPopMatrix();
}

static void floorPlane(GLfloat alpha) {
    glColor4f(0.5f, 0.6f, 0.5f, alpha);
    glNormal3f(0.0f, 1.0f, 0.0f);
    glBegin(GL_QUADS);
    glVertex3f(-2.0f, 0.0f, 2.0f);
    glVertex3f(2.0f, 0.0f, 2.0f);
    glVertex3f(2.0f, 0.0f, -2.0f);
    glVertex3f(-2.0f, 0.0f, -2.0f);
    glEnd();
}

/* The floor's pixels get 1 in the stencil, and the mirrored world is drawn there. */
static void mirroredWorld(void) {
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, 1, 1);
    glStencilOp(GL_REPLACE, GL_REPLACE, GL_REPLACE);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDisable(GL_DEPTH_TEST);
    floorPlane(1.0f);
    glEnable(GL_DEPTH_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glStencilFunc(GL_EQUAL, 1, 1);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    glPushMatrix();
    glScalef(1.0f, -1.0f, 1.0f);
    glLightfv(GL_LIGHT0, GL_POSITION, light);
    solids();
    glPopMatrix();
    glLightfv(GL_LIGHT0, GL_POSITION, light);
    glClear(GL_DEPTH_BUFFER_BIT);
    glDisable(GL_STENCIL_TEST);
}

static void display(void) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glPushMatrix();
    glRotatef(25.0f, 1.0f, 0.0f, 0.0f);
    glRotatef(15.0f, 0.0f, 1.0f, 0.0f);
    glLightfv(GL_LIGHT0, GL_POSITION, light);
#ifdef OPENRT
    raysReflect = 1;
    glEnable(RT_REFLECTIONS);
    glMaterialf(GL_FRONT, RT_REFLECTION, 0.6f);
    floorPlane(1.0f);
    glMaterialf(GL_FRONT, RT_REFLECTION, 0.0f);
#endif
    if (!raysReflect) {
        mirroredWorld();
        glEnable(GL_BLEND);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        floorPlane(0.4f);
        glDisable(GL_BLEND);
    }
    solids();
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
    glTranslatef(0.0f, -0.4f, -6.0f);
}

static void idle(void) {
    angle = 30.0f + 0.05f * (GLfloat)glutGet(GLUT_ELAPSED_TIME);
    glutPostRedisplay();
}

int main(int argc, char** argv) {
    glutInitWindowSize(500, 400);
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH | GLUT_STENCIL);
    glutCreateWindow("mirror");
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_COLOR_MATERIAL);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutIdleFunc(idle);
    glutMainLoop();
    return 0;
}

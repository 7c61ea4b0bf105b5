/* SPDX-License-Identifier: MIT */
/* clip: two clip planes cut a sphere open; its inside is seen, lit from both sides. */
#include <GL/glut.h>

static void display(void) {
    static const GLdouble horizontal[] = {0.0, -1.0, 0.0, 0.15}, vertical[] = {1.0, 0.0, 0.0, 0.3};
    const GLfloat turn = 0.05f * (GLfloat)glutGet(GLUT_ELAPSED_TIME);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glPushMatrix();
    glRotatef(30.0f, 1.0f, 0.0f, 0.0f);
    glRotatef(turn, 0.0f, 1.0f, 0.0f);
    glClipPlane(GL_CLIP_PLANE0, horizontal);
    glEnable(GL_CLIP_PLANE0);
    glClipPlane(GL_CLIP_PLANE1, vertical);
    glEnable(GL_CLIP_PLANE1);
    glutSolidSphere(1.0, 32, 24);
    glDisable(GL_CLIP_PLANE0);
    glDisable(GL_CLIP_PLANE1);
    glutSolidCube(0.5);
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
    glTranslatef(0.0f, 0.0f, -3.5f);
}

int main(int argc, char** argv) {
    static const GLfloat position[] = {1.0f, 2.0f, 3.0f, 1.0f}, front[] = {0.2f, 0.5f, 0.9f, 1.0f},
                         back[] = {0.9f, 0.5f, 0.2f, 1.0f};
    glutInitWindowSize(500, 500);
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutCreateWindow("clip");
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, front);
    glMaterialfv(GL_BACK, GL_AMBIENT_AND_DIFFUSE, back);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutIdleFunc(glutPostRedisplay);
    glutMainLoop();
    return 0;
}

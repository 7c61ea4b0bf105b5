/* SPDX-License-Identifier: MIT */
/* nested_lists: lists that call lists, that change state which stays, and names from a base. */
#include <GL/glut.h>

enum { kLeaf, kBranch, kTree, kRow, kColors, kLists = kColors + 4 };

static GLuint base;

static void leafList(void) {
    glNewList(base + kLeaf, GL_COMPILE);
    glBegin(GL_TRIANGLES);
    glNormal3f(0.0f, 0.0f, 1.0f);
    glVertex3f(-0.12f, 0.0f, 0.0f);
    glVertex3f(0.12f, 0.0f, 0.0f);
    glVertex3f(0.0f, 0.45f, 0.1f);
    glEnd();
    glEndList();
}

static void branchList(void) {
    glNewList(base + kBranch, GL_COMPILE);
    for (int i = 0; i < 6; ++i) {
        glPushMatrix();
        glRotatef(60.0f * (GLfloat)i, 0.0f, 1.0f, 0.0f);
        glTranslatef(0.0f, 0.0f, 0.25f);
        glRotatef(50.0f, 1.0f, 0.0f, 0.0f);
        glCallList(base + kLeaf);
        glPopMatrix();
    }
    glEndList();
}

static void treeList(void) {
    glNewList(base + kTree, GL_COMPILE);
    glPushMatrix();
    for (int i = 0; i < 4; ++i) {
        glCallList(base + kBranch);
        glTranslatef(0.0f, 0.3f, 0.0f);
        glScalef(0.75f, 0.9f, 0.75f);
    }
    glPopMatrix();
    glEndList();
}

/* A row leaves the matrix moved: what a list does stays done. */
static void rowList(void) {
    static const GLubyte calls[] = {kColors, kTree, kColors + 1, kTree, kColors + 2, kTree};
    glNewList(base + kRow, GL_COMPILE);
    for (int i = 0; i < 3; ++i) {
        glCallLists(2, GL_UNSIGNED_BYTE, calls + 2 * i);
        glTranslatef(1.1f, 0.0f, 0.0f);
    }
    glEndList();
}

static void colorLists(void) {
    static const GLfloat colors[4][4] = {{0.9f, 0.4f, 0.2f, 1.0f},
                                         {0.3f, 0.8f, 0.3f, 1.0f},
                                         {0.3f, 0.5f, 0.9f, 1.0f},
                                         {0.8f, 0.8f, 0.3f, 1.0f}};
    for (int i = 0; i < 4; ++i) {
        glNewList(base + kColors + (GLuint)i, GL_COMPILE);
        glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, colors[i]);
        glEndList();
    }
}

static void init(void) {
    static const GLfloat position[] = {1.0f, 2.0f, 4.0f, 0.0f};
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_NORMALIZE);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    base = glGenLists(kLists);
    glListBase(base);
    rowList(); /* before the lists that it calls: names are looked up when it is called */
    treeList();
    branchList();
    leafList();
    colorLists();
}

static void display(void) {
    const GLfloat turn = 0.05f * (GLfloat)glutGet(GLUT_ELAPSED_TIME);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glPushMatrix();
    glRotatef(20.0f, 1.0f, 0.0f, 0.0f);
    glRotatef(turn, 0.0f, 1.0f, 0.0f);
    glTranslatef(-1.1f, -0.9f, 0.8f);
    glCallList(base + kRow);
    glTranslatef(-3.3f, 0.0f, -1.6f);
    glCallList(base + kRow);
    glCallList(base + kColors + 3);
    glTranslatef(-2.2f, 0.0f, 0.8f);
    glScalef(1.5f, 1.8f, 1.5f);
    glCallList(base + kTree);
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
    glTranslatef(0.0f, 0.0f, -5.0f);
}

int main(int argc, char** argv) {
    glutInitWindowSize(500, 400);
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutCreateWindow("nested_lists");
    init();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutIdleFunc(glutPostRedisplay);
    glutMainLoop();
    return 0;
}

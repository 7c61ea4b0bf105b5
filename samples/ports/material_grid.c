/* SPDX-License-Identifier: MIT */
/* material_grid: twelve spheres of one display list; rows differ in ambient light, columns in
 * shininess and emission. */
#include <GL/glut.h>

static GLuint sphere;

static void drawSphere(int row, int column) {
    static const GLfloat none[] = {0.0f, 0.0f, 0.0f, 1.0f}, white[] = {1.0f, 1.0f, 1.0f, 1.0f},
                         emission[] = {0.3f, 0.2f, 0.2f, 1.0f},
                         diffuse[] = {0.1f, 0.5f, 0.8f, 1.0f};
    static const GLfloat ambients[3][4] = {
        {0.0f, 0.0f, 0.0f, 1.0f}, {0.7f, 0.7f, 0.7f, 1.0f}, {0.8f, 0.8f, 0.2f, 1.0f}};
    static const GLfloat shininess[] = {0.0f, 5.0f, 100.0f, 0.0f};
    glMaterialfv(GL_FRONT, GL_AMBIENT, ambients[row]);
    glMaterialfv(GL_FRONT, GL_DIFFUSE, diffuse);
    glMaterialfv(GL_FRONT, GL_SPECULAR, column == 1 || column == 2 ? white : none);
    glMaterialf(GL_FRONT, GL_SHININESS, shininess[column]);
    glMaterialfv(GL_FRONT, GL_EMISSION, column == 3 ? emission : none);
    glPushMatrix();
    glTranslatef(2.5f * (GLfloat)column - 3.75f, 3.0f - 3.0f * (GLfloat)row, 0.0f);
    glCallList(sphere);
    glPopMatrix();
}

static void display(void) {
    const GLfloat turn = 0.03f * (GLfloat)glutGet(GLUT_ELAPSED_TIME);
    const GLfloat position[] = {0.0f, 3.0f, 2.0f, 0.0f};
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glPushMatrix();
    glRotatef(turn, 0.0f, 0.0f, 1.0f);
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glPopMatrix();
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column) drawSphere(row, column);
    glutSwapBuffers();
}

static void reshape(int width, int height) {
    const GLdouble aspect = (GLdouble)width / height;
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    if (aspect < 1.0)
        glOrtho(-5.5, 5.5, -5.5 / aspect, 5.5 / aspect, -10.0, 10.0);
    else
        glOrtho(-5.5 * aspect, 5.5 * aspect, -5.5, 5.5, -10.0, 10.0);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

static void init(void) {
    static const GLfloat ambient[] = {0.4f, 0.4f, 0.4f, 1.0f};
    glClearColor(0.0f, 0.12f, 0.12f, 0.0f);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
    glLightModelf(GL_LIGHT_MODEL_LOCAL_VIEWER, 0.0f);
    sphere = glGenLists(1);
    glNewList(sphere, GL_COMPILE);
    glutSolidSphere(1.0, 20, 16);
    glEndList();
}

int main(int argc, char** argv) {
    glutInitWindowSize(600, 450);
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutCreateWindow("material_grid");
    init();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutIdleFunc(glutPostRedisplay);
    glutMainLoop();
    return 0;
}

/* SPDX-License-Identifier: MIT */
/* scene: quadrics under several lights, smooth on even frames and flat on odd ones. */
#include <GL/glut.h>

static GLUquadric* quadric;
static int frame;

static void init(void) {
    static const GLfloat sun[] = {1.0f, 1.0f, 1.0f, 0.0f}, lamp[] = {-2.0f, 1.0f, 2.0f, 1.0f},
                         warm[] = {0.7f, 0.5f, 0.3f, 1.0f}, cold[] = {0.2f, 0.3f, 0.7f, 1.0f},
                         specular[] = {0.6f, 0.6f, 0.6f, 1.0f},
                         ambient[] = {0.1f, 0.1f, 0.1f, 1.0f};
    glClearColor(0.32f, 0.32f, 0.32f, 1.0f);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_LIGHT1);
    glLightfv(GL_LIGHT0, GL_POSITION, sun);
    glLightfv(GL_LIGHT0, GL_DIFFUSE, warm);
    glLightfv(GL_LIGHT0, GL_AMBIENT, ambient);
    glLightfv(GL_LIGHT1, GL_POSITION, lamp);
    glLightfv(GL_LIGHT1, GL_DIFFUSE, cold);
    glLightfv(GL_LIGHT1, GL_SPECULAR, specular);
    glLightf(GL_LIGHT1, GL_LINEAR_ATTENUATION, 0.1f);
    glMaterialfv(GL_FRONT, GL_SPECULAR, specular);
    glMaterialf(GL_FRONT, GL_SHININESS, 25.0f);
    glEnable(GL_COLOR_MATERIAL);
    glColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    quadric = gluNewQuadric();
}

static void display(void) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glShadeModel(frame % 2 ? GL_FLAT : GL_SMOOTH);
    gluQuadricNormals(quadric, frame % 2 ? GLU_FLAT : GLU_SMOOTH);
    glPushMatrix();
    glRotatef(20.0f, 1.0f, 0.0f, 0.0f);

    glPushMatrix();
    glTranslatef(-0.75f, 0.5f, 0.0f);
    glRotatef(90.0f + 3.0f * (GLfloat)frame, 1.0f, 0.2f, 0.0f);
    glColor3f(0.8f, 0.7f, 0.6f);
    glutSolidTorus(0.275, 0.85, 16, 28);
    glPopMatrix();

    glPushMatrix();
    glTranslatef(-0.75f, -0.6f, 0.0f);
    glRotatef(-90.0f, 1.0f, 0.0f, 0.0f);
    glColor3f(0.6f, 0.8f, 0.6f);
    gluCylinder(quadric, 0.6, 0.2, 0.9, 20, 5);
    gluDisk(quadric, 0.1, 0.6, 20, 3);
    glTranslatef(0.0f, 0.0f, 0.9f);
    gluPartialDisk(quadric, 0.0, 0.2, 20, 2, 0.0, 270.0);
    glPopMatrix();

    glPushMatrix();
    glTranslatef(0.9f, 0.0f, -1.0f);
    glColor3f(0.7f, 0.6f, 0.8f);
    gluSphere(quadric, 1.0, 24, 18);
    glPopMatrix();

    glPopMatrix();
    glFlush();
}

static void reshape(int width, int height) {
    const GLdouble w = width > height ? 2.2 * width / height : 2.2,
                   h = width > height ? 2.2 : 2.2 * height / width;
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(-w, w, -h, h, -10.0, 10.0);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

static void idle(void) {
    frame = glutGet(GLUT_ELAPSED_TIME) / 40;
    glutPostRedisplay();
}

int main(int argc, char** argv) {
    glutInitWindowSize(500, 500);
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_SINGLE | GLUT_RGB | GLUT_DEPTH);
    glutCreateWindow("scene");
    init();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutIdleFunc(idle);
    glutMainLoop();
    return 0;
}

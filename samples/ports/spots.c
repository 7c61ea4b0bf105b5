/* SPDX-License-Identifier: MIT */
/* spots: three swinging spot lights with attenuation on a finely divided, two-sided floor. */
#include <GL/glut.h>
#include <math.h>

enum { kCells = 40, kSpots = 3 };

static GLuint floorList;
static GLfloat seconds;

static const GLfloat colors[kSpots][4] = {
    {1.0f, 0.2f, 0.2f, 1.0f}, {0.2f, 1.0f, 0.2f, 1.0f}, {0.3f, 0.4f, 1.0f, 1.0f}};

static void init(void) {
    static const GLfloat ambient[] = {0.05f, 0.05f, 0.05f, 1.0f}, gray[] = {0.7f, 0.7f, 0.7f, 1.0f},
                         specular[] = {0.3f, 0.3f, 0.3f, 1.0f};
    static const GLfloat exponents[] = {20.0f, 4.0f, 0.0f}, cutoffs[] = {20.0f, 40.0f, 15.0f};
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_NORMALIZE);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
    for (int i = 0; i < kSpots; ++i) {
        const GLenum light = (GLenum)(GL_LIGHT0 + i);
        glEnable(light);
        glLightfv(light, GL_DIFFUSE, colors[i]);
        glLightfv(light, GL_SPECULAR, colors[i]);
        glLightf(light, GL_SPOT_EXPONENT, exponents[i]);
        glLightf(light, GL_SPOT_CUTOFF, cutoffs[i]);
        glLightf(light, GL_CONSTANT_ATTENUATION, 0.6f);
        glLightf(light, GL_LINEAR_ATTENUATION, 0.1f);
        glLightf(light, GL_QUADRATIC_ATTENUATION, 0.03f);
    }
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, gray);
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, specular);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 8.0f);
    floorList = glGenLists(1);
    glNewList(floorList, GL_COMPILE);
    glNormal3f(0.0f, 1.0f, 0.0f);
    for (int row = 0; row < kCells; ++row) {
        glBegin(GL_QUAD_STRIP);
        for (int column = 0; column <= kCells; ++column) {
            glVertex3f(-3.0f + 6.0f * (GLfloat)column / kCells, 0.0f,
                       -3.0f + 6.0f * (GLfloat)row / kCells);
            glVertex3f(-3.0f + 6.0f * (GLfloat)column / kCells, 0.0f,
                       -3.0f + 6.0f * (GLfloat)(row + 1) / kCells);
        }
        glEnd();
    }
    glEndList();
}

static void placeSpot(int i) {
    static const GLfloat position[] = {0.0f, 0.0f, 0.0f, 1.0f}, down[] = {0.0f, -1.0f, 0.0f};
    const GLenum light = (GLenum)(GL_LIGHT0 + i);
    const double swing = 25.0 * sin(1.3 * seconds + 2.0 * i);
    glPushMatrix();
    glTranslatef(-1.4f + 1.4f * (GLfloat)i, 3.0f, 0.6f * (GLfloat)(i % 2));
    glRotated(swing, 1.0, 0.0, 0.4);
    glLightfv(light, GL_POSITION, position);
    glLightfv(light, GL_SPOT_DIRECTION, down);
    glDisable(GL_LIGHTING);
    glColor3fv(colors[i]);
    glScalef(0.2f, 0.2f, 0.2f);
    glutSolidOctahedron();
    glEnable(GL_LIGHTING);
    glPopMatrix();
}

static void display(void) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glPushMatrix();
    glRotatef(30.0f, 1.0f, 0.0f, 0.0f);
    glRotatef(10.0f * seconds, 0.0f, 1.0f, 0.0f);
    for (int i = 0; i < kSpots; ++i) placeSpot(i);
    glCallList(floorList);
    glTranslatef(0.0f, 0.4f, 0.0f);
    glutSolidTorus(0.2, 0.6, 16, 32);
    glPopMatrix();
    glutSwapBuffers();
}

static void reshape(int width, int height) {
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(45.0, (GLdouble)width / height, 1.0, 30.0);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(0.0f, -0.8f, -9.0f);
}

static void idle(void) {
    seconds = 0.001f * (GLfloat)glutGet(GLUT_ELAPSED_TIME);
    glutPostRedisplay();
}

int main(int argc, char** argv) {
    glutInitWindowSize(500, 400);
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutCreateWindow("spots");
    init();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutIdleFunc(idle);
    glutMainLoop();
    return 0;
}

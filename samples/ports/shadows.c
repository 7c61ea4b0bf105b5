/* SPDX-License-Identifier: MIT */
/* shadows: solids over a floor. With OpenGL they are drawn again, flattened onto the floor in the
 * colour that it has without the light (Blinn, 1988); with OpenRT rays find the shadows. */
#include <GL/glut.h>

enum { kTiles = 12 };

static const GLfloat light[] = {1.5f, 5.0f, 2.0f, 1.0f};
static GLfloat angle;
static int raysShadow;

static void solids(int colored) {
    glPushMatrix();
    glTranslatef(-1.3f, 0.8f, 0.3f);
    glRotatef(angle, 0.2f, 1.0f, 0.0f);
    if (colored) glColor3f(0.9f, 0.5f, 0.2f);
    glutSolidCube(0.9);
    glPopMatrix();
    glPushMatrix();
    glTranslatef(0.2f, 0.7f, 0.9f);
    if (colored) glColor3f(0.3f, 0.5f, 0.9f);
    glutSolidSphere(0.5, 32, 24);
    glPopMatrix();
    glPushMatrix();
    glTranslatef(1.3f, 0.3f, -0.6f);
    glRotatef(-90.0f, 1.0f, 0.0f, 0.0f);
    if (colored) glColor3f(0.4f, 0.8f, 0.4f);
    glutSolidCone(0.5, 1.2, 32, 8);
    glPopMatrix();
}

static void floorPlane(void) {
    glColor3f(0.7f, 0.7f, 0.7f);
    glNormal3f(0.0f, 1.0f, 0.0f);
    for (int row = 0; row < kTiles; ++row) {
        const GLfloat z = -3.6f + 0.6f * (GLfloat)row;
        glBegin(GL_QUAD_STRIP);
        for (int column = 0; column <= kTiles; ++column) {
            const GLfloat x = -3.6f + 0.6f * (GLfloat)column;
            glVertex3f(x, 0.0f, z);
            glVertex3f(x, 0.0f, z + 0.6f);
        }
        glEnd();
    }
}

/* Onto the plane y = 0 from the light: l.y * p - p.y * l, divided by l.y - p.y. */
static void flatten(void) {
    const GLfloat matrix[16] = {light[1],  0.0f,  0.0f, 0.0f,    -light[0], 0.0f,
                                -light[2], -1.0f, 0.0f, 0.0f,    light[1],  0.0f,
                                0.0f,      0.0f,  0.0f, light[1]};
    glMultMatrixf(matrix);
}

static void flatShadows(void) {
    glDisable(GL_LIGHTING);
    glDisable(GL_DEPTH_TEST);
    glColor3f(0.14f, 0.14f, 0.14f); /* 0.7 of the ambient light of the model, 0.2 */
    glPushMatrix();
    flatten();
    solids(0);
    glPopMatrix();
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
}

static void display(void) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
#ifdef OPENRT
    glEnable(RT_SHADOWS);
    raysShadow = 1;
#endif
    glPushMatrix();
    glRotatef(35.0f, 1.0f, 0.0f, 0.0f);
    glLightfv(GL_LIGHT0, GL_POSITION, light);
    floorPlane();
    if (!raysShadow) flatShadows();
    solids(1);
    glPopMatrix();
    glutSwapBuffers();
}

static void reshape(int width, int height) {
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(40.0, (GLdouble)width / height, 1.0, 30.0);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(0.0f, -0.4f, -8.0f);
}

static void idle(void) {
    angle = 30.0f + 0.05f * (GLfloat)glutGet(GLUT_ELAPSED_TIME);
    glutPostRedisplay();
}

int main(int argc, char** argv) {
    glutInitWindowSize(500, 400);
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutCreateWindow("shadows");
    glClearColor(0.52f, 0.6f, 0.8f, 1.0f);
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

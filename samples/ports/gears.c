/* SPDX-License-Identifier: MIT */
/* gears: three meshing toothed wheels, each a display list; flat faces, smooth bores, culling. */
#include <GL/glut.h>
#include <math.h>

#define PI 3.14159265358979323846

enum { kMaxTeeth = 20, kPointsPerTooth = 4 };

static GLuint gears[3];
static GLfloat angle;

typedef struct {
    GLfloat x, y;
} Point;

/* The outline: root, tip, tip, root for every tooth, closed by its first point. */
static int outline(Point* points, int teeth, double root, double tip) {
    const double step = 2.0 * PI / (teeth * kPointsPerTooth);
    int count = teeth * kPointsPerTooth;
    for (int i = 0; i <= count; ++i) {
        const int corner = i % kPointsPerTooth;
        const double radius = corner == 1 || corner == 2 ? tip : root;
        points[i].x = (GLfloat)(radius * cos(i * step));
        points[i].y = (GLfloat)(radius * sin(i * step));
    }
    return count;
}

static void face(const Point* points, int count, double bore, GLfloat z, int front) {
    const double step = 2.0 * PI / count;
    glNormal3f(0.0f, 0.0f, front ? 1.0f : -1.0f);
    glBegin(GL_QUAD_STRIP);
    for (int i = 0; i <= count; ++i) {
        const int at = front ? i : count - i;
        glVertex3f((GLfloat)(bore * cos(at * step)), (GLfloat)(bore * sin(at * step)), z);
        glVertex3f(points[at].x, points[at].y, z);
    }
    glEnd();
}

static void rim(const Point* points, int count, GLfloat half) {
    glBegin(GL_QUADS);
    for (int i = 0; i < count; ++i) {
        const Point a = points[i], b = points[i + 1];
        glNormal3f(b.y - a.y, a.x - b.x, 0.0f);
        glVertex3f(a.x, a.y, half);
        glVertex3f(a.x, a.y, -half);
        glVertex3f(b.x, b.y, -half);
        glVertex3f(b.x, b.y, half);
    }
    glEnd();
}

static void boreWall(double radius, int count, GLfloat half) {
    const double step = 2.0 * PI / count;
    glBegin(GL_QUAD_STRIP);
    for (int i = 0; i <= count; ++i) {
        const GLfloat x = (GLfloat)cos(i * step), y = (GLfloat)sin(i * step);
        glNormal3f(-x, -y, 0.0f);
        glVertex3f((GLfloat)radius * x, (GLfloat)radius * y, -half);
        glVertex3f((GLfloat)radius * x, (GLfloat)radius * y, half);
    }
    glEnd();
}

static GLuint makeGear(int teeth, double bore, double middle, double depth, GLfloat width,
                       const GLfloat* color) {
    Point points[kMaxTeeth * kPointsPerTooth + 1];
    const int count = outline(points, teeth, middle - depth / 2, middle + depth / 2);
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, color);
    glShadeModel(GL_FLAT);
    face(points, count, bore, width / 2, 1);
    face(points, count, bore, -width / 2, 0);
    rim(points, count, width / 2);
    glShadeModel(GL_SMOOTH);
    boreWall(bore, count, width / 2);
    glEndList();
    return list;
}

static void drawGear(int gear, GLfloat x, GLfloat y, GLfloat turn) {
    glPushMatrix();
    glTranslatef(x, y, 0.0f);
    glRotatef(turn, 0.0f, 0.0f, 1.0f);
    glCallList(gears[gear]);
    glPopMatrix();
}

static void display(void) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glPushMatrix();
    glRotatef(20.0f, 1.0f, 0.0f, 0.0f);
    glRotatef(30.0f, 0.0f, 1.0f, 0.0f);
    drawGear(0, -3.0f, -2.0f, angle);
    drawGear(1, 3.1f, -2.0f, -2.0f * angle - 9.0f);
    drawGear(2, -3.1f, 4.2f, -2.0f * angle - 25.0f);
    glPopMatrix();
    glutSwapBuffers();
}

static void reshape(int width, int height) {
    const GLdouble h = (GLdouble)height / width;
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    if (h < 1.0)
        glFrustum(-1.0 / h, 1.0 / h, -1.0, 1.0, 5.0, 60.0);
    else
        glFrustum(-1.0, 1.0, -h, h, 5.0, 60.0);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(0.0f, 0.0f, -40.0f);
}

static void idle(void) {
    angle = 0.07f * (GLfloat)glutGet(GLUT_ELAPSED_TIME);
    glutPostRedisplay();
}

static void init(void) {
    static const GLfloat position[] = {5.0f, 5.0f, 10.0f, 0.0f};
    static const GLfloat red[] = {0.8f, 0.1f, 0.0f, 1.0f}, green[] = {0.0f, 0.8f, 0.2f, 1.0f},
                         blue[] = {0.2f, 0.2f, 1.0f, 1.0f};
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glEnable(GL_CULL_FACE);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_NORMALIZE);
    gears[0] = makeGear(20, 1.0, 4.0, 0.7, 1.0f, red);
    gears[1] = makeGear(10, 0.5, 2.0, 0.7, 2.0f, green);
    gears[2] = makeGear(10, 1.3, 2.0, 0.7, 0.5f, blue);
}

int main(int argc, char** argv) {
    glutInitWindowSize(300, 300);
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_RGB | GLUT_DEPTH | GLUT_DOUBLE);
    glutCreateWindow("gears");
    init();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutIdleFunc(idle);
    glutMainLoop();
    return 0;
}

/* SPDX-License-Identifier: MIT */
/* isosurface: metaballs by marching tetrahedra, a display list of one vertex array with about 50,000
 * triangles. Usage: isosurface [CELLS], the number of cells along an edge of the grid (default 86).
 * The subdivision of a cell into six tetrahedra around its diagonal: Kuhn, 1960. */
#include <GL/glut.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { kBalls = 5 };

typedef struct {
    GLfloat x, y, z;
} Vector;

typedef struct {
    Vector normal, position;
} Vertex;

static const GLfloat balls[kBalls][4] = {{0.0f, 0.0f, 0.0f, 0.30f},
                                         {0.55f, 0.15f, 0.1f, 0.20f},
                                         {-0.5f, 0.3f, -0.1f, 0.22f},
                                         {-0.1f, -0.55f, 0.25f, 0.20f},
                                         {0.2f, 0.5f, -0.35f, 0.18f}};
static const GLfloat kLevel = 1.0f;

static Vertex* vertices;
static GLsizei vertexCount, vertexRoom;
static int cells = 86;
static GLuint surface;
static GLfloat angle;

static GLfloat field(Vector p) {
    GLfloat sum = 0.0f;
    for (int i = 0; i < kBalls; ++i) {
        const GLfloat x = p.x - balls[i][0], y = p.y - balls[i][1], z = p.z - balls[i][2];
        sum += balls[i][3] * balls[i][3] / (x * x + y * y + z * z + 1e-6f);
    }
    return sum;
}

static Vector gradient(Vector p) {
    Vector g = {0.0f, 0.0f, 0.0f};
    for (int i = 0; i < kBalls; ++i) {
        const GLfloat x = p.x - balls[i][0], y = p.y - balls[i][1], z = p.z - balls[i][2],
                      square = x * x + y * y + z * z + 1e-6f,
                      weight = 2.0f * balls[i][3] * balls[i][3] / (square * square);
        g.x += weight * x;
        g.y += weight * y;
        g.z += weight * z;
    }
    return g;
}

static Vector gridPoint(int x, int y, int z) {
    const GLfloat step = 2.4f / (GLfloat)cells;
    const Vector p = {-1.2f + step * (GLfloat)x, -1.2f + step * (GLfloat)y,
                      -1.2f + step * (GLfloat)z};
    return p;
}

static void append(Vector p) {
    const Vector g = gradient(p);
    const GLfloat length = (GLfloat)sqrt(g.x * g.x + g.y * g.y + g.z * g.z);
    if (vertexCount == vertexRoom) {
        vertexRoom = vertexRoom ? 2 * vertexRoom : 4096;
        vertices = realloc(vertices, (size_t)vertexRoom * sizeof *vertices);
        if (vertices == NULL) exit(1);
    }
    vertices[vertexCount].normal.x = g.x / length;
    vertices[vertexCount].normal.y = g.y / length;
    vertices[vertexCount].normal.z = g.z / length;
    vertices[vertexCount++].position = p;
}

static Vector crossing(Vector a, Vector b, GLfloat fa, GLfloat fb) {
    const GLfloat t = (kLevel - fa) / (fb - fa);
    const Vector p = {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
    return p;
}

/* Turned so that the front face looks down the gradient's slope, out of the balls. */
static void triangle(Vector a, Vector b, Vector c) {
    const Vector u = {b.x - a.x, b.y - a.y, b.z - a.z}, v = {c.x - a.x, c.y - a.y, c.z - a.z},
                 g = gradient(a);
    const GLfloat side = (u.y * v.z - u.z * v.y) * g.x + (u.z * v.x - u.x * v.z) * g.y +
                         (u.x * v.y - u.y * v.x) * g.z;
    append(a);
    append(side >= 0.0f ? b : c);
    append(side >= 0.0f ? c : b);
}

static void tetrahedron(const Vector p[4], const GLfloat f[4]) {
    int inside[4], outside[4], in = 0, out = 0;
    Vector cut[4];
    for (int i = 0; i < 4; ++i)
        if (f[i] >= kLevel)
            inside[in++] = i;
        else
            outside[out++] = i;
    if (in == 0 || out == 0) return;
    for (int i = 0, n = 0; i < in; ++i)
        for (int j = 0; j < out; ++j)
            cut[n++] = crossing(p[inside[i]], p[outside[j]], f[inside[i]], f[outside[j]]);
    triangle(cut[0], cut[1], cut[2]);
    if (in == 2) triangle(cut[1], cut[2], cut[3]);
}

/* The field at the grid points below and above a layer of cells. */
static GLfloat* layers[2];

static GLfloat* fieldAt(int x, int y, int above) {
    return layers[above] + (size_t)y * (size_t)(cells + 1) + (size_t)x;
}

static void fillLayer(int z) {
    GLfloat* const below = layers[0];
    layers[0] = layers[1];
    layers[1] = below;
    for (int y = 0; y <= cells; ++y)
        for (int x = 0; x <= cells; ++x) *fieldAt(x, y, 1) = field(gridPoint(x, y, z));
}

static void cell(int x, int y, int z) {
    static const int orders[6][2] = {{1, 3}, {1, 5}, {2, 3}, {2, 6}, {4, 5}, {4, 6}};
    Vector p[8];
    GLfloat f[8];
    int inside = 0;
    for (int i = 0; i < 8; ++i) {
        f[i] = *fieldAt(x + (i & 1), y + (i >> 1 & 1), i >> 2);
        inside += f[i] >= kLevel;
    }
    if (inside == 0 || inside == 8) return;
    for (int i = 0; i < 8; ++i) p[i] = gridPoint(x + (i & 1), y + (i >> 1 & 1), z + (i >> 2));
    for (int i = 0; i < 6; ++i) {
        const int a = orders[i][0], b = orders[i][1];
        const Vector corners[4] = {p[0], p[a], p[b], p[7]};
        const GLfloat values[4] = {f[0], f[a], f[b], f[7]};
        tetrahedron(corners, values);
    }
}

static void makeSurface(void) {
    const size_t points = (size_t)(cells + 1) * (size_t)(cells + 1);
    for (int i = 0; i < 2; ++i) {
        layers[i] = malloc(points * sizeof *layers[i]);
        if (layers[i] == NULL) exit(1);
    }
    fillLayer(0);
    for (int z = 0; z < cells; ++z) {
        fillLayer(z + 1);
        for (int y = 0; y < cells; ++y)
            for (int x = 0; x < cells; ++x) cell(x, y, z);
    }
    free(layers[0]);
    free(layers[1]);
}

static void display(void) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glPushMatrix();
    glRotatef(angle, 0.3f, 1.0f, 0.1f);
    glCallList(surface);
    glPopMatrix();
    glutSwapBuffers();
}

static void reshape(int width, int height) {
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(40.0, (GLdouble)width / height, 1.0, 10.0);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(0.0f, 0.0f, -3.4f);
}

static void idle(void) {
    angle = 0.05f * (GLfloat)glutGet(GLUT_ELAPSED_TIME);
    glutPostRedisplay();
}

static void init(void) {
    static const GLfloat position[] = {2.0f, 3.0f, 4.0f, 0.0f},
                         specular[] = {0.5f, 0.5f, 0.5f, 1.0f},
                         diffuse[] = {0.3f, 0.7f, 0.6f, 1.0f};
    glClearColor(0.12f, 0.12f, 0.2f, 1.0f);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, diffuse);
    glMaterialfv(GL_FRONT, GL_SPECULAR, specular);
    glMaterialf(GL_FRONT, GL_SHININESS, 40.0f);
    glEnableClientState(GL_NORMAL_ARRAY);
    glEnableClientState(GL_VERTEX_ARRAY);
    glNormalPointer(GL_FLOAT, sizeof(Vertex), &vertices[0].normal);
    glVertexPointer(3, GL_FLOAT, sizeof(Vertex), &vertices[0].position);
    surface = glGenLists(1);
    glNewList(surface, GL_COMPILE);
    glDrawArrays(GL_TRIANGLES, 0, vertexCount);
    glEndList();
}

int main(int argc, char** argv) {
    glutInitWindowSize(512, 512);
    glutInit(&argc, argv);
    if (argc > 1) cells = atoi(argv[1]);
    if (cells < 2 || cells > 1000) {
        fprintf(stderr, "isosurface: 2 to 1000 cells\n");
        return 2;
    }
    makeSurface();
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutCreateWindow("isosurface");
    init();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutIdleFunc(idle);
    glutMainLoop();
    return 0;
}

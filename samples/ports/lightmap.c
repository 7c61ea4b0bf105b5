/* SPDX-License-Identifier: MIT */
/* lightmap: a corridor of tiles, darkened by maps of light in a second texture unit, with a spot that
 * wanders through the texture matrix of a third. */
#define GL_GLEXT_PROTOTYPES
#include <GL/glut.h>
#include <math.h>

enum { kTile = 32, kLight = 16 };

static GLuint tiles, spot, lights[2];
static GLfloat seconds;

static GLuint makeTexture(GLint format, int side, const GLubyte* image, GLint minify, GLint wrap) {
    GLuint name;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, minify);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
    gluBuild2DMipmaps(GL_TEXTURE_2D, format, side, side, GL_RGB, GL_UNSIGNED_BYTE, image);
    return name;
}

static GLuint makeTiles(void) {
    static GLubyte image[kTile][kTile][3];
    for (int row = 0; row < kTile; ++row)
        for (int column = 0; column < kTile; ++column) {
            const int joint = row % 16 < 2 || column % 16 < 2;
            image[row][column][0] = (GLubyte)(joint ? 150 : 214 - (row * column) % 9);
            image[row][column][1] = (GLubyte)(joint ? 146 : 190 + (row + column) % 7);
            image[row][column][2] = (GLubyte)(joint ? 140 : 168);
        }
    return makeTexture(GL_RGB, kTile, image[0][0], GL_LINEAR, GL_REPEAT);
}

/* Lamps at equal distances, or one at the end. */
static GLuint makeLight(int kind) {
    static GLubyte image[kLight][kLight][3];
    for (int row = 0; row < kLight; ++row)
        for (int column = 0; column < kLight; ++column) {
            const float across = (float)(column - kLight / 2) / 8.0f,
                        along = kind ? (float)row / kLight : (float)(row % 8 - 4) / 4.0f;
            const float level = 1.0f / (1.0f + 2.0f * along * along + across * across);
            image[row][column][0] = (GLubyte)(40.0f + 200.0f * level);
            image[row][column][1] = (GLubyte)(44.0f + 170.0f * level);
            image[row][column][2] = (GLubyte)(58.0f + 120.0f * level);
        }
    return makeTexture(GL_RGB, kLight, image[0][0], GL_LINEAR, GL_CLAMP_TO_EDGE);
}

static GLuint makeSpot(void) {
    static GLubyte image[kTile][kTile][3];
    for (int row = 1; row + 1 < kTile; ++row)
        for (int column = 1; column + 1 < kTile; ++column) {
            const float x = (float)(column - kTile / 2) / 8.0f,
                        y = (float)(row - kTile / 2) / 8.0f;
            const float level = 60.0f * expf(-x * x - y * y);
            image[row][column][0] = image[row][column][1] = (GLubyte)level;
            image[row][column][2] = (GLubyte)(level / 4.0f);
        }
    return makeTexture(GL_RGB, kTile, image[0][0], GL_LINEAR, GL_CLAMP_TO_EDGE);
}

static void init(void) {
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    tiles = makeTiles();
    spot = makeSpot();
    for (int i = 0; i < 2; ++i) lights[i] = makeLight(i);
    glBindTexture(GL_TEXTURE_2D, tiles);
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glActiveTexture(GL_TEXTURE1);
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    glActiveTexture(GL_TEXTURE2);
    glBindTexture(GL_TEXTURE_2D, spot);
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_ADD);
    glActiveTexture(GL_TEXTURE1);
    glEnable(GL_DEPTH_TEST);
    glClearColor(0.12f, 0.13f, 0.18f, 1.0f);
}

/* Corners anticlockwise; tiles along both sides, the whole map of light once. */
static void panel(GLuint light, const GLfloat corners[4][3], GLfloat across, GLfloat along) {
    static const GLfloat places[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    glBindTexture(GL_TEXTURE_2D, light);
    glBegin(GL_QUADS);
    for (int i = 0; i < 4; ++i) {
        glMultiTexCoord2f(GL_TEXTURE0, across * places[i][0], along * places[i][1]);
        glMultiTexCoord2fv(GL_TEXTURE1, places[i]);
        glMultiTexCoord2fv(GL_TEXTURE2, places[i]);
        glVertex3fv(corners[i]);
    }
    glEnd();
}

static void display(void) {
    static const GLfloat ground[4][3] = {{-2, -1, 2}, {2, -1, 2}, {2, -1, -12}, {-2, -1, -12}},
                         left[4][3] = {{-2, 2, 2}, {-2, -1, 2}, {-2, -1, -12}, {-2, 2, -12}},
                         right[4][3] = {{2, -1, 2}, {2, 2, 2}, {2, 2, -12}, {2, -1, -12}},
                         end[4][3] = {{-2, -1, -12}, {2, -1, -12}, {2, 2, -12}, {-2, 2, -12}};
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glActiveTexture(GL_TEXTURE2);
    glMatrixMode(GL_TEXTURE);
    glLoadIdentity();
    glTranslatef(0.5f, 0.5f, 0.0f);
    glScalef(1.5f, 4.0f, 1.0f);
    glTranslatef(-0.5f - 0.2f * sinf(seconds), -0.5f - 0.2f * cosf(seconds), 0.0f);
    glMatrixMode(GL_MODELVIEW);
    glActiveTexture(GL_TEXTURE1);
    glLoadIdentity();
    gluLookAt(0.3 * sin(seconds), 0.6, 3.5, 0.0, 0.4, -6.0, 0.0, 1.0, 0.0);
    panel(lights[0], ground, 2.0f, 7.0f);
    panel(lights[0], left, 1.5f, 7.0f);
    panel(lights[0], right, 1.5f, 7.0f);
    panel(lights[1], end, 2.0f, 1.5f);
    glutSwapBuffers();
}

static void reshape(int width, int height) {
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(50.0, (GLdouble)width / height, 0.5, 40.0);
    glMatrixMode(GL_MODELVIEW);
}

static void idle(void) {
    seconds = 0.6f + 0.001f * (GLfloat)glutGet(GLUT_ELAPSED_TIME);
    glutPostRedisplay();
}

int main(int argc, char** argv) {
    glutInitWindowSize(500, 400);
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutCreateWindow("lightmap");
    init();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutIdleFunc(idle);
    glutMainLoop();
    return 0;
}

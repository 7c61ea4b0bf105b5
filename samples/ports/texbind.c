/* SPDX-License-Identifier: MIT */
/* texbind: three texture objects (nearest, linear, mipmapped) on a floor and on two lit cubes. */
#include <GL/glut.h>

enum { kImage = 64 };

static GLuint textures[3];
static GLfloat angle;

static void fill(GLubyte* image, int kind) {
    for (int row = 0; row < kImage; ++row)
        for (int column = 0; column < kImage; ++column) {
            GLubyte* pixel = image + 3 * (row * kImage + column);
            const int brick = row % 16 < 2 || (column + (row / 16 % 2) * 16) % 32 < 2;
            const int dx = column - kImage / 2, dy = row - kImage / 2;
            if (kind == 0) {
                pixel[0] = brick ? 180 : 150;
                pixel[1] = brick ? 180 : 60;
                pixel[2] = brick ? 170 : 40;
            } else if (kind == 1) {
                pixel[0] = (GLubyte)(4 * column);
                pixel[1] = (GLubyte)((dx * dx + dy * dy) / 8);
                pixel[2] = (GLubyte)(4 * row);
            } else {
                pixel[0] = pixel[1] = (row / 16 + column / 16) % 2 ? 220 : 60;
                pixel[2] = 90;
            }
        }
}

static void init(void) {
    static const GLint magnify[] = {GL_NEAREST, GL_LINEAR, GL_LINEAR},
                       minify[] = {GL_NEAREST, GL_LINEAR, GL_LINEAR_MIPMAP_LINEAR};
    static GLubyte image[3 * kImage * kImage];
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glGenTextures(3, textures);
    for (int i = 0; i < 3; ++i) {
        fill(image, i);
        glBindTexture(GL_TEXTURE_2D, textures[i]);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, magnify[i]);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, minify[i]);
        gluBuild2DMipmaps(GL_TEXTURE_2D, GL_RGB, kImage, kImage, GL_RGB, GL_UNSIGNED_BYTE, image);
    }
    glEnable(GL_TEXTURE_2D);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    glClearColor(0.52f, 0.6f, 0.8f, 1.0f);
}

static void texturedCube(void) {
    static const GLfloat corners[4][2] = {
        {-1.0f, -1.0f}, {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}};
    for (int face = 0; face < 6; ++face) {
        glPushMatrix();
        if (face < 4)
            glRotatef(90.0f * (GLfloat)face, 0.0f, 1.0f, 0.0f);
        else
            glRotatef(face == 4 ? 90.0f : -90.0f, 1.0f, 0.0f, 0.0f);
        glNormal3f(0.0f, 0.0f, 1.0f);
        glBegin(GL_QUADS);
        for (int i = 0; i < 4; ++i) {
            glTexCoord2f((corners[i][0] + 1.0f) / 2.0f, (corners[i][1] + 1.0f) / 2.0f);
            glVertex3f(corners[i][0], corners[i][1], 1.0f);
        }
        glEnd();
        glPopMatrix();
    }
}

static void cube(GLuint texture, GLfloat x, GLfloat turn) {
    glBindTexture(GL_TEXTURE_2D, texture);
    glPushMatrix();
    glTranslatef(x, 0.0f, 0.0f);
    glRotatef(turn, 0.2f, 1.0f, 0.0f);
    glScalef(0.8f, 0.8f, 0.8f);
    texturedCube();
    glPopMatrix();
}

static void floorPlane(void) {
    glBindTexture(GL_TEXTURE_2D, textures[2]);
    glNormal3f(0.0f, 1.0f, 0.0f);
    glBegin(GL_QUADS);
    glTexCoord2f(0.0f, 0.0f);
    glVertex3f(-6.0f, -1.3f, 4.0f);
    glTexCoord2f(8.0f, 0.0f);
    glVertex3f(6.0f, -1.3f, 4.0f);
    glTexCoord2f(8.0f, 8.0f);
    glVertex3f(6.0f, -1.3f, -8.0f);
    glTexCoord2f(0.0f, 8.0f);
    glVertex3f(-6.0f, -1.3f, -8.0f);
    glEnd();
}

static void display(void) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    floorPlane();
    cube(textures[0], -1.4f, angle);
    cube(textures[1], 1.4f, 30.0f - angle);
    glutSwapBuffers();
}

static void reshape(int width, int height) {
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(45.0, (GLdouble)width / height, 1.0, 40.0);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(0.0, 1.5, 6.5, 0.0, -0.2, 0.0, 0.0, 1.0, 0.0);
}

static void idle(void) {
    angle = 20.0f + 0.04f * (GLfloat)glutGet(GLUT_ELAPSED_TIME);
    glutPostRedisplay();
}

int main(int argc, char** argv) {
    glutInitWindowSize(500, 400);
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutCreateWindow("texbind");
    init();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutIdleFunc(idle);
    glutMainLoop();
    return 0;
}

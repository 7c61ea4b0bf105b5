/* SPDX-License-Identifier: MIT */
/* checker: a chequered image on two quads, one of them seen aslant; wrapped and clamped. */
#include <GL/glut.h>

enum { kImage = 64 };

static GLubyte image[kImage][kImage][4];
static GLuint texture;

static void makeImage(void) {
    for (int row = 0; row < kImage; ++row)
        for (int column = 0; column < kImage; ++column) {
            const GLubyte value = (row / 8 + column / 8) % 2 ? 230 : 30;
            image[row][column][0] = value;
            image[row][column][1] = (GLubyte)(value * 3 / 4 + row / 2);
            image[row][column][2] = (GLubyte)(255 - value);
            image[row][column][3] = 255;
        }
}

static void quad(GLfloat repeats) {
    glBegin(GL_QUADS);
    glTexCoord2f(0.0f, 0.0f);
    glVertex3f(-1.0f, -1.0f, 0.0f);
    glTexCoord2f(repeats, 0.0f);
    glVertex3f(1.0f, -1.0f, 0.0f);
    glTexCoord2f(repeats, repeats);
    glVertex3f(1.0f, 1.0f, 0.0f);
    glTexCoord2f(0.0f, repeats);
    glVertex3f(-1.0f, 1.0f, 0.0f);
    glEnd();
}

static void display(void) {
    const GLfloat turn = 0.03f * (GLfloat)glutGet(GLUT_ELAPSED_TIME);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_TEXTURE_2D);
    glTexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL);
    glBindTexture(GL_TEXTURE_2D, texture);
    glPushMatrix();
    glTranslatef(-1.2f, 0.0f, 0.0f);
    quad(1.0f);
    glPopMatrix();
    glPushMatrix();
    glTranslatef(1.2f, 0.0f, 0.0f);
    glRotatef(40.0f + turn, 0.0f, 1.0f, 0.0f);
    quad(1.5f);
    glPopMatrix();
    glDisable(GL_TEXTURE_2D);
    glutSwapBuffers();
}

static void reshape(int width, int height) {
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(60.0, (GLdouble)width / height, 1.0, 30.0);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(0.0f, 0.0f, -2.9f);
}

int main(int argc, char** argv) {
    glutInitWindowSize(500, 250);
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutCreateWindow("checker");
    glShadeModel(GL_FLAT);
    glEnable(GL_DEPTH_TEST);
    makeImage();
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, kImage, kImage, 0, GL_RGBA, GL_UNSIGNED_BYTE, image);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutIdleFunc(glutPostRedisplay);
    glutMainLoop();
    return 0;
}

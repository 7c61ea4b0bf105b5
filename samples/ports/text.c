/* SPDX-License-Identifier: MIT */
/* text: stroke letters that turn in space and bitmap lines that stay in place. */
#include <GL/glut.h>

static void strokes(const char* text) {
    for (; *text; ++text) glutStrokeCharacter(GLUT_STROKE_ROMAN, *text);
}

static void bitmaps(void* font, GLfloat x, GLfloat y, const char* text) {
    glRasterPos2f(x, y);
    for (; *text; ++text) glutBitmapCharacter(font, *text);
}

static void display(void) {
    const char* const word = "Rays";
    const GLfloat turn = 0.04f * (GLfloat)glutGet(GLUT_ELAPSED_TIME);
    const GLfloat length = (GLfloat)glutStrokeLength(GLUT_STROKE_ROMAN, (const unsigned char*)word);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glPushMatrix();
    glRotatef(20.0f - turn, 0.0f, 1.0f, 0.2f);
    glScalef(0.008f, 0.008f, 0.008f);
    glTranslatef(-length / 2.0f, -40.0f, 0.0f);
    glLineWidth(3.0f);
    glColor3f(0.92f, 0.8f, 0.32f);
    strokes(word);
    glPopMatrix();
    glColor3f(0.6f, 0.92f, 0.6f);
    bitmaps(GLUT_BITMAP_8_BY_13, -1.6f, -1.2f, "8 by 13: 0123");
    glColor3f(0.72f, 0.72f, 1.0f);
    bitmaps(GLUT_BITMAP_HELVETICA_18, -1.6f, 1.3f, "Helvetica 18");
    glFlush();
}

static void reshape(int width, int height) {
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(45.0, (GLdouble)width / height, 1.0, 20.0);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(0.0f, 0.0f, -4.5f);
}

int main(int argc, char** argv) {
    glutInitWindowSize(400, 300);
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_SINGLE | GLUT_RGB | GLUT_DEPTH);
    glutCreateWindow("text");
    glClearColor(0.12f, 0.12f, 0.2f, 1.0f);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutIdleFunc(glutPostRedisplay);
    glutMainLoop();
    return 0;
}

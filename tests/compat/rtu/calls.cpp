// SPDX-License-Identifier: MIT
#include "tests/compat/rtu/calls.h"

#include <GL/gl.h>
#include <openrt/rt.h>

#include <algorithm>
#include <map>

namespace testing_rtu {

std::vector<Call> glCalls, rtCalls;
std::vector<Level> glLevels, rtLevels;
double glMatrix[16];
int bytesPerPixel = 3;
std::function<void()> whenLevelComes;

namespace {

float glMode(RTenum mode) {
    static const std::map<RTenum, float> modes = {
        {RT_POINTS, GL_POINTS},           {RT_LINES, GL_LINES},
        {RT_LINE_LOOP, GL_LINE_LOOP},     {RT_LINE_STRIP, GL_LINE_STRIP},
        {RT_TRIANGLES, GL_TRIANGLES},     {RT_TRIANGLE_STRIP, GL_TRIANGLE_STRIP},
        {RT_TRIANGLE_FAN, GL_TRIANGLE_FAN}, {RT_QUADS, GL_QUADS},
        {RT_QUAD_STRIP, GL_QUAD_STRIP},   {RT_POLYGON, GL_POLYGON}};
    return modes.at(mode);
}

Level levelOf(int level, int width, int height, const void* pixels) {
    const auto* bytes = static_cast<const unsigned char*>(pixels);
    return {level, width, height, {bytes, bytes + width * height * bytesPerPixel}};
}

} // namespace
} // namespace testing_rtu

using namespace testing_rtu;

extern "C" {

void GLAPIENTRY glBegin(GLenum mode) { glCalls.push_back({Call::Begin, {float(mode)}}); }
void GLAPIENTRY glEnd(void) { glCalls.push_back({Call::End, {}}); }
void GLAPIENTRY glVertex3f(GLfloat x, GLfloat y, GLfloat z) {
    glCalls.push_back({Call::Vertex, {x, y, z}});
}
void GLAPIENTRY glVertex2f(GLfloat x, GLfloat y) { glVertex3f(x, y, 0); }
void GLAPIENTRY glNormal3f(GLfloat x, GLfloat y, GLfloat z) {
    glCalls.push_back({Call::Normal, {x, y, z}});
}
void GLAPIENTRY glTexCoord2f(GLfloat s, GLfloat t) { glCalls.push_back({Call::TexCoord, {s, t}}); }

void GLAPIENTRY glTranslatef(GLfloat x, GLfloat y, GLfloat z) {
    for (int row = 0; row < 4; ++row)
        glMatrix[12 + row] += glMatrix[row] * double(x) + glMatrix[4 + row] * double(y) +
                              glMatrix[8 + row] * double(z);
}
void GLAPIENTRY glTranslated(GLdouble x, GLdouble y, GLdouble z) {
    for (int row = 0; row < 4; ++row)
        glMatrix[12 + row] += glMatrix[row] * x + glMatrix[4 + row] * y + glMatrix[8 + row] * z;
}
void GLAPIENTRY glMultMatrixd(const GLdouble* m) {
    double product[16] = {};
    for (int i = 0; i < 16; ++i)
        for (int k = 0; k < 4; ++k) product[i] += glMatrix[i % 4 + 4 * k] * m[i / 4 * 4 + k];
    std::copy(product, product + 16, glMatrix);
}
void GLAPIENTRY glMultMatrixf(const GLfloat* m) {
    double matrix[16];
    std::copy(m, m + 16, matrix);
    glMultMatrixd(matrix);
}
void GLAPIENTRY glScalef(GLfloat x, GLfloat y, GLfloat z) {
    const double factors[] = {x, y, z};
    for (int i = 0; i < 12; ++i) glMatrix[i] *= factors[i / 4];
}

// OpenGL's state as a program has it that has set nothing.
void GLAPIENTRY glGetIntegerv(GLenum name, GLint* value) {
    *value = name == GL_UNPACK_ALIGNMENT || name == GL_PACK_ALIGNMENT ? 4
             : name == GL_MAX_TEXTURE_SIZE                           ? 8192
                                                                     : 0;
}
void GLAPIENTRY glPixelStorei(GLenum, GLint) {}
const GLubyte* GLAPIENTRY glGetString(GLenum) {
    return reinterpret_cast<const GLubyte*>("1.5");
}
void GLAPIENTRY glGetTexLevelParameteriv(GLenum, GLint, GLenum, GLint* value) { *value = 1; }
void GLAPIENTRY glTexImage1D(GLenum target, GLint level, GLint, GLsizei width, GLint, GLenum,
                             GLenum type, const void* pixels) {
    if (target != GL_TEXTURE_1D || !pixels) return;
    if (type == GL_UNSIGNED_BYTE)
        return glLevels.push_back(levelOf(level, width, 1, pixels));
    // GLU gives 16 bits whatever it got.
    const auto* shorts = static_cast<const GLushort*>(pixels);
    Level converted{level, width, 1, {}};
    for (int i = 0; i < width * bytesPerPixel; ++i)
        converted.bytes.push_back(static_cast<unsigned char>(shorts[i] / 257));
    glLevels.push_back(converted);
}
void GLAPIENTRY glTexImage2D(GLenum target, GLint level, GLint, GLsizei width, GLsizei height,
                             GLint, GLenum, GLenum, const void* pixels) {
    if (target == GL_TEXTURE_2D && pixels)
        glLevels.push_back(levelOf(level, width, height, pixels));
}

void RTAPIENTRY rtBegin(RTenum mode) { rtCalls.push_back({Call::Begin, {glMode(mode)}}); }
void RTAPIENTRY rtEnd(void) { rtCalls.push_back({Call::End, {}}); }
void RTAPIENTRY rtVertex3f(RTfloat x, RTfloat y, RTfloat z) {
    rtCalls.push_back({Call::Vertex, {x, y, z}});
}
void RTAPIENTRY rtNormal3f(RTfloat x, RTfloat y, RTfloat z) {
    rtCalls.push_back({Call::Normal, {x, y, z}});
}
void RTAPIENTRY rtTexCoord2f(RTfloat s, RTfloat t) { rtCalls.push_back({Call::TexCoord, {s, t}}); }
void RTAPIENTRY rtTexImage1D(RTenum, RTint level, RTint, RTsizei width, RTint, RTenum, RTenum,
                             const void* pixels) {
    rtLevels.push_back(levelOf(level, width, 1, pixels));
}
void RTAPIENTRY rtTexImage2D(RTenum, RTint level, RTint, RTsizei width, RTsizei height, RTint,
                             RTenum, RTenum, const void* pixels) {
    rtLevels.push_back(levelOf(level, width, height, pixels));
    if (whenLevelComes) whenLevelComes();
}

} // extern "C"

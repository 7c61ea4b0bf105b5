/* SPDX-License-Identifier: MIT */
/* Pictures of fixed function in the names of OpenGL. Compiled twice: with OpenGL's headers, and
 * with openrt/gl.h in their place; DRAW_SCENE names the function. */
#include "tests/api/fixed_function_scenes.h"

#ifndef OPENRT
#include <GL/gl.h>
#endif

#include <math.h>

static unsigned long long state;

static unsigned bits(void) {
    state = state * 6364136223846793005ull + 1442695040888963407ull;
    return (unsigned)(state >> 33);
}
static float number(float low, float high) {
    return low + (high - low) * (float)(bits() % 100000u) / 100000.0f;
}
static unsigned choice(unsigned count) {
    return bits() % count;
}
static void color(float out[4], float largest) {
    int k;
    for (k = 0; k < 4; ++k) out[k] = number(0, largest);
}
static void enable(GLenum what, int on) {
    if (on)
        glEnable(what);
    else
        glDisable(what);
}

static void setMaterials(void) {
    const GLenum sides[2] = {GL_FRONT, GL_BACK};
    int side;
    for (side = 0; side < 2; ++side) {
        float c[4];
        color(c, 0.6f);
        glMaterialfv(sides[side], GL_AMBIENT, c);
        color(c, 1.0f);
        glMaterialfv(sides[side], GL_DIFFUSE, c);
        color(c, 1.0f);
        glMaterialfv(sides[side], GL_SPECULAR, c);
        color(c, 0.1f);
        glMaterialfv(sides[side], GL_EMISSION, c);
        glMaterialf(sides[side], GL_SHININESS, number(0, 100));
    }
}

static void setLights(unsigned features) {
    int i, k;
    float c[4];
    glEnable(GL_LIGHTING);
    color(c, 0.3f);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, c);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, (features & SCENE_LOCAL_VIEWER) != 0);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, (features & SCENE_TWO_SIDED) != 0);
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, features & SCENE_SEPARATE_SPECULAR
                                                    ? GL_SEPARATE_SPECULAR_COLOR
                                                    : GL_SINGLE_COLOR);
    for (i = 0; i < 3; ++i) {
        float place[4], towards[3];
        const GLenum light = (GLenum)(GL_LIGHT0 + i);
        glEnable(light);
        color(c, 0.2f);
        glLightfv(light, GL_AMBIENT, c);
        color(c, 0.7f);
        glLightfv(light, GL_DIFFUSE, c);
        color(c, 0.8f);
        glLightfv(light, GL_SPECULAR, c);
        for (k = 0; k < 3; ++k) place[k] = number(-3, 3);
        place[2] = number(0, 3);
        place[3] = (float)choice(2);
        glLightfv(light, GL_POSITION, place);
        if (features & SCENE_ATTENUATION) {
            glLightf(light, GL_CONSTANT_ATTENUATION, number(0.5f, 1));
            glLightf(light, GL_LINEAR_ATTENUATION, number(0, 0.3f));
            glLightf(light, GL_QUADRATIC_ATTENUATION, number(0, 0.1f));
        }
        if (features & SCENE_SPOTS) {
            for (k = 0; k < 3; ++k) towards[k] = number(-0.3f, 0.3f) - place[k];
            glLightfv(light, GL_SPOT_DIRECTION, towards);
            glLightf(light, GL_SPOT_CUTOFF, number(50, 90));
            glLightf(light, GL_SPOT_EXPONENT, number(0, 10));
        }
    }
    if (features & SCENE_COLOR_MATERIAL) {
        const GLenum modes[5] = {GL_EMISSION, GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR,
                                 GL_AMBIENT_AND_DIFFUSE};
        const GLenum faces[3] = {GL_FRONT, GL_BACK, GL_FRONT_AND_BACK};
        glColorMaterial(faces[choice(3)], modes[choice(5)]);
        glEnable(GL_COLOR_MATERIAL);
    }
}

static void setFog(void) {
    const GLenum modes[3] = {GL_LINEAR, GL_EXP, GL_EXP2};
    float c[4];
    color(c, 1.0f);
    glEnable(GL_FOG);
    glFogi(GL_FOG_MODE, (GLint)modes[choice(3)]);
    glFogf(GL_FOG_DENSITY, number(0.05f, 0.3f));
    glFogf(GL_FOG_START, number(1, 3));
    glFogf(GL_FOG_END, number(6, 9));
    glFogfv(GL_FOG_COLOR, c);
}

enum { kTexels = 16 };

static void setImage(int level, int side, GLint internalFormat, int coarse) {
    static unsigned char texels[kTexels * kTexels][4];
    int x, y, k;
    for (y = 0; y < side; ++y)
        for (x = 0; x < side; ++x)
            for (k = 0; k < 4; ++k) {
                const double wave = sin((x + 0.5) * 6.2831853 / side * (1 + k % 2)) *
                                    cos((y + 0.5) * 6.2831853 / side);
                texels[y * side + x][k] =
                    (unsigned char)(coarse ? 30 * level + 20 * k : (int)(127.5 + 100 * wave));
            }
    glTexImage2D(GL_TEXTURE_2D, level, internalFormat, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 texels);
}

static void setCombine(void) {
    const GLint functions[8] = {GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED,
                                GL_INTERPOLATE, GL_SUBTRACT, GL_DOT3_RGB, GL_DOT3_RGBA};
    const GLint sources[4] = {GL_TEXTURE, GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS};
    const GLint operands[4] = {GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_SRC_COLOR,
                               GL_ONE_MINUS_SRC_COLOR};
    int i;
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, functions[choice(8)]);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, functions[choice(6)]);
    for (i = 0; i < 3; ++i) {
        glTexEnvi(GL_TEXTURE_ENV, (GLenum)(GL_SOURCE0_RGB + i), sources[choice(4)]);
        glTexEnvi(GL_TEXTURE_ENV, (GLenum)(GL_SOURCE0_ALPHA + i), sources[choice(4)]);
        glTexEnvi(GL_TEXTURE_ENV, (GLenum)(GL_OPERAND0_RGB + i), operands[choice(4)]);
        glTexEnvi(GL_TEXTURE_ENV, (GLenum)(GL_OPERAND0_ALPHA + i), operands[choice(2)]);
    }
    glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, (float)(1u << choice(3)));
    glTexEnvf(GL_TEXTURE_ENV, GL_ALPHA_SCALE, (float)(1u << choice(3)));
}

static void setTexture(unsigned features) {
    const GLint formats[6] = {GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA,
                              GL_INTENSITY, GL_RGB, GL_RGBA};
    const GLint modes[6] = {GL_MODULATE, GL_REPLACE, GL_BLEND, GL_ADD, GL_DECAL, GL_COMBINE};
    const GLint wraps[3] = {GL_REPEAT, GL_CLAMP_TO_EDGE, GL_MIRRORED_REPEAT};
    const int mipmaps = (features & SCENE_MIPMAPS) != 0;
    const unsigned mode = choice(6);
    const GLint format = formats[modes[mode] == GL_DECAL ? 4 + choice(2) : choice(6)];
    float c[4];
    int level, side;
    glEnable(GL_TEXTURE_2D);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    if (features & SCENE_NAMED_TEXTURE) glBindTexture(GL_TEXTURE_2D, 7);
    for (level = 0, side = kTexels; side > 0; ++level, side /= 2) {
        setImage(level, side, mipmaps ? GL_RGB : format, mipmaps);
        if (!mipmaps) break;
    }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                    mipmaps ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wraps[choice(3)]);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wraps[choice(3)]);
    color(c, 1.0f);
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, c);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, mipmaps ? GL_REPLACE : modes[mode]);
    if (modes[mode] == GL_COMBINE && !mipmaps) setCombine();
    if (features & SCENE_TEXTURE_MATRIX) {
        glMatrixMode(GL_TEXTURE);
        glLoadIdentity();
        glTranslatef(number(0, 1), number(0, 1), 0);
        glRotatef(number(0, 360), 0, 0, 1);
        glScalef(number(0.5f, 2), number(0.5f, 2), 1);
        if (mipmaps) glScalef(10, 10, 1);
        glMatrixMode(GL_MODELVIEW);
    }
    if (features & SCENE_TEXGEN) {
        const GLint gens[5] = {GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_SPHERE_MAP, GL_NORMAL_MAP,
                               GL_REFLECTION_MAP};
        const GLint gen = gens[choice(5)];
        const float s[4] = {0.7f, 0.2f, 0.1f, 0.3f}, t[4] = {0.1f, 0.6f, -0.4f, 0.1f};
        glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, gen);
        glTexGeni(GL_T, GL_TEXTURE_GEN_MODE, gen);
        glTexGenfv(GL_S, GL_OBJECT_PLANE, s);
        glTexGenfv(GL_T, GL_OBJECT_PLANE, t);
        glTexGenfv(GL_S, GL_EYE_PLANE, s);
        glTexGenfv(GL_T, GL_EYE_PLANE, t);
        glEnable(GL_TEXTURE_GEN_S);
        glEnable(GL_TEXTURE_GEN_T);
    }
}

/* A wavy sheet of 5 x 5 vertices. */
static void vertex(int i, int j, float height) {
    const float x = (float)i / 2 - 1, y = (float)j / 2 - 1;
    const float z = height * sinf(2 * x + 0.5f) * cosf(2 * y);
    glNormal3f(-2 * height * cosf(2 * x + 0.5f) * cosf(2 * y),
               2 * height * sinf(2 * x + 0.5f) * sinf(2 * y), 1);
    glColor4f(0.5f + 0.4f * x, 0.5f - 0.4f * y, 0.5f + 0.3f * x * y, 0.3f + 0.2f * (x + 1));
    glTexCoord4f(x * 1.2f + 0.3f, y, 0, 1);
    glVertex3f(x, y, z);
}

static void drawSheet(unsigned features, float height) {
    int i, j;
    if (features & SCENE_QUADS) {
        glBegin(GL_QUADS);
        for (j = 0; j < 4; ++j)
            for (i = 0; i < 4; ++i) {
                vertex(i, j, height);
                vertex(i + 1, j, height);
                vertex(i + 1, j + 1, height);
                vertex(i, j + 1, height);
            }
        glEnd();
        return;
    }
    for (j = 0; j < 4; ++j) {
        glBegin(GL_TRIANGLE_STRIP);
        for (i = 0; i < 5; ++i) {
            vertex(i, j + 1, height);
            vertex(i, j, height);
        }
        glEnd();
    }
}

void DRAW_SCENE(unsigned features, unsigned seed) {
    float height;
    state = seed * 7919ull + 17;
    /* Along which diagonal a quad is split is left open: it must not matter. */
    if (features & SCENE_QUADS) features = (features | SCENE_FLAT) & ~(unsigned)SCENE_TEXGEN;
    glViewport(0, 0, SCENE_SIDE, SCENE_SIDE);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    if (features & SCENE_ORTHO)
        glOrtho(-1.3, 1.3, -1.3, 1.3, 1, 10);
    else
        glFrustum(-0.4, 0.4, -0.4, 0.4, 1, 10);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    if (features & SCENE_LIGHTS) setLights(features);
    setMaterials();
    if (features & SCENE_FOG) setFog();
    if (features & SCENE_TEXTURE) setTexture(features);
    glShadeModel(features & SCENE_FLAT ? GL_FLAT : GL_SMOOTH);
    glFrontFace(features & SCENE_CLOCKWISE ? GL_CW : GL_CCW);
    enable(GL_NORMALIZE, (features & SCENE_RESCALE) == 0);
    enable(GL_RESCALE_NORMAL, (features & SCENE_RESCALE) != 0);
    glTranslatef(number(-0.1f, 0.1f), number(-0.1f, 0.1f), -3.5f);
    glRotatef(number(-40, 40) + (features & SCENE_TURNED ? 180.0f : 0.0f), 0.3f, 1, 0.1f);
    glScalef(1.2f, 1.2f, 1.2f);
    height = features & SCENE_QUADS ? 0.0f : number(0.1f, 0.4f);
    if (features & SCENE_LIST) {
        glNewList(1, GL_COMPILE);
        drawSheet(features, height);
        glEndList();
        glCallList(1);
    } else {
        drawSheet(features, height);
    }
}

// SPDX-License-Identifier: MIT
#include "tests/memory/scenes.h"

#include <cmath>

#include "openrt/rt.h"
#include "openrt/rtu.h"

namespace openrt::test {
namespace {

void triangle(float x, float z) {
    rtBegin(RT_TRIANGLES);
    rtVertex3f(x - 0.5f, -0.5f, z);
    rtVertex3f(x + 0.5f, -0.5f, z);
    rtVertex3f(x, 0.5f, z);
    rtEnd();
}

RTuint classes[8], classCount = 0;

RTuint shaderOf(const char* name) {
    classes[classCount++ % 8] = rtGenNewShaderClass(name, nullptr);
    return rtGenNewShader();
}
void forgetClasses() {
    while (classCount > 0) rtRemoveShaderClass(classes[--classCount % 8]);
}

void checkTexture() {
    static const RTubyte texels[16] = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 9, 9, 9, 9};
    rtBindTexture(RT_TEXTURE_2D, 1);
    rtTexImage2D(RT_TEXTURE_2D, 0, RT_RGBA, 2, 2, 0, RT_RGBA, RT_UNSIGNED_BYTE, texels);
    rtTexParameteri(RT_TEXTURE_2D, RT_TEXTURE_MIN_FILTER, RT_NEAREST);
}

/// A bumpy field, large enough for a tree of several levels.
void field(int rows) {
    for (int row = 0; row < rows; ++row) {
        rtBegin(RT_TRIANGLE_STRIP);
        for (int i = 0; i <= rows; ++i)
            for (int side = 0; side < 2; ++side) {
                const float x = float(i) / float(rows) - 0.5f;
                const float y = float(row + side) / float(rows) - 0.5f;
                rtNormal3f(x, y, 1);
                rtVertex3f(x, y, float((i * 7 + row * 5) % 11) / 40);
            }
        rtEnd();
    }
}

void looseTriangles() {
    for (int i = 0; i < 5; ++i) {
        rtColor3f(float(i) / 5, 0.5f, 1);
        triangle(float(i) / 4 - 0.5f, float(i) / 10);
    }
    rtRender();
}

void shadedObjects() {
    const RTuint light = shaderOf("PointLight");
    const RTuint environment = shaderOf("ConstantEnvironment");
    const RTuint surface = shaderOf("DiffuseShader");
    rtParameter3f(rtParameterHandle("color"), 0.5f, 0.75f, 0.25f);
    const RTuint inner = rtNewObject(RT_DEFINE);
    rtBindShader(surface);
    field(6);
    rtEndObject();
    const RTuint outer = rtNewObject(RT_DEFINE);
    rtInstantiateObject(inner);
    rtTranslatef(0.25f, 0.25f, 0.25f);
    rtInstantiateObjectShader(inner, 0);
    rtEndObject();
    static const RTfloat moved[6] = {-0.5f, -0.5f, 0.5f, 0.5f, -0.5f, 0.5f};
    rtUpdateObject(inner, 0, 2, moved);
    rtUseLight(light);
    rtUseEnvironmentShader(environment);
    rtInstantiateObject(outer);
    const RTuint replacement = surface;
    rtInstantiateObjectShaders(outer, 1, &replacement);
    rtReplaceObject(outer);
    triangle(0, 0.5f);
    rtEndObject();
    rtInstantiateObject(outer);
    rtRender();
    rtRemoveObject(outer);
    rtRemoveObject(inner);
    for (const RTuint shader : {light, environment, surface}) rtRemoveShader(shader);
    forgetClasses();
}

void lists() {
    const RTuint first = rtGenLists(2);
    rtNewList(first, RT_COMPILE);
    rtColor3f(1, 0.5f, 0);
    rtPushMatrix();
    rtRotatef(30, 0, 0, 1);
    triangle(0, 0);
    rtPopMatrix();
    rtEndList();
    rtNewList(first + 1, RT_COMPILE_AND_EXECUTE);
    rtCallList(first);
    rtTranslatef(0.25f, 0.25f, 0.125f);
    rtCallList(first);
    rtEndList();
    const RTuint both[2] = {first, first + 1};
    rtCallLists(2, RT_UNSIGNED_INT, both);
    rtRender();
    rtDeleteLists(first, 2);
}

void fixedFunction() {
    static const RTfloat position[4] = {0.5f, 0.5f, 2, 1};
    rtPushAttrib(RT_ALL_ATTRIB_BITS);
    rtEnable(RT_LIGHTING);
    rtEnable(RT_LIGHT0);
    rtLightfv(RT_LIGHT0, RT_POSITION, position);
    rtEnable(RT_TEXTURE_2D);
    checkTexture();
    rtEnable(RT_FOG);
    rtEnable(RT_DEPTH_TEST);
    rtTexCoord2f(0.25f, 0.75f);
    field(4);
    rtRender();
    rtPopAttrib();
    const RTuint texture = 1;
    rtDeleteTextures(1, &texture);
}

void layers() {
    rtPushAttrib(RT_ALL_ATTRIB_BITS);
    rtEnable(RT_BLEND);
    rtBlendFunc(RT_SRC_ALPHA, RT_ONE_MINUS_SRC_ALPHA);
    rtColor4f(1, 0, 0, 0.5f);
    triangle(0, 0);
    rtColor4f(0, 1, 0, 0.5f);
    triangle(0.25f, 0.25f);
    rtClear(RT_DEPTH_BUFFER_BIT);
    rtBegin(RT_LINES);
    rtVertex3f(-1, -1, 0);
    rtVertex3f(1, 1, 0);
    rtEnd();
    rtPointSize(3);
    rtBegin(RT_POINTS);
    rtVertex3f(0, 0, 0);
    rtEnd();
    static const RTubyte bits[8] = {0xFF, 0x81, 0x81, 0xFF, 0xFF, 0x81, 0x81, 0xFF};
    rtRasterPos3f(-0.5f, -0.5f, 0);
    rtBitmap(8, 2, 0, 0, 0, 0, bits);
    rtDrawPixels(2, 1, RT_RGBA, RT_UNSIGNED_BYTE, bits);
    rtRender();
    rtPopAttrib();
}

void arrays() {
    static const RTfloat corners[12] = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0};
    static const RTubyte order[6] = {0, 1, 2, 0, 2, 3};
    RTuint buffer = 0;
    rtGenBuffers(1, &buffer);
    rtBindBuffer(RT_ARRAY_BUFFER, buffer);
    rtBufferData(RT_ARRAY_BUFFER, sizeof corners, corners, RT_STATIC_DRAW);
    rtVertexPointer(3, RT_FLOAT, 0, nullptr);
    rtEnableClientState(RT_VERTEX_ARRAY);
    rtDrawElements(RT_TRIANGLES, 6, RT_UNSIGNED_BYTE, order);
    rtBindBuffer(RT_ARRAY_BUFFER, 0);
    rtVertexPointer(3, RT_FLOAT, 0, corners);
    rtDrawArrays(RT_TRIANGLE_FAN, 0, 4);
    rtDisableClientState(RT_VERTEX_ARRAY);
    rtRender();
    rtDeleteBuffers(1, &buffer);
}

void queuedFrames() {
    rtFrameDepth(3);
    RTuint last = 0;
    for (int i = 0; i < 3; ++i) {
        const RTuint camera = shaderOf("PinholeCameraShader");
        rtUseCamera(camera);
        triangle(float(i) / 4, -2);
        last = rtQueueFrame();
        rtUseCamera(camera);
        last = rtQueueView();
        rtRemoveShader(camera);
    }
    rtWaitFrame(last);
    rtFinish(); // the last may have failed, and others be under way
    forgetClasses();
    triangle(0, 0); // the picture that is looked at
    rtRender();
}

void rays() {
    triangle(0, 0);
    const RTuint scene = rtCompileScene();
    RTray some[20] = {};
    RThit hits[20];
    for (int i = 0; i < 20; ++i) some[i] = {{float(i) / 20, 0, 5}, 0, {0, 0, -1}, 100};
    rtIntersect(scene, some, hits, 20, RT_COHERENT);
    RTubyte blocked[20];
    rtOccluded(scene, some, blocked, 20, RT_INCOHERENT);
    rtReleaseScene(scene);
    rtRender();
}

void utilities() {
    RTUquadric* const quadric = rtuNewQuadric();
    rtuSphere(quadric, 0.5, 6, 4);
    rtuDeleteQuadric(quadric);
    static RTdouble corners[5][3] = {{-1, -1, 0}, {1, -1, 0}, {0, 0, 0}, {1, 1, 0}, {-1, 1, 0}};
    RTUtesselator* const tess = rtuNewTess();
    rtuTessCallback(tess, RTU_TESS_BEGIN, RTUfuncptr(rtBegin));
    rtuTessCallback(tess, RTU_TESS_VERTEX, RTUfuncptr(rtVertex3dv));
    rtuTessCallback(tess, RTU_TESS_END, RTUfuncptr(rtEnd));
    rtuTessBeginPolygon(tess, nullptr);
    rtuTessBeginContour(tess);
    for (RTdouble* corner : corners) rtuTessVertex(tess, corner, corner);
    rtuTessEndContour(tess);
    rtuTessEndPolygon(tess);
    rtuDeleteTess(tess);
    static const RTubyte image[3 * 12] = {9, 200, 90};
    rtBindTexture(RT_TEXTURE_2D, 2);
    rtuBuild2DMipmaps(RT_TEXTURE_2D, RT_RGB, 3, 3, RT_RGB, RT_UNSIGNED_BYTE, image);
    rtRender();
    const RTuint texture = 2;
    rtDeleteTextures(1, &texture);
}

void lazyObjects() {
    for (const RTenum quality : {RT_NICEST, RT_FASTEST, RT_KD_TREE}) {
        rtObjectHint(RT_BUILD_QUALITY, RTenum(quality));
        rtObjectHint(RT_LAZY_BUILD, quality != RT_FASTEST);
        const RTuint object = rtNewObject(RT_DEFINE);
        field(8);
        rtEndObject();
        rtInstantiateObject(object);
        rtTranslatef(0.3f, 0.3f, 0.3f);
        rtRemoveObject(object);
    }
    rtRender();
}

} // namespace

const std::vector<Scene>& scenes() {
    static const std::vector<Scene> all = {
        {"loose triangles", looseTriangles}, {"shaded objects", shadedObjects},
        {"display lists", lists},            {"fixed function", fixedFunction},
        {"layers", layers},                  {"vertex arrays", arrays},
        {"queued frames", queuedFrames},     {"ray queries", rays},
        {"utilities", utilities},            {"lazy objects", lazyObjects},
    };
    return all;
}

void backToStart() {
    rtEnd();
    rtEndList();
    rtEndObject();
    rtEndRendering();
    static RTubyte unseen[4];
    rtSetFrameBuffer(unseen, 1, 1, RT_RGBA_8);
    rtRender(); // uses up what was given of a scene
    for (int i = 0; i < 8; ++i) rtPopAttrib();
    for (const RTenum mode : {RT_PROJECTION, RT_MODELVIEW}) {
        rtMatrixMode(RTenum(mode));
        for (int i = 0; i < 8; ++i) rtPopMatrix();
        rtLoadIdentity();
    }
    rtDisableClientState(RT_VERTEX_ARRAY);
    rtBindBuffer(RT_ARRAY_BUFFER, 0);
    rtBindTexture(RT_TEXTURE_2D, 0);
    rtBindShader(0);
    rtColor4f(1, 1, 1, 1);
    rtNormal3f(0, 0, 1);
    rtTexCoord4f(0, 0, 0, 1);
    rtPointSize(1);
    for (const RTenum what : {RT_BLEND, RT_LIGHTING, RT_LIGHT0, RT_TEXTURE_2D, RT_FOG,
                              RT_DEPTH_TEST})
        rtDisable(RTenum(what));
    rtObjectHint(RT_BUILD_QUALITY, RT_DONT_CARE);
    rtObjectHint(RT_LAZY_BUILD, RT_FALSE);
    rtRasterPos3f(0, 0, 0);
    while (rtGetError() != RT_NO_ERROR) {
    }
}

} // namespace openrt::test

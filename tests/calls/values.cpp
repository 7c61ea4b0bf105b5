// SPDX-License-Identifier: MIT
#include "tests/calls/values.h"

#include <climits>
#include <cmath>
#include <cstring>
#include <limits>

namespace openrt::test {

unsigned char framePixels[kFrameBytes];
unsigned callbacks = 0;

namespace {

// As large as any image of the sides and skips below.
constexpr std::size_t kMemory = 1 << 20;
unsigned char zeroBytes[kMemory], mixedBytes[kMemory];
unsigned char scratch[16 << 20]; // whatever calls write
float floatArray[256], wildFloats[256], smallFloats[256];
double doubleArray[256], wildDoubles[256];
RTint intArray[256], wildInts[256];
RTuint idArray[256], indexArray[4096];
RTsizei countArray[256];
const void* pointerArray[256];
RTray rays[64];
RTuint compiled = 0;
RTUquadric* quadric = nullptr;
RTUtesselator* tess = nullptr;
RTcontext context = nullptr;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

void fillMemory() {
    static const float wild[] = {kNan, kInfinity, -kInfinity, 1e30f, -1e30f, 1e-40f, -0.0f, 0.5f};
    static const RTint wildInt[] = {INT_MAX, INT_MIN, -1, 0, 1, 3, 0x1400, 0x7F041};
    for (std::size_t i = 0; i < kMemory; ++i) mixedBytes[i] = (unsigned char)(i * 37 + i / 256);
    for (int i = 0; i < 256; ++i) {
        floatArray[i] = float(i % 5) / 4;
        smallFloats[i] = i % 5 == 0 ? 1.0f : 0.0f; // the identity matrix
        wildFloats[i] = wild[i % 8];
        doubleArray[i] = floatArray[i];
        wildDoubles[i] = double(wild[(i + 3) % 8]);
        intArray[i] = i % 6 + 1;
        wildInts[i] = wildInt[i % 8];
        idArray[i] = RTuint(i % 6 + 1);
        countArray[i] = i % 5 - 1;
        pointerArray[i] = i % 7 == 6 ? nullptr : indexArray;
    }
    for (int i = 0; i < 4096; ++i) indexArray[i] = RTuint(i % 9);
    for (int i = 0; i < 64; ++i) {
        rays[i].origin[0] = float(i % 8) / 4 - 1;
        rays[i].origin[1] = float(i / 8) / 4 - 1;
        rays[i].origin[2] = i == 60 ? kNan : 5;
        rays[i].direction[2] = i == 61 ? 0 : -1;
        rays[i].tfar = i == 62 ? kInfinity : 100;
    }
}

std::vector<Value> numbers(std::initializer_list<int64_t> list) {
    std::vector<Value> values;
    for (const int64_t number : list) values.push_back(Value::of(number));
    return values;
}
std::vector<Value> memories(std::initializer_list<const void*> list) {
    std::vector<Value> values;
    for (const void* memory : list) values.push_back(Value::of(memory));
    return values;
}

std::vector<Value> floatingValues() {
    std::vector<Value> values;
    for (const double number : {0.5, 0.0, 1.0, -1.0, 2.0, 45.0, 1e-40, 1e-7, 1e30, -1e30, 1e300,
                                double(kNan), double(kInfinity), -double(kInfinity)})
        values.push_back(Value::of(number));
    return values;
}

std::vector<Value> tokenValues(const std::vector<RTenum>& tokens) {
    std::vector<Value> values = numbers({0});
    for (const RTenum token : tokens) values.push_back(Value::of(int64_t(token)));
    values.push_back(Value::of(0x9999));
    return values;
}

std::vector<Value> fonts() {
    std::vector<Value> values;
    for (const int number : {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, INT_MAX})
        values.push_back(Value::of(reinterpret_cast<const void*>(uintptr_t(number))));
    values.push_back(Value::of(scratch));
    return values;
}

std::vector<Value> programArguments() {
    static char program[] = "program", threads[] = "--rt-threads", one[] = "1";
    static char frames[] = "--rt-offscreen", none[] = "0";
    static char* right[] = {program, threads, one, nullptr};
    static char* wrong[] = {program, frames, none, nullptr};
    static char* incomplete[] = {program, one, frames, nullptr};
    static char* empty[] = {nullptr, nullptr, nullptr, nullptr};
    return memories({right, wrong, incomplete, empty, nullptr});
}

std::vector<Value> make(Kind kind) {
    static RTraystream stream;
    static RThitstream hits;
    static const RTshaderclass empty = {};
    static RTshaderclass copied = {};
    switch (kind) {
        case Kind::Token:
            return tokenValues(apiTokens());
        case Kind::Bits:
            return numbers({1, 0, 2, 0x4000, 0xFFFFF, 0xFFFFFFFF, 0x80000000});
        case Kind::Number:
            return floatingValues();
        case Kind::Integer:
            return numbers({1, 0, 2, 3, 5, 7, 16, 100, 255, 4096, -1, -2, 65536, INT_MAX, INT_MIN});
        case Kind::Id:
            return numbers({1, 0, 2, 3, 4, 5, 6, 7, 0x7FFFFFFF, 0xFFFFFFFE, 0xFFFFFFFF});
        case Kind::Count:
            return numbers({1, 0, 2, 3, 4, 5, 8, 16, -1, INT_MIN});
        case Kind::Size:
            return numbers({1, 0, 2, 3, 4, 8, 12, 16, 64, 4096});
        case Kind::Samples:
            return numbers({2, 0, 1, 4, 4097, 0xFFFFFFFF});
        case Kind::Threads:
            return numbers({2, 1, 1025, 0xFFFFFFFF});
        case Kind::Depth:
            return numbers({3, 0, 1, 2, 0xFFFFFFFF});
        case Kind::Recursion:
            return numbers({3, 0, 1, 8, 257, 0xFFFFFFFF});
        case Kind::Side:
            return numbers({16, 0, 1, 7, 33});
        case Kind::Stride:
            return numbers({0, 64, 128, 512, 63, 3, -1, INT_MIN});
        case Kind::Floats:
            return memories({floatArray, smallFloats, wildFloats, nullptr});
        case Kind::Doubles:
            return memories({doubleArray, wildDoubles, nullptr});
        case Kind::Ints:
            return memories({intArray, wildInts, nullptr});
        case Kind::Ids:
            return memories({idArray, nullptr});
        case Kind::Counts:
            return memories({countArray, nullptr});
        case Kind::Image:
            return memories({zeroBytes, mixedBytes, wildFloats, nullptr});
        case Kind::Indices:
            return memories({indexArray, zeroBytes, nullptr});
        case Kind::Pointers:
            return memories({pointerArray, nullptr});
        case Kind::Out:
            return memories({scratch, nullptr});
        case Kind::Text:
            return memories({"DiffuseShader",
                             "color",
                             "",
                             "position",
                             "radiance",
                             "ConstantShader",
                             "TexturedDiffuseShader",
                             "TextureShader",
                             "MirrorShader",
                             "PointLight",
                             "SpotLightShader",
                             "PunctualLight",
                             "DirectionalLight",
                             "QuadLight",
                             "SphereLight",
                             "ConstantEnvironment",
                             "ImageEnvironment",
                             "PinholeCameraShader",
                             "texture",
                             "no such\n\xff\x01%s%n",
                             nullptr});
        case Kind::FileName:
            return memories({nullptr, "", "missing", "/dev/null", "/", "./a\xff.so"});
        case Kind::Rays:
            return memories({rays, nullptr});
        case Kind::RayStream:
            stream = {floatArray, floatArray, floatArray, floatArray, wildFloats,
                      floatArray, nullptr,    wildFloats, 0};
            return memories({&stream, nullptr});
        case Kind::HitStream: {
            auto* const floats = reinterpret_cast<float*>(scratch);
            auto* const ids = reinterpret_cast<RTuint*>(scratch + 4096);
            hits = {floats,  floats + 64,  nullptr, ids,    ids + 64,
                    nullptr, floats + 128, nullptr, nullptr};
            return memories({&hits, nullptr});
        }
        case Kind::Descriptor:
            copied.structSize = sizeof copied;
            copied.name = "Copied";
            return memories({&empty, &copied, nullptr});
        case Kind::Context:
            return {Value::of(Made::Context), Value{}, Value::of(scratch)};
        case Kind::Quadric:
            return {Value::of(Made::Quadric), Value{}};
        case Kind::Tess:
            return {Value::of(Made::Tess), Value{}};
        case Kind::Nurbs:
            return memories({nullptr});
        case Kind::ErrorCallback:
        case Kind::FrameCallback:
        case Kind::Function:
        case Kind::Callback:
            return memories({scratch, nullptr});
        case Kind::ToolkitToken:
            return tokenValues(toolkitTokens());
        case Kind::Pixels:
            return numbers({16, 0, 1, 300, -1, 16385, INT_MAX, INT_MIN});
        case Kind::Font:
            return fonts();
        case Kind::DisplayString:
            return memories(
                {"rgba double depth samples", "single", "index", "", "%s%n\xff", nullptr});
        case Kind::ArgumentCount: {
            static int three = 3, two = 2, none = 0, negative = -1, least = INT_MIN;
            return memories({&three, &two, &none, &negative, &least, nullptr});
        }
        case Kind::Arguments:
            return programArguments();
        case Kind::kCount:
            break;
    }
    return {Value{}};
}

RTuint shaderOf(const char* className) {
    rtGenNewShaderClass(className, nullptr);
    return rtGenNewShader();
}

} // namespace

RTuint Value::compiledScene() {
    return compiled;
}

const void* Value::pointer() const {
    switch (made) {
        case Made::Context:
            return context;
        case Made::Quadric:
            return quadric;
        case Made::Tess:
            return tess;
        default:
            return p;
    }
}

const std::vector<Value>& valuesOf(Kind kind) {
    static const bool filled = (fillMemory(), true);
    (void)filled;
    static std::vector<Value> tables[std::size_t(Kind::kCount)];
    std::vector<Value>& values = tables[std::size_t(kind)];
    if (values.empty()) values = make(kind);
    return values;
}

const std::vector<RTenum>& apiTokens() {
    static const std::vector<RTenum> tokens = {
#include "tests/calls/api_tokens.inc"
    };
    return tokens;
}

const std::vector<RTenum>& toolkitTokens() {
    static const std::vector<RTenum> tokens = {
#include "tests/calls/rtut_tokens.inc"
    };
    return tokens;
}

extern "C" {
static char nameOfProgram[] = "program", threadsOption[] = "--rt-threads", twoThreads[] = "2";
char* startNames[] = {nullptr, nullptr, nullptr, nullptr};
int* startArguments(const Value&) {
    static int count;
    startNames[0] = nameOfProgram;
    startNames[1] = threadsOption;
    startNames[2] = twoThreads;
    count = 3;
    return &count;
}
void errorCallback(RTenum, const char*, const char*, void*) {
    ++callbacks;
}
void frameCallback(RTuint, RTenum, RTint, RTint, RTsizei, RTsizei, void*) {}
}

void prepareContext() {
    valuesOf(Kind::Floats);
    rtThreads(1);
    rtSetFrameBuffer(framePixels, kSide, kSide, RT_RGBA_8);
    shaderOf("DiffuseShader");
    shaderOf("PointLight");
    shaderOf("PinholeCameraShader");
    shaderOf("ConstantEnvironment");
    rtBindShader(1);
    rtParameterHandle("color");
    rtBindTexture(RT_TEXTURE_2D, 1);
    rtTexImage2D(RT_TEXTURE_2D, 0, RT_RGBA, 2, 2, 0, RT_RGBA, RT_UNSIGNED_BYTE, mixedBytes);
    rtBindBuffer(RT_ARRAY_BUFFER, 1);
    rtBufferData(RT_ARRAY_BUFFER, 256, indexArray, RT_STATIC_DRAW);
    rtBindBuffer(RT_ARRAY_BUFFER, 0);
    rtNewList(1, RT_COMPILE);
    rtColor3f(0.5f, 0.25f, 1);
    rtEndList();
    rtNewObject(RT_DEFINE);
    rtBegin(RT_TRIANGLES);
    rtVertex3f(-1, -1, 0);
    rtVertex3f(1, -1, 0);
    rtVertex3f(0, 1, 0);
    rtEnd();
    rtEndObject();
    rtInstantiateObject(1);
    rtReleaseScene(compiled);
    compiled = rtCompileScene();
    if (!quadric) quadric = rtuNewQuadric();
    if (!tess) tess = rtuNewTess();
    context = rtGetCurrentContext();
    while (rtGetError() != RT_NO_ERROR) {
    }
}

void forgetContext() {
    if (compiled) rtReleaseScene(compiled);
    compiled = 0;
    rtuDeleteQuadric(quadric);
    rtuDeleteTess(tess);
    quadric = nullptr;
    tess = nullptr;
}

} // namespace openrt::test

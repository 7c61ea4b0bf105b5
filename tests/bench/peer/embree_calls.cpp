// SPDX-License-Identifier: MIT
// The calls that the samples of changing scenes make, on Embree: linked with this instead of the
// library, a sample makes the same frames there. Colours, normals and materials are dropped; frames
// are rendered at once, off-screen. Options: --rt-offscreen N, --rt-size WxH, --rt-output FILE
// with a %d, for pictures of what is seen (PGM), and --embree refit, low or medium.
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "openrt/rt.h"
#include "openrt/rtut.h"
#include "tests/bench/peer/embree_frames.h"

namespace {

using smart::bench::EmbreeFrames;
using smart::bench::PeerFrame;
using smart::bench::PeerRays;
using smart::bench::PeerWay;

constexpr int kMillisecondsOfFrame = 40;
constexpr std::size_t kLights = 8;

struct Program {
    int frames = 1, done = 0;
    int width = 512, height = 512;
    bool hasSize = false;
    std::string output;
    PeerWay way = PeerWay::Low;
    void (*display)() = nullptr;
    void (*reshape)(int, int) = nullptr;
    void (*idle)() = nullptr;
};

struct Definition {
    RTuint id = 0;
    bool replaces = false, reflects = false;
    std::vector<float> points;
    std::vector<uint32_t> corners;
};

struct Light {
    bool on = false;
    std::array<float, 4> position{0, 0, 1, 0};
};

struct State {
    glm::dmat4 modelView{1}, projection{1};
    std::vector<glm::dmat4> pushed;
    RTenum mode = RT_MODELVIEW;
    bool lit = false, shadows = false, fastest = false;
    Light lights[kLights];
    std::map<RTuint, std::array<float, 4>> shaders; // those with a position
    std::vector<RTuint> used;                       // of them, by this frame
    RTuint newest = 0, shader = 0;
    std::unique_ptr<Definition> definition;
    RTenum primitive = 0;
    uint32_t first = 0; // point of this run
    std::vector<PeerFrame::Instance> instances;
    PeerRays rays;
    int pictures = 0;
};

Program program;
State state;
std::unique_ptr<EmbreeFrames> peer;

[[noreturn]] void refuse(const std::string& what) {
    std::fprintf(stderr, "the peer of a sample: %s\n", what.c_str());
    std::exit(2);
}

glm::dmat4& current() {
    return state.mode == RT_PROJECTION ? state.projection : state.modelView;
}
void multiply(const glm::dmat4& by) {
    current() = current() * by;
}

void vertex(double x, double y, double z) {
    glm::dvec4 point(x, y, z, 1);
    if (state.modelView != glm::dmat4(1)) point = state.modelView * point;
    for (int k = 0; k < 3; ++k) state.definition->points.push_back(float(point[k]));
}

void endPrimitive() {
    Definition& d = *state.definition;
    const uint32_t begin = state.first, end = uint32_t(d.points.size() / 3);
    const auto triangle = [&](uint32_t a, uint32_t b, uint32_t c) {
        d.corners.insert(d.corners.end(), {a, b, c});
    };
    if (state.primitive == RT_TRIANGLES) {
        for (uint32_t i = begin; i + 2 < end; i += 3) triangle(i, i + 1, i + 2);
    } else if (state.primitive == RT_QUADS || state.primitive == RT_QUAD_STRIP) {
        const bool strip = state.primitive == RT_QUAD_STRIP;
        for (uint32_t i = begin; i + 3 < end; i += strip ? 2 : 4) {
            const uint32_t third = strip ? i + 3 : i + 2, fourth = strip ? i + 2 : i + 3;
            triangle(i, i + 1, third);
            triangle(i, third, fourth);
        }
    } else {
        refuse("another kind of primitive");
    }
}

void writeSeen(const std::vector<uint8_t>& seen, uint32_t width, uint32_t height) {
    std::string name = program.output;
    const std::size_t place = name.find("%d");
    if (place != std::string::npos) name.replace(place, 2, std::to_string(state.pictures++));
    std::FILE* const file = std::fopen(name.c_str(), "wb");
    if (!file) refuse(name + " cannot be written");
    std::fprintf(file, "P5\n%u %u\n255\n", width, height);
    for (uint32_t y = height; y-- > 0;) std::fwrite(&seen[y * width], 1, width, file);
    std::fclose(file);
}

void render() {
    if (state.instances.empty()) return;
    PeerFrame frame;
    frame.instances.swap(state.instances);
    frame.width = uint32_t(program.width);
    frame.height = uint32_t(program.height);
    for (int k = 0; k < 2; ++k) frame.slope[k] = float(1 / state.projection[k][k]);
    for (const Light& light : state.lights)
        if (light.on && state.shadows) frame.lights.push_back(light.position);
    for (const RTuint shader : state.used) frame.lights.push_back(state.shaders[shader]);
    state.used.clear();
    std::vector<uint8_t> seen;
    if (!program.output.empty()) {
        seen.resize(std::size_t(frame.width) * frame.height);
        frame.seen = seen.data();
    }
    state.rays.add(peer->render(frame));
    if (frame.seen) writeSeen(seen, frame.width, frame.height);
}

void report() {
    const auto each = [](double sum) { return sum / std::max(program.done, 1); };
    std::printf(
        "embree: %.3f ms committing, %.3f ms tracing; rays: %.0f primary, %.0f shadow, "
        "%.0f reflected; %.0f hits\n",
        1e3 * each(peer->committing()), 1e3 * each(peer->tracing()),
        each(double(state.rays.primary)), each(double(state.rays.shadow)),
        each(double(state.rays.reflected)), each(double(state.rays.hits)));
}

} // namespace

extern "C" {

void rtutInitWindowSize(int width, int height) {
    if (program.hasSize) return;
    program.width = width;
    program.height = height;
}
void rtutInit(int* argc, char** argv) {
    int kept = 1;
    for (int i = 1; i < *argc; ++i) {
        const std::string option = argv[i], value = i + 1 < *argc ? argv[i + 1] : "";
        if (option == "--rt-offscreen") {
            program.frames = std::atoi(value.c_str());
        } else if (option == "--rt-size") {
            program.hasSize =
                std::sscanf(value.c_str(), "%dx%d", &program.width, &program.height) == 2;
        } else if (option == "--rt-output") {
            program.output = value;
        } else if (option == "--embree") {
            if (value != "refit" && value != "low" && value != "medium")
                refuse("--embree takes refit, low or medium");
            program.way = value == "refit" ? PeerWay::Refit
                          : value == "low" ? PeerWay::Low
                                           : PeerWay::Medium;
        } else {
            argv[kept++] = argv[i];
            continue;
        }
        ++i;
    }
    *argc = kept;
    argv[kept] = nullptr;
    const char* const threads = std::getenv("OPENRT_THREADS");
    const unsigned count =
        threads ? unsigned(std::atoi(threads)) : std::thread::hardware_concurrency();
    peer = std::make_unique<EmbreeFrames>(program.way, std::max(count, 1u));
}
void rtutInitDisplayMode(unsigned) {}
int rtutCreateWindow(const char*) {
    return 1;
}
void rtutDisplayFunc(void (*callback)(void)) {
    program.display = callback;
}
void rtutReshapeFunc(void (*callback)(int, int)) {
    program.reshape = callback;
}
void rtutIdleFunc(void (*callback)(void)) {
    program.idle = callback;
}
void rtutPostRedisplay(void) {}
int rtutGet(RTenum query) {
    if (query != RTUT_ELAPSED_TIME) refuse("another value of rtutGet");
    return kMillisecondsOfFrame * program.done;
}
void rtutSwapBuffers(void) {
    render();
}
void rtutMainLoop(void) {
    program.reshape(program.width, program.height);
    for (; program.done < program.frames; ++program.done) {
        if (program.idle) program.idle();
        program.display();
    }
    report();
    std::exit(0);
}
void rtutSolidSphere(RTdouble radius, RTint slices, RTint stacks) {
    for (int stack = 0; stack < stacks; ++stack) {
        rtBegin(RT_QUAD_STRIP);
        for (int slice = 0; slice <= slices; ++slice) {
            for (const int row : {stack, stack + 1}) {
                const double down = M_PI * row / stacks, around = 2 * M_PI * slice / slices;
                vertex(radius * std::sin(down) * std::cos(around),
                       radius * std::sin(down) * std::sin(around), radius * std::cos(down));
            }
        }
        rtEnd();
    }
}

// Contexts and scenes: the samples describe one after the other, and each is rendered at once.
RTcontext rtCreateContext(void) {
    return reinterpret_cast<RTcontext>(&state);
}
RTcontext rtGetCurrentContext(void) {
    return reinterpret_cast<RTcontext>(&state);
}
RTboolean rtMakeCurrent(RTcontext) {
    return RT_TRUE;
}
RTuint rtGenScene(void) {
    return ++state.newest;
}
void rtBindScene(RTuint) {}
void rtFrameDepth(RTuint) {}
void rtSetFrameBuffer(RTubyte*, RTuint width, RTuint height, RTuint) {
    program.width = int(width);
    program.height = int(height);
}
RTuint rtQueueFrame(void) {
    render();
    return ++state.newest;
}
RTboolean rtWaitFrame(RTuint) {
    return RT_TRUE;
}
void rtExit(void) {}
RTenum rtGetError(void) {
    return RT_NO_ERROR;
}
const char* rtGetErrorText(void) {
    return "";
}

// Matrices.
void rtMatrixMode(RTenum mode) {
    state.mode = mode;
}
void rtLoadIdentity(void) {
    current() = glm::dmat4(1);
}
void rtPushMatrix(void) {
    state.pushed.push_back(current());
}
void rtPopMatrix(void) {
    current() = state.pushed.back();
    state.pushed.pop_back();
}
void rtMultMatrixf(const RTfloat* m) {
    multiply(glm::dmat4(glm::make_mat4(m)));
}
void rtTranslated(RTdouble x, RTdouble y, RTdouble z) {
    multiply(glm::translate(glm::dmat4(1), glm::dvec3(x, y, z)));
}
void rtScaled(RTdouble x, RTdouble y, RTdouble z) {
    multiply(glm::scale(glm::dmat4(1), glm::dvec3(x, y, z)));
}
void rtRotated(RTdouble angle, RTdouble x, RTdouble y, RTdouble z) {
    multiply(glm::rotate(glm::dmat4(1), glm::radians(angle), glm::dvec3(x, y, z)));
}
void rtRotatef(RTfloat angle, RTfloat x, RTfloat y, RTfloat z) {
    rtRotated(double(angle), double(x), double(y), double(z));
}
void rtPerspective(RTdouble fov, RTdouble aspect, RTdouble near, RTdouble far) {
    multiply(glm::perspective(glm::radians(fov), aspect, near, far));
}
void rtLookAt(RTdouble ex, RTdouble ey, RTdouble ez, RTdouble cx, RTdouble cy, RTdouble cz,
              RTdouble ux, RTdouble uy, RTdouble uz) {
    multiply(glm::lookAt(glm::dvec3(ex, ey, ez), glm::dvec3(cx, cy, cz), glm::dvec3(ux, uy, uz)));
}
void rtViewport(RTint, RTint, RTsizei width, RTsizei height) {
    program.width = int(width);
    program.height = int(height);
}

// Objects.
RTuint rtNewObject(RTenum) {
    rtReplaceObject(++state.newest);
    state.definition->replaces = false;
    return state.newest;
}
void rtReplaceObject(RTuint object) {
    state.definition = std::make_unique<Definition>();
    state.definition->id = object;
    state.definition->replaces = true;
    state.pushed.push_back(state.modelView);
    state.modelView = glm::dmat4(1);
}
void rtEndObject(void) {
    const Definition& d = *state.definition;
    if (d.replaces)
        peer->redefine(d.id, d.points, d.corners);
    else
        peer->define(d.id, d.points, d.corners, !state.fastest, d.reflects);
    state.definition.reset();
    state.modelView = state.pushed.back();
    state.pushed.pop_back();
}
void rtUpdateObject(RTuint object, RTuint first, RTsizei count, const RTfloat* positions) {
    peer->move(object, first, {positions, 3 * std::size_t(count)});
}
void rtRemoveObject(RTuint object) {
    peer->remove(object);
}
void rtObjectHint(RTenum hint, RTenum value) {
    if (hint == RT_BUILD_QUALITY) state.fastest = value == RT_FASTEST;
}
void rtInstantiateObject(RTuint object) {
    PeerFrame::Instance instance;
    instance.object = object;
    instance.identity = state.modelView == glm::dmat4(1);
    instance.lit = state.lit || !state.used.empty();
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row)
            instance.toEye[std::size_t(3 * column + row)] = float(state.modelView[column][row]);
    state.instances.push_back(instance);
}
void rtBegin(RTenum mode) {
    state.primitive = mode;
    state.first = uint32_t(state.definition->points.size() / 3);
}
void rtEnd(void) {
    endPrimitive();
}
void rtVertex3f(RTfloat x, RTfloat y, RTfloat z) {
    vertex(double(x), double(y), double(z));
}
void rtVertex3d(RTdouble x, RTdouble y, RTdouble z) {
    vertex(x, y, z);
}
void rtVertex3fv(const RTfloat* v) {
    vertex(double(v[0]), double(v[1]), double(v[2]));
}

// Lights.
void rtEnable(RTenum what) {
    if (what == RT_LIGHTING) state.lit = true;
    if (what == RT_SHADOWS) state.shadows = true;
    if (what >= RT_LIGHT0 && what < RT_LIGHT0 + kLights) state.lights[what - RT_LIGHT0].on = true;
}
void rtDisable(RTenum what) {
    if (what == RT_LIGHTING) state.lit = false;
    if (what == RT_SHADOWS) state.shadows = false;
    if (what >= RT_LIGHT0 && what < RT_LIGHT0 + kLights) state.lights[what - RT_LIGHT0].on = false;
}
void rtLightfv(RTenum light, RTenum what, const RTfloat* v) {
    if (what != RT_POSITION) return;
    const glm::dvec4 eye = state.modelView * glm::dvec4(v[0], v[1], v[2], v[3]);
    for (int k = 0; k < 4; ++k)
        state.lights[light - RT_LIGHT0].position[std::size_t(k)] = float(eye[k]);
}
RTuint rtGenNewShaderClass(const char*, const char*) {
    return ++state.newest;
}
RTuint rtGenNewShader(void) {
    return state.shader = ++state.newest;
}
RTuint rtParameterHandle(const char* name) {
    return std::string(name) == "position" ? 1 : 2;
}
void rtParameter3f(RTuint handle, RTfloat x, RTfloat y, RTfloat z) {
    if (handle == 1) state.shaders[state.shader] = {x, y, z, 1};
}
void rtUseLight(RTuint shader) {
    state.used.push_back(shader);
}
void rtMaterialf(RTenum, RTenum what, RTfloat value) {
    if (what == RT_REFLECTION && state.definition) state.definition->reflects = value > 0;
}

// What is shading only.
void rtParameter1f(RTuint, RTfloat) {}
void rtBindShader(RTuint) {}
void rtMaterialfv(RTenum, RTenum, const RTfloat*) {}
void rtLightf(RTenum, RTenum, RTfloat) {}
void rtLightModelfv(RTenum, const RTfloat*) {}
void rtFogf(RTenum, RTfloat) {}
void rtFogi(RTenum, RTint) {}
void rtFogfv(RTenum, const RTfloat*) {}
void rtClear(RTbitfield) {}
void rtClearColor(RTclampf, RTclampf, RTclampf, RTclampf) {}
void rtColor3f(RTfloat, RTfloat, RTfloat) {}
void rtColor3d(RTdouble, RTdouble, RTdouble) {}
void rtColor3fv(const RTfloat*) {}
void rtNormal3f(RTfloat, RTfloat, RTfloat) {}
void rtNormal3d(RTdouble, RTdouble, RTdouble) {}
void rtNormal3fv(const RTfloat*) {}
void rtWindowPos2i(RTint, RTint) {}
void rtDrawPixels(RTsizei, RTsizei, RTenum, RTenum, const RTvoid*) {}

} // extern "C"

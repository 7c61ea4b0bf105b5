// SPDX-License-Identifier: MIT
#include "tests/calls/observation.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <set>

#include "tests/calls/values.h"

namespace openrt::test {
namespace {

constexpr RTuint kNames = 8; // ids up to here are looked at

std::string inHex(const char* what, RTenum token) {
    char text[64];
    std::snprintf(text, sizeof text, "%s 0x%X", what, token);
    return text;
}

/// Times, and the most that memory has been: they tell of calls without effect too.
const std::set<RTenum> kPassing = {RT_STAT_BUILD_MICROSECONDS, RT_STAT_BUSY_MICROSECONDS,
                                   RT_STAT_IDLE_MICROSECONDS, RT_STAT_PEAK_BYTES};

void clearErrors() {
    while (rtGetError() != RT_NO_ERROR) {
    }
}

/// The tokens that rtGetDoublev answers.
const std::vector<RTenum>& stateTokens() {
    static const std::vector<RTenum> tokens = [] {
        std::vector<RTenum> answered;
        double values[512];
        for (const RTenum token : apiTokens()) {
            clearErrors();
            rtGetDoublev(token, values);
            if (rtGetError() == RT_NO_ERROR && !kPassing.contains(token)) answered.push_back(token);
        }
        return answered;
    }();
    return tokens;
}

bool same(double a, double b) {
    return a == b || (std::isnan(a) && std::isnan(b));
}

} // namespace

void Observation::add(std::string name, const double* values, std::size_t count) {
    entries_.push_back({std::move(name), std::vector<double>(values, values + count)});
}

void Observation::addState() {
    for (const RTenum token : stateTokens()) {
        double values[512] = {};
        rtGetDoublev(token, values);
        std::size_t count = 512;
        while (count > 1 && values[count - 1] == 0) --count;
        add(inHex("state", token), values, count);
    }
    for (const RTenum token :
         {RT_VERTEX_ARRAY_POINTER, RT_NORMAL_ARRAY_POINTER, RT_COLOR_ARRAY_POINTER,
          RT_TEXTURE_COORD_ARRAY_POINTER, RT_EDGE_FLAG_ARRAY_POINTER, RT_INDEX_ARRAY_POINTER,
          RT_FEEDBACK_BUFFER_POINTER, RT_SELECTION_BUFFER_POINTER}) {
        void* pointer = nullptr;
        rtGetPointerv(RTenum(token), &pointer);
        const double address = double(reinterpret_cast<uintptr_t>(pointer));
        add(inHex("pointer", RTenum(token)), &address, 1);
    }
}

void Observation::addFixedFunction() {
    RTfloat values[16];
    const auto keep = [&](const char* what, RTenum of, RTenum token, auto get) {
        std::fill(std::begin(values), std::end(values), 0.0f);
        get(of, token, values);
        double wide[16];
        std::copy(std::begin(values), std::end(values), wide);
        add(inHex(what, of) + inHex(",", token), wide, 16);
    };
    for (RTenum light = RT_LIGHT0; light < RT_LIGHT0 + 8; ++light)
        for (RTenum token = RT_AMBIENT; token <= RT_QUADRATIC_ATTENUATION; ++token)
            keep("light", light, token, rtGetLightfv);
    for (const RTenum face : {RT_FRONT, RT_BACK})
        for (const RTenum token :
             {RT_AMBIENT, RT_DIFFUSE, RT_SPECULAR, RT_EMISSION, RT_SHININESS, RT_REFLECTION})
            keep("material", RTenum(face), RTenum(token), rtGetMaterialfv);
    for (const RTenum token : {RT_TEXTURE_ENV_MODE, RT_TEXTURE_ENV_COLOR, RT_COMBINE_RGB,
                               RT_COMBINE_ALPHA, RT_RGB_SCALE, RT_ALPHA_SCALE})
        keep("texture environment", RT_TEXTURE_ENV, RTenum(token), rtGetTexEnvfv);
    for (const RTenum axis : {RT_S, RT_T, RT_R, RT_Q})
        for (const RTenum token : {RT_TEXTURE_GEN_MODE, RT_OBJECT_PLANE, RT_EYE_PLANE})
            keep("texture generation", RTenum(axis), RTenum(token), rtGetTexGenfv);
    for (RTenum plane = RT_CLIP_PLANE0; plane < RT_CLIP_PLANE0 + 6; ++plane) {
        double equation[4] = {};
        rtGetClipPlane(plane, equation);
        add(inHex("plane", plane), equation, 4);
    }
    RTubyte stipple[128] = {};
    double sum = 0;
    rtGetPolygonStipple(stipple);
    for (int i = 0; i < 128; ++i) sum += (i + 1) * stipple[i];
    add("polygon stipple", &sum, 1);
}

void Observation::addTextures() {
    for (const RTenum target : {RT_TEXTURE_1D, RT_TEXTURE_2D}) {
        for (const RTenum token :
             {RT_TEXTURE_MIN_FILTER, RT_TEXTURE_MAG_FILTER, RT_TEXTURE_WRAP_S, RT_TEXTURE_WRAP_T,
              RT_TEXTURE_MAX_LEVEL, RT_TEXTURE_BASE_LEVEL, RT_GENERATE_MIPMAP}) {
            RTfloat value = 0;
            rtGetTexParameterfv(RTenum(target), RTenum(token), &value);
            const double wide = value;
            add(inHex("texture", RTenum(target)) + inHex(",", RTenum(token)), &wide, 1);
        }
        for (RTint level = 0; level < 3; ++level) {
            RTint sizes[3] = {};
            rtGetTexLevelParameteriv(RTenum(target), level, RT_TEXTURE_WIDTH, &sizes[0]);
            rtGetTexLevelParameteriv(RTenum(target), level, RT_TEXTURE_HEIGHT, &sizes[1]);
            rtGetTexLevelParameteriv(RTenum(target), level, RT_TEXTURE_INTERNAL_FORMAT, &sizes[2]);
            const double wide[3] = {double(sizes[0]), double(sizes[1]), double(sizes[2])};
            add(inHex("image", RTenum(target)), wide, 3);
        }
    }
}

void Observation::addNames() {
    for (RTuint id = 1; id <= kNames; ++id) {
        RTint shaders[20] = {};
        rtGetObjectiv(id, RT_OBJECT_SHADER_COUNT, shaders);
        const bool object = rtGetError() == RT_NO_ERROR;
        if (object && shaders[0] < 16) rtGetObjectiv(id, RT_OBJECT_SHADERS, shaders + 1);
        const double values[] = {double(rtIsList(id)),
                                 double(rtIsTexture(id)),
                                 double(rtIsBuffer(id)),
                                 double(object),
                                 double(shaders[0]),
                                 double(shaders[1]),
                                 double(rtGetShaderClassDescriptor(id) != nullptr)};
        clearErrors();
        add("name " + std::to_string(id), values, std::size(values));
    }
}

void Observation::addScene() {
    constexpr int kRays = 36;
    RTray rays[kRays] = {};
    RThit hits[kRays];
    for (int i = 0; i < kRays; ++i) {
        rays[i] = {{float(i % 6) / 3 - 0.8f, float(i / 6) / 3 - 0.8f, 5}, 0, {0, 0, -1}, 1000};
        hits[i] = {};
    }
    const RTuint scene = rtCompileScene();
    rtIntersect(scene, rays, hits, kRays, RT_INCOHERENT);
    rtReleaseScene(scene);
    clearErrors();
    for (int i = 0; i < kRays; ++i) {
        const double values[] = {hits[i].t, double(hits[i].primitive), double(hits[i].object),
                                 double(hits[i].instance)};
        add("ray " + std::to_string(i), values, 4);
    }
}

Observation Observation::now() {
    Observation seen;
    clearErrors();
    seen.addState();
    seen.addFixedFunction();
    seen.addTextures();
    seen.addNames();
    clearErrors();
    seen.addScene();
    double sum = 0;
    for (unsigned i = 0; i < sizeof framePixels; ++i) sum += double(i % 251 + 1) * framePixels[i];
    seen.add("frame buffer", &sum, 1);
    return seen;
}

std::string Observation::differences(const Observation& other) const {
    std::string text;
    int told = 0;
    if (entries_.size() != other.entries_.size()) return "other things can be asked for";
    for (std::size_t i = 0; i < entries_.size() && told < 4; ++i) {
        const std::vector<double>&a = entries_[i].values, &b = other.entries_[i].values;
        if (a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), same)) continue;
        text += (told++ ? "; " : "") + entries_[i].name;
    }
    return text;
}

} // namespace openrt::test

// SPDX-License-Identifier: MIT
// Arguments for any function of the library: for each kind of parameter the values that are worth
// trying, all of which keep the promises that a caller has to keep (memory is as large as said).
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "openrt/rt.h"
#include "openrt/rts.h"
#include "openrt/rtu.h"

namespace openrt::test {

enum class Kind {
    Token,
    Bits,
    Number,
    Integer,
    Id,
    Count,
    Size,
    Samples,
    Threads,
    Depth,
    Recursion,
    Side,
    Stride, // numbers
    Floats,
    Doubles,
    Ints,
    Ids,
    Counts,
    Image,
    Indices,
    Pointers,
    Out, // memory
    Text,
    FileName,
    Rays,
    RayStream,
    HitStream,
    Descriptor,
    Context,
    Quadric,
    Tess,
    Nurbs,
    ErrorCallback,
    FrameCallback,
    Function,
    ToolkitToken, // of librtut, from here
    Pixels,
    Font,
    Callback,
    DisplayString,
    ArgumentCount,
    Arguments,
    kCount
};

/// What prepareContext() makes anew each time.
enum class Made { Nothing, Scene, Context, Quadric, Tess };

/// An argument of any type.
struct Value {
    int64_t i = 0;
    double d = 0;
    const void* p = nullptr;
    Made made = Made::Nothing;

    static Value of(int64_t number) { return {number, double(number), nullptr, Made::Nothing}; }
    static Value of(int number) { return of(int64_t(number)); }
    static Value of(double number) { return {0, number, nullptr, Made::Nothing}; }
    static Value of(std::nullptr_t) { return {}; }
    static Value of(const void* memory) { return {0, 0, memory, Made::Nothing}; }
    static Value of(Made what) { return {0, 0, nullptr, what}; }

    template <class T>
    T to() const {
        if (made == Made::Scene) return T(compiledScene());
        if constexpr (std::is_floating_point_v<T>)
            return T(d);
        else
            return T(i);
    }
    template <class T>
    T as() const {
        return reinterpret_cast<T>(reinterpret_cast<uintptr_t>(pointer()));
    }

private:
    const void* pointer() const;
    static RTuint compiledScene();
};

/// Never empty; the first value of a kind is one that can be legal.
const std::vector<Value>& valuesOf(Kind kind);
inline Value first(Kind kind) {
    return valuesOf(kind).front();
}

struct ApiParameter {
    const char* name;
    Kind kind;
    Value legal;
};
struct ApiFunction {
    const char* name;
    void (*call)(const Value* arguments);
    std::vector<ApiParameter> parameters;
    bool isLeftOut = false; ///< by its header: does nothing but to tell so
};

/// All of the library's functions; generate_calls.py writes the table.
const std::vector<ApiFunction>& apiFunctions();
/// All of its tokens, and those of librtut.
const std::vector<RTenum>& apiTokens();
const std::vector<RTenum>& toolkitTokens();

inline constexpr unsigned kSide = 16;
/// The frame buffer of prepareContext(), RT_RGBA_8; large enough for all sizes and strides.
inline constexpr unsigned kFrameBytes = 1 << 16;
extern unsigned char framePixels[kFrameBytes];

/// What the first values and the legal arguments refer to: class, surface, light, camera and
/// environment shader 1 to 4, object, texture, list and buffer 1, a compiled scene, a frame buffer.
/// In the current context, which is new.
void prepareContext();
/// Frees what is beside the context.
void forgetContext();

/// How often the library called back since the start.
extern unsigned callbacks;

extern "C" {
extern char* startNames[];
int* startArguments(const Value& any);
void errorCallback(RTenum code, const char* function, const char* text, void* user);
void frameCallback(RTuint frame, RTenum event, RTint x, RTint y, RTsizei w, RTsizei h, void* user);
void callBack(void); // in C: called with whatever arguments a callback has
}

/// What becomes of results: what a call has made beside its context is freed.
inline void given(RTuint) {}
inline void given(RTint) {}
inline void given(RTfloat) {}
inline void given(RTboolean) {}
inline void given(const void*) {}
inline void given(void*) {}
inline void given(RTcontext context) {
    rtDestroyContext(context);
}
inline void given(RTUquadric* quadric) {
    rtuDeleteQuadric(quadric);
}
inline void given(RTUtesselator* tess) {
    rtuDeleteTess(tess);
}
inline void given(RTUnurbs* nurbs) {
    rtuDeleteNurbsRenderer(nurbs);
}

} // namespace openrt::test

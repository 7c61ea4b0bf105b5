// SPDX-License-Identifier: MIT
// A shader library with one fault, which FAULT names, in what it shows. Its static constructor
// leaves a trace: no code of a library may run that is refused for what its file says.
#include <openrt/rts_plugin_format.h>

#include <cstdlib>
#include <cstring>
#include <exception>
#include <stdexcept>

#define FAULT_kMagic 1
#define FAULT_kVersion 2
#define FAULT_kRevision 3
#define FAULT_kSize 4
#define FAULT_kNoSymbol 5
#define FAULT_kFunction 6
#define FAULT_kUnresolved 7
#define FAULT_kReversed 8
#define FAULT_kNoFirst 9
#define FAULT_kEmpty 10
#define FAULT_kNullEntry 11
#define FAULT_kSmallEntry 12
#define FAULT_kNothingBehind 13
#define FAULT_kNameless 14
#define FAULT_kTwins 15
#define FAULT_kDescribeFails 16
#define FAULT_kDescribeFailsWordily 17
#define FAULT_kDescribeThrows 18
#define FAULT_kConstructFails 19
#define FAULT_kConstructThrows 20
#define FAULT_kClassVersion 21
#define FAULT_kClassTooSmall 22
#define FAULT_kHuge 23
#define FAULT_kShadeThrows 24
#define FAULT_kNone 25
#define IS(name) (FAULT == FAULT_##name)

namespace {

const struct Trace {
    Trace() { setenv("OPENRT_TEST_CODE_RAN", "1", 1); }
} trace;

int construct(void*, void*, void*) {
    if (IS(kConstructThrows)) throw 42;
    return IS(kConstructFails) ? 1 : 0;
}
struct LocalError : std::exception {
    const char* what() const noexcept override { return "words of the library"; }
};
int shade(const void*, RTSstate* state) {
    if (IS(kShadeThrows)) throw LocalError();
    rtsResultColor(state, 0.5f, 0.5f, 0.5f);
    return 0;
}

RTshaderclass makeClass() {
    RTshaderclass c = {};
    c.structSize = IS(kClassTooSmall) ? 16 : sizeof c;
    c.interfaceVersion = IS(kClassVersion) ? 99 : RTS_INTERFACE_VERSION;
    c.kind = RT_SURFACE_SHADER;
    c.name = IS(kNameless) ? "" : "Faulty";
    c.alignment = 1;
    c.construct = construct;
    c.shade = shade;
    return c;
}
const RTshaderclass shaderClass = makeClass();

const RTshaderclass* describe(const RTSpluginclass*, char* reason, RTuint size) {
    if (IS(kDescribeThrows)) throw std::runtime_error("describe lost its words");
    if (IS(kDescribeFailsWordily)) std::memset(reason, 'w', size); // and no zero at the end
    return nullptr;
}

constexpr bool kDescribed = IS(kDescribeFails) || IS(kDescribeFailsWordily) || IS(kDescribeThrows);
const RTSpluginclass entry = {
    IS(kSmallEntry) ? 8u : RTuint(sizeof(RTSpluginclass)),
    IS(kNameless) ? nullptr : "Faulty",
    kDescribed || IS(kNothingBehind) ? nullptr : &shaderClass,
    kDescribed ? describe : nullptr,
};
[[maybe_unused]] const RTSpluginclass* const list[2] = {IS(kNullEntry) ? nullptr : &entry, &entry};

} // namespace

extern "C" {

#if IS(kUnresolved)
void isDefinedNowhere();
void (*volatile called)() = isDefinedNowhere;
#endif

#if IS(kFunction)
__attribute__((visibility("default"))) void rtsPlugin() {}
#elif !IS(kNoSymbol)
__attribute__((visibility("default"))) extern const RTSplugin rtsPlugin;
const RTSplugin rtsPlugin = {
    {'O', 'p', 'e', 'n', IS(kMagic) ? 'X' : 'R', 'T', 'S', 0},
    IS(kSize) ? 24u : RTuint(sizeof(RTSplugin)),
    IS(kVersion) ? 77u : RTS_INTERFACE_VERSION,
    IS(kRevision) ? RTS_INTERFACE_REVISION + 1u : RTS_INTERFACE_REVISION,
    sizeof(RTshaderclass),
    IS(kNoFirst) ? nullptr : IS(kReversed) ? list + 1 : list,
    IS(kReversed) || IS(kEmpty) ? list
    : IS(kTwins)                ? list + 2
    : IS(kHuge)                 ? list + 100000
                                : list + 1};
#endif
}

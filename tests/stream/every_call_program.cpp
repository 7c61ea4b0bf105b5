// SPDX-License-Identifier: MIT
// Calls every function of the interface once.
#include <cstring>
#include <string_view>

#include "compat/stream/utility_objects.h"
#include "openrt/rt.h"
#include "tests/stream/every_call.h"

using namespace smart::compat;

int main() {
    static EveryCallMemory memory;
    rtInit(nullptr, nullptr);
    const RTcontext context = rtGetCurrentContext();
    UtilityObjects made;
    const auto make = [&](const CallSignature& call) {
        CallValue arguments[kMaxParameters + 1], result;
        fillArguments(call, memory, arguments);
        invokeCall(call, arguments, result);
        if (call.resultMeaning == Meaning::Quadric) made.made(result.as<RTUquadric*>());
        if (call.resultMeaning == Meaning::Tessellator) made.made(result.as<RTUtesselator*>());
    };
    const auto isOfContexts = [](std::string_view name) {
        return name == "rtInit" || name == "rtExit" || name == "rtMakeCurrent";
    };
    for (const CallSignature& call : callTable())
        if (!isOfContexts(call.name)) make(call);
    rtMakeCurrent(context);
    for (const CallSignature& call : callTable())
        if (isOfContexts(call.name)) make(call);
    return 0;
}

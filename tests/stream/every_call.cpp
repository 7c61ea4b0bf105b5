// SPDX-License-Identifier: MIT
#include "tests/stream/every_call.h"

#include <cstring>

namespace smart::compat {

void fillArguments(const CallSignature& call, EveryCallMemory& memory, CallValue* arguments) {
    memory.fill();
    const std::span<const CallParameter> parameters = parametersOf(call);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const CallParameter& p = parameters[i];
        const auto number = int64_t(i) % 3 + 1;
        if (p.meaning == Meaning::Token) {
            arguments[i] = CallValue(RTenum(0x7F00 + number)); // of nothing
        } else if (p.meaning >= Meaning::Object || p.memory == Memory::Callback) {
            arguments[i] = CallValue(uint64_t(0));
        } else if (p.kind == ValueKind::Float) {
            arguments[i] = CallValue(float(number) / 4);
        } else if (p.kind == ValueKind::Double) {
            arguments[i] = CallValue(double(number) / 4);
        } else if (p.kind == ValueKind::Pointer) {
            arguments[i] = CallValue(p.memory == Memory::ShaderDescriptor ||
                                             p.memory == Memory::Rays || p.memory == Memory::Hits ||
                                             p.memory == Memory::ManyIndices ||
                                             p.memory == Memory::Arguments ||
                                             std::strcmp(call.name, "rtInit") == 0
                                         ? static_cast<void*>(memory.zeros)
                                         : static_cast<void*>(memory.small[i % 4]));
        } else {
            arguments[i] = CallValue(number);
        }
    }
}

} // namespace smart::compat

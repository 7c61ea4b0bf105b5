// SPDX-License-Identifier: MIT
// Programs of up to 64 calls, as api_program.h has them. Every function of the headers takes part.
#include "tests/fuzz/api_program.h"

namespace openrt::test {
namespace {

void run(Input& input) {
    rtInit(nullptr, nullptr);
    prepareContext();
    for (int i = 0; i < kMaxCalls && !input.atEnd(); ++i) {
        const ApiFunction& function = functionOf(input.word());
        Value arguments[24];
        int count = 0;
        for (const ApiParameter& parameter : function.parameters)
            arguments[count++] = argumentOf(parameter, input.byte(), input);
        function.call(arguments);
    }
    forgetContext();
    rtExit();
}

} // namespace
} // namespace openrt::test

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
    openrt::test::Input input(data, size);
    openrt::test::run(input);
    return 0;
}

// SPDX-License-Identifier: MIT
// Recordings of calls, as openrt-trace and the processes of a cluster play them. An input is a
// stream as it lies in a file where its first byte is 255, otherwise what ForgedStream makes of it.
#include <vector>

#include "compat/stream/call_player.h"
#include "openrt/rt.h"
#include "tests/fuzz/forged_stream.h"

namespace openrt::test {
namespace {

constexpr smart::compat::PlayLimits kSmall{uint64_t(64) << 20, 1 << 12, 4, 4};

void play(std::span<const std::byte> stream) {
    {
        smart::compat::CallPlayer player(nullptr, kSmall);
        try {
            player.play(stream);
            player.finish();
        } catch (const smart::compat::StreamError&) { // a refusal
        }
    }
    rtExit();
}

void run(Input& input) {
    if (input.left() > 0 && *input.rest() == 255) {
        (void)input.byte();
        const std::span stream(reinterpret_cast<const std::byte*>(input.rest()), input.left());
        return play(stream.first(smart::compat::bytesOfWholeRecords(stream)));
    }
    play(ForgedStream(input).bytes());
}

} // namespace
} // namespace openrt::test

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
    openrt::test::Input input(data, size);
    openrt::test::run(input);
    return 0;
}

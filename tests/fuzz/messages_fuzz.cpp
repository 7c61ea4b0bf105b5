// SPDX-License-Identifier: MIT
// What a peer of bad will or a bad line may send to processes that render together: to the parser,
// to the master or to a worker, as the input's first byte says. The frames of the master have to be
// complete whatever comes, and a worker has to end with its master.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <list>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "compat/mpi/lz4_codec.h"
#include "libsmart/base/error.h"
#include "libsmart/remote/frame_fingerprint.h"
#include "libsmart/remote/remote_service.h"
#include "libsmart/remote/remote_workers.h"
#include "tests/fuzz/forged_transport.h"
#include "tests/libsmart/remote/shared_renderer.h"

namespace openrt::test {
namespace {

using namespace smart;
using smart::test::FakeTracer;
using smart::test::FrameCall;
using smart::test::SharedRenderer;
using smart::test::TestFrame;

const compat::Lz4Codec kCodec;

constexpr uint64_t kFrames = 3;

void require(bool promise) {
    if (!promise) std::abort();
}

/// What is taken for a message is one: it is written the same again.
void parse(std::span<const std::byte> bytes) {
    const Parsed parsed = parseMessage(bytes);
    if (bytes.size() >= kHeaderSize) (void)messageLength(bytes.first<kHeaderSize>());
    if (parsed.problem) return;
    const Packet again = encode(parsed.message);
    require(std::equal(again->begin(), again->end(), bytes.begin(), bytes.end()));
}

void parseAny(std::span<const std::byte> bytes) {
    require(*framed(5, bytes) == *encode(CallBytes{bytes})); // or nothing below is parsed
    parse(bytes);
    if (bytes.empty()) return;
    const Packet packet = framed(uint16_t(bytes[0]) % 12, bytes.subspan(1));
    parse(*packet);
    CallAssembler calls;
    std::vector<std::byte> record;
    try {
        for (std::size_t at = 1; at < bytes.size(); at += std::size_t(bytes[0]) + 1) {
            calls.add(bytes.subspan(at, std::min(bytes.size() - at, std::size_t(bytes[0]) + 1)));
            while (calls.take(record)) require(record.size() <= bytes.size());
        }
    } catch (const Error&) { // a length that can not be
    }
}

std::vector<uint64_t> fingerprints() {
    std::vector<uint64_t> all;
    for (uint64_t id = 1; id <= kFrames; ++id)
        all.push_back(frameFingerprint(
            *TestFrame(id, ForgedTransport::kWidth, ForgedTransport::kHeight).frame));
    return all;
}

void master(Input& input) {
    ForgedTransport peers(input, 2, fingerprints());
    RemoteOptions options;
    options.codec = &kCodec;
    options.identity = ForgedTransport::kIdentity;
    options.stallAfter = std::chrono::milliseconds(20);
    options.deafAfter = std::chrono::milliseconds(20);
    // Slow enough that others get tiles.
    const FakeTracer tracer([](const Frame&, const Tile&) {
        std::this_thread::sleep_for(std::chrono::microseconds(100));
    });
    std::list<TestFrame> frames;
    RemoteWorkers workers(peers, options, [](const std::string&) {});
    SharedRenderer renderer(workers, 1, 1, tracer);
    for (uint64_t id = 1; id <= kFrames; ++id) {
        const FrameCall call{id, ForgedTransport::kWidth, ForgedTransport::kHeight, 0, 0};
        workers.addCall(std::as_bytes(std::span(&call, 1)));
        workers.flushCalls();
        const QueuedFramePtr queued = renderer.submit(
            frames.emplace_back(id, ForgedTransport::kWidth, ForgedTransport::kHeight));
        require(queued->wait() == FrameStatus::Done);
    }
    workers.leave();
}

/// Makes the calls of one frame each. False: there is no such call.
bool serveCall(std::span<const std::byte> record, SharedRenderer& renderer,
               std::list<TestFrame>& frames) {
    FrameCall call;
    if (record.size() != sizeof call) return false;
    std::memcpy(&call, record.data(), sizeof call);
    TestFrame& frame =
        frames.emplace_back(call.id, ForgedTransport::kWidth, ForgedTransport::kHeight);
    const QueuedFramePtr queued = renderer.submit(frame);
    if (call.picture == 0) return true;
    queued->wait();
    renderer.participation().sharePicture(frame.frame->target);
    return true;
}

void worker(Input& input) {
    ForgedTransport masters(input, 1, fingerprints());
    std::list<TestFrame> frames;
    RemoteService service(masters, ForgedTransport::kIdentity, 2, &kCodec);
    {
        const FakeTracer tracer;
        SharedRenderer renderer(service, 1, 2, tracer);
        try {
            std::vector<std::byte> record;
            while (service.nextCall(record) && serveCall(record, renderer, frames)) {
            }
            service.giveUp("no such call");
        } catch (const Error& problem) {
            service.giveUp(problem.what());
        }
    }
    service.waitForLeave();
}

} // namespace
} // namespace openrt::test

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
    using namespace openrt::test;
    Input input(data, size);
    switch (input.byte() % 3) {
        case 0:
            parseAny({reinterpret_cast<const std::byte*>(input.rest()), input.left()});
            break;
        case 1:
            master(input);
            break;
        default:
            worker(input);
            break;
    }
    return 0;
}

// SPDX-License-Identifier: MIT
#include "tests/bench/remote_job.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "compat/mpi/lz4_codec.h"
#include "libsmart/remote/remote_service.h"
#include "libsmart/remote/wire.h"
#include "libsmart/render/stored_tile.h"

namespace smart::bench {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

const compat::Lz4Codec kCodec;

double since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

void work(int socket, const Tracer& tracer, const std::shared_ptr<const Frame>& frame,
          std::chrono::microseconds latency, Packing packing) {
    test::SocketTransport sockets({socket});
    test::DelayedTransport delayed(sockets, latency);
    RemoteService service(delayed, "bench", 1, &kCodec, packing);
    {
        test::SharedRenderer renderer(service, 1, 1, tracer);
        std::vector<std::byte> call;
        while (service.nextCall(call)) renderer.submit(frame);
    }
    service.waitForLeave();
}

} // namespace

RemoteJob::RemoteJob(unsigned workers, const Tracer& tracer, std::shared_ptr<const Frame> frame,
                     const RemoteLine& line, Packing packing)
    : frame_(std::move(frame)) {
    std::vector<int> sockets;
    for (unsigned i = 0; i < workers; ++i) {
        const test::SocketPair pair;
        sockets.push_back(pair.here);
        workers_.emplace_back([there = pair.there, &tracer, frame = frame_, line, packing] {
            work(there, tracer, frame, line.latency, packing);
        });
    }
    sockets_ = std::make_unique<test::SocketTransport>(sockets);
    delayed_ = std::make_unique<test::DelayedTransport>(*sockets_, line.latency,
                                                        line.bytesPerSecond);
    RemoteOptions options;
    options.identity = "bench";
    options.codec = &kCodec;
    options.stallAfter = 60s; // no tile twice: it would be measured
    remote_ = std::make_unique<RemoteWorkers>(*delayed_, options, [](const std::string&) {});
    if (!remote_->waitForPeers(30s)) throw std::runtime_error("workers do not start");
    renderer_ = std::make_unique<test::SharedRenderer>(*remote_, 1, 1, tracer);
}

RemoteJob::~RemoteJob() {
    renderer_.reset();
    remote_.reset();
    workers_.clear(); // before the sockets
}

QueuedFramePtr RemoteJob::submit() {
    const std::byte call{};
    remote_->addCall({&call, 1});
    return renderer_->submit(frame_);
}

double RemoteJob::secondsOfFrame(unsigned repeat) {
    std::vector<double> seconds;
    for (unsigned i = 0; i <= repeat; ++i) {
        const Clock::time_point start = Clock::now();
        submit()->wait();
        if (i > 0) seconds.push_back(since(start));
    }
    std::sort(seconds.begin(), seconds.end());
    return seconds[seconds.size() / 2];
}

double RemoteJob::secondsOfQueue(unsigned frames) {
    submit()->wait();
    const Clock::time_point start = Clock::now();
    QueuedFramePtr last;
    for (unsigned i = 0; i < frames; ++i) last = submit();
    last->wait();
    return since(start) / frames;
}

double socketLatency(std::size_t bytes, unsigned repeat) {
    const test::SocketPair pair;
    test::SocketTransport here({pair.here});
    const std::vector<std::byte> payload(bytes);
    const Packet packet = encode(CallBytes{payload});
    std::jthread echo([&packet, there = pair.there] {
        test::SocketTransport transport({there});
        unsigned peer = 0;
        std::vector<std::byte> message;
        for (;;) {
            const Transport::Event event = transport.receive(100ms, peer, message);
            if (event == Transport::Event::Closed) return;
            if (event == Transport::Event::Arrived) transport.send(0, packet);
            if (message.size() == kHeaderSize) return; // Leave
        }
    });
    unsigned peer = 0;
    std::vector<std::byte> message;
    const Clock::time_point start = Clock::now();
    for (unsigned i = 0; i < repeat; ++i) {
        here.send(0, packet);
        while (here.receive(1s, peer, message) == Transport::Event::Nothing) {}
    }
    const double seconds = since(start) / (2.0 * repeat);
    here.send(0, encode(Leave{}));
    return seconds;
}

double servingSeconds(const Frame& frame, unsigned repeat) {
    const Tile tile{0, 0, std::min(kTileSize, frame.target.width),
                    std::min(kTileSize, frame.target.height)};
    std::vector<std::byte> pixels(storedTileSize(frame.target, tile));
    const Packet answer = encode(TileAnswer{1, 0, 0, 0, 0, 0, false, pixels});
    const Clock::time_point start = Clock::now();
    for (unsigned i = 0; i < repeat; ++i) {
        encode(TileRequest{1, {1, 1}, tile, frame.target.width, frame.target.height,
                           uint32_t(pixels.size()), true, 0});
        const Parsed parsed = parseMessage(*answer);
        placeTile(frame.target, tile, std::get<TileAnswer>(parsed.message).pixels.data());
    }
    return since(start) / repeat;
}

} // namespace smart::bench

// SPDX-License-Identifier: MIT
// remote_worker_process SOCKET MODE [SEED]: a worker at the other end of a socket. Modes: honest,
// packing (packs all tiles), lie (packs all, and damages what it sends, now and then), slow
// (microseconds a tile in place of the seed), other (has another library), diverge (gives up at its
// third call).
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <list>
#include <random>
#include <string>
#include <thread>

#include "compat/mpi/lz4_codec.h"
#include "libsmart/remote/remote_service.h"
#include "tests/libsmart/remote/shared_renderer.h"
#include "tests/support/socket_transport.h"

using namespace smart;
using namespace smart::test;

namespace {

/// Sends one message in so many wrong, in one of several ways.
class LyingTransport final : public Transport {
public:
    LyingTransport(Transport& inner, unsigned seed) : inner_(inner), random_(seed) {
        truths_ = 1 + random_() % 40;
    }
    unsigned peers() const override { return inner_.peers(); }
    std::string peerName(unsigned peer) const override { return inner_.peerName(peer); }
    Event receive(std::chrono::microseconds timeout, unsigned& peer,
                  std::vector<std::byte>& message) override {
        return inner_.receive(timeout, peer, message);
    }
    void flush(std::chrono::milliseconds timeout) override { inner_.flush(timeout); }
    void send(unsigned peer, Packet packet) override {
        const std::lock_guard lock(mutex_);
        if (truths_ > 0) {
            --truths_;
            return inner_.send(peer, std::move(packet));
        }
        inner_.send(peer, lie(*packet));
    }

private:
    /// In ways that no checksum finds out.
    Packet lieAbout(TileAnswer answer) {
        std::vector<std::byte> pixels(answer.pixels.begin(), answer.pixels.end());
        switch (random_() % 5) {
            case 0: pixels.resize(pixels.size() / 2); break;
            case 1: pixels.push_back(std::byte(random_())); break;
            case 2: answer.packed = !answer.packed; break;
            case 3: pixels.clear(); break;
            case 4: // many times what a tile has, in few bytes
                const std::vector<std::byte> zeros(900000);
                pixels.resize(zeros.size());
                pixels.resize(compat::Lz4Codec().pack(zeros, pixels));
                answer.packed = true;
                break;
        }
        answer.pixels = pixels;
        return encode(answer);
    }
    Packet lie(std::vector<std::byte> bytes) {
        const std::vector<std::byte> noise(random_() % 5000, std::byte(random_()));
        if (const Parsed said = parseMessage(bytes); random_() % 2 == 0)
            if (const auto* const answer = std::get_if<TileAnswer>(&said.message))
                return lieAbout(*answer);
        switch (random_() % 8) {
            case 0: return encode(TileAnswer{random_() % 100, 0, 0, 0, 0, 0, false, noise});
            case 1: return encode(TileAnswer{random_(), 1, 2, 3, 4, 5, false, {}});
            case 2: return encode(FrameReady{{random_() % 3, random_() % 9}, random_()});
            case 3: return encode(CallBytes{noise});
            case 4: return encode(Leave{});
            case 5: return std::make_shared<std::vector<std::byte>>(noise);
            case 6: bytes.resize(bytes.size() / 2); break;
            case 7: bytes[random_() % bytes.size()] ^= std::byte(1 + random_() % 255); break;
        }
        return std::make_shared<std::vector<std::byte>>(bytes);
    }
    Transport& inner_;
    std::mutex mutex_;
    std::mt19937 random_;
    unsigned truths_ = 0;
};

} // namespace

int main(int argc, char** argv) {
    if (argc < 3) return 2;
    const std::string mode = argv[2];
    const unsigned number = argc > 3 ? unsigned(std::atoi(argv[3])) : 0;
    SocketTransport sockets({std::atoi(argv[1])});
    LyingTransport lying(sockets, number);
    Transport& transport = mode == "lie" ? static_cast<Transport&>(lying) : sockets;
    const compat::Lz4Codec codec;
    RemoteService service(transport, mode == "other" ? "another" : "test", 2, &codec,
                          mode == "lie" || mode == "packing" ? Packing::Always
                                                             : Packing::WhenItPays);
    std::list<TestFrame> frames;
    {
        const FakeTracer tracer([&](const Frame&, const Tile&) {
            if (mode == "slow") std::this_thread::sleep_for(std::chrono::microseconds(number));
        });
        SharedRenderer renderer(service, 1, 2, tracer);
        std::vector<std::byte> record;
        while (service.nextCall(record)) {
            FrameCall call;
            if (record.size() != sizeof call) return 3;
            std::memcpy(&call, record.data(), sizeof call);
            if (mode == "diverge" && call.id == 3) {
                service.giveUp("no such plug-in here");
                break;
            }
            TestFrame& frame = frames.emplace_back(call.id, call.width, call.height);
            const QueuedFramePtr queued = renderer.submit(frame);
            if (call.picture == 0) continue;
            queued->wait();
            renderer.participation().sharePicture(frame.frame->target);
            // Tells by its end whether all pixels have come.
            if (!isComplete(frame)) return 4;
        }
    }
    service.waitForLeave();
    return 0;
}

// SPDX-License-Identifier: MIT
#include "libsmart/remote/remote_service.h"

#include <chrono>
#include <exception>
#include <utility>

#include "libsmart/base/error.h"
#include "libsmart/remote/frame_fingerprint.h"
#include "libsmart/remote/tile_server.h"
#include "libsmart/render/stored_tile.h"
#include "libsmart/render/worker.h"

namespace smart {
namespace {

using namespace std::chrono_literals;

constexpr uint64_t kTellAfter = 1u << 20; ///< bytes taken in until the master hears of it

[[noreturn]] void refuse(const char* reason) {
    throw Error(ErrorCode::InvalidOperation, reason);
}

} // namespace

RemoteService::RemoteService(Transport& transport, const std::string& identity, unsigned threads,
                             const ByteCodec* codec, Packing packing)
    : transport_(transport), threads_(threads), packer_(codec, packing, threads) {
    send(Hello{identity, threads});
    receiver_ = startWorkerThread("remote", [this] { receive(); });
}

RemoteService::~RemoteService() {
    stopped_ = true;
}

void RemoteService::send(const Message& message) {
    transport_.send(0, encode(message));
}

void RemoteService::count(std::size_t bytes) {
    taken_ += bytes;
    if (taken_ - told_ < kTellAfter) return;
    told_ = taken_;
    send(Progress{taken_});
}

bool RemoteService::nextCall(std::vector<std::byte>& record) {
    std::unique_lock lock(mutex_);
    for (;;) {
        if (ended_) return false;
        if (calls_.take(record)) break;
        news_.wait(lock);
    }
    count(sizeof(uint64_t) + record.size());
    return true;
}

void RemoteService::giveUp(const std::string& reason) noexcept {
    try {
        send(Trouble{reason});
    } catch (...) { // the master gives the tiles to others when they do not come
    }
    end();
}

void RemoteService::waitForLeave() {
    receiver_.join();
}

std::unique_ptr<Participation> RemoteService::join(FrameQueue& queue, uint64_t renderer) {
    return std::make_unique<TileServer>(*this, queue, renderer);
}

// A frame that is about to be queued. The master may have asked for none of its tiles and be done
// with it already.
void RemoteService::enter(uint64_t renderer, const QueuedFramePtr& frame, TileServer& server) {
    const uint64_t fingerprint = frameFingerprint(frame->frame());
    const std::lock_guard endLock(endMutex_);
    std::unique_lock lock(mutex_);
    const FrameKey key{renderer, ++lastFrame_[renderer]};
    const auto over = over_.extract(key);
    if (over || ended_) {
        lock.unlock();
        server.queue().endElsewhere(*frame, over && over.mapped());
        return;
    }
    frames_.emplace(key, KnownFrame{frame->sharedFrame(), frame, &server});
    send(FrameReady{key, fingerprint});
}

// Also waits until no queue is told of an end.
void RemoteService::leaveOut(const TileServer& server) {
    const std::lock_guard endLock(endMutex_);
    const std::lock_guard lock(mutex_);
    std::erase_if(frames_, [&](const auto& entry) { return entry.second.server == &server; });
}

void RemoteService::takePicture(uint64_t renderer, const PixelTarget& target) {
    std::vector<std::byte> bytes;
    {
        std::unique_lock lock(mutex_);
        const FrameKey key{renderer, ++lastPicture_[renderer]};
        const auto isWhole = [&] {
            const auto found = pictures_.find(key);
            return found != pictures_.end() && found->second.second;
        };
        news_.wait(lock, [&] { return ended_ || isWhole(); });
        if (!isWhole()) return;
        bytes = std::move(pictures_.extract(key).mapped().first);
        count(bytes.size());
    }
    const Tile whole{0, 0, target.width, target.height};
    if (bytes.size() != storedTileSize(target, whole)) refuse("a picture has another size");
    placeTile(target, whole, bytes.data());
}

// What the master says.

void RemoteService::receive() {
    unsigned peer = 0;
    std::vector<std::byte> bytes;
    while (!stopped_) {
        try {
            const Transport::Event event = transport_.receive(50ms, peer, bytes);
            if (event == Transport::Event::Closed) break;
            if (event == Transport::Event::Nothing) continue;
            const Parsed parsed = parseMessage(bytes);
            if (parsed.problem) refuse(parsed.problem);
            if (std::holds_alternative<Leave>(parsed.message)) break;
            std::visit([&](const auto& message) { take(message); }, parsed.message);
        } catch (const std::exception& problem) {
            giveUp(problem.what());
        }
    }
    end();
}

void RemoteService::take(const CallBytes& calls) {
    const std::lock_guard lock(mutex_);
    if (ended_) return;
    calls_.add(calls.bytes);
    news_.notify_all();
}

void RemoteService::take(const TileRequest& request) {
    packer_.arrived(request.arrived, std::chrono::steady_clock::now());
    const std::lock_guard lock(mutex_);
    if (ended_) return;
    const auto found = frames_.find(request.frame);
    if (found == frames_.end()) refuse("a tile is asked for of a frame that is not known");
    const KnownFrame& known = found->second;
    const PixelTarget& target = known.frame->target;
    if (request.width != target.width || request.height != target.height ||
        request.bytes != storedTileSize(target, request.tile))
        refuse("a tile is asked for of another frame");
    known.server->ask(request, known.frame);
}

void RemoteService::take(const FrameOver& over) {
    const std::lock_guard endLock(endMutex_);
    KnownFrame known;
    {
        const std::lock_guard lock(mutex_);
        const auto found = frames_.extract(over.frame);
        if (!found) {
            if (over.frame.number > lastFrame_[over.frame.renderer])
                over_.emplace(over.frame, over.done);
            return;
        }
        known = std::move(found.mapped());
        if (frames_.empty()) packer_.paused();
    }
    known.server->dropRequests(over.frame);
    known.server->queue().endElsewhere(*known.queued, over.done);
}

void RemoteService::take(const PictureBytes& picture) {
    const std::lock_guard lock(mutex_);
    if (ended_) return;
    auto& [bytes, whole] = pictures_[picture.picture];
    if (whole) refuse("a picture comes twice");
    bytes.insert(bytes.end(), picture.bytes.begin(), picture.bytes.end());
    whole = picture.last;
    news_.notify_all();
}

void RemoteService::take(const Leave&) {}

template <class Other>
void RemoteService::take(const Other&) {
    refuse("the master sends what only a worker may");
}

// Nothing more comes from the master, and nobody waits for it.
void RemoteService::end() noexcept {
    const std::lock_guard endLock(endMutex_);
    std::map<FrameKey, KnownFrame> frames;
    {
        const std::lock_guard lock(mutex_);
        ended_ = true;
        frames.swap(frames_);
        news_.notify_all();
    }
    for (const auto& [key, known] : frames)
        known.server->queue().endElsewhere(*known.queued, false);
}

} // namespace smart

// SPDX-License-Identifier: MIT
#include "libsmart/remote/remote_workers.h"

#include <algorithm>
#include <exception>
#include <iterator>
#include <optional>
#include <stdexcept>

#include "libsmart/base/error.h"
#include "libsmart/remote/call_bytes.h"
#include "libsmart/remote/frame_fingerprint.h"
#include "libsmart/remote/tile_feeder.h"
#include "libsmart/render/stored_tile.h"
#include "libsmart/render/worker.h"

namespace smart {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t kBatch = 64u << 10; ///< bytes of calls that are sent together
constexpr auto kTick = 50ms;              ///< how often stalled peers are looked for
constexpr unsigned kMaxThreads = 1024;
/// Frames that a peer may be ready for before they exist here.
constexpr std::size_t kMaxEarly = 1024;
constexpr const char* kOtherFrame = "its frame is not the one of this process";

/// A peer that is in order but can not take part: people have to change something.
struct Unsuitable : std::runtime_error {
    using std::runtime_error::runtime_error;
};

[[noreturn]] void refuse(const std::string& reason) {
    throw Error(ErrorCode::InvalidOperation, reason);
}

} // namespace

RemoteWorkers::RemoteWorkers(Transport& transport, RemoteOptions options, Warn warn)
    : transport_(transport),
      options_(std::move(options)),
      warn_(std::move(warn)),
      peers_(transport.peers()),
      patience_(options_.stallAfter),
      unpacker_(options_.codec),
      present_(transport.peers()) {
    receiver_ = startWorkerThread("remote", [this] { receive(); });
}

RemoteWorkers::~RemoteWorkers() {
    leave();
}

void RemoteWorkers::leave() noexcept {
    if (stopped_.exchange(true)) return;
    try {
        flushCalls();
        const Packet leave = encode(Leave{});
        for (unsigned i = 0; i < transport_.peers(); ++i) transport_.send(i, leave);
    } catch (...) { // they notice when this process ends
    }
    transport_.flush(2000ms);
    if (receiver_.joinable() && receiver_.get_id() != std::this_thread::get_id()) receiver_.join();
}

std::unique_ptr<Participation> RemoteWorkers::join(FrameQueue& queue, uint64_t renderer) {
    return std::make_unique<TileFeeder>(*this, queue, renderer);
}

unsigned RemoteWorkers::working() const {
    const std::lock_guard lock(mutex_);
    return unsigned(std::count_if(peers_.begin(), peers_.end(),
                                  [](const Peer& p) { return p.greeted && !p.gone; }));
}

bool RemoteWorkers::waitForPeers(std::chrono::milliseconds timeout) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, timeout, [&] {
        return std::all_of(peers_.begin(), peers_.end(),
                           [](const Peer& p) { return p.greeted || p.gone; });
    });
}

RemoteTraffic RemoteWorkers::traffic() const {
    const std::lock_guard lock(mutex_);
    return traffic_;
}

void RemoteWorkers::sendToAll(const Message& message) {
    const Packet packet = encode(message);
    std::vector<unsigned> receivers;
    {
        const std::lock_guard lock(mutex_);
        for (unsigned i = 0; i < peers_.size(); ++i)
            if (!peers_[i].gone) receivers.push_back(i);
    }
    for (const unsigned peer : receivers) transport_.send(peer, packet);
}

// Calls.

void RemoteWorkers::addCall(std::span<const std::byte> record) {
    if (present_.load(std::memory_order_relaxed) == 0) return;
    const std::lock_guard lock(callMutex_);
    appendCall(calls_, record);
    if (calls_.size() >= kBatch) sendCalls();
}

void RemoteWorkers::flushCalls() {
    const std::lock_guard lock(callMutex_);
    sendCalls();
}

void RemoteWorkers::sendCalls() {
    if (calls_.empty()) return;
    const std::span<const std::byte> all(calls_);
    for (std::size_t begin = 0; begin < all.size(); begin += kMaxPart)
        sendToAll(CallBytes{all.subspan(begin, std::min(kMaxPart, all.size() - begin))});
    sentBytes_ += all.size();
    calls_.clear();
    if (calls_.capacity() > 4 * kMaxPart) calls_.shrink_to_fit();
    waitForSlowPeers();
}

// Who lags behind is waited for, so that memory is bounded; who does not move is left out.
void RemoteWorkers::waitForSlowPeers() {
    std::unique_lock lock(mutex_);
    traffic_.callBytes = sentBytes_;
    const auto lags = [&](const Peer& p) {
        return !p.gone && sentBytes_ - std::min(p.taken, sentBytes_) > options_.window;
    };
    // The thread that receives would wait for itself.
    while (receiver_.get_id() != std::this_thread::get_id()) {
        const auto slowest = std::find_if(peers_.begin(), peers_.end(), lags);
        if (slowest == peers_.end()) return;
        const uint64_t before = slowest->taken;
        if (changed_.wait_for(lock, options_.deafAfter,
                              [&] { return slowest->gone || slowest->taken != before; }))
            continue;
        const unsigned peer = unsigned(slowest - peers_.begin());
        lock.unlock();
        drop(peer, "it takes in nothing");
        lock.lock();
    }
}

void RemoteWorkers::sharePicture(uint64_t renderer, const PixelTarget& picture) {
    flushCalls();
    FrameKey key{renderer, 0};
    {
        const std::lock_guard lock(mutex_);
        key.number = ++lastPicture_[renderer];
    }
    const Tile whole{0, 0, picture.width, picture.height};
    std::vector<std::byte> bytes(storedTileSize(picture, whole));
    gatherTile(picture, whole, bytes.data());
    const std::span<const std::byte> all(bytes);
    for (std::size_t begin = 0; begin < all.size(); begin += kMaxPart) {
        const std::size_t count = std::min(kMaxPart, all.size() - begin);
        sendToAll(PictureBytes{key, begin + count == all.size(), all.subspan(begin, count)});
    }
    const std::lock_guard lock(callMutex_);
    sentBytes_ += all.size();
    waitForSlowPeers();
}

// Frames and tiles.

void RemoteWorkers::shareFrame(uint64_t renderer, const QueuedFramePtr& frame, FrameQueue& queue) {
    flushCalls();
    SharedFrame shared{frame, &queue, frameFingerprint(frame->frame()), {}};
    std::vector<unsigned> mistaken;
    {
        const std::lock_guard lock(mutex_);
        if (!error_.empty())
            frame->keepError(std::make_exception_ptr(
                Error(ErrorCode::InvalidOperation, std::exchange(error_, {}))));
        shared.ready.resize(peers_.size());
        const FrameKey key{renderer, ++lastFrame_[renderer]};
        SharedFrame& kept = frames_.insert_or_assign(key, std::move(shared)).first->second;
        const auto early = early_.extract(key);
        for (const EarlyPeer& e : early ? early.mapped() : std::vector<EarlyPeer>()) {
            if (e.fingerprint == kept.fingerprint)
                markReady(kept, e.peer);
            else
                mistaken.push_back(e.peer);
        }
    }
    for (const unsigned peer : mistaken) drop(peer, kOtherFrame, true);
}

void RemoteWorkers::markReady(SharedFrame& frame, unsigned peer) {
    frame.ready[peer] = true;
    frame.queue->offer(*frame.queued, true);
}

void RemoteWorkers::endFrame(const QueuedFrame& frame, bool done) noexcept {
    try {
        std::optional<FrameKey> key;
        {
            const std::lock_guard lock(mutex_);
            for (auto i = frames_.begin(); i != frames_.end() && !key; ++i)
                if (i->second.queued.get() == &frame) {
                    key = i->first;
                    frames_.erase(i);
                    break;
                }
        }
        if (key) sendToAll(FrameOver{*key, done});
    } catch (...) { // out of memory: peers keep the frame until they leave
    }
}

bool RemoteWorkers::waitForRoom(const std::atomic<bool>& closing) {
    std::unique_lock lock(mutex_);
    room_.wait(lock, [&] {
        return closing || std::any_of(peers_.begin(), peers_.end(),
                                      [](const Peer& p) { return p.takesTiles(); });
    });
    return !closing;
}

void RemoteWorkers::wakeFeeders() {
    const std::lock_guard lock(mutex_);
    room_.notify_all();
}

void RemoteWorkers::hand(TileJob& job, const std::shared_ptr<QueueLink>& link,
                         const std::atomic<bool>& closing) {
    const Clock::time_point end = Clock::now() + 100ms;
    std::unique_lock lock(mutex_);
    for (;;) {
        const auto entry = std::find_if(frames_.begin(), frames_.end(), [&](const auto& f) {
            return f.second.queued.get() == job.ticket.get();
        });
        unsigned best = unsigned(peers_.size());
        bool anyReady = false;
        for (unsigned i = 0; entry != frames_.end() && i < peers_.size(); ++i) {
            const Peer& p = peers_[i];
            if (p.gone || !entry->second.ready[i]) continue;
            anyReady = true;
            if (p.takesTiles() && (best == peers_.size() || p.room > peers_[best].room)) best = i;
        }
        if (best < peers_.size()) {
            const PixelTarget& target = job.frame->target;
            const std::size_t bytes = storedTileSize(target, job.tile);
            const uint64_t number = ++lastTicket_;
            const Packet request =
                encode(TileRequest{number, entry->first, job.tile, target.width, target.height,
                                   uint32_t(bytes), unpacker_.mayPack(), peers_[best].arrived});
            tickets_.emplace(number, Ticket{job, link, best, storedLayout(target), bytes,
                                            Clock::now()});
            --peers_[best].room;
            ++traffic_.tilesSent;
            lock.unlock();
            transport_.send(best, request);
            return;
        }
        if (!anyReady && entry != frames_.end())
            entry->second.queue->offer(*entry->second.queued, false);
        if (!anyReady || closing || room_.wait_until(lock, end) == std::cv_status::timeout) break;
    }
    lock.unlock();
    link->queue->returned(job);
}

void RemoteWorkers::forget(const QueueLink& link) {
    const std::lock_guard lock(mutex_);
    for (auto i = tickets_.begin(); i != tickets_.end();) {
        if (i->second.link.get() != &link) {
            ++i;
            continue;
        }
        ++peers_[i->second.peer].room;
        i = tickets_.erase(i);
    }
}

// What peers say.

void RemoteWorkers::receive() {
    unsigned peer = 0;
    std::vector<std::byte> message;
    Clock::time_point look = Clock::now() + kTick;
    while (!stopped_) {
        try {
            switch (transport_.receive(kTick, peer, message)) {
                case Transport::Event::Arrived: handle(peer, message); break;
                case Transport::Event::Closed: drop(peer, "it has ended"); break;
                case Transport::Event::Nothing: break;
            }
        } catch (const Unsuitable& problem) {
            drop(peer, problem.what(), true);
        } catch (const std::exception& problem) {
            drop(peer, problem.what());
        }
        if (Clock::now() < look) continue;
        look = Clock::now() + kTick;
        giveBackStalled();
    }
}

void RemoteWorkers::handle(unsigned peer, std::span<const std::byte> bytes) {
    bool greeted = false;
    {
        const std::lock_guard lock(mutex_);
        if (peers_[peer].gone) return;
        greeted = peers_[peer].greeted;
    }
    const Parsed parsed = parseMessage(bytes);
    if (parsed.problem) refuse(std::string("a message of it is ") + parsed.problem);
    if (!greeted && !std::holds_alternative<Hello>(parsed.message) &&
        !std::holds_alternative<Trouble>(parsed.message))
        refuse("it did not say what it is");
    std::visit([&](const auto& message) { take(peer, message); }, parsed.message);
}

void RemoteWorkers::take(unsigned peer, const Hello& hello) {
    if (hello.identity != options_.identity)
        throw Unsuitable("its library is another one: " + hello.identity + ", not " +
                         options_.identity);
    if (hello.threads == 0 || hello.threads > kMaxThreads)
        refuse("it has no such number of threads");
    const std::lock_guard lock(mutex_);
    Peer& p = peers_[peer];
    if (p.greeted) refuse("it said twice what it is");
    p.greeted = true;
    p.room = hello.threads * std::max(options_.tilesAhead, 1u);
    changed_.notify_all();
    room_.notify_all();
}

void RemoteWorkers::take(unsigned peer, const FrameReady& ready) {
    const std::lock_guard lock(mutex_);
    const auto found = frames_.find(ready.frame);
    if (found != frames_.end()) {
        if (found->second.fingerprint != ready.fingerprint) throw Unsuitable(kOtherFrame);
        markReady(found->second, peer);
        room_.notify_all();
        return;
    }
    const auto last = lastFrame_.find(ready.frame.renderer);
    if (last != lastFrame_.end() && ready.frame.number <= last->second) return; // over
    if (early_.size() >= kMaxEarly) refuse("it is ready for too many frames that there are not");
    std::vector<EarlyPeer>& early = early_[ready.frame];
    if (std::any_of(early.begin(), early.end(), [&](const EarlyPeer& e) { return e.peer == peer; }))
        refuse("it said twice that it is ready for a frame");
    early.push_back({peer, ready.fingerprint});
}

void RemoteWorkers::take(unsigned peer, const TileAnswer& answer) {
    const Clock::time_point start = Clock::now();
    Ticket ticket;
    {
        const std::lock_guard lock(mutex_);
        peers_[peer].arrived += answer.pixels.size();
        const auto found = tickets_.find(answer.ticket);
        if (found == tickets_.end()) {
            if (answer.ticket == 0 || answer.ticket > lastTicket_)
                refuse("it answers what was not asked");
            return; // of a renderer that has ended, or answered twice
        }
        if (found->second.peer != peer) refuse("it answers what another was asked");
        const std::size_t bytes = answer.pixels.size();
        if (!answer.packed && bytes != found->second.bytes && bytes != 0)
            refuse("its tile has another size");
        ticket = found->second;
    }
    // A tile that can not be unpacked is still its sender's, and goes to others with the rest.
    const std::span<const std::byte> pixels =
        answer.packed
            ? unpacker_.unpack(ticket.layout, ticket.job.tile, ticket.bytes, answer.pixels)
            : answer.pixels;
    {
        const std::lock_guard lock(mutex_);
        const auto found = tickets_.find(answer.ticket);
        if (found == tickets_.end()) return; // its renderer has ended in the meantime
        ticket = std::move(found->second);
        tickets_.erase(found);
        patience_.answered(start - ticket.sent);
        ++peers_[peer].room;
        peers_[peer].stalled = false;
        ++traffic_.tilesAnswered;
        traffic_.answerBytes += answer.pixels.size();
        traffic_.pixelBytes += pixels.size();
        room_.notify_all();
    }
    {
        const std::lock_guard lock(ticket.link->mutex);
        if (!ticket.link->queue) return;
        if (!pixels.empty())
            ticket.link->queue->answered(
                ticket.job, {pixels.data(), answer.primaryRays, answer.shadowRays,
                             answer.secondaryRays, answer.badPixels, answer.busyNanoseconds});
        else if (!ticket.job.returned)
            ticket.link->queue->returned(ticket.job);
    }
    unpacker_.served(start, answer.pixels.size());
}

void RemoteWorkers::take(unsigned peer, const Progress& progress) {
    const std::lock_guard lock(mutex_);
    peers_[peer].taken = std::max(peers_[peer].taken, progress.bytes);
    changed_.notify_all();
}

void RemoteWorkers::take(unsigned, const Trouble& trouble) {
    throw Unsuitable(trouble.text);
}

template <class Other>
void RemoteWorkers::take(unsigned, const Other&) {
    refuse("it sends what only this process may");
}

void RemoteWorkers::giveBackStalled() {
    struct Stalled {
        std::shared_ptr<QueueLink> link;
        uint64_t ticket;
    };
    std::vector<Stalled> stalled;
    std::vector<unsigned> late;
    {
        const std::lock_guard lock(mutex_);
        const Clock::time_point limit = Clock::now() - patience_.limit();
        for (const auto& [number, ticket] : tickets_)
            if (!ticket.job.returned && ticket.sent < limit)
                stalled.push_back({ticket.link, number});
    }
    for (const Stalled& s : stalled) {
        const std::lock_guard linkLock(s.link->mutex);
        const std::lock_guard lock(mutex_);
        const auto found = tickets_.find(s.ticket);
        if (!s.link->queue || found == tickets_.end()) continue;
        s.link->queue->returned(found->second.job);
        ++traffic_.tilesReturned;
        const unsigned peer = found->second.peer;
        peers_[peer].stalled = true;
        if (!std::exchange(peers_[peer].wasLate, true)) late.push_back(peer);
    }
    for (const unsigned peer : late)
        warn_(transport_.peerName(peer) + " does not answer in time: others get its tiles");
}

void RemoteWorkers::drop(unsigned peer, const std::string& reason, bool isError) noexcept {
    try {
        std::vector<Ticket> lost;
        bool news = false;
        {
            const std::lock_guard lock(mutex_);
            Peer& p = peers_[peer];
            news = !std::exchange(p.gone, true);
            if (news) --present_;
            for (auto i = tickets_.begin(); i != tickets_.end();) {
                if (i->second.peer == peer) {
                    lost.push_back(std::move(i->second));
                    i = tickets_.erase(i);
                } else {
                    ++i;
                }
            }
            for (auto& [key, frame] : frames_) {
                frame.ready[peer] = false;
                if (std::find(frame.ready.begin(), frame.ready.end(), true) == frame.ready.end())
                    frame.queue->offer(*frame.queued, false);
            }
            for (auto& [key, ready] : early_)
                std::erase_if(ready, [&](const EarlyPeer& e) { return e.peer == peer; });
            std::erase_if(early_, [](const auto& e) { return e.second.empty(); });
            changed_.notify_all();
            room_.notify_all();
        }
        for (Ticket& ticket : lost) {
            const std::lock_guard lock(ticket.link->mutex);
            if (ticket.link->queue && !ticket.job.returned)
                ticket.link->queue->returned(ticket.job);
        }
        if (!news || stopped_) return;
        const std::string text = transport_.peerName(peer) + " renders no more: " + reason;
        warn_(text);
        const std::lock_guard lock(mutex_);
        if (isError && error_.empty()) error_ = text;
    } catch (...) { // out of memory: its tiles are given back when they are found stalled
    }
}

} // namespace smart

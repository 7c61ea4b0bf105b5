// SPDX-License-Identifier: MIT
#include "libsmart/remote/tile_server.h"

#include <chrono>
#include <exception>
#include <string>
#include <utility>

#include "libsmart/render/stored_tile.h"
#include "libsmart/render/thread_loan.h"

namespace smart {
namespace {

struct AnswerMemory {
    std::vector<std::byte> stored;
    PackMemory packing;
};

} // namespace

TileServer::TileServer(RemoteService& service, FrameQueue& queue, uint64_t renderer)
    : service_(service), queue_(queue), renderer_(renderer) {
    queue_.renderElsewhere();
}

TileServer::~TileServer() {
    close();
}

unsigned TileServer::threads(unsigned) const {
    return service_.threads_;
}

void TileServer::submitting(const QueuedFramePtr& frame) noexcept {
    try {
        service_.enter(renderer_, frame, *this);
    } catch (const std::exception& problem) {
        service_.giveUp(problem.what());
    }
}

void TileServer::sharePicture(const PixelTarget& picture) {
    service_.takePicture(renderer_, picture);
}

void TileServer::close() noexcept {
    service_.leaveOut(*this);
    {
        const std::lock_guard lock(mutex_);
        closed_ = true;
    }
    news_.notify_all();
}

bool TileServer::next(TileJob& job) {
    std::unique_lock lock(mutex_);
    news_.wait(lock, [&] { return closed_ || !requests_.empty(); });
    if (requests_.empty()) return false;
    const auto request = std::make_shared<Request>(std::move(requests_.front()));
    requests_.pop_front();
    job.frame = request->frame.get();
    job.tile = request->tile;
    job.ticket = request;
    job.since = std::chrono::steady_clock::now();
    return true;
}

void TileServer::done(TileJob& job, const TilePixels& pixels) {
    const Request& request = *static_cast<const Request*>(job.ticket.get());
    const PixelTarget& target = request.frame->target;
    const ThreadLoan<AnswerMemory> memory;
    std::vector<std::byte>& stored = memory->stored;
    stored.resize(storedTileSize(target, request.tile));
    storeTile(target, request.tile, pixels, stored.data());
    const std::chrono::nanoseconds busy = std::chrono::steady_clock::now() - job.since;
    const std::span<const std::byte> bytes = service_.packer().pack(
        storedLayout(target), request.tile, stored, double(busy.count()) * 1e-9, request.mayPack,
        memory->packing);
    service_.send(TileAnswer{request.ticket, pixels.primaryRays, pixels.shadowRays,
                             pixels.secondaryRays, pixels.badPixels, uint64_t(busy.count()),
                             bytes.size() < stored.size(), bytes});
    job.ticket.reset();
}

void TileServer::failed(TileJob& job, std::exception_ptr reason) noexcept {
    job.ticket.reset();
    try {
        std::rethrow_exception(std::move(reason));
    } catch (const std::exception& problem) {
        service_.giveUp(problem.what());
    } catch (...) {
        service_.giveUp("a tile failed");
    }
}

void TileServer::ask(const TileRequest& request, std::shared_ptr<const Frame> frame) {
    {
        const std::lock_guard lock(mutex_);
        requests_.push_back({request.ticket, request.frame, std::move(frame), request.tile,
                             request.mayPack});
    }
    news_.notify_one();
}

void TileServer::dropRequests(FrameKey frame) {
    std::deque<Request> dropped, kept;
    {
        const std::lock_guard lock(mutex_);
        for (Request& request : requests_)
            (request.key == frame ? dropped : kept).push_back(std::move(request));
        requests_.swap(kept);
    }
    for (const Request& request : dropped)
        service_.send(TileAnswer{request.ticket, 0, 0, 0, 0, 0, false, {}});
}

} // namespace smart

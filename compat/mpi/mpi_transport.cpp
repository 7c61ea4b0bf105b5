// SPDX-License-Identifier: MIT
#include "compat/mpi/mpi_transport.h"

#include <dlfcn.h>
#include <pthread.h>
#include <sys/prctl.h>

#include <algorithm>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "libsmart/base/variable_warning.h"

namespace smart::compat {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr int kTag = 7;
constexpr unsigned kUnderWay = 32; ///< messages to a peer that MPI has at once
constexpr auto kHeartbeat = 1s;    ///< from one heartbeat to the next
constexpr int kSilence = 60;       ///< seconds without any after which rank 0 is lost

/// MPI has no call that waits for a message or a time: how long to sleep between two looks.
std::chrono::microseconds pause(Clock::duration idle) {
    return idle < 5ms ? 20us : idle < 1s ? 200us : 1000us;
}

/// 0: for ever.
std::chrono::seconds silenceFromEnvironment() {
    const char* const text = secure_getenv("OPENRT_MPI_SILENCE");
    if (!text) return std::chrono::seconds(kSilence);
    int seconds = 0;
    const char* const end = text + std::strlen(text);
    const auto [last, problem] = std::from_chars(text, end, seconds);
    if (problem == std::errc() && last == end && (seconds == 0 || seconds > kHeartbeat.count()))
        return std::chrono::seconds(seconds);
    char reason[80];
    std::snprintf(reason, sizeof reason, "neither 0 nor a number of seconds above %d; using %d",
                  int(kHeartbeat.count()), kSilence);
    warnOfVariable("OPENRT_MPI_SILENCE", text, reason);
    return std::chrono::seconds(kSilence);
}

/// Open MPI opens its own parts as plug-ins, which look for its symbols among the global ones.
/// Where this library was opened with dlopen they are not there yet.
void makeMpiGlobal() {
    Dl_info info;
    if (dladdr(reinterpret_cast<void*>(&MPI_Init_thread), &info) != 0 && info.dli_fname)
        dlopen(info.dli_fname, RTLD_NOW | RTLD_GLOBAL | RTLD_NOLOAD);
}

} // namespace

MpiTransport::MpiTransport() {
    sigset_t all, before;
    sigfillset(&all);
    for (const int own : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGABRT, SIGSYS})
        sigdelset(&all, own);
    pthread_sigmask(SIG_BLOCK, &all, &before); // signals are for the application's threads
    thread_ = std::thread([this] { run(); });
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return started_; });
    if (problem_.empty()) return;
    lock.unlock();
    thread_.join();
    throw std::runtime_error(problem_);
}

MpiTransport::~MpiTransport() {
    if (thread_.joinable()) thread_.detach(); // it lives until the process ends
}

std::string MpiTransport::peerName(unsigned peer) const {
    return "rank " + std::to_string(rankOf(peer));
}

void MpiTransport::send(unsigned peer, Packet packet) {
    {
        const std::lock_guard lock(mutex_);
        if (peers_[peer].closed || finishing_) return;
        peers_[peer].outgoing.push_back(std::move(packet));
        ++unsent_;
    }
    wake_.notify_one();
}

Transport::Event MpiTransport::receive(std::chrono::microseconds timeout, unsigned& peer,
                                       std::vector<std::byte>& message) {
    std::unique_lock lock(mutex_);
    if (!arrived_.wait_for(lock, timeout, [&] { return !arrivals_.empty(); }))
        return Event::Nothing;
    Arrival arrival = std::move(arrivals_.front());
    arrivals_.pop_front();
    peer = arrival.peer;
    message.swap(arrival.message);
    return arrival.event;
}

void MpiTransport::flush(std::chrono::milliseconds timeout) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, timeout, [&] { return unsent_ == 0 || finished_; });
}

bool MpiTransport::finish(std::chrono::milliseconds timeout) noexcept {
    std::unique_lock lock(mutex_);
    finishing_ = true;
    wake_.notify_one();
    for (uint64_t before = 0;;) {
        before = moved_;
        if (changed_.wait_for(lock, timeout, [&] { return finished_; })) break;
        if (moved_ == before) return false;
    }
    lock.unlock();
    if (thread_.joinable()) thread_.join();
    return true;
}

// The thread that calls MPI.

std::string MpiTransport::start() {
    makeMpiGlobal();
    int initialized = 0;
    MPI_Initialized(&initialized);
    if (initialized) return "the program uses MPI itself";
    int level = 0;
    if (MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &level) != MPI_SUCCESS)
        return "MPI can not be started";
    if (MPI_Comm_dup(MPI_COMM_WORLD, &ranks_) != MPI_SUCCESS) return "MPI gives no communicator";
    MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
    MPI_Comm_set_errhandler(ranks_, MPI_ERRORS_RETURN);
    int size = 1;
    MPI_Comm_rank(ranks_, &rank_);
    MPI_Comm_size(ranks_, &size);
    peers_.resize(rank_ == 0 ? std::size_t(size) - 1 : 1);
    if (rank_ == 0) heartbeats_.resize(peers_.size(), MPI_REQUEST_NULL);
    silence_ = silenceFromEnvironment();
    lastHeard_ = Clock::now();
    return "";
}

void MpiTransport::run() {
    pthread_setname_np(pthread_self(), "openrt-mpi");
    prctl(PR_SET_TIMERSLACK, 1000ul); // nanoseconds: pauses are short
    std::string problem = start();
    const bool usable = problem.empty();
    {
        const std::lock_guard lock(mutex_);
        problem_ = std::move(problem);
        started_ = true;
    }
    changed_.notify_all();
    if (!usable) return;

    Clock::time_point last = Clock::now();
    for (;;) {
        bool moved = startSends();
        moved |= endSends();
        moved |= takeMessage();
        sendHeartbeats();
        const Clock::time_point now = Clock::now();
        if (moved) last = now;
        std::unique_lock lock(mutex_);
        if (rank_ != 0 && silence_ != 0s && now - lastHeard_ > silence_) loseLocked(0);
        if (finishing_ && (unsent_ == 0 || now - last > 5s)) break;
        if (!moved)
            wake_.wait_for(lock, pause(now - last), [&] {
                return std::any_of(peers_.begin(), peers_.end(), [](const Peer& p) {
                    return !p.outgoing.empty() && p.underWay < kUnderWay;
                });
            });
    }
    MPI_Finalize(); // where a message is still under way it belongs to a rank that is lost
    {
        const std::lock_guard lock(mutex_);
        finished_ = true;
    }
    changed_.notify_all();
}

// Where the last one to a rank is still under way, the rank takes none.
void MpiTransport::sendHeartbeats() {
    const Clock::time_point now = Clock::now();
    if (heartbeats_.empty() || now - lastHeartbeat_ < kHeartbeat) return;
    lastHeartbeat_ = now;
    for (unsigned i = 0; i < heartbeats_.size(); ++i) {
        int done = 0;
        if (MPI_Test(&heartbeats_[i], &done, MPI_STATUS_IGNORE) == MPI_SUCCESS && done)
            MPI_Isend(nullptr, 0, MPI_BYTE, rankOf(i), kTag, ranks_, &heartbeats_[i]);
    }
}

void MpiTransport::loseLocked(unsigned peer) {
    Peer& p = peers_[peer];
    if (std::exchange(p.closed, true)) return;
    unsent_ -= p.outgoing.size();
    p.outgoing.clear();
    arrivals_.push_back({Event::Closed, peer, {}});
    arrived_.notify_one();
}

bool MpiTransport::startSends() {
    std::vector<Sending> begun;
    {
        const std::lock_guard lock(mutex_);
        for (unsigned i = 0; i < peers_.size(); ++i)
            for (Peer& p = peers_[i]; !p.outgoing.empty() && p.underWay < kUnderWay; ++p.underWay) {
                begun.push_back({i, std::move(p.outgoing.front())});
                p.outgoing.pop_front();
            }
    }
    for (Sending& s : begun) {
        MPI_Request request = MPI_REQUEST_NULL;
        const int result = MPI_Isend(s.packet->data(), int(s.packet->size()), MPI_BYTE,
                                     rankOf(s.peer), kTag, ranks_, &request);
        if (result != MPI_SUCCESS) {
            const std::lock_guard lock(mutex_);
            --peers_[s.peer].underWay;
            --unsent_;
            loseLocked(s.peer);
            continue;
        }
        requests_.push_back(request);
        sending_.push_back(std::move(s));
    }
    return !begun.empty();
}

bool MpiTransport::endSends() {
    bool any = false;
    for (std::size_t i = 0; i < requests_.size();) {
        int done = 0;
        const int result = MPI_Test(&requests_[i], &done, MPI_STATUS_IGNORE);
        if (result == MPI_SUCCESS && !done) {
            ++i;
            continue;
        }
        any = true;
        {
            const std::lock_guard lock(mutex_);
            --peers_[sending_[i].peer].underWay;
            --unsent_;
            ++moved_;
            if (result != MPI_SUCCESS) loseLocked(sending_[i].peer);
        }
        changed_.notify_all();
        requests_[i] = requests_.back();
        requests_.pop_back();
        sending_[i] = std::move(sending_.back());
        sending_.pop_back();
    }
    return any;
}

bool MpiTransport::takeMessage() {
    int found = 0;
    MPI_Message matched;
    MPI_Status status;
    if (MPI_Improbe(MPI_ANY_SOURCE, kTag, ranks_, &found, &matched, &status) != MPI_SUCCESS) {
        const std::lock_guard lock(mutex_); // it does not say which
        for (unsigned i = 0; i < peers_.size(); ++i) loseLocked(i);
        return false;
    }
    if (!found) return false;
    lastHeard_ = Clock::now();
    int count = 0;
    MPI_Get_count(&status, MPI_BYTE, &count);
    const bool fits = count >= 0 && std::size_t(count) <= kMaxMessage;
    Arrival arrival{Event::Arrived, rank_ == 0 ? unsigned(status.MPI_SOURCE) - 1 : 0,
                    std::vector<std::byte>(fits ? std::size_t(count) : 1)};
    // What does not fit is cut, and known as no message by its length.
    const int result = MPI_Mrecv(arrival.message.data(), int(arrival.message.size()), MPI_BYTE,
                                 &matched, MPI_STATUS_IGNORE);
    if (rank_ != 0 && count == 0) return false; // a heartbeat
    const std::lock_guard lock(mutex_);
    ++moved_;
    if (arrival.peer >= peers_.size() || peers_[arrival.peer].closed) return true;
    if (fits && result != MPI_SUCCESS) {
        loseLocked(arrival.peer);
        return true;
    }
    arrivals_.push_back(std::move(arrival));
    arrived_.notify_one();
    return true;
}

} // namespace smart::compat

// The symbols that libOpenRT looks for.
extern "C" __attribute__((visibility("default"))) const char openrtMpiComponent[] =
    OPENRT_MPI_COMPONENT;

extern "C" __attribute__((visibility("default"))) smart::compat::MpiRanks* openrtMpiOpen(
    char* problem, std::size_t size) {
    try {
        return new smart::compat::MpiTransport();
    } catch (const std::exception& why) {
        std::snprintf(problem, size, "%s", why.what());
    }
    return nullptr;
}

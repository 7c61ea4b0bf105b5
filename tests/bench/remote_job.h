// SPDX-License-Identifier: MIT
// Ranks within this process: everything but the program that is played, over sockets.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include "libsmart/remote/remote_workers.h"
#include "libsmart/render/tracer.h"
#include "tests/libsmart/remote/shared_renderer.h"
#include "tests/support/delayed_transport.h"
#include "tests/support/socket_transport.h"

namespace smart::bench {

struct RemoteLine {
    std::chrono::microseconds latency{0}; ///< one way
    double bytesPerSecond = 0;            ///< of what rank 0 receives; 0: no limit
};

/// A master and its workers, one thread each, which render one frame again and again.
class RemoteJob {
public:
    RemoteJob(unsigned workers, const Tracer& tracer, std::shared_ptr<const Frame> frame,
              const RemoteLine& line = {}, Packing packing = Packing::Never);
    ~RemoteJob();

    /// Seconds of a frame, the median; one at a time.
    double secondsOfFrame(unsigned repeat);
    /// The same of frames in the queue, the mean.
    double secondsOfQueue(unsigned frames);
    RemoteTraffic traffic() const { return remote_->traffic(); }

private:
    QueuedFramePtr submit();

    std::shared_ptr<const Frame> frame_;
    std::vector<std::jthread> workers_;
    std::unique_ptr<test::SocketTransport> sockets_;
    std::unique_ptr<test::DelayedTransport> delayed_;
    std::unique_ptr<RemoteWorkers> remote_;
    std::unique_ptr<test::SharedRenderer> renderer_;
};

/// Seconds that a message of so many bytes takes from thread to thread over a pair of sockets.
double socketLatency(std::size_t bytes, unsigned repeat);
/// Seconds that rank 0 spends on a tile of another rank: request, check and copy of the answer.
double servingSeconds(const Frame& frame, unsigned repeat);

} // namespace smart::bench

// SPDX-License-Identifier: MIT
#include "libsmart/render/render_peers.h"

#include <atomic>

namespace smart {
namespace {
std::atomic<RenderPeers*> current{nullptr};
std::atomic<uint64_t> renderers{0};
} // namespace

RenderPeers* renderPeers() noexcept {
    return current.load(std::memory_order_acquire);
}

void setRenderPeers(RenderPeers* peers) noexcept {
    renderers.store(0, std::memory_order_relaxed);
    current.store(peers, std::memory_order_release);
}

uint64_t nextRendererNumber() noexcept {
    return renderPeers() ? renderers.fetch_add(1, std::memory_order_relaxed) + 1 : 0;
}

} // namespace smart

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "libsmart/kernel/packet.h"
#include "libsmart/kernel/view.h"

namespace smart {

/// All that the rays of a packet meet: each triangle once, in order of submission. Memory that is
/// used again for one packet after the other.
class AllHits {
public:
    /// One of KernelTable::intersectAll.
    using Kernel = void (*)(const ModelView&, const RayPacket&, HitList&);

    void find(Kernel intersectAll, const ModelView& scene, const RayPacket& rays);
    std::span<const Hit> of(uint32_t lane) const {
        return std::span(hits_).subspan(begins_[lane], ends_[lane] - begins_[lane]);
    }

private:
    std::vector<Hit> met_;        ///< in no order
    std::vector<uint32_t> lanes_; ///< beside them
    std::vector<Hit> hits_;       ///< lane after lane
    uint32_t begins_[kPacketSize] = {}, ends_[kPacketSize] = {};
};

} // namespace smart

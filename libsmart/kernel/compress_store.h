// SPDX-License-Identifier: MIT
// Lanes of a mask side by side in memory. AVX-512 has an instruction for it. For others Highway looks
// up where lanes go in a table that it sets up on the stack for each call, which takes longer than
// everything else that a traversal does at a node; here the table is static.
#pragma once

#include "libsmart/kernel/simd.h"

namespace smart::SMART_ISA {

/// For each set of lanes of a register: which lane comes to which place.
struct LaneOrder {
    uint8_t of[kRegisterLanes < 16 ? 1u << kRegisterLanes : 1][kRegisterLanes]{};

    constexpr LaneOrder() {
        for (uint32_t lanes = 0; lanes < sizeof of / sizeof of[0]; ++lanes) {
            int place = 0;
            for (int lane = 0; lane < kRegisterLanes; ++lane)
                if ((lanes >> lane & 1) != 0) of[lanes][place++] = uint8_t(lane);
        }
    }
};
inline constexpr LaneOrder kLaneOrder;

/// Of one register; returns how many there are.
template <class D>
HWY_INLINE std::size_t compressStore(D tag, hn::Mask<D> m, hn::Vec<D> v, hn::TFromD<D>* to) {
#if HWY_TARGET == HWY_SCALAR
    if (hn::AllTrue(tag, m)) *to = hn::GetLane(v);
    return hn::CountTrue(tag, m);
#else
    if constexpr (kRegisterLanes == 16) {
        hn::StoreU(hn::Compress(v, m), tag, to);
        return hn::CountTrue(tag, m);
    } else {
        uint64_t lanes = 0;
        hn::StoreMaskBits(tag, m, reinterpret_cast<uint8_t*>(&lanes));
        const hn::Rebind<uint8_t, D> bytes;
        const auto order = hn::PromoteTo(hn::RebindToUnsigned<D>(),
                                         hn::LoadU(bytes, kLaneOrder.of[lanes]));
        hn::StoreU(hn::TableLookupLanes(v, hn::IndicesFromVec(tag, order)), tag, to);
        return std::size_t(__builtin_popcountll(lanes));
    }
#endif
}

/// Stores the lanes of the mask side by side and returns how many they are; the rest of a whole
/// group's memory behind `to` gets any value.
inline int compressStore(const Mask<kPacketSize>& m, const Real<kPacketSize>& a, float* to) {
    std::size_t count = 0;
    for (int i = 0; i < kRegisters<kPacketSize>; ++i)
        count += compressStore(Tag(), m.m[i], a.v[i], to + count);
    return int(count);
}
inline int compressStore(const Mask<kPacketSize>& m, const Word<kPacketSize>& a, uint32_t* to) {
    std::size_t count = 0;
    for (int i = 0; i < kRegisters<kPacketSize>; ++i)
        count += compressStore(WordTag(), hn::RebindMask(WordTag(), m.m[i]), a.v[i], to + count);
    return int(count);
}

} // namespace smart::SMART_ISA

// SPDX-License-Identifier: MIT
#include "libsmart/kernel/packet_math.h"

#include <cstring>

namespace smart {

#if defined(__x86_64__)
namespace avx512 { extern const PacketMath kPacketMath; }
namespace avx2 { extern const PacketMath kPacketMath; }
namespace sse4 { extern const PacketMath kPacketMath; }
#elif defined(__aarch64__)
namespace neon { extern const PacketMath kPacketMath; }
#endif
namespace generic { extern const PacketMath kPacketMath; }

const PacketMath& packetMathOf(const KernelTable& kernels) {
    static const PacketMath* const kTables[] = {
#if defined(__x86_64__)
        &avx512::kPacketMath, &avx2::kPacketMath, &sse4::kPacketMath,
#elif defined(__aarch64__)
        &neon::kPacketMath,
#endif
    };
    for (const PacketMath* table : kTables)
        if (std::strcmp(table->name, kernels.name) == 0) return *table;
    return generic::kPacketMath;
}

} // namespace smart

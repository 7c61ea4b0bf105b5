// SPDX-License-Identifier: MIT
#include "libsmart/render/packet_tracer.h"

namespace smart {

template class ShadingServices<DynamicShading>;
template class TileTracer<DynamicShading>;
template class PacketTracer<DynamicShading>;

} // namespace smart

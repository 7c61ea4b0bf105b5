// SPDX-License-Identifier: MIT
#include "libsmart/render/packet_tracer.h"

#include "libsmart/render/layered_tile.h"

namespace smart {

void renderLayered(const Frame& frame, const Tile& tile, TilePixels& pixels, ShadingForm form) {
    pixels.primaryRays = pixels.shadowRays = pixels.secondaryRays = pixels.badPixels = 0;
    LayeredTile(frame, tile, pixels, form).trace();
}

template class ShadingServices<DynamicShading>;
template class TileTracer<DynamicShading>;
template class PacketTracer<DynamicShading>;

} // namespace smart

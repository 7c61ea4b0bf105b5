// SPDX-License-Identifier: MIT
#pragma once

#include "libsmart/render/packet_tracer.h"

namespace smart {

/// The tracer that serves a frame best: one made for a built-in surface class where the frame has
/// no other surfaces, otherwise the general one.
const Tracer& tracerFor(const FrameShading& shading, ShadingForm form = ShadingForm::Packets);

/// Leaves each frame to that tracer.
class FrameTracer final : public Tracer {
public:
    void render(const Frame& frame, const Tile& tile, TilePixels& pixels) const override {
        tracerFor(frame.shading()).render(frame, tile, pixels);
    }
};

} // namespace smart

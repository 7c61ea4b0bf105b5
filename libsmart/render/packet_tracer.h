// SPDX-License-Identifier: MIT
#pragma once

#include "libsmart/render/tile_tracer.h"
#include "libsmart/render/tracer.h"

namespace smart {

/// Renders a tile of a layered frame.
void renderLayered(const Frame& frame, const Tile& tile, TilePixels& pixels, ShadingForm form);

/// The tracer. DynamicShading serves every frame. With FixedShading<S> shaders of class S are
/// compiled into it; frames that use surfaces of other classes besides are left to the general
/// tracer. The picture is the same.
template <class Shading = DynamicShading>
class PacketTracer final : public Tracer {
public:
    explicit PacketTracer(ShadingForm form = ShadingForm::Packets) : form_(form) {}

    void render(const Frame& frame, const Tile& tile, TilePixels& pixels) const override {
        if (!Shading::serves(frame.shading()))
            return PacketTracer<DynamicShading>(form_).render(frame, tile, pixels);
        if (frame.isLayered()) return renderLayered(frame, tile, pixels, form_);
        pixels.primaryRays = pixels.shadowRays = pixels.secondaryRays = pixels.badPixels = 0;
        TileTracer<Shading> tracer(frame, tile, pixels, form_);
        if (frame.renderingObject)
            tracer.tracePixels();
        else
            tracer.tracePackets();
    }

private:
    const ShadingForm form_;
};

extern template class TileTracer<DynamicShading>;
extern template class PacketTracer<DynamicShading>;

} // namespace smart

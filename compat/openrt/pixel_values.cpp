// SPDX-License-Identifier: MIT
#include "compat/openrt/pixel_values.h"

#include "openrt/rt.h"

namespace smart::compat {

namespace {

std::optional<StateValue> rasterValue(const RasterPosition& raster, std::size_t unit,
                                      RTenum name) {
    switch (name) {
    case RT_CURRENT_RASTER_POSITION:
        return StateValue::list(
            {raster.window.x, raster.window.y, raster.window.z, raster.clipW});
    case RT_CURRENT_RASTER_POSITION_VALID: return StateValue::number(raster.valid);
    case RT_CURRENT_RASTER_COLOR: return StateValue::vector(raster.lit.primary, true);
    case RT_CURRENT_RASTER_TEXTURE_COORDS:
        return StateValue::vector(
            unit == 0 ? raster.lit.texCoord : raster.lit.moreTexCoords[unit - 1], false);
    case RT_CURRENT_RASTER_DISTANCE: return StateValue::number(double(raster.lit.fogDistance));
    default: return std::nullopt;
    }
}

} // namespace

std::optional<StateValue> pixelValue(const Recorder& recorder, RTenum name) {
    const PixelDrawing& drawing = recorder.pixelDrawingNow();
    const auto number = [](double n) { return StateValue::number(n); };
    switch (name) {
    case RT_ZOOM_X: return number(drawing.zoom.x);
    case RT_ZOOM_Y: return number(drawing.zoom.y);
    case RT_RED_SCALE: return number(double(drawing.transfer.scale.r));
    case RT_GREEN_SCALE: return number(double(drawing.transfer.scale.g));
    case RT_BLUE_SCALE: return number(double(drawing.transfer.scale.b));
    case RT_ALPHA_SCALE: return number(double(drawing.transfer.scale.a));
    case RT_RED_BIAS: return number(double(drawing.transfer.bias.r));
    case RT_GREEN_BIAS: return number(double(drawing.transfer.bias.g));
    case RT_BLUE_BIAS: return number(double(drawing.transfer.bias.b));
    case RT_ALPHA_BIAS: return number(double(drawing.transfer.bias.a));
    case RT_DEPTH_SCALE: return number(1);
    case RT_DEPTH_BIAS:
    case RT_MAP_COLOR:
    case RT_MAP_STENCIL:
    case RT_INDEX_SHIFT:
    case RT_INDEX_OFFSET: return number(0);
    default: return rasterValue(drawing.raster, recorder.textureUnit(), name);
    }
}

} // namespace smart::compat

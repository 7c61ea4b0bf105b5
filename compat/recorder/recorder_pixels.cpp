// SPDX-License-Identifier: MIT
// The raster position, and what is drawn there.
#include <algorithm>
#include <cmath>
#include <utility>

#include "compat/recorder/recorder.h"
#include "libsmart/render/line_raster.h"
#include "libsmart/render/window_vertex.h"

namespace smart::compat {

namespace {

/// The lower or left side of the pixel that a window coordinate lies in.
double pixelOf(double coordinate) {
    return std::floor(double(toSubpixels(coordinate)) / kSubpixels);
}

glm::vec4 clampedToUnit(const glm::vec4& color) {
    return glm::clamp(color, glm::vec4(0.0f), glm::vec4(1.0f));
}

bool canBeSeen(const glm::dvec2& window) {
    for (int k = 0; k < 2; ++k)
        if (!(window[k] > kWindowMin && window[k] < kWindowMax)) return false;
    return true;
}

} // namespace

void Recorder::setRasterPosition(const glm::dvec4& position) {
    requireOutsideObject();
    const FixedStatePtr block = looseState();
    const FixedState start;
    const FixedState& state = block ? *block : start;

    const glm::dvec4 eye = matrices_.modelView() * position;
    FixedVertex vertex;
    vertex.position = eye.w == 1.0 ? glm::dvec3(eye) : glm::dvec3(eye) / eye.w;
    vertex.objectPosition = glm::dvec4(vertex.position, 1.0); // as loose geometry is kept
    vertex.normal = looseNormalMatrix() * glm::dvec3(attributes_.normal);
    vertex.color = attributes_.color;
    vertex.texCoord = attributes_.texCoord;
    vertex.moreTexCoords = attributes_.moreTexCoords;
    vertex.fogCoordinate = attributes_.fogCoordinate;
    vertex.secondaryColor = glm::vec3(attributes_.secondaryColor);
    const FixedMaterials materialsNow = materials();
    vertex.materials = &materialsNow;

    RasterPosition& raster = pixelDrawing_.raster;
    const ClipVertex clip{matrices_.projection() * eye, vertex.position,
                          litVertex(state, vertex, false)};
    raster.valid = clip.isFinite() && ClipVolume(&state).contains(clip);
    if (!raster.valid) return;
    const FrameSettings& settings = frameSettings_;
    const WindowVertex window = WindowTransform(viewportNow(), settings.depthNear,
                                                settings.depthFar)(clip);
    raster.window = {window.at, window.depth};
    raster.clipW = clip.clip.w;
    raster.lit = clip.lit;
    if (!state.lighting.enabled) // even where nothing adds it now
        raster.lit.secondary = clampedToUnit(attributes_.secondaryColor);
    // Of all units, whether they have a texture or not.
    vertex.objectPosition = position;
    const FixedState& units = fixedState_.state();
    for (std::size_t unit = 0; unit < kTextureUnits; ++unit) {
        FixedTexture texture = unit == 0                           ? units.texture
                               : unit <= units.moreTextures.size() ? units.moreTextures[unit - 1]
                                                                   : FixedTexture();
        texture.matrix = matrices_.textureStack(unit).top();
        (unit == 0 ? raster.lit.texCoord : raster.lit.moreTexCoords[unit - 1]) =
            transformedTexCoord(state, texture, vertex, attributes_.texCoordOf(unit));
    }
    if (!state.fog.fromCoordinate) raster.lit.fogDistance = float(std::fabs(vertex.position.z));
}

void Recorder::setWindowPosition(const glm::dvec3& position) {
    requireOutsideObject();
    RasterPosition raster;
    const double depth = position.z > 0.0 ? std::min(position.z, 1.0) : 0.0;
    const double near = frameSettings_.depthNear, far = frameSettings_.depthFar;
    raster.window = {position.x, position.y, near + depth * (far - near)};
    raster.lit.primary = clampedToUnit(attributes_.color);
    raster.lit.texCoord = attributes_.texCoord;
    raster.lit.moreTexCoords = attributes_.moreTexCoords;
    raster.lit.secondary = clampedToUnit(attributes_.secondaryColor);
    if (fixedState_.state().fog.fromCoordinate) raster.lit.fogDistance = attributes_.fogCoordinate;
    pixelDrawing_.raster = raster;
}

void Recorder::drawBitmap(std::shared_ptr<const ImagePixels> bitmap, const glm::dvec2& origin,
                          const glm::dvec2& move) {
    requireOutsideObject();
    RasterPosition& raster = pixelDrawing_.raster;
    if (!raster.valid) return;
    const glm::dvec2 corner = glm::dvec2(raster.window) - origin;
    if (bitmap && canBeSeen(corner)) {
        WindowImage image;
        image.pixels = std::move(bitmap);
        image.corner = {pixelOf(corner.x), pixelOf(corner.y)};
        addImage(std::move(image));
    }
    raster.window += glm::dvec3(move, 0.0);
}

void Recorder::drawPixels(std::shared_ptr<const ImagePixels> pixels) {
    requireOutsideObject();
    const RasterPosition& raster = pixelDrawing_.raster;
    if (!raster.valid || !canBeSeen(raster.window)) return;
    WindowImage image;
    image.pixels = std::move(pixels);
    image.corner = raster.window;
    image.zoom = pixelDrawing_.zoom;
    image.scale = pixelDrawing_.transfer.scale;
    image.bias = pixelDrawing_.transfer.bias;
    addImage(std::move(image));
}

void Recorder::addImage(WindowImage image) {
    image.depth = float(pixelDrawing_.raster.window.z);
    image.lit = pixelDrawing_.raster.lit;
    auto placed = std::make_shared<const WindowImage>(std::move(image));
    openLooseRun();
    scene().loose.addImage(std::move(placed));
    ++scene().additions;
}

} // namespace smart::compat

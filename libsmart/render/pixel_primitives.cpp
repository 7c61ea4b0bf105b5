// SPDX-License-Identifier: MIT
#include "libsmart/render/pixel_primitives.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "libsmart/base/fp_environment.h"
#include "libsmart/render/image_raster.h"
#include "libsmart/render/line_raster.h"
#include "libsmart/render/point_raster.h"
#include "libsmart/render/sampling.h"

namespace smart {
namespace {

struct PixelRange {
    double low, high;
};

/// Tiles of a picture from one to another, both included.
struct TileRange {
    uint32_t first, last;
    bool empty;
};
TileRange tilesOf(const PixelRange& pixels, uint32_t count) {
    const double first = std::floor(pixels.low / kTileSize);
    const double last = std::floor(pixels.high / kTileSize);
    if (!(last >= 0.0) || !(first < count)) return {0, 0, true};
    return {uint32_t(std::max(first, 0.0)), uint32_t(std::min(last, count - 1.0)), false};
}

const FixedRaster& rasterOf(const FixedState* state) {
    static const FixedRaster start;
    return state ? state->raster : start;
}

/// Pixels beyond the line between two vertices that it may cover.
double reachOf(float width) {
    return limitedSize(width) / 2 + 2.0;
}

template <class Add>
void forEachTileOf(const PixelRange& x, const PixelRange& y, uint32_t columns, uint32_t rows,
                   Add&& add) {
    const TileRange across = tilesOf(x, columns), up = tilesOf(y, rows);
    if (across.empty || up.empty) return;
    for (uint32_t row = up.first; row <= up.last; ++row)
        for (uint32_t column = across.first; column <= across.last; ++column) add(column, row);
}

// Column by column of tiles, or row by row where the line is steep.
template <class Add>
void forEachTileOfLine(const PixelItems::Line& line, uint32_t columns, uint32_t rows, Add&& add) {
    const glm::dvec2 a = line.from.at, b = line.to.at, run = b - a;
    const int major = std::abs(run.y) > std::abs(run.x) ? 1 : 0, minor = 1 - major;
    const double reach = reachOf(rasterOf(line.state).lineWidth);
    const PixelRange whole{std::min(a[major], b[major]) - reach,
                           std::max(a[major], b[major]) + reach};
    const TileRange tiles = tilesOf(whole, major == 0 ? columns : rows);
    if (tiles.empty) return;
    const double slope = run[major] == 0.0 ? 0.0 : run[minor] / run[major];
    for (uint32_t tile = tiles.first; tile <= tiles.last; ++tile) {
        const auto minorAt = [&](double place) {
            const double at = std::min(std::max(place, whole.low), whole.high);
            return a[minor] + slope * (at - a[major]);
        };
        const double one = minorAt(double(tile) * kTileSize);
        const double other = minorAt((double(tile) + 1.0) * kTileSize);
        const TileRange hit = tilesOf({std::min(one, other) - reach, std::max(one, other) + reach},
                                      major == 0 ? rows : columns);
        if (hit.empty) continue;
        for (uint32_t i = hit.first; i <= hit.last; ++i)
            major == 0 ? add(tile, i) : add(i, tile);
    }
}

TileBins sortIntoTiles(const PixelItems& items, uint32_t width, uint32_t height) {
    const uint32_t columns = (width + kTileSize - 1) / kTileSize;
    const uint32_t rows = (height + kTileSize - 1) / kTileSize;
    return TileBins(width, height, [&](auto&& addThing) {
        for (uint32_t number = 0; number < items.items.size(); ++number) {
            const auto add = [&](uint32_t column, uint32_t row) {
                addThing(number, column, row);
            };
            const auto [kind, index] = items.items[number];
            if (kind == PixelItems::Kind::Line) {
                forEachTileOfLine(items.lines[index], columns, rows, add);
            } else if (kind == PixelItems::Kind::Point) {
                const PixelItems::Point& point = items.points[index];
                const double reach = reachOf(
                    std::max(point.size, rasterOf(point.state).pointFadeThreshold));
                const glm::dvec2 at = point.at.at;
                forEachTileOf({at.x - reach, at.x + reach}, {at.y - reach, at.y + reach}, columns,
                              rows, add);
            } else {
                const ImageCoverage image(*items.images[index].image);
                const PixelBox& box = image.box();
                if (box.xLow < box.xHigh && box.yLow < box.yHigh)
                    forEachTileOf({double(box.xLow), double(box.xHigh) - 1.0},
                                  {double(box.yLow), double(box.yHigh) - 1.0}, columns, rows, add);
            }
        }
    });
}

/// Distances in texels between the texture coordinates of neighbouring pixels, by texture unit.
using Texels = std::array<double, kTextureUnits>;

/// Those of a line.
Texels texelsOf(const PixelItems::Line& line, double length) {
    Texels texels{};
    if (!line.state || !(length > 0.0)) return texels;
    const auto measure = [&](std::size_t unit, const FixedTexture& texture, const glm::vec4& a) {
        const TextureImage& image = texture.image->levels().first();
        const LitVertex& end = line.to.lit;
        const glm::vec4& b = unit == 0 ? end.texCoord : end.moreTexCoords[unit - 1];
        const auto place = [&](const glm::vec4& c) {
            return glm::dvec2(double(c.x) / c.w * image.width(),
                              double(c.y) / c.w * image.height());
        };
        const glm::dvec2 difference = place(b) - place(a);
        const double distance =
            std::sqrt(difference.x * difference.x + difference.y * difference.y) / length;
        texels[unit] = std::isfinite(distance) ? distance : 0.0;
    };
    forEachTexture(*line.state, line.from.lit, measure);
    return texels;
}

/// Appends the fragments of one tile.
class TileCover {
public:
    TileCover(const Frame& layer, const Tile& tile, std::vector<PixelFragment>& out)
        : samples_(std::max(layer.samples, 1u)), seed_(layer.seed), tile_(tile), out_(out) {}

    void add(const PixelItems::Point& point) {
        const FixedRaster& raster = rasterOf(point.state);
        glm::vec4 color = colorOf(point.state, point.at.lit, {});
        float size = point.size;
        if (samples_ > 1 && size < raster.pointFadeThreshold) { // equation 3.2
            const float share = size / raster.pointFadeThreshold;
            color.a *= share * share;
            size = raster.pointFadeThreshold;
        }
        const auto put = [&](uint32_t x, uint32_t y, double coverage, uint64_t samples) {
            emit(point, x, y, point.at.depth, color, coverage, samples);
        };
        if (samples_ == 1 && !raster.pointSmooth) {
            pointSquare(point.at.at, size)
                .forEach(tile_, [&](uint32_t x, uint32_t y) { put(x, y, 1.0, kAllSamples); });
            return;
        }
        const PointDisc disc(point.at.at, size);
        disc.box().forEach(tile_, [&](uint32_t x, uint32_t y) {
            if (samples_ == 1)
                put(x, y, disc.coverage(x, y), kAllSamples);
            else
                put(x, y, 1.0, samplesInside(disc, x, y));
        });
    }

    void add(const PixelItems::Line& line) {
        const FixedRaster& raster = rasterOf(line.state);
        const glm::dvec2 run = line.to.at - line.from.at;
        const double squared = run.x * run.x + run.y * run.y;
        if (!(squared > 0.0)) return;
        const Texels texels = texelsOf(line, std::sqrt(squared));
        const auto put = [&](uint32_t x, uint32_t y, double coverage, uint64_t samples) {
            const glm::dvec2 offset = glm::dvec2(x + 0.5, y + 0.5) - line.from.at;
            const double share =
                std::clamp((offset.x * run.x + offset.y * run.y) / squared, 0.0, 1.0);
            emit(line, x, y, depthBetween(line.from, line.to, share),
                 colorOf(line.state, litBetween(line.from, line.to, share), texels), coverage,
                 samples);
        };
        if (samples_ == 1 && !raster.lineSmooth) {
            LineCoverage(line.from.at, line.to.at, wholePixels(raster.lineWidth))
                .forEach(tile_, [&](uint32_t x, uint32_t y, uint32_t step) {
                    if (!stippledAway(raster, line.stippleStart + step))
                        put(x, y, 1.0, kAllSamples);
                });
            return;
        }
        const LineRectangle rectangle(line.from.at, line.to.at, limitedSize(raster.lineWidth));
        rectangle.forEach(tile_, [&](uint32_t x, uint32_t y) {
            const double along = rectangle.along({x + 0.5, y + 0.5});
            if (stippledAway(raster, line.stippleStart + uint32_t(std::max(along, 0.0)))) return;
            if (samples_ == 1)
                put(x, y, rectangle.coverage(x, y), kAllSamples);
            else
                put(x, y, 1.0, samplesInside(rectangle, x, y));
        });
    }

    void add(const PixelItems::Image& item) {
        const WindowImage& image = *item.image;
        const ImagePixels& pixels = *image.pixels;
        LitVertex lit = image.lit;
        const glm::vec4 one = pixels.bitmap ? colorOf(item.state, lit, {}) : glm::vec4(0.0f);
        ImageCoverage(image).forEach(tile_, [&](uint32_t x, uint32_t y, uint32_t i, uint32_t j) {
            if (pixels.bitmap) {
                if (pixels.bit(i, j)) emit(item, x, y, image.depth, one, 1.0, kAllSamples);
                return;
            }
            const glm::vec4 color = pixels.color(i, j) * image.scale + image.bias;
            for (int k = 0; k < 4; ++k)
                lit.primary[k] = color[k] > 0.0f ? std::min(color[k], 1.0f) : 0.0f;
            emit(item, x, y, image.depth, colorOf(item.state, lit, {}), 1.0, kAllSamples);
        });
    }

private:
    static constexpr uint64_t kAllSamples = ~uint64_t(0);

    static bool stippledAway(const FixedRaster& raster, uint32_t step) {
        if (!raster.lineStippled) return false;
        const uint32_t bit = step / uint32_t(std::max(raster.lineFactor, 1)) % 16;
        return (raster.linePattern >> bit & 1u) == 0;
    }

    static glm::vec4 colorOf(const FixedState* state, const LitVertex& lit, const Texels& texels) {
        if (!state) return lit.primary;
        glm::vec4 memory[kTextureUnits];
        return fragmentColor(*state, lit, fixedTexels(*state, lit, texels.data(), memory));
    }

    template <class Shape>
    uint64_t samplesInside(const Shape& shape, uint32_t x, uint32_t y) const {
        uint64_t inside = 0;
        for (uint32_t i = 0; i < std::min(samples_, 64u); ++i) {
            const glm::vec2 at = samplePosition(x, y, seed_, i, samples_);
            if (shape.contains({double(x) + at.x, double(y) + at.y})) inside |= uint64_t(1) << i;
        }
        return inside;
    }

    void emit(const PixelItems::Common& item, uint32_t x, uint32_t y, double depth,
              glm::vec4 color, double coverage, uint64_t samples) {
        if (!(coverage > 0.0) || samples == 0) return;
        color.a *= float(coverage);
        PixelFragment& added = out_.emplace_back();
        added.entry = uint16_t((y - tile_.y) * kTileSize + (x - tile_.x));
        added.samples = samples;
        added.fragment.order = item.order;
        added.fragment.state = item.state;
        added.fragment.depth = depth > 0.0 ? float(std::min(depth, 1.0)) : 0.0f;
        added.fragment.color = color;
    }

    const uint32_t samples_, seed_;
    const Tile& tile_;
    std::vector<PixelFragment>& out_;
};

} // namespace

PixelPrimitives::PixelPrimitives(const Frame& layer) {
    layer_.scene = layer.scene;
    layer_.camera = layer.camera;
    layer_.matrixCamera = layer.matrixCamera;
    layer_.viewport = layer.viewport;
    layer_.depthNear = layer.depthNear;
    layer_.depthFar = layer.depthFar;
    layer_.samples = layer.samples;
    layer_.seed = layer.seed;
    layer_.target.width = layer.target.width;
    layer_.target.height = layer.target.height;
}

std::shared_ptr<const PixelPrimitives> PixelPrimitives::make(const Frame& layer) {
    if (!drawsPixels(*layer.scene)) return nullptr;
    return std::shared_ptr<const PixelPrimitives>(new PixelPrimitives(layer));
}

const PixelPrimitives::Prepared& PixelPrimitives::prepared() const {
    std::call_once(once_, [this] {
        const FpEnvironment standard;
        PixelItems items = assemblePixels(layer_);
        TileBins bins = sortIntoTiles(items, layer_.target.width, layer_.target.height);
        prepared_.emplace(Prepared{std::move(items), std::move(bins)});
    });
    return *prepared_;
}

void PixelPrimitives::cover(const Tile& tile, std::vector<PixelFragment>& fragments) const {
    const Prepared& all = prepared();
    const uint32_t column = tile.x / kTileSize, row = tile.y / kTileSize;
    if (column >= all.bins.columns() || row >= all.bins.rows()) return;
    TileCover cover(layer_, tile, fragments);
    for (const uint32_t number : all.bins.of(column, row)) {
        const auto [kind, index] = all.items.items[number];
        switch (kind) {
        case PixelItems::Kind::Point: cover.add(all.items.points[index]); break;
        case PixelItems::Kind::Line: cover.add(all.items.lines[index]); break;
        case PixelItems::Kind::Image: cover.add(all.items.images[index]); break;
        }
    }
}

} // namespace smart

// SPDX-License-Identifier: MIT
#include "libsmart/render/layer_pass.h"

#include <algorithm>
#include <bit>
#include <iterator>
#include <limits>

#include "libsmart/render/tile_rays.h"

namespace smart {
namespace {

/// PixelValue::source of a pixel in which the layer has shown nothing so far.
constexpr uint32_t kUnseen = PixelValue::kNoSource - 1;

} // namespace

LayerPass::LayerPass(const Frame& layer, bool lowest, const Tile& tile, TilePixels& pixels,
                     LayeredPixels& memory, ShadingForm form)
    : layer_(layer),
      needs_(layer.needs()),
      lowest_(lowest),
      keepsNormals_(layer.target.aux.normal != nullptr),
      tile_(tile),
      pixels_(pixels),
      memory_(memory),
      camera_(layer),
      raster_(layer),
      services_(layer, pixels, form) {
    pass_->surfaces.clear();
}

void LayerPass::draw(uint32_t sample, uint32_t samples) {
    sample_ = sample;
    samples_ = samples;
    coverPixels();
    for (uint32_t packet = 0; packet < tile_order::kPackets; packet += kTilePackets)
        drawBlock(packet);
}

void LayerPass::coverPixels() {
    std::vector<PixelFragment>& covered = pass_->covered;
    covered.clear();
    if (!layer_.primitives) return;
    layer_.primitives->cover(tile_, covered);
    std::erase_if(covered, [this](const PixelFragment& pixel) {
        return (pixel.samples >> (sample_ % 64) & 1u) == 0;
    });
    std::stable_sort(covered.begin(), covered.end(),
                     [](const PixelFragment& a, const PixelFragment& b) {
                         return a.entry != b.entry ? a.entry < b.entry
                                                   : a.fragment.order < b.fragment.order;
                     });
}

std::span<const PixelFragment> LayerPass::coveredAt(uint32_t entry) const {
    const std::vector<PixelFragment>& covered = pass_->covered;
    if (covered.empty()) return {};
    const auto first = std::partition_point(
        covered.begin(), covered.end(),
        [&](const PixelFragment& pixel) { return pixel.entry < entry; });
    const auto end = std::find_if(first, covered.end(), [&](const PixelFragment& pixel) {
        return pixel.entry != entry;
    });
    return {first, end};
}

void LayerPass::drawBlock(uint32_t packet) {
    LayerPassMemory& pass = *pass_;
    const auto select = [&](uint32_t i) {
        rays_ = &pass.rays.groups[i];
        of_ = &pass.lanes[i];
    };
    uint32_t active[kTilePackets], some = 0;
    for (uint32_t i = 0; i < kTilePackets; ++i) {
        select(i);
        begin(packet + i);
        some |= active[i] = of_->active;
    }
    if (some != 0) services_.findTileHits(pass.rays, active);
    for (uint32_t i = 0; i < kTilePackets; ++i) {
        select(i);
        if (of_->open == 0) continue;
        gather(packet + i);
        shade(packet + i);
        merge(packet + i);
    }
}

void LayerPass::begin(uint32_t packet) {
    of_->open = of_->active = of_->all = 0;
    uint32_t inTile = 0, open = 0, seen = 0;
    for (uint32_t lane = 0; lane < kLanes; ++lane) {
        const uint32_t entry = tile_order::entryOf(packet * kLanes + lane);
        const uint32_t i = entry % kTileSize, j = entry / kTileSize;
        if (i >= tile_.width || j >= tile_.height) continue;
        const uint32_t x = tile_.x + i, y = tile_.y + j;
        inTile |= 1u << lane;
        if (!layer_.scissor || layer_.scissor->contains(x, y)) open |= 1u << lane;
        if (camera_.covers(x, y)) seen |= 1u << lane;
    }
    if (inTile == 0) return;
    if (layer_.renderingObject) {
        clear(packet, inTile);
        return drawPixelsOfObject(packet, open & seen);
    }
    const bool environment = lowest_ && layer_.environment;
    const uint32_t made = makeRays(packet, environment ? seen : seen & open);
    if (environment) showEnvironment(packet, made);
    clear(packet, inTile);
    of_->open = open;
    of_->active = made & open;
    if (pass_->covered.empty()) return;
    forEach(of_->active, [&](int lane) {
        if (needsAll(coveredAt(tile_order::entryOf(packet * kLanes + uint32_t(lane)))))
            of_->all |= 1u << lane;
    });
}

void LayerPass::clear(uint32_t packet, uint32_t lanes) {
    for (const BufferClear& clear : layer_.clears)
        forEach(lanes, [&](int lane) {
            const uint32_t entry = tile_order::entryOf(packet * kLanes + uint32_t(lane));
            const uint32_t x = tile_.x + entry % kTileSize, y = tile_.y + entry / kTileSize;
            if (clear.scissor && !clear.scissor->contains(x, y)) return;
            PixelValue& value = memory_.values[entry];
            for (int k = 0; k < 4; ++k)
                if (clear.colorMask[k]) value.color[k] = clear.color[k];
            if (!clear.depth) return;
            value.depth = *clear.depth;
            if (sample_ == 0) pixels_.setMiss(entry);
        });
}

uint32_t LayerPass::makeRays(uint32_t packet, uint32_t lanes) {
    double atX[kPacketSize] = {}, atY[kPacketSize] = {};
    forEach(lanes, [&](int lane) {
        const uint32_t entry = tile_order::entryOf(packet * kLanes + uint32_t(lane));
        const uint32_t x = tile_.x + entry % kTileSize, y = tile_.y + entry / kTileSize;
        of_->samples[lane] = PixelSample(x, y, sample_, layer_.seed);
        const glm::vec2 in = samplePosition(x, y, layer_.seed, sample_, samples_);
        atX[lane] = double(x) + in.x;
        atY[lane] = double(y) + in.y;
        of_->at[lane] = {atX[lane], atY[lane]};
        rays_->weight[lane] = 1.0f;
        rays_->sample[lane] = &of_->samples[lane];
    });
    const uint32_t active =
        lanes == 0 ? 0 : services_.makeCameraRays(camera_, atX, atY, lanes, *rays_);
    forEach(lanes & ~active, [&](int lane) {
        memory_.bad[tile_order::entryOf(packet * kLanes + uint32_t(lane))] = true;
    });
    pixels_.primaryRays += uint64_t(std::popcount(active));
    return active;
}

void LayerPass::showEnvironment(uint32_t packet, uint32_t active) {
    if (active == 0) return;
    glm::vec4 colors[kPacketSize];
    services_.shadeMisses(*rays_, active, colors);
    forEach(active, [&](int lane) {
        const uint32_t entry = tile_order::entryOf(packet * kLanes + uint32_t(lane));
        keepColor(entry, of_->samples[lane], colors[lane]);
        memory_.values[entry].color = colors[lane];
    });
}

// What a shader made of a pixel; black if it failed.
void LayerPass::keepColor(uint32_t entry, const PixelSample& sample, glm::vec4& color) {
    ShadedSample shaded;
    shaded.color = color;
    shaded.judge(sample);
    memory_.bad[entry] |= shaded.bad;
    color = shaded.color;
}

// A rendering object sees the nearest hits; its pixel is one fragment.
void LayerPass::drawPixelsOfObject(uint32_t packet, uint32_t lanes) {
    forEach(lanes, [&](int lane) {
        const uint32_t entry = tile_order::entryOf(packet * kLanes + uint32_t(lane));
        const PixelResult result =
            renderPixel(layer_, camera_, services_, tile_.x + entry % kTileSize,
                        tile_.y + entry / kTileSize);
        PixelValue& value = memory_.values[entry];
        memory_.bad[entry] |= result.bad;
        if (!result.hasFirst || result.first.instance == kNoId) {
            if (lowest_) value.color = result.color;
            return;
        }
        Fragment fragment;
        fragment.depth = camera_.depth(result.firstRay, result.first.distance);
        fragment.color = result.color;
        fragment.source = 0;
        value.source = kUnseen;
        replay({&fragment, 1}, value);
        if (value.source != fragment.source) return;
        const ShadedSample& first = result.first;
        pixels_.distance[entry] = first.distance;
        pixels_.normal[entry] = first.normal;
        pixels_.objectId[entry] = first.object;
        pixels_.instanceId[entry] = first.instance + layer_.firstInstance;
        pixels_.primitiveId[entry] = first.primitive;
    });
}

// Behind the nearest of opaque hits nothing matters, unless a pixel primitive that shows what is
// behind it takes the hit's place.
bool LayerPass::needsAll(std::span<const PixelFragment> covered) {
    return std::any_of(covered.begin(), covered.end(), [](const PixelFragment& pixel) {
        const FixedState* const state = pixel.fragment.state;
        return state && !state->isOpaque() && state->ops.depthTest && state->ops.depthMask;
    });
}

void LayerPass::gather(uint32_t packet) {
    LayerPassMemory& pass = *pass_;
    pass.hits.clear();
    pass.fragments.clear();
    collect();
    for (uint32_t lane = 0; lane < kLanes; ++lane) {
        const std::size_t first = pass.hits.size();
        if ((of_->active >> lane & 1u) && rays_->hasHit(int(lane))) gatherHits(lane);
        lanes_[lane].first = uint32_t(pass.fragments.size());
        if (of_->open >> lane & 1u)
            addFragments(first, tile_order::entryOf(packet * kLanes + lane));
        lanes_[lane].end = uint32_t(pass.fragments.size());
    }
}

void LayerPass::collect() {
    of_->alone = of_->limited = 0;
    RayPacket rays = rays_->rays;
    rays.active = 0;
    forEach(of_->active, [&](int lane) {
        if (!rays_->hasHit(lane)) return;
        const uint32_t bit = 1u << lane;
        if ((of_->all & bit) == 0) {
            const Hit nearest = rays_->hit(lane);
            const bool alone = needs_.collects
                                   ? decidesAlone(uint32_t(lane), nearest)
                                   : isDrawn(surfaceOf(nearest), nearest, uint32_t(lane));
            if (alone) {
                of_->alone |= bit;
                return;
            }
            const float far = farthestSeen(uint32_t(lane), nearest);
            if (needs_.collects && far < rays.tFar[lane]) {
                rays.tFar[lane] = far;
                of_->limited |= bit;
            }
        }
        rays.active |= bit;
    });
    if (rays.active != 0) services_.findAllHits(rays, pass_->met);
}

void LayerPass::gatherHits(uint32_t lane) {
    LayerPassMemory& pass = *pass_;
    const uint32_t bit = 1u << lane;
    if (((of_->alone | of_->limited) & bit) == 0) return keepHits(lane, pass.met.of(lane), true);
    const auto first = std::ptrdiff_t(pass.hits.size());
    if ((of_->alone & bit) != 0) {
        const Hit nearest = rays_->hit(int(lane));
        keepHits(lane, {&nearest, 1}, false);
    } else {
        keepHits(lane, pass.met.of(lane), false);
    }
    const auto begin = pass.hits.begin() + first;
    if (begin != pass.hits.end() &&
        std::all_of(begin, pass.hits.end(), [](const LayerHit& kept) { return kept.counts; }))
        return;
    pass.hits.erase(begin, pass.hits.end()); // the ray goes on
    RayPacket rays = rays_->rays;
    rays.active = bit;
    services_.findAllHits(rays, pass.beyond);
    keepHits(lane, pass.beyond.of(lane), true);
}

bool LayerPass::hidesOthers(uint32_t lane, const Hit& nearest) {
    if (!needs_.opaqueHides) return false;
    const LayerSurface& surface = surfaceOf(nearest);
    return (!surface.state || surface.state->isOpaque()) && isDrawn(surface, nearest, lane);
}

bool LayerPass::decidesAlone(uint32_t lane, const Hit& nearest) {
    // In eye space a place's coordinates are as large as its distance, which its rounding goes by.
    if (layer_.camera || !hidesOthers(lane, nearest)) return false;
    const Ray ray = rays_->ray(int(lane));
    glm::vec3 place;
    for (int k = 0; k < 3; ++k) place[k] = ray.org[k] + nearest.t * ray.dir[k];
    return needs_.isAlone(place);
}

float LayerPass::farthestSeen(uint32_t lane, const Hit& nearest) {
    // Hits as far away as that, but for rounding, are fragments of the same depth.
    constexpr float kBeyondEqual = 1.0f + 0x1p-14f;
    return hidesOthers(lane, nearest) ? nearest.t * kBeyondEqual
                                      : std::numeric_limits<float>::infinity();
}

void LayerPass::keepHits(uint32_t lane, std::span<const Hit> met, bool complete) {
    std::vector<LayerHit>& hits = pass_->hits;
    const std::size_t first = hits.size();
    for (const Hit& hit : met) {
        const LayerSurface& surface = surfaceOf(hit);
        LayerHit& kept = hits.emplace_back();
        kept.hit = hit;
        kept.lane = lane;
        kept.objectId = surface.objectId;
        kept.state = surface.state;
        kept.shader = surface.shader;
        kept.counts = isDrawn(surface, hit, lane);
        if (kept.counts) kept.depth = depthOf(surface, hit, lane);
    }
    keepOwned(std::span(hits).subspan(first), of_->at[lane], complete);
}

const LayerSurface& LayerPass::surfaceOf(const Hit& hit) {
    bool isNew = false;
    LayerSurface& surface = pass_->surfaces.find(hit, isNew);
    if (!isNew) return surface;
    surface = {};
    const HitChain chain = resolve(*layer_.scene, hit.path, hit.levels, hit.triangle);
    surface.triangle = RasterTriangle(chain);
    surface.plane = raster_.planeOf(surface.triangle);
    surface.state = chain.instances[0]->traits->state.get();
    surface.shader = services_.findSurface(hit);
    surface.objectId = chain.instances[chain.levels - 1]->objectId;
    if (!surface.state) return surface;
    const FixedRaster& raster = surface.state->raster;
    surface.hasHoles = raster.polygonStippled ||
                       std::any_of(std::begin(raster.clip), std::end(raster.clip),
                                   [](bool plane) { return plane; });
    if (!layer_.camera) surface.isShown = isShown(surface.triangle, *surface.state, Ray{});
    return surface;
}

// Culling and polygon mode.
bool LayerPass::isShown(const RasterTriangle& triangle, const FixedState& state,
                        const Ray& ray) const {
    const FixedRaster& raster = state.raster;
    const bool front = raster_.isCounterclockwise(triangle, ray) != raster.frontFaceClockwise;
    if (raster.cull && (raster.cullFace == FixedFace::FrontAndBack ||
                        (raster.cullFace == FixedFace::Front) == front))
        return false;
    return raster.polygonMode[front ? 0 : 1] == FixedPolygonMode::Fill;
}

// That, clip planes and stipple.
bool LayerPass::isDrawn(const LayerSurface& surface, const Hit& hit, uint32_t lane) const {
    if (!surface.state) return true;
    const bool shown = layer_.camera ? isShown(surface.triangle, *surface.state,
                                               rays_->ray(int(lane)))
                                     : surface.isShown;
    if (!shown) return false;
    if (!surface.hasHoles) return true;
    const FixedRaster& raster = surface.state->raster;
    const double u = hit.u, v = hit.v;
    const glm::dvec3(&corners)[3] = surface.triangle.corners;
    const glm::dvec3 point = (1.0 - u - v) * corners[0] + u * corners[1] + v * corners[2];
    for (int i = 0; i < kFixedClipPlanes; ++i)
        if (raster.clip[i] && glm::dot(raster.clipPlane[i], glm::dvec4(point, 1.0)) < 0.0)
            return false;
    if (!raster.polygonStippled) return true;
    const PixelSample& pixel = of_->samples[lane];
    return (raster.polygonStipple[pixel.y % 32] >> (31 - pixel.x % 32) & 1u) != 0;
}

float LayerPass::depthOf(const LayerSurface& surface, const Hit& hit, uint32_t lane) const {
    PolygonRaster::Depth depth{0.0, 0.0};
    if (surface.plane.hasDepth)
        depth = raster_.depthAt(surface.plane, of_->at[lane]);
    else
        depth.window = camera_.depth(rays_->ray(int(lane)), hit.t);
    if (surface.state && surface.state->raster.offsetFill)
        depth.window += double(surface.state->raster.offsetFactor) * depth.slope +
                        double(surface.state->raster.offsetUnits) * kDepthUnit;
    return depth.window > 0.0 ? float(std::min(depth.window, 1.0)) : 0.0f;
}

void LayerPass::addFragments(std::size_t firstHit, uint32_t entry) {
    LayerPassMemory& pass = *pass_;
    const std::size_t start = pass.fragments.size();
    for (std::size_t i = firstHit; i < pass.hits.size(); ++i) {
        const LayerHit& kept = pass.hits[i];
        if (!kept.counts) continue;
        Fragment& fragment = pass.fragments.emplace_back();
        fragment.order = orderOfInstance(
            kept.hit.path[0],
            kept.hit.levels == 1 ? kept.hit.triangle : kFirstNested + uint32_t(i - firstHit));
        fragment.state = kept.state;
        fragment.source = uint32_t(i);
        fragment.depth = kept.depth;
    }
    const std::span<const PixelFragment> covered = coveredAt(entry);
    for (const PixelFragment& pixel : covered) {
        pass.fragments.push_back(pixel.fragment);
        pass.fragments.back().source = PixelValue::kNoSource;
    }
    if (!covered.empty())
        std::stable_sort(pass.fragments.begin() + std::ptrdiff_t(start), pass.fragments.end(),
                         [](const Fragment& a, const Fragment& b) { return a.order < b.order; });
}

void LayerPass::shade(uint32_t packet) {
    LayerPassMemory& pass = *pass_;
    pass.wanted.clear();
    for (uint32_t lane = 0; lane < kLanes; ++lane) {
        const uint32_t first = lanes_[lane].first, count = lanes_[lane].end - first;
        if (count == 0) continue;
        const std::span<const Fragment> fragments(&pass.fragments[first], count);
        pass.needed.resize(std::max<std::size_t>(pass.needed.size(), count));
        const uint32_t entry = tile_order::entryOf(packet * kLanes + lane);
        findNeeded(fragments, memory_.values[entry].depth, pass.needed.data());
        for (uint32_t i = 0; i < count; ++i) {
            Fragment& fragment = pass.fragments[first + i];
            if (!pass.needed[i] || fragment.source == PixelValue::kNoSource) continue;
            const LayerHit& kept = pass.hits[fragment.source];
            if (!keepsNormals_ && services_.shadeAlone(rays_->ray(int(lane)), kept.hit, kept.shader,
                                                       fragment.color))
                keepColor(entry, of_->samples[lane], fragment.color);
            else
                pass.wanted.push_back({first + i, entry, kept.shader});
        }
    }
    // Sixteen at a time, shader by shader in the order in which they are first met.
    while (!pass.wanted.empty()) {
        const ShaderObject* const surface = pass.wanted.front().surface;
        WantedColor chosen[kPacketSize];
        uint32_t count = 0;
        std::erase_if(pass.wanted, [&](const WantedColor& wanted) {
            if (wanted.surface != surface || count == kLanes) return false;
            chosen[count++] = wanted;
            return true;
        });
        shadeGroup(surface, {chosen, count});
    }
}

void LayerPass::shadeGroup(const ShaderObject* surface, std::span<const WantedColor> wanted) {
    LayerPassMemory& pass = *pass_;
    LoneRayGroup group;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const LayerHit& kept = pass.hits[pass.fragments[wanted[i].fragment].source];
        group.copyLane(int(i), *rays_, int(kept.lane));
        group.setHit(int(i), kept.hit);
    }
    const auto lanes = uint32_t((uint64_t(1) << wanted.size()) - 1);
    glm::vec4 colors[kPacketSize];
    ShadedSample found[kPacketSize];
    const bool describes = keepsNormals_ && sample_ == 0;
    services_.shadeGroup(surface, {&group, lanes, colors, describes ? found : nullptr});
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        Fragment& fragment = pass.fragments[wanted[i].fragment];
        LayerHit& kept = pass.hits[fragment.source];
        keepColor(wanted[i].entry, of_->samples[kept.lane], colors[i]);
        fragment.color = colors[i];
        kept.normal = found[i].normal;
    }
}

void LayerPass::merge(uint32_t packet) {
    const LayerPassMemory& pass = *pass_;
    forEach(of_->open, [&](int lane) {
        const LaneRange range = lanes_[lane];
        if (range.first == range.end) return;
        const uint32_t entry = tile_order::entryOf(packet * kLanes + uint32_t(lane));
        PixelValue& value = memory_.values[entry];
        const glm::vec4 before = value.color;
        value.source = kUnseen;
        replay({&pass.fragments[range.first], range.end - range.first}, value);
        if (!layer_.drawsColor) value.color = before;
        if (sample_ != 0 || value.source == kUnseen) return;
        if (value.source == PixelValue::kNoSource)
            pixels_.setMiss(entry);
        else
            storeFirst(entry, pass.hits[value.source]);
    });
}

void LayerPass::storeFirst(uint32_t entry, const LayerHit& kept) {
    pixels_.distance[entry] = kept.hit.t;
    pixels_.normal[entry] = kept.normal;
    pixels_.objectId[entry] = kept.objectId;
    pixels_.instanceId[entry] = kept.hit.path[0] + layer_.firstInstance;
    pixels_.primitiveId[entry] = kept.hit.triangle;
}

} // namespace smart

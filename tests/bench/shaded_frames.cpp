// SPDX-License-Identifier: MIT
#include "tests/bench/shaded_frames.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstring>
#include <ctime>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <iomanip>
#include <thread>

#include "libsmart/render/tile_order.h"
#include "libsmart/render/tracers.h"
#include "libsmart/shading/fixed_state.h"
#include "libsmart/shading/shader_registry.h"
#include "tests/bench/openrt_engine.h"

namespace smart::bench {
namespace {

using Pixels = std::vector<glm::vec4>;

template <class T>
std::vector<std::byte> bytesOf(const T& value) {
    std::vector<std::byte> bytes(sizeof value);
    std::memcpy(bytes.data(), &value, sizeof value);
    return bytes;
}

std::shared_ptr<const ShaderObject> pointLight(const View& view) {
    const ShaderClassPtr light = findBuiltinClass("PointLight");
    glm::vec3 position(0.0f);
    double squared = 0;
    for (int k = 0; k < 3; ++k) {
        position[k] = float(view.light[k]);
        squared += std::pow(view.light[k] - view.camera.target[k], 2);
    }
    const ParameterValues values{
        {uint32_t(light->findParameter("position")), bytesOf(position)},
        {uint32_t(light->findParameter("radiance")), bytesOf(glm::vec3(float(squared)))}};
    return std::make_shared<const ShaderObject>(light, values);
}

/// The scene, every instance with a state block that lights it by the view's light.
ScenePtr litByFixedFunction(const Scene& scene, const View& view) {
    auto state = std::make_shared<FixedState>();
    state->lighting.enabled = state->lighting.shadows = true;
    FixedLight& light = state->lighting.lights[0];
    light.enabled = true;
    for (int k = 0; k < 3; ++k) light.position[k] = float(view.light[k]);
    light.position.w = 1.0f;
    state->ops.depthTest = true;
    InstanceList instances;
    for (const InstanceView& placed : scene.group().instances()) {
        Instance instance = asGiven(placed);
        instance.state = state;
        instances.add(std::move(instance));
    }
    return std::make_shared<const Scene>(std::move(instances), scene.precision(), 1);
}

constexpr const char* kFixedFunctionLighting = "fixed function, lit, with shadows";

/// A frame and the memory that it is written to.
struct Shot {
    Frame frame;
    Pixels pixels;

    Shot(const ScenePtr& scene, const std::string& surface, const View& view, uint32_t size)
        : pixels(std::size_t(size) * size) {
        const bool fixed = surface == kFixedFunctionLighting;
        frame.scene = fixed ? litByFixedFunction(*scene, view) : scene;
        frame.shaders = std::make_shared<const ShaderTable>(
            ShaderTable{std::make_shared<const ShaderObject>(
                findBuiltinClass(fixed ? "FixedFunction" : surface), ParameterValues())});
        frame.lights = {pointLight(view)};
        const auto vector = [](const double (&v)[3]) { return glm::dvec3(v[0], v[1], v[2]); };
        const test::CameraPose& pose = view.camera;
        const glm::dvec3 eye = vector(pose.eye), target = vector(pose.target);
        const double distance = glm::length(target - eye);
        const glm::dmat4 matrix =
            glm::perspective(glm::radians(pose.fov), 1.0, distance * 1e-3, distance * 1e3) *
            glm::lookAt(eye, target, vector(pose.up));
        frame.matrixCamera = {matrix, glm::inverse(matrix)};
        frame.viewport = {0, 0, size, size};
        frame.target.memory = pixels.data();
        frame.target.width = frame.target.height = size;
        frame.target.format = PixelFormat::Rgba32f;
    }
};

/// Makes and traces the camera rays of tiles, and shades nothing.
class RaysOnly final : public Tracer {
public:
    void render(const Frame& frame, const Tile& tile, TilePixels& pixels) const override {
        ShadingServices services(frame, pixels);
        const CameraRays camera(frame);
        std::size_t found = 0;
        for (uint32_t block = 0; block < tile_order::kPackets; block += kTilePackets) {
            RayBlock rays;
            uint32_t lanes[kTilePackets];
            for (uint32_t p = 0; p < kTilePackets; ++p) {
                const tile_order::Corner corner = tile_order::cornerOf(block + p);
                double x[kPacketSize], y[kPacketSize];
                uint32_t inside = 0;
                for (uint32_t lane = 0; lane < uint32_t(kPacketSize); ++lane) {
                    const uint32_t i = corner.x + lane % tile_order::kPacketSide;
                    const uint32_t j = corner.y + lane / tile_order::kPacketSide;
                    if (i < tile.width && j < tile.height) inside |= 1u << lane;
                    x[lane] = tile.x + i + 0.5;
                    y[lane] = tile.y + j + 0.5;
                }
                lanes[p] = services.makeCameraRays(camera, x, y, inside, rays.groups[p]);
            }
            services.findTileHits(rays, lanes);
            for (uint32_t p = 0; p < kTilePackets; ++p)
                forEach(lanes[p], [&](int lane) { found += rays.groups[p].hasHit(lane); });
        }
        hits += found;
    }

    mutable std::atomic<std::size_t> hits{0};
};

/// Seconds that `threads` take for items 0 to count, which are handed out one by one.
template <class Work>
double timed(std::size_t count, unsigned threads, const Work& work) {
    std::atomic<std::size_t> next{0};
    const auto share = [&] {
        const auto pixels = std::make_unique<TilePixels>();
        for (std::size_t i = next++; i < count; i = next++) work(i, *pixels);
    };
    const std::clock_t processor = std::clock();
    const auto clock = std::chrono::steady_clock::now();
    std::vector<std::jthread> team;
    for (unsigned i = 1; i < threads; ++i) team.emplace_back(share);
    share();
    team.clear();
    if (threads == 1) return double(std::clock() - processor) / CLOCKS_PER_SEC;
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - clock).count();
}

/// For all tiles of a frame.
double timed(const Tracer& tracer, const Frame& frame, unsigned threads, bool write,
             std::atomic<std::size_t>& shadowRays) {
    const std::vector<Tile> tiles = mortonTiles(frame.target.width, frame.target.height);
    return timed(tiles.size(), threads, [&](std::size_t i, TilePixels& pixels) {
        pixels.shadowRays = 0;
        tracer.render(frame, tiles[i], pixels);
        shadowRays += pixels.shadowRays;
        if (write) writeTile(frame.target, tiles[i], pixels);
    });
}

/// The rays of a frame, packed.
struct PackedRays {
    RaySet primary, shadow;
};

double timed(const PackedRays& rays, const Scene& scene, bool shadows, unsigned threads) {
    const KernelTable& table = kernels();
    const auto mode = std::size_t(scene.precision());
    const auto trace = [&](const RaySet& set, const auto& kernel) {
        constexpr std::size_t kChunk = 16 * kTilePackets;
        const std::size_t count = set.packets.size();
        return timed((count + kChunk - 1) / kChunk, threads, [&](std::size_t i, TilePixels&) {
            const std::size_t end = std::min((i + 1) * kChunk, count);
            for (std::size_t p = i * kChunk; p < end; p += kTilePackets)
                kernel(&set.packets[p], uint32_t(std::min<std::size_t>(kTilePackets, end - p)));
        });
    };
    double seconds = trace(rays.primary, [&](const RayPacket* packets, uint32_t count) {
        HitPacket found[kTilePackets];
        table.intersectTile[mode](scene.view(), packets, count, found);
    });
    if (shadows)
        seconds += trace(rays.shadow, [&](const RayPacket* packets, uint32_t count) {
            uint32_t blocked[kTilePackets];
            table.occludedTile[mode](scene.view(), packets, count, blocked);
        });
    return seconds;
}

double least(const std::vector<double>& values) {
    return *std::min_element(values.begin(), values.end());
}

FrameSeries measureSurface(const ScenePtr& scene, const std::string& surface,
                           const PackedRays& rays, const View& view, uint32_t size,
                           unsigned threads, unsigned repeats, const Progress& progress) {
    Shot shot(scene, surface, view, size);
    const PacketTracer<> points(ShadingForm::Points), packets(ShadingForm::Packets);
    const FrameShading& shading = shot.frame.shading();
    const RaysOnly raysOnly;
    std::vector<std::pair<const char*, const Tracer*>> ways = {
        {"packets, fixed", &tracerFor(shading, ShadingForm::Packets)},
        {"packets, general", &packets},
        {"points, general", &points}};
    if (surface == kFixedFunctionLighting) ways.resize(1);

    FrameSeries series;
    series.surface = surface;
    series.threads = threads;
    series.pixels = std::size_t(size) * size;
    series.aloneShadowRays = rays.shadow.active;
    std::vector<std::vector<double>> seconds(ways.size());
    std::vector<double> alone, camera;
    Pixels first;
    for (const auto& way : ways) series.ways.push_back({way.first});
    for (unsigned repeat = 0; repeat <= repeats; ++repeat) { // the first only warms caches
        progress(surface + ", repeat " + std::to_string(repeat));
        std::atomic<std::size_t> shadowRays{0};
        for (std::size_t way = 0; way < ways.size(); ++way) {
            shadowRays = 0;
            const double time = timed(*ways[way].second, shot.frame, threads, true, shadowRays);
            if (repeat > 0) seconds[way].push_back(time);
            if (first.empty()) first = shot.pixels;
            if (std::memcmp(first.data(), shot.pixels.data(), first.size() * sizeof first[0]) != 0)
                series.ways[way].same = false;
        }
        series.shadowRays = shadowRays;
        const double making = timed(raysOnly, shot.frame, threads, false, shadowRays);
        const double tracing = timed(rays, *scene, series.shadowRays > 0, threads);
        if (repeat == 0) continue;
        camera.push_back(making);
        alone.push_back(tracing);
    }
    series.aloneSeconds = least(alone);
    series.cameraSeconds = least(camera);
    for (std::size_t way = 0; way < ways.size(); ++way)
        series.ways[way].seconds = least(seconds[way]);
    return series;
}

} // namespace

bool FrameReport::allSame() const {
    return std::ranges::all_of(series, [](const FrameSeries& s) {
        return std::ranges::all_of(s.ways, [](const FrameCost& way) { return way.same; });
    });
}

std::ostream& operator<<(std::ostream& out, const FrameReport& report) {
    out << std::fixed << std::setprecision(2);
    const auto line = [&](const char* what, const FrameSeries& s, double seconds) {
        out << "  " << std::left << std::setw(26) << what << std::right << std::setw(9)
            << seconds * 1e9 / double(s.pixels) << " ns a pixel, " << seconds / s.aloneSeconds
            << " times the rays alone";
        for (const FrameSeries& one : report.series) // what one thread took for the same
            if (s.threads > 1 && one.threads == 1 && one.surface == s.surface) {
                double before = seconds == s.aloneSeconds ? one.aloneSeconds : one.cameraSeconds;
                for (const FrameCost& way : one.ways)
                    if (way.way == what) before = way.seconds;
                out << ", " << before / seconds << " times as fast as one thread";
            }
    };
    for (const FrameSeries& s : report.series) {
        out << s.surface << ", threads: " << s.threads << ", pixels: " << s.pixels
            << ", shadow rays: " << s.shadowRays;
        if (s.shadowRays > 0) out << " (alone: " << s.aloneShadowRays << ')';
        out << '\n';
        line("rays alone", s, s.aloneSeconds);
        out << '\n';
        line("camera rays, traced", s, s.cameraSeconds);
        out << '\n';
        for (const FrameCost& way : s.ways) {
            line(way.way.c_str(), s, way.seconds);
            out << (way.same ? "\n" : ", refused: the pixels differ\n");
        }
    }
    return out;
}

FrameReport measureFrames(const std::vector<Triangle>& triangles, const View& view,
                          const std::string& only, uint32_t size, unsigned threads,
                          unsigned repeats, const Progress& progress) {
    progress("building");
    BuildReport built;
    const ScenePtr scene = buildOpenrt(triangles, Precision::Watertight, threads, built);
    PackedRays rays;
    rays.primary = primaryRays(view, size);
    rays.shadow = shadowRays(view, surfacePoints(rays.primary, scene->view(), triangles));
    FrameReport report;
    for (const unsigned team : {1u, threads}) {
        if (team == threads && threads == 1 && !report.series.empty()) break;
        for (const char* surface :
             {"ConstantShader", "DiffuseShader", "Phong", kFixedFunctionLighting})
            if (only.empty() || std::string(surface).starts_with(only))
                report.series.push_back(
                    measureSurface(scene, surface, rays, view, size, team, repeats, progress));
    }
    return report;
}

} // namespace smart::bench

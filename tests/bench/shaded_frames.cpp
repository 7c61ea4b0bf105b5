// SPDX-License-Identifier: MIT
#include "tests/bench/shaded_frames.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <ctime>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <iomanip>
#include <thread>

#include "libsmart/render/tile_order.h"
#include "libsmart/render/tracers.h"
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

/// A frame and the memory that it is written to.
struct Shot {
    Frame frame;
    Pixels pixels;

    Shot(const ScenePtr& scene, const char* surface, const View& view, uint32_t size)
        : pixels(std::size_t(size) * size) {
        frame.scene = scene;
        frame.shaders = std::make_shared<const ShaderTable>(ShaderTable{
            std::make_shared<const ShaderObject>(findBuiltinClass(surface), ParameterValues())});
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
        for (uint32_t packet = 0; packet < tile_order::kPackets; ++packet) {
            const tile_order::Corner corner = tile_order::cornerOf(packet);
            RayGroup rays;
            uint32_t lanes = 0;
            for (uint32_t lane = 0; lane < uint32_t(kPacketSize); ++lane) {
                const uint32_t x = corner.x + lane % tile_order::kPacketSide;
                const uint32_t y = corner.y + lane / tile_order::kPacketSide;
                if (x >= tile.width || y >= tile.height) continue;
                PixelSample sample(tile.x + x, tile.y + y, 0, 0);
                Ray ray;
                RayCone cone;
                if (!services.makeCameraRay(camera, sample.x + 0.5, sample.y + 0.5, sample, ray,
                                            cone))
                    continue;
                rays.setRay(int(lane), ray);
                lanes |= 1u << lane;
            }
            if (lanes == 0) continue;
            services.findHits(rays, lanes);
            forEach(lanes, [&](int lane) { found += rays.hasHit(lane); });
        }
        hits += found;
    }

    mutable std::atomic<std::size_t> hits{0};
};

/// Seconds of processor time, over all threads, for all tiles of a frame.
double timed(const Tracer& tracer, const Frame& frame, unsigned threads, bool write,
             std::atomic<std::size_t>& shadowRays) {
    const std::vector<Tile> tiles = mortonTiles(frame.target.width, frame.target.height);
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        const auto pixels = std::make_unique<TilePixels>();
        for (;;) {
            const std::size_t i = next++;
            if (i >= tiles.size()) return;
            pixels->shadowRays = 0;
            tracer.render(frame, tiles[i], *pixels);
            shadowRays += pixels->shadowRays;
            if (write) writeTile(frame.target, tiles[i], *pixels);
        }
    };
    const std::clock_t start = std::clock();
    std::vector<std::jthread> team;
    for (unsigned i = 1; i < threads; ++i) team.emplace_back(work);
    work();
    team.clear();
    return double(std::clock() - start) / CLOCKS_PER_SEC;
}

double least(const std::vector<double>& values) {
    return *std::min_element(values.begin(), values.end());
}

ShadingSeries measureSurface(const ScenePtr& scene, const char* surface, const View& view,
                             uint32_t size, unsigned threads, unsigned repeats,
                             const Progress& progress) {
    Shot shot(scene, surface, view, size);
    const PacketTracer<> points(ShadingForm::Points), packets(ShadingForm::Packets);
    const FrameShading& shading = shot.frame.shading();
    const RaysOnly raysOnly;
    const std::pair<const char*, const Tracer*> ways[] = {
        {"rays", &raysOnly},
        {"points, general", &points},
        {"packets, general", &packets},
        {"points, fixed", &tracerFor(shading, ShadingForm::Points)},
        {"packets, fixed", &tracerFor(shading, ShadingForm::Packets)}};

    ShadingSeries series;
    series.surface = surface;
    std::vector<std::vector<double>> seconds(std::size(ways));
    Pixels first;
    for (std::size_t way = 1; way < std::size(ways); ++way)
        series.results.push_back({ways[way].first});
    for (unsigned repeat = 0; repeat <= repeats; ++repeat) { // the first only warms caches
        progress(std::string(surface) + ", repeat " + std::to_string(repeat));
        for (std::size_t way = 0; way < std::size(ways); ++way) {
            raysOnly.hits = 0;
            std::atomic<std::size_t> shadowRays{0};
            const double time =
                timed(*ways[way].second, shot.frame, threads, way > 0, shadowRays);
            if (repeat > 0) seconds[way].push_back(time);
            if (way == 0) {
                series.hits = raysOnly.hits;
                continue;
            }
            series.shadowRays = shadowRays;
            if (first.empty()) first = shot.pixels;
            if (std::memcmp(first.data(), shot.pixels.data(), first.size() * sizeof first[0]) != 0)
                series.results[way - 1].same = false;
        }
    }
    series.raySeconds = least(seconds[0]);
    for (std::size_t way = 1; way < std::size(ways); ++way)
        series.results[way - 1].seconds = least(seconds[way]);
    return series;
}

} // namespace

bool ShadingReport::allSame() const {
    for (const ShadingSeries& s : series)
        for (const ShadingResult& result : s.results)
            if (!result.same) return false;
    return true;
}

std::ostream& operator<<(std::ostream& out, const ShadingReport& report) {
    out << std::fixed << std::setprecision(2);
    for (const ShadingSeries& s : report.series) {
        out << s.surface << ", threads: " << report.threads << ", hits: " << s.hits
            << ", shadow rays: " << s.shadowRays << "\n  camera rays alone    " << std::setw(9)
            << s.raySeconds * 1e3 << " ms\n";
        const auto perHit = [&](const ShadingResult& result) {
            return (result.seconds - s.raySeconds) * 1e9 /
                   double(std::max<std::size_t>(s.hits, 1));
        };
        for (const ShadingResult& result : s.results) {
            out << "  " << std::left << std::setw(19) << result.way << std::right << std::setw(9)
                << result.seconds * 1e3 << " ms, " << std::setw(8) << perHit(result)
                << " ns a shaded hit, frame " << s.results[0].seconds / result.seconds
                << " times and shading " << perHit(s.results[0]) / perHit(result)
                << " times as fast as the first";
            if (!result.same) out << ", refused: the pixels differ";
            out << '\n';
        }
    }
    return out;
}

ShadingReport measureFrames(const std::vector<Triangle>& triangles, const View& view,
                            uint32_t size, unsigned threads, unsigned repeats,
                            const Progress& progress) {
    progress("building");
    BuildReport built;
    const ScenePtr scene = buildOpenrt(triangles, Precision::Watertight, threads, built);
    ShadingReport report;
    report.threads = threads;
    for (const char* surface : {"FixedFunction", "DiffuseShader", "Phong"})
        report.series.push_back(
            measureSurface(scene, surface, view, size, threads, repeats, progress));
    return report;
}

} // namespace smart::bench

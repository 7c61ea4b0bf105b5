// SPDX-License-Identifier: MIT
#include "tests/bench/workload.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "libsmart/kernel/kernels.h"
#include "samples/common/tri_loader.h"
#include "tests/support/procedural_meshes.h"

namespace smart::bench {
namespace {

constexpr const char* kGenerated = "generated:";

uint32_t spread(uint32_t x) {
    x = (x | x << 8) & 0x00FF00FF;
    x = (x | x << 4) & 0x0F0F0F0F;
    x = (x | x << 2) & 0x33333333;
    return (x | x << 1) & 0x55555555;
}

} // namespace

std::vector<Triangle> readTriangles(const std::string& scene) {
    if (scene.rfind(kGenerated, 0) == 0) {
        return test::bumpySphere(
            uint32_t(std::stoul(scene.substr(std::string(kGenerated).size()))));
    }
    try {
        const samples::SceneDescription read = samples::loadTri(scene);
        if (read.meshes.empty()) throw samples::LoadError("it shows no triangle");
        const std::vector<glm::vec3>& corners = read.meshes[0].parts[0].positions;
        std::vector<Triangle> triangles(corners.size() / 3);
        static_assert(sizeof(Triangle) == 3 * sizeof(glm::vec3));
        std::memcpy(triangles.data(), corners.data(), triangles.size() * sizeof(Triangle));
        return triangles;
    } catch (const samples::LoadError& error) {
        throw std::runtime_error(scene + ": " + error.what());
    }
}

View readView(const std::string& file, const std::string& name) {
    std::ifstream lines(file);
    if (!lines) throw std::runtime_error(file + ": can not be read");
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string first;
        if (!(words >> first) || first != name) continue;
        View view;
        for (double* v : {view.camera.eye, view.camera.target, view.camera.up}) {
            words >> v[0] >> v[1] >> v[2];
        }
        words >> view.camera.fov >> view.light[0] >> view.light[1] >> view.light[2];
        if (!words) throw std::runtime_error(file + ": " + name + " needs 13 numbers");
        return view;
    }
    throw std::runtime_error(file + ": no view named '" + name + "'; see --name");
}

void RaySet::add(const RayPacket& packet) {
    packets.push_back(packet);
    for (int lane = 0; lane < kPacketSize; ++lane) {
        const bool on = packet.active >> lane & 1;
        active += on;
        for (int k = 0; k < 3; ++k) {
            org[k].push_back(on ? packet.org[k][lane] : 0.0f);
            dir[k].push_back(on ? packet.dir[k][lane] : 1.0f);
        }
        tNear.push_back(on ? packet.tNear[lane] : 0.0f);
        tFar.push_back(on ? packet.tFar[lane] : -1.0f);
    }
}

void RaySet::add(std::span<const Ray> rays) {
    for (std::size_t first = 0; first < rays.size(); first += kPacketSize)
        add(test::packet(rays, first));
}

RaySet primaryRays(const View& view, uint32_t size, uint64_t seed) {
    test::Random random(seed);
    const double x = seed == 0 ? 0 : random.unit() - 0.5, y = seed == 0 ? 0 : random.unit() - 0.5;
    const std::vector<Ray> rays = test::cameraRays(view.camera, size, size, x, y);
    const uint32_t side = size / 4;
    std::vector<uint32_t> order(std::size_t(side) * side);
    for (uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    const auto code = [&](uint32_t block) {
        return spread(block % side) | spread(block / side) << 1;
    };
    std::sort(order.begin(), order.end(),
              [&](uint32_t a, uint32_t b) { return code(a) < code(b); });
    RaySet set;
    set.packets.reserve(order.size());
    for (const uint32_t block : order) {
        set.add(test::packet(rays, std::size_t(block) * std::size_t(kPacketSize)));
    }
    return set;
}

std::vector<SurfacePacket> surfacePoints(const RaySet& primary, const ModelView& scene,
                                         const std::vector<Triangle>& triangles) {
    std::vector<SurfacePacket> points(primary.packets.size());
    for (std::size_t p = 0; p < points.size(); ++p) {
        const RayPacket& packet = primary.packets[p];
        HitPacket hits;
        kernels().intersect[int(Precision::Watertight)](scene, packet, hits);
        for (int lane = 0; lane < kPacketSize; ++lane) {
            if (!(packet.active >> lane & 1) || hits.triangle[lane] == kNoHit) continue;
            const Triangle& triangle = triangles[hits.triangle[lane]];
            const double u = hits.u[lane], v = hits.v[lane];
            double position[3], normal[3], facing = 0, square = 0, largest = 0;
            for (int k = 0; k < 3; ++k) {
                const int i = (k + 1) % 3, j = (k + 2) % 3;
                position[k] =
                    (1 - u - v) * triangle.v0[k] + u * triangle.v1[k] + v * triangle.v2[k];
                normal[k] = (double(triangle.v1[i]) - triangle.v0[i]) *
                                (double(triangle.v2[j]) - triangle.v0[j]) -
                            (double(triangle.v1[j]) - triangle.v0[j]) *
                                (double(triangle.v2[i]) - triangle.v0[i]);
                facing += normal[k] * packet.dir[k][lane];
                square += normal[k] * normal[k];
                largest = std::max(largest, std::abs(position[k]));
            }
            const double scale = (facing > 0 ? -1 : 1) / std::sqrt(square);
            SurfacePoint& point = points[p].point[lane];
            for (int k = 0; k < 3; ++k) {
                point.normal[k] = scale * normal[k];
                point.position[k] = float(position[k] + 4 * 0x1p-23 * largest * point.normal[k]);
            }
            points[p].seen |= 1u << lane;
        }
    }
    return points;
}

RaySet shadowRays(const View& view, std::span<const SurfacePacket> points) {
    RaySet set;
    RayPacket block[kTilePackets];
    uint32_t filled = 0;
    for (const SurfacePacket& packet : points) {
        RayPacket shadow{};
        for (int lane = 0; lane < kPacketSize; ++lane) {
            if (!(packet.seen >> lane & 1)) continue;
            const SurfacePoint& point = packet.point[lane];
            double lit = 0;
            for (int k = 0; k < 3; ++k) {
                const double toLight = view.light[k] - double(point.position[k]);
                shadow.org[k][lane] = point.position[k];
                shadow.dir[k][lane] = float(toLight);
                lit += toLight * point.normal[k];
            }
            if (lit <= 0) continue; // seen from the front, lit from behind
            shadow.tFar[lane] = 1;
            shadow.active |= 1u << lane;
        }
        block[filled++] = shadow;
        if (filled < kTilePackets && &packet != &points.back()) continue;
        // Blocks stay together, but for those without a ray.
        const bool any = std::any_of(block, block + filled,
                                     [](const RayPacket& p) { return p.active != 0; });
        for (uint32_t i = 0; i < filled && any; ++i) set.add(block[i]);
        filled = 0;
    }
    return set;
}

RaySet diffuseRays(std::span<const SurfacePacket> points, uint32_t count, float tFar,
                   uint64_t seed) {
    test::Random random(seed);
    std::vector<Ray> rays;
    for (const SurfacePacket& packet : points) {
        for (int lane = 0; lane < kPacketSize; ++lane) {
            if (!(packet.seen >> lane & 1)) continue;
            const SurfacePoint& point = packet.point[lane];
            for (uint32_t i = 0; i < count; ++i) {
                // Normal plus a point of the unit sphere has the cosine's distribution.
                const std::array<double, 3> sphere = random.onSphere();
                Ray ray{{}, {}, 0, tFar};
                double direction[3], square = 0;
                for (int k = 0; k < 3; ++k) {
                    direction[k] = point.normal[k] + 0.999 * sphere[std::size_t(k)];
                    square += direction[k] * direction[k];
                }
                for (int k = 0; k < 3; ++k) {
                    ray.org[k] = point.position[k];
                    ray.dir[k] = float(direction[k] / std::sqrt(square));
                }
                rays.push_back(ray);
            }
        }
    }
    RaySet set;
    set.packets.reserve(rays.size() / kPacketSize + 1);
    set.add(rays);
    return set;
}

double diagonalOf(const std::vector<Triangle>& triangles) {
    double lo[3] = {INFINITY, INFINITY, INFINITY}, hi[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (const Triangle& triangle : triangles) {
        for (const float* v : {triangle.v0, triangle.v1, triangle.v2}) {
            for (int k = 0; k < 3; ++k) {
                lo[k] = std::min(lo[k], double(v[k]));
                hi[k] = std::max(hi[k], double(v[k]));
            }
        }
    }
    return triangles.empty() ? 0 : std::hypot(hi[0] - lo[0], hi[1] - lo[1], hi[2] - lo[2]);
}

} // namespace smart::bench

// SPDX-License-Identifier: MIT
#include "tests/bench/workload.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "libsmart/kernel/kernels.h"
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
    std::ifstream file(scene, std::ios::binary | std::ios::ate);
    if (!file) throw std::runtime_error(scene + ": can not be read");
    const auto size = std::size_t(file.tellg());
    uint32_t count = 0;
    file.seekg(0);
    file.read(reinterpret_cast<char*>(&count), sizeof(count));
    static_assert(sizeof(Triangle) == 36);
    if (!file || count == 0 || size != sizeof(count) + count * sizeof(Triangle)) {
        throw std::runtime_error(scene + ": is no .tri file: its size does not fit its count");
    }
    std::vector<Triangle> triangles(count);
    file.read(reinterpret_cast<char*>(triangles.data()), std::streamsize(count * sizeof(Triangle)));
    return triangles;
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
    throw std::runtime_error(file + ": has no " + name);
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

RaySet primaryRays(const View& view, uint32_t size) {
    const std::vector<Ray> rays = test::cameraRays(view.camera, size, size);
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

RaySet shadowRays(const View& view, const RaySet& primary, const ModelView& scene,
                  const std::vector<Triangle>& triangles) {
    RaySet set;
    RayPacket block[kTilePackets];
    uint32_t filled = 0;
    for (const RayPacket& packet : primary.packets) {
        HitPacket hits;
        kernels().intersect[int(Precision::Watertight)](scene, packet, hits);
        RayPacket shadow{};
        for (int lane = 0; lane < kPacketSize; ++lane) {
            if (!(packet.active >> lane & 1) || hits.triangle[lane] == kNoHit) continue;
            const Triangle& triangle = triangles[hits.triangle[lane]];
            const double u = hits.u[lane], v = hits.v[lane];
            double point[3], normal[3], toLight[3], facing = 0, lit = 0, square = 0, largest = 0;
            for (int k = 0; k < 3; ++k) {
                const int i = (k + 1) % 3, j = (k + 2) % 3;
                point[k] = (1 - u - v) * triangle.v0[k] + u * triangle.v1[k] + v * triangle.v2[k];
                normal[k] = (double(triangle.v1[i]) - triangle.v0[i]) *
                                (double(triangle.v2[j]) - triangle.v0[j]) -
                            (double(triangle.v1[j]) - triangle.v0[j]) *
                                (double(triangle.v2[i]) - triangle.v0[i]);
                facing += normal[k] * packet.dir[k][lane];
                square += normal[k] * normal[k];
                largest = std::max(largest, std::abs(point[k]));
            }
            const double scale = (facing > 0 ? -1 : 1) * 4 * 0x1p-23 * largest / std::sqrt(square);
            for (int k = 0; k < 3; ++k) {
                shadow.org[k][lane] = float(point[k] + scale * normal[k]);
                toLight[k] = view.light[k] - double(shadow.org[k][lane]);
                shadow.dir[k][lane] = float(toLight[k]);
                lit += toLight[k] * normal[k];
            }
            if (lit * facing >= 0) continue; // seen from the front, lit from behind
            shadow.tFar[lane] = 1;
            shadow.active |= 1u << lane;
        }
        block[filled++] = shadow;
        if (filled < kTilePackets && &packet != &primary.packets.back()) continue;
        // Blocks stay together, but for those without a ray.
        const bool any = std::any_of(block, block + filled,
                                     [](const RayPacket& p) { return p.active != 0; });
        for (uint32_t i = 0; i < filled && any; ++i) set.add(block[i]);
        filled = 0;
    }
    return set;
}

} // namespace smart::bench

// SPDX-License-Identifier: MIT
#include "libsmart/kernel/packet_math.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

namespace smart {
namespace {

std::vector<const PacketMath*> tables() {
    std::vector<const PacketMath*> found;
    for (const char* name : {"generic", "sse4", "avx2", "avx512", "neon"})
        if (const KernelTable* kernels = findKernels(name)) {
            found.push_back(&packetMathOf(*kernels));
            EXPECT_STREQ(found.back()->name, name);
        }
    return found;
}

bool same(float a, float b) { return std::memcmp(&a, &b, sizeof a) == 0; }

class Numbers {
public:
    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }
    void fill(RTSvectors& v, double size) {
        for (RTSfloats* channel : {&v.x, &v.y, &v.z})
            for (float& lane : channel->lane) lane = float(between(-size, size));
    }

private:
    std::mt19937_64 random_{7};
};

MatrixLens anyLens(Numbers& numbers, bool hasEye, bool upright) {
    MatrixLens lens{};
    for (auto& column : lens.inverse)
        for (double& entry : column) entry = numbers.between(-2, 2);
    for (int column = 0; column < 2; ++column)
        if (upright || !hasEye) lens.inverse[column][3] = 0.0;
    const double w = lens.inverse[2][3] = hasEye ? numbers.between(-3, -1) : 0.0;
    const double nearW = lens.inverse[3][3] - w;
    for (int k = 0; k < 3; ++k) {
        lens.eye[k] = lens.inverse[2][k] / w;
        lens.turning[k] = numbers.between(-1e-3, 1e-3);
    }
    lens.left = std::floor(numbers.between(-10, 10));
    lens.bottom = std::floor(numbers.between(-10, 10));
    lens.width = std::floor(numbers.between(1, 2000));
    lens.height = std::floor(numbers.between(1, 2000));
    lens.pixelWidth = 1.0 / lens.width;
    lens.pixelHeight = 1.0 / lens.height;
    lens.sampleSide = numbers.between(0.1, 1);
    lens.hasEye = hasEye;
    lens.upright = upright;
    lens.nearScale = -1.0 / (w * nearW);
    lens.farScale = -1.0 / (w * (nearW + 2.0 * w));
    return lens;
}

/// Lanes of sixteen rays that differ from those made one by one.
int differingRays(const PacketMath& math, const MatrixLens& lens, const MatrixLens& single,
                  Numbers& numbers) {
    double x[kPacketSize], y[kPacketSize];
    for (int i = 0; i < kPacketSize; ++i) {
        x[i] = numbers.between(0, lens.width);
        y[i] = numbers.between(0, lens.height);
    }
    RayPacket rays{};
    float width[kPacketSize], spread[kPacketSize];
    LensLanes columns, rows;
    math.lensColumns(lens, x, 1, &columns);
    math.lensRows(lens, y, 1, &rows);
    const uint32_t made = math.cameraRays(lens, columns, rows, rays, width, spread);
    RayPacket bare{}; // without cones
    int differ = math.cameraRays(lens, columns, rows, bare, nullptr, nullptr) != made;
    for (int i = 0; i < kPacketSize; ++i) {
        const LensRay ray = forLens(single, [&](auto hasEye, auto upright) {
            return rayThrough<hasEye.value, upright.value, true>(single, lensColumn(single, x[i]),
                                                                 lensRow(single, y[i]));
        });
        bool fine = ray.made == ((made >> i & 1u) != 0) && same(ray.tNear, rays.tNear[i]) &&
                    same(ray.tFar, rays.tFar[i]) && same(ray.coneWidth, width[i]) &&
                    same(ray.coneSpread, spread[i]);
        for (int k = 0; k < 3; ++k)
            fine &= same(ray.org[k], rays.org[k][i]) && same(ray.dir[k], rays.dir[k][i]) &&
                    same(ray.org[k], bare.org[k][i]) && same(ray.dir[k], bare.dir[k][i]);
        fine &= same(ray.tNear, bare.tNear[i]) && same(ray.tFar, bare.tFar[i]);
        differ += !fine;
    }
    return differ;
}

TEST(PacketMath, CameraRaysHaveTheBitsOfSingleOnes) {
    for (const PacketMath* math : tables()) {
        Numbers numbers;
        for (int i = 0; i < 300; ++i) {
            const MatrixLens lens = anyLens(numbers, i % 3 != 0, i % 2 == 0);
            EXPECT_EQ(differingRays(*math, lens, lens, numbers), 0) << math->name << ' ' << i;
        }
        // The comparison sees another lens.
        const MatrixLens lens = anyLens(numbers, true, true);
        MatrixLens other = lens;
        other.inverse[0][0] += 1e-3;
        EXPECT_GT(differingRays(*math, lens, other, numbers), 0);
    }
}

TEST(PacketMath, RaysThatAreNoneAreNotMade) {
    for (const PacketMath* math : tables()) {
        MatrixLens lens{}; // maps all points nowhere
        lens.pixelWidth = lens.pixelHeight = lens.width = lens.height = 1;
        RayPacket rays{};
        const double at[kPacketSize] = {};
        float width[kPacketSize], spread[kPacketSize];
        LensLanes columns, rows;
        math->lensColumns(lens, at, 1, &columns);
        math->lensRows(lens, at, 1, &rows);
        EXPECT_EQ(math->cameraRays(lens, columns, rows, rays, width, spread), 0u) << math->name;
    }
}

TEST(PacketMath, RaysThatGoOnHaveTheBitsOfSingleOnes) {
    for (const PacketMath* math : tables()) {
        Numbers numbers;
        for (int round = 0; round < 200; ++round) {
            RTSpacket points;
            numbers.fill(points.position, 100);
            numbers.fill(points.geometricNormal, 1);
            numbers.fill(points.rayDirection, 1);
            RTSvectors direction, origin = points.position;
            numbers.fill(direction, 3);
            float error[kPacketSize];
            for (float& e : error) e = float(numbers.between(0, 1e-3));
            // Along the surface; no direction; an origin of the shader's own.
            direction.x.lane[3] = direction.y.lane[3] = 0.0f;
            points.geometricNormal.z.lane[3] = 0.0f;
            direction.x.lane[5] = direction.y.lane[5] = direction.z.lane[5] = 0.0f;
            direction.x.lane[6] = std::numeric_limits<float>::quiet_NaN();
            origin.y.lane[7] += 1.0f;
            RayPacket rays;
            math->spawn(points, round % 2 ? error : nullptr, origin, direction, rays);
            for (int i = 0; i < kPacketSize; ++i) {
                const auto lane = [i](const RTSvectors& v) {
                    return Real3{v.x.lane[i], v.y.lane[i], v.z.lane[i]};
                };
                const Real3 unit = unitOf(lane(direction));
                const Real3 outgoing{float(unit.x), float(unit.y), float(unit.z)};
                const bool moves = round % 2 && i != 7;
                const Real3 from = moves ? offSurface(lane(points.position),
                                                      lane(points.geometricNormal),
                                                      lane(points.rayDirection), outgoing, error[i])
                                         : lane(origin);
                EXPECT_TRUE(same(rays.dir[0][i], float(unit.x)) &&
                            same(rays.dir[1][i], float(unit.y)) &&
                            same(rays.dir[2][i], float(unit.z)))
                    << math->name << ' ' << i;
                EXPECT_TRUE(same(rays.org[0][i], float(from.x)) &&
                            same(rays.org[1][i], float(from.y)) &&
                            same(rays.org[2][i], float(from.z)))
                    << math->name << ' ' << i;
                EXPECT_EQ(rays.tNear[i], 0.0f);
                EXPECT_EQ(rays.tFar[i], std::numeric_limits<float>::infinity());
            }
            EXPECT_EQ(rays.dir[0][5], 0.0f);
            EXPECT_EQ(rays.dir[0][6], 0.0f);
        }
    }
}

TEST(PacketMath, PointLightsAgainstTheirDefinition) {
    const float from[3] = {1.0f, -2.0f, 0.5f}, strength[3] = {8.0f, 4.0f, 2.0f};
    for (const PacketMath* math : tables()) {
        Numbers numbers;
        RTSvectors position;
        numbers.fill(position, 10);
        for (int k = 0; k < 3; ++k) // at the light
            (k == 0 ? position.x : k == 1 ? position.y : position.z).lane[4] = from[k];
        RTSlightpacket light;
        EXPECT_EQ(math->pointLight(from, strength, position, light), 0xFFFFu & ~(1u << 4));
        for (int i = 0; i < kPacketSize; ++i) {
            if (i == 4) continue;
            const double x = from[0] - double(position.x.lane[i]);
            const double y = from[1] - double(position.y.lane[i]);
            const double z = from[2] - double(position.z.lane[i]);
            const double distance = std::hypot(x, y, z);
            EXPECT_FLOAT_EQ(light.distance.lane[i], float(distance));
            EXPECT_FLOAT_EQ(light.direction.x.lane[i], float(x / distance));
            EXPECT_FLOAT_EQ(light.direction.z.lane[i], float(z / distance));
            EXPECT_FLOAT_EQ(light.radiance.r.lane[i], float(8 / (distance * distance)));
            EXPECT_FLOAT_EQ(light.radiance.b.lane[i], float(2 / (distance * distance)));
        }
    }
}

} // namespace
} // namespace smart

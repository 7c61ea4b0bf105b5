// SPDX-License-Identifier: MIT
// The pictures of two samples against closed forms: a sphere and a floor under a point light.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

namespace {

struct Picture {
    int width = 0, height = 0;
    std::vector<float> rgb;

    glm::dvec3 at(int x, int y) const {
        const float* p = &rgb[(size_t(y) * width + x) * 3];
        return {p[0], p[1], p[2]};
    }
};

Picture render(const std::string& program) {
    const std::string path = testing::TempDir() + "openrt_analytic.pfm";
    std::remove(path.c_str());
    EXPECT_EQ(std::system((program + " " + path + " > /dev/null").c_str()), 0);
    std::ifstream file(path, std::ios::binary);
    Picture picture;
    std::string magic;
    double scale = 0;
    file >> magic >> picture.width >> picture.height >> scale;
    file.get();
    picture.rgb.resize(size_t(picture.width) * picture.height * 3);
    file.read(reinterpret_cast<char*>(picture.rgb.data()),
              std::streamsize(picture.rgb.size() * sizeof(float)));
    EXPECT_TRUE(file.good());
    return picture;
}

/// Exact radiance along the ray from the origin through (x, y, -1); nothing where the pixel lies
/// so near an edge of what is seen that the closed form may fall on the other side.
using Radiance = std::function<std::optional<glm::dvec3>(glm::dvec3 direction)>;

struct Comparison {
    int compared = 0, lit = 0;
    double worst = 0; ///< largest difference of a channel
};

Comparison compare(const Picture& picture, double halfWidth, double halfHeight,
                   const Radiance& exact) {
    Comparison result;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const double ndcX = (x + 0.5) / picture.width * 2 - 1;
            const double ndcY = (y + 0.5) / picture.height * 2 - 1;
            const auto expected =
                exact(glm::normalize(glm::dvec3(ndcX * halfWidth, ndcY * halfHeight, -1)));
            if (!expected) continue;
            ++result.compared;
            if (expected->x > 0) ++result.lit;
            const glm::dvec3 error = glm::abs(picture.at(x, y) - *expected);
            result.worst = std::max({result.worst, error.x, error.y, error.z});
        }
    return result;
}

Picture shiftedByOnePixel(const Picture& picture) {
    Picture shifted = picture;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 1; x < picture.width; ++x)
            for (int c = 0; c < 3; ++c)
                shifted.rgb[(size_t(y) * picture.width + x) * 3 + c] =
                    picture.rgb[(size_t(y) * picture.width + x - 1) * 3 + c];
    return shifted;
}

glm::dvec3 diffuse(glm::dvec3 color, glm::dvec3 position, glm::dvec3 normal, glm::dvec3 light,
                   double radiance) {
    const glm::dvec3 toLight = light - position;
    const double squared = glm::dot(toLight, toLight);
    const double cosine = glm::dot(normal, toLight) / std::sqrt(squared);
    return color * std::max(cosine, 0.0) * radiance / squared;
}

std::optional<glm::dvec3> sphereRadiance(glm::dvec3 direction) {
    const glm::dvec3 center(0, 0, -5), light(3, 3, -1), color(0.9, 0.5, 0.2);
    const double along = glm::dot(center, direction);
    const double missSquared = glm::dot(center, center) - along * along;
    if (std::abs(missSquared - 1) < 0.01) return std::nullopt; // the silhouette is of triangles
    if (missSquared > 1) return glm::dvec3(0);
    const glm::dvec3 position = direction * (along - std::sqrt(1 - missSquared));
    return diffuse(color, position, position - center, light, 25);
}

constexpr double kFloor = -2, kSquare = -0.5, kEdge = 1e-4;
const glm::dvec3 kLamp(0, 3, -10);

/// Whether (x, z) is in the square; nothing near its edges.
std::optional<bool> inSquare(double x, double z, double halfSize) {
    const double distance = std::max(std::abs(x), std::abs(z + 10)) - halfSize;
    if (std::abs(distance) < kEdge) return std::nullopt;
    return distance < 0;
}

std::optional<glm::dvec3> floorRadiance(glm::dvec3 direction) {
    const glm::dvec3 up(0, 1, 0);
    if (std::abs(direction.y) < kEdge) return std::nullopt;
    if (direction.y > 0) return glm::dvec3(0);
    const glm::dvec3 onSquare = direction * (kSquare / direction.y);
    const auto seesSquare = inSquare(onSquare.x, onSquare.z, 1);
    if (!seesSquare) return std::nullopt;
    if (*seesSquare) return diffuse({0.9, 0.2, 0.2}, onSquare, up, kLamp, 12);

    const glm::dvec3 onFloor = direction * (kFloor / direction.y);
    const auto seesFloor = inSquare(onFloor.x, onFloor.z, 20);
    if (!seesFloor) return std::nullopt;
    if (!*seesFloor) return glm::dvec3(0);
    const glm::dvec3 crossing =
        kLamp + (onFloor - kLamp) * ((kSquare - kLamp.y) / (kFloor - kLamp.y));
    const auto shadowed = inSquare(crossing.x, crossing.z, 1);
    if (!shadowed) return std::nullopt;
    return *shadowed ? glm::dvec3(0) : diffuse({0.7, 0.8, 0.9}, onFloor, up, kLamp, 12);
}

TEST(AnalyticImages, SphereUnderAPointLight) {
    const Picture picture = render(SPHERE_PROGRAM);
    const double half = std::tan(glm::radians(20.0));
    const Comparison result = compare(picture, half, half, sphereRadiance);
    // A ball of 256 x 512 quads lies up to 4e-5 of the radius below the sphere.
    EXPECT_LT(result.worst, 4e-4);
    EXPECT_GT(result.lit, 25000);
    EXPECT_GT(result.compared, 157000);

    EXPECT_GT(compare(shiftedByOnePixel(picture), half, half, sphereRadiance).worst, 5e-3);
}

TEST(AnalyticImages, FloorWithShadow) {
    const Picture picture = render(FLOOR_PROGRAM);
    const Comparison result = compare(picture, 0.75, 0.5, floorRadiance);
    EXPECT_LT(result.worst, 2e-6);
    EXPECT_GT(result.lit, 50000);
    EXPECT_GT(result.compared, 152000);

    EXPECT_GT(compare(shiftedByOnePixel(picture), 0.75, 0.5, floorRadiance).worst, 0.01);
}

} // namespace

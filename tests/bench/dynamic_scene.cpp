// SPDX-License-Identifier: MIT
#include "tests/bench/dynamic_scene.h"

#include <cmath>

#include "tests/support/procedural_meshes.h"

namespace smart::bench {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr uint32_t kBallTriangles = 320;

/// From 0 to 1, the same on every machine.
double chance(uint32_t number, uint32_t what) {
    uint32_t x = number * 2654435761u + what * 40503u + 12345u;
    x = (x ^ (x >> 15)) * 2246822519u;
    x = (x ^ (x >> 13)) * 3266489917u;
    return double(x ^ (x >> 16)) / 4294967296.0;
}

struct Point {
    double x, y, z;
};

/// Where a point of the flat sheet is. A hundred steps are a time of 20.
Point deformed(SheetMotion motion, double x, double z, double time) {
    if (motion == SheetMotion::Waves) {
        return {x,
                0.15 * std::sin(4 * x + 1.3 * time) * std::cos(3 * z - time) +
                    0.03 * std::sin(19 * x + 11 * z + 4 * time),
                z};
    }
    if (motion == SheetMotion::Twist) {
        const double angle = 0.3 * time * (1 - std::sqrt(x * x + z * z) / 1.5);
        const double c = std::cos(angle), s = std::sin(angle);
        return {c * x - s * z, 0.1 * std::sin(7 * x + 3 * z), s * x + c * z};
    }
    Point point{x, 0.15 * std::sin(4 * x) * std::cos(3 * z), z};
    for (int fold = 0; fold < 4; ++fold) {
        const double size = 0.0125 * time / (fold + 1), often = 3 + 4 * fold;
        point.x += size * std::sin(often * point.z + fold);
        point.z += size * std::sin(often * point.x + 2 * fold);
        point.y += size * std::sin(often * (point.x + point.z) + 3 * fold);
    }
    return point;
}

} // namespace

DynamicScene DynamicScene::balls(uint32_t instances) {
    DynamicScene scene;
    scene.instances_ = instances;
    scene.triangles_ = test::bumpySphere(kBallTriangles);
    return scene;
}

DynamicScene DynamicScene::sheet(uint32_t triangles, SheetMotion motion) {
    DynamicScene scene;
    scene.motion_ = motion;
    scene.rows_ = uint32_t(std::fmax(1, std::round(std::sqrt(triangles / 3.2))));
    scene.columns_ = uint32_t(std::fmax(1, std::round(triangles / 2.0 / scene.rows_)));
    const std::vector<uint32_t> indices = scene.indices();
    const std::vector<float> points = scene.step(0).points;
    scene.triangles_.resize(indices.size() / 3);
    for (std::size_t i = 0; i < scene.triangles_.size(); ++i) {
        Triangle& triangle = scene.triangles_[i];
        float* const corners[3] = {triangle.v0, triangle.v1, triangle.v2};
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t k = 0; k < 3; ++k)
                corners[c][k] = points[std::size_t(indices[3 * i + c]) * 3 + k];
    }
    return scene;
}

DynamicStep DynamicScene::step(unsigned number) const {
    const double time = 0.2 * number;
    DynamicStep step;
    if (isSheet()) {
        step.points.reserve(std::size_t(rows_ + 1) * (columns_ + 1) * 3);
        for (uint32_t row = 0; row <= rows_; ++row) {
            for (uint32_t column = 0; column <= columns_; ++column) {
                const double x = 2.0 * column / columns_ - 1, z = 2.0 * row / rows_ - 1;
                const Point point = deformed(motion_, x, z, time);
                step.points.insert(step.points.end(),
                                   {float(point.x), float(point.y), float(point.z)});
            }
        }
        return step;
    }
    const uint32_t side = uint32_t(std::ceil(std::sqrt(double(instances_))));
    const double cell = 2.0 / side;
    step.matrices.reserve(instances_);
    for (uint32_t i = 0; i < instances_; ++i) {
        const double x = cell * (i % side + 0.5) - 1, z = cell * (i / side + 0.5) - 1;
        const double y = 0.5 * cell * std::sin(2 * kPi * chance(i, 0) + time);
        const double angle = 2 * kPi * chance(i, 1) + time * (chance(i, 2) - 0.5);
        const double size = cell * (0.5 + 0.15 * chance(i, 3));
        const float c = float(size * std::cos(angle)), s = float(size * std::sin(angle));
        step.matrices.push_back(
            {c, 0, -s, 0, float(size), 0, s, 0, c, float(x), float(y), float(z)});
    }
    return step;
}

View DynamicScene::view() const {
    View view;
    view.camera = {{0, 2.6, 1.5}, {0, 0, 0.05}, {0, 1, 0}, 42};
    return view;
}

std::vector<uint32_t> DynamicScene::indices() const {
    std::vector<uint32_t> result;
    result.reserve(std::size_t(rows_) * columns_ * 6);
    for (uint32_t row = 0; row < rows_; ++row) {
        for (uint32_t column = 0; column < columns_; ++column) {
            const uint32_t a = row * (columns_ + 1) + column, b = a + columns_ + 1;
            result.insert(result.end(), {a, b, b + 1, a, b + 1, a + 1});
        }
    }
    return result;
}

} // namespace smart::bench

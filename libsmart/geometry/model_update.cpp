// SPDX-License-Identifier: MIT
#include "libsmart/geometry/model_update.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <glm/vec3.hpp>

#include "libsmart/accel/build_crew.h"
#include "libsmart/base/fp_environment.h"

namespace smart {
namespace {

/// The vertices that move.
struct MovedVertices {
    uint32_t first, count;
    const float* positions;

    /// nullptr: it stays where it is.
    const float* find(uint32_t vertex) const {
        const uint32_t number = vertex - first; // far above count for those before the first
        return number < count ? positions + 3 * std::size_t(number) : nullptr;
    }
};

void move(std::vector<Triangle>& triangles, const TriangleCorners& corners,
          const MovedVertices& moved, unsigned threads) {
    constexpr std::size_t kTrianglesOfPart = 16384;
    const std::size_t parts = (triangles.size() + kTrianglesOfPart - 1) / kTrianglesOfPart;
    BuildCrew(threads).forEach(parts, [&](std::size_t part) {
        const std::size_t first = part * kTrianglesOfPart;
        const std::size_t end = std::min(first + kTrianglesOfPart, triangles.size());
        for (std::size_t i = first; i < end; ++i) {
            const TriangleCorners::Corners numbers = corners[i];
            float* const vertices[] = {triangles[i].v0, triangles[i].v1, triangles[i].v2};
            for (std::size_t k = 0; k < 3; ++k)
                if (const float* const to = moved.find(numbers[k])) std::copy_n(to, 3, vertices[k]);
        }
    });
}

void move(PixelGeometry& pixels, const MovedVertices& moved) {
    for (const PixelRun& run : pixels.runs) {
        if (run.kind == PixelRun::Kind::Image) continue;
        for (uint32_t i = 0; i < run.count; ++i)
            if (const float* const to = moved.find(run.firstVertex + i))
                pixels.positions[run.first + i] = glm::vec3(to[0], to[1], to[2]);
    }
}

} // namespace

ModelPtr updateModel(const Model& old, uint32_t first, uint32_t count, const float* positions,
                     const ModelBuildOptions& options) {
    const FpEnvironment standard;
    const auto start = std::chrono::steady_clock::now();
    assert(old.shading.corners.size() == old.triangles.size());
    const MovedVertices moved{first, count, positions};
    const auto model = std::make_shared<Model>(old.sharedShading, old.sharedChildren, options);
    model->triangles = old.triangles;
    move(model->triangles, old.shading.corners, moved, options.threads);
    model->pixels = old.pixels;
    move(model->pixels, moved);
    model->buildTree(model->triangles, &old);
    model->show();
    model->buildSeconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return model;
}

} // namespace smart

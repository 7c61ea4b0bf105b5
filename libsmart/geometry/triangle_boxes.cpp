// SPDX-License-Identifier: MIT
#include "libsmart/geometry/triangle_boxes.h"

#include <algorithm>

#include "libsmart/accel/build_crew.h"
#include "libsmart/base/fp_environment.h"
#include "libsmart/geometry/degenerate.h"

namespace smart {

TriangleBoxes::TriangleBoxes(const std::vector<Triangle>& triangles, unsigned threads)
    : boxes(triangles.size()) {
    constexpr std::size_t kTrianglesOfPart = 16384;
    struct Part {
        Aabb bounds;
        std::size_t dropped = 0;
    };
    std::vector<Part> parts((triangles.size() + kTrianglesOfPart - 1) / kTrianglesOfPart);
    BuildCrew crew(threads);
    crew.forEach(parts.size(), [&](std::size_t number) {
        const FpEnvironment standard;
        Part& part = parts[number];
        const std::size_t first = number * kTrianglesOfPart;
        const std::size_t end = std::min(first + kTrianglesOfPart, triangles.size());
        for (std::size_t i = first; i < end; ++i) {
            const Triangle& triangle = triangles[i];
            if (!isFinite(triangle) || isDegenerate(triangle)) {
                ++part.dropped;
                continue;
            }
            boxes[i].add(triangle.v0);
            boxes[i].add(triangle.v1);
            boxes[i].add(triangle.v2);
            part.bounds.add(boxes[i]);
        }
    });
    for (const Part& part : parts) {
        bounds.add(part.bounds);
        dropped += part.dropped;
    }
}

} // namespace smart

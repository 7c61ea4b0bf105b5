// SPDX-License-Identifier: MIT
#include "libsmart/accel/kd_split.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace smart {
namespace {

struct Boxes {
    std::vector<Aabb> boxes;
    KdEventArena arena;
    KdCell cell;

    explicit Boxes(std::vector<Aabb> made) : boxes(std::move(made)) {
        cell.lists = arena.allocate(boxes.size());
        for (uint32_t i = 0; i < boxes.size(); ++i) {
            cell.box.add(boxes[i]);
            cell.lists.add(boxes[i], i);
        }
        cell.count = uint32_t(boxes.size());
        std::vector<KdEvent> scratch;
        for (int k = 0; k < 3; ++k) sortKdEvents(cell.lists.events[k], cell.lists.size[k], scratch);
    }

    /// Expected cost of a split straight from the definition, or of a leaf where axis < 0.
    double cost(const KdPlane& plane, const KdBuildOptions& options) const {
        if (plane.axis < 0) return double(options.intersectionCost) * cell.count;
        double left = 0, right = 0;
        for (const Aabb& box : boxes) {
            const float lo = box.lo[plane.axis], hi = box.hi[plane.axis];
            if (lo == plane.position && hi == plane.position) {
                ++(plane.planarLeft ? left : right);
            } else {
                left += lo < plane.position;
                right += hi > plane.position;
            }
        }
        Aabb leftBox = cell.box, rightBox = cell.box;
        leftBox.hi[plane.axis] = rightBox.lo[plane.axis] = plane.position;
        const double expected =
            options.traversalCost +
            options.intersectionCost *
                (left * leftBox.halfArea() + right * rightBox.halfArea()) / cell.box.halfArea();
        return left == 0 || right == 0 ? options.emptyFactor * expected : expected;
    }

    /// Least cost of all planes through ends of boxes.
    double leastCost(const KdBuildOptions& options) const {
        double least = cost(KdPlane{}, options);
        for (int axis = 0; axis < 3; ++axis) {
            for (const Aabb& box : boxes) {
                for (const float position : {box.lo[axis], box.hi[axis]}) {
                    if (!(position > cell.box.lo[axis] && position < cell.box.hi[axis])) continue;
                    for (const bool planarLeft : {false, true}) {
                        least = std::min(least, cost({axis, position, planarLeft}, options));
                    }
                }
            }
        }
        return least;
    }
};

TEST(KdSplit, PlaneHasTheLeastCostOfAll) {
    std::mt19937 generator(5);
    int splits = 0;
    for (int round = 0; round < 400; ++round) {
        const uint32_t count = 1 + generator() % 40;
        const int grid = round % 2 ? 1 << 20 : 16; // coarse: many equal and many flat boxes
        std::vector<Aabb> boxes(count);
        for (Aabb& box : boxes) {
            float a[3], b[3];
            for (int k = 0; k < 3; ++k) {
                const int lo = int(generator() % uint32_t(grid));
                a[k] = float(lo) / float(grid);
                b[k] = float(lo + int(generator() % uint32_t(grid)) / 5) / float(grid);
            }
            box.add(a);
            box.add(b);
        }
        const Boxes made(std::move(boxes));
        if (!(made.cell.box.halfArea() > 0)) continue;
        KdBuildOptions options;
        options.intersectionCost = round % 3 ? 0.5f : 2.0f;
        const KdPlane plane = findKdPlane(made.cell, options);
        splits += plane.axis >= 0;
        const double least = made.leastCost(options);
        EXPECT_NEAR(made.cost(plane, options), least, 1e-9 * least) << round;
    }
    EXPECT_GT(splits, 100);
}

TEST(KdSplit, EmptySpaceIsCutOffAtABonus) {
    // Two far boxes in opposite corners: the bonus decides between the middle and the empty part.
    Aabb near, far;
    for (const float x : {0.0f, 1.0f}) {
        const float p[3] = {x, x, x}, q[3] = {x + 99, x + 99, x + 99};
        near.add(p);
        far.add(q);
    }
    Boxes made({near, near, near, far});
    KdBuildOptions options;
    options.intersectionCost = 10;
    const KdPlane plane = findKdPlane(made.cell, options);
    ASSERT_GE(plane.axis, 0);
    EXPECT_NEAR(made.cost(plane, options), made.leastCost(options), 1e-6);
}

TEST(KdSplit, NoPlaneThinnerThanAFewUlp) {
    // At 1000 a float's last place is 2^-14: boxes one such step apart are not to be separated.
    std::vector<Aabb> boxes(64);
    for (uint32_t i = 0; i < boxes.size(); ++i) {
        const float lo[3] = {0, 0, 1000 + float(i % 4) * 0x1p-14f}, hi[3] = {1, 1, lo[2]};
        boxes[i].add(lo);
        boxes[i].add(hi);
    }
    const Boxes made(std::move(boxes));
    KdBuildOptions options;
    options.intersectionCost = 1000;
    EXPECT_LT(findKdPlane(made.cell, options).axis, 0);
}

} // namespace
} // namespace smart

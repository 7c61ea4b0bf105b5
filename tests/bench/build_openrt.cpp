// SPDX-License-Identifier: MIT
#include <time.h>

#include <algorithm>
#include <cmath>

#include "libsmart/accel/build_crew.h"
#include "libsmart/accel/kd_builder.h"
#include "libsmart/accel/triangle_clip.h"
#include "libsmart/geometry/box_view.h"
#include "libsmart/geometry/kd_view.h"
#include "libsmart/geometry/triangle_tree.h"
#include "libsmart/kernel/kernels.h"
#include "tests/bench/build_engine.h"

namespace smart::bench {
namespace {

std::vector<Aabb> boxesOf(const std::vector<Triangle>& triangles, unsigned threads) {
    constexpr std::size_t kPart = 16384;
    std::vector<Aabb> boxes(triangles.size());
    BuildCrew crew(threads);
    crew.forEach((boxes.size() + kPart - 1) / kPart, [&](std::size_t part) {
        const std::size_t end = std::min(boxes.size(), (part + 1) * kPart);
        for (std::size_t i = part * kPart; i < end; ++i) {
            boxes[i].add(triangles[i].v0);
            boxes[i].add(triangles[i].v1);
            boxes[i].add(triangles[i].v2);
        }
    });
    return boxes;
}

class Primitives final : public KdPrimitives {
public:
    explicit Primitives(const std::vector<Triangle>& triangles) : triangles_(triangles) {}
    uint32_t count() const override { return uint32_t(triangles_.size()); }
    Aabb bounds(uint32_t prim) const override {
        Aabb box;
        box.add(triangles_[prim].v0);
        box.add(triangles_[prim].v1);
        box.add(triangles_[prim].v2);
        return box;
    }
    Aabb clipped(uint32_t prim, const Aabb& cell) const override {
        const Triangle& t = triangles_[prim];
        return clipTriangle(t.v0, t.v1, t.v2, cell);
    }

private:
    const std::vector<Triangle>& triangles_;
};

/// One model in one scene, as kernels see it.
class OpenrtTree : public TracedTree {
public:
    void closest(const RaySet& rays, bool coherent, Found* found) const override {
        const KernelTable& table = kernels();
        const int mode = int(Precision::Watertight);
        HitPacket hits[kTilePackets];
        for (std::size_t p = 0; p < rays.packets.size(); p += kTilePackets) {
            const std::size_t n = std::min<std::size_t>(kTilePackets, rays.packets.size() - p);
            const auto& trace = coherent ? table.intersectTile : table.intersectStream;
            trace[mode](scene_, &rays.packets[p], uint32_t(n), hits);
            for (std::size_t i = 0; i < n; ++i) {
                std::copy_n(hits[i].t, kPacketSize, found[p + i].t);
                std::copy_n(hits[i].triangle, kPacketSize, found[p + i].triangle);
            }
        }
    }

protected:
    explicit OpenrtTree(const std::vector<Triangle>& triangles) {
        model_.triangles = triangles.data();
        instance_.identity = 1;
        instance_.model = &model_;
        scene_.children = &instance_;
        scene_.childCount = 1;
    }
    OpenrtTree(const OpenrtTree&) = delete;
    OpenrtTree& operator=(const OpenrtTree&) = delete;

    void enclose(const Aabb& box) {
        static_cast<BoxView&>(scene_.childTree) = makeBoxView(box);
    }

    ModelView model_{};

private:
    InstanceView instance_{};
    ModelView scene_{};
};

class KdTraced final : public OpenrtTree {
public:
    KdTraced(const std::vector<Triangle>& triangles, KdTree tree)
        : OpenrtTree(triangles), tree_(std::move(tree)), triangles_(triangles.size()) {
        model_.tree = makeKdView(tree_, tree_.bounds);
        enclose(tree_.bounds);
    }
    std::size_t bytes() const override { return tree_.bytes() + triangles_ * sizeof(Triangle); }

private:
    const KdTree tree_;
    const std::size_t triangles_;
};

class WideTraced final : public OpenrtTree {
public:
    WideTraced(const std::vector<Triangle>& triangles, TriangleTree tree)
        : OpenrtTree(triangles), tree_(std::move(tree)) {
        static_cast<BoxView&>(model_.wide) = makeBoxView(tree_.bounds());
        model_.wide.nodes = tree_.nodes().data();
        model_.wide.blocks = tree_.blocks();
        enclose(tree_.bounds());
    }
    std::size_t bytes() const override { return tree_.bytes(); }
    float cost() const override { return tree_.cost(); }

private:
    const TriangleTree tree_;
};

TreeBuilder wideBuilder(const std::string& name, WideQuality quality) {
    return {name, false,
            [quality](const std::vector<Triangle>& triangles, unsigned threads, double& seconds) {
                const BuildClock clock(threads);
                TriangleTree tree(triangles, boxesOf(triangles, threads), quality, threads);
                seconds = clock.seconds();
                return std::make_unique<WideTraced>(triangles, std::move(tree));
            }};
}

std::unique_ptr<TracedTree> buildKd(const std::vector<Triangle>& triangles, unsigned threads,
                                    double& seconds) {
    KdBuildOptions options;
    options.threads = threads;
    const BuildClock clock(threads);
    KdTree tree = buildKdTree(Primitives(triangles), options);
    seconds = clock.seconds();
    return std::make_unique<KdTraced>(triangles, std::move(tree));
}

/// A tree over bent triangles that goes back to the straight ones.
std::unique_ptr<TracedTree> refit(const std::vector<Triangle>& triangles, unsigned threads,
                                  double& seconds) {
    const std::vector<Triangle> before = bent(triangles);
    const TriangleTree old(before, boxesOf(before, threads), WideQuality::Binned, threads);
    const BuildClock clock(threads);
    std::optional<TriangleTree> tree =
        old.refitted(triangles, boxesOf(triangles, threads), threads);
    seconds = clock.seconds();
    return std::make_unique<WideTraced>(triangles, std::move(tree.value()));
}

} // namespace

BuildClock::BuildClock(unsigned threads)
    : clock_(threads == 1 ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC), start_(0) {
    start_ = seconds();
}

double BuildClock::seconds() const {
    timespec now;
    clock_gettime(clockid_t(clock_), &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec) - start_;
}

std::vector<Triangle> bent(const std::vector<Triangle>& triangles) {
    Aabb box;
    for (const Triangle& triangle : triangles)
        for (const float* corner : {triangle.v0, triangle.v1, triangle.v2}) box.add(corner);
    std::vector<Triangle> result = triangles;
    for (Triangle& triangle : result) {
        for (float* corner : {triangle.v0, triangle.v1, triangle.v2}) {
            const double x = (corner[0] - box.lo[0]) / std::max(box.extent(0), 1e-30f);
            corner[1] += float(0.02 * box.extent(1) * std::sin(6.0 * x));
        }
    }
    return result;
}

std::vector<TreeBuilder> openrtBuilders() {
    return {{"kd-tree, exact", false, buildKd},
            wideBuilder("wide, spatial splits", WideQuality::Spatial),
            wideBuilder("wide, binned", WideQuality::Binned),
            wideBuilder("wide, fast", WideQuality::Fast),
            {"wide, refit", false, refit}};
}

} // namespace smart::bench

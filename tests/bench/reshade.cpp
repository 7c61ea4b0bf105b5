// SPDX-License-Identifier: MIT
#include "tests/bench/reshade.h"

#include <cmath>
#include <memory>
#include <ostream>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

#include "libsmart/geometry/model_builder.h"
#include "libsmart/scene/scene.h"

namespace smart::bench {
namespace {

/// Bytes that the program holds, by malloc's own books.
double allocatedBytes() {
#if defined(__GLIBC__) && (__GLIBC__ > 2 || __GLIBC_MINOR__ >= 33)
    const struct mallinfo2 info = mallinfo2();
    return double(info.uordblks) + double(info.hblkhd);
#else
    return 0;
#endif
}

/// One instance after the other, each with two shaders exchanged for its own.
std::vector<Instance> reshaded(const ModelPtr& model, uint32_t count) {
    std::vector<Instance> all;
    all.reserve(count);
    const uint32_t columns = uint32_t(std::ceil(std::sqrt(double(count))));
    const Aabb& box = model->bounds;
    for (uint32_t i = 0; i < count; ++i) {
        auto replacement = std::make_shared<ShaderReplacement>();
        replacement->pairs.reserve(2);
        replacement->pairs.emplace_back(0u, 2 * i + 2);
        replacement->pairs.emplace_back(1u, 2 * i + 3);
        Instance& instance = all.emplace_back();
        instance.model = model;
        instance.objectId = 1;
        instance.toParent[3] = {double(i % columns) * 1.1 * (box.hi[0] - box.lo[0]),
                                double(i / columns) * 1.1 * (box.hi[1] - box.lo[1]), 0.0};
        instance.replacement = std::move(replacement);
    }
    return all;
}

struct Held {
    double reported, allocated, milliseconds;
};

Held hold(const ModelPtr& model, uint32_t count, unsigned threads) {
    const double before = allocatedBytes();
    const auto scene =
        std::make_unique<const Scene>(reshaded(model, count), Precision::Watertight, threads);
    return {double(scene->group().bytes()), allocatedBytes() - before,
            scene->buildSeconds() * 1e3};
}

} // namespace

ReshadeReport measureReshading(const std::vector<Triangle>& triangles, uint32_t instances,
                               unsigned threads) {
    ModelBuilder builder;
    builder.triangles = triangles;
    builder.shading.shaders = {0, 1};
    builder.shading.slots.resize(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) builder.shading.slots[i] = uint32_t(i % 2);
    ModelBuildOptions options;
    options.threads = threads;
    const ModelPtr model = std::move(builder).build(options);

    hold(model, instances + 1, threads); // what the allocator keeps for later, it has by now
    const Held one = hold(model, 1, threads);
    const Held many = hold(model, instances + 1, threads);
    ReshadeReport report;
    report.triangles = triangles.size();
    report.instances = instances;
    report.modelBytes = model->bytes();
    report.instanceBytes = (many.reported - one.reported) / instances;
    report.instanceAllocated = (many.allocated - one.allocated) / instances;
    report.millisecondsPerFrame = many.milliseconds;
    return report;
}

std::ostream& operator<<(std::ostream& out, const ReshadeReport& r) {
    const double copies = double(r.modelBytes) * r.instances;
    out << r.triangles << " triangles, " << double(r.modelBytes) / 1e6
        << " MB with tree and shaders\n"
        << r.instances << " instances with shaders of their own: " << r.instanceBytes
        << " bytes each as counted, " << r.instanceAllocated << " as malloc counts\n"
        << "all of them " << r.instanceBytes * r.instances / 1e6 << " MB, where copies would take "
        << copies / 1e6 << " MB; tree over them in " << r.millisecondsPerFrame << " ms\n";
    return out;
}

} // namespace smart::bench

// SPDX-License-Identifier: MIT
#include "libsmart/scene/scene.h"

#include <chrono>
#include <unordered_set>
#include <utility>

namespace smart {
namespace {

class StatisticsCollector {
public:
    void add(const InstanceGroup& group) {
        statistics.droppedInstances += group.dropped();
        add(group.tree());
        for (const auto& traits : group.traits()) {
            const Model* const model = traits->model.get();
            if (model && seen_.insert(model).second) add(*model);
        }
    }

    SceneStatistics statistics;

private:
    void add(const Model& model) {
        statistics.triangles += model.triangles.size();
        statistics.droppedTriangles += model.droppedTriangles;
        statistics.bytes += model.ownBytes();
        if (seen_.insert(model.sharedShading.get()).second)
            statistics.bytes += model.shading.bytes();
        if (seen_.insert(model.sharedChildren.get()).second)
            statistics.bytes += model.children.bytes();
        add(model.treeSizes());
        add(model.children);
    }
    void add(const TreeSizes& sizes) {
        statistics.nodes += sizes.nodes;
        statistics.leaves += sizes.leaves;
        statistics.references += sizes.references;
    }
    void add(const WideTree& tree) {
        TreeSizes sizes;
        sizes.add(std::span(tree.nodes));
        add(sizes);
    }

    std::unordered_set<const void*> seen_; ///< models, and what they share
};

} // namespace

Scene::Scene(InstanceList instances, Precision precision, unsigned threads, bool lastOfEqual)
    : precision_(precision) {
    const auto start = std::chrono::steady_clock::now();
    group_ = InstanceGroup(std::move(instances), threads, GroupLife::OneFrame);
    group_.show(view_);
    view_.lastOfEqual = lastOfEqual;
    if (precision == Precision::Fast) {
        for (const auto& traits : group_.traits())
            if (traits->model) traits->model->prepareFastRecords();
    }
    buildSeconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

SceneStatistics statistics(const Scene& scene) {
    StatisticsCollector collector;
    collector.add(scene.group());
    collector.statistics.instances = scene.group().instances().size();
    collector.statistics.bytes += sizeof(Scene) + scene.group().bytes();
    return collector.statistics;
}

} // namespace smart

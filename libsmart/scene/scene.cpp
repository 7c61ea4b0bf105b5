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
        for (const Instance& instance : group.instances()) {
            if (instance.model && seen_.insert(instance.model.get()).second) add(*instance.model);
        }
    }

    SceneStatistics statistics;

private:
    void add(const Model& model) {
        statistics.triangles += model.triangles.size();
        statistics.droppedTriangles += model.droppedTriangles;
        statistics.bytes += model.bytes();
        add(model.tree);
        add(model.children);
    }
    void add(const KdTree& tree) {
        statistics.nodes += tree.nodes.size();
        statistics.references += tree.prims.size();
        for (const KdNode& node : tree.nodes) statistics.leaves += (node.bits & 3) == kKdLeaf;
    }

    std::unordered_set<const Model*> seen_;
};

} // namespace

Scene::Scene(std::vector<Instance> instances, Precision precision, unsigned threads)
    : precision_(precision) {
    const auto start = std::chrono::steady_clock::now();
    group_ = InstanceGroup(std::move(instances), threads);
    group_.show(view_);
    if (precision == Precision::Fast) {
        for (const Instance& instance : group_.instances()) {
            if (instance.model) instance.model->prepareFastRecords();
        }
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

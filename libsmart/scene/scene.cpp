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
        const Model* last = nullptr; // runs of one model are common
        for (const Instance& instance : group.instances()) {
            const Model* const model = instance.model.get();
            if (model != last && model && seen_.insert(model).second) add(*model);
            last = model;
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
        statistics.leaves += (tree.nodes.size() + 1) / 2; // inner nodes have two children
    }

    std::unordered_set<const Model*> seen_;
};

} // namespace

Scene::Scene(std::vector<Instance> instances, Precision precision, unsigned threads,
             bool lastOfEqual)
    : precision_(precision) {
    const auto start = std::chrono::steady_clock::now();
    group_ = InstanceGroup(std::move(instances), threads);
    group_.show(view_);
    view_.lastOfEqual = lastOfEqual;
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

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
    void add(const WideTree& tree) {
        statistics.nodes += tree.nodes.size();
        statistics.references += tree.prims.size();
        for (const WideNode& node : tree.nodes)
            for (const uint32_t child : node.child) statistics.leaves += child / kWideLeaf;
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

void Scene::prepareTiles() const {
    if (precision_ == Precision::Precise) return;
    std::call_once(tilesOnce_, [this] {
        for (const Instance& instance : group_.instances())
            if (instance.model) instance.model->prepareTiles();
        preparedView_ = view_;
        preparedView_.wideReady = 1;
        tilesReady_.store(true, std::memory_order_release);
    });
}

bool Scene::readyForTiles(uint64_t rays) const {
    if (tilesReady_.load(std::memory_order_acquire)) return true;
    if (precision_ == Precision::Precise) return false;
    constexpr uint64_t kPrimitivesOfRay = 4;
    std::call_once(tilesPayOnce_, [this] {
        const SceneStatistics sizes = smart::statistics(*this);
        tilesPay_ = (sizes.triangles + sizes.instances) / kPrimitivesOfRay;
    });
    if (tileRays_.fetch_add(rays, std::memory_order_relaxed) + rays < tilesPay_) return false;
    prepareTiles();
    return true;
}

SceneStatistics statistics(const Scene& scene) {
    StatisticsCollector collector;
    collector.add(scene.group());
    collector.statistics.instances = scene.group().instances().size();
    collector.statistics.bytes += sizeof(Scene) + scene.group().bytes();
    return collector.statistics;
}

} // namespace smart

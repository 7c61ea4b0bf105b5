// SPDX-License-Identifier: MIT
#include "libsmart/scene/scene.h"

#include <algorithm>
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
    if (modelsAreReady()) prepareTiles();
    buildSeconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

bool Scene::modelsAreReady() const {
    return std::ranges::all_of(group_.traits(), [](const auto& traits) {
        return !traits->model || traits->model->readyForTiles();
    });
}

void Scene::prepareTiles() const {
    if (precision_ == Precision::Precise) return;
    std::call_once(tilesOnce_, [this] {
        for (const auto& traits : group_.traits())
            if (traits->model) traits->model->prepareTiles();
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

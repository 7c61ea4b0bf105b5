// SPDX-License-Identifier: MIT
#include "tests/support/traced_scene.h"

#include <algorithm>
#include <utility>

#include "libsmart/geometry/model_builder.h"

namespace smart::test {

ModelPtr makeModel(std::vector<Triangle> triangles, std::vector<Instance> children,
                   BuildQuality quality) {
    ModelBuilder builder;
    builder.triangles = std::move(triangles);
    builder.children = std::move(children);
    return std::move(builder).build({.quality = quality});
}

namespace {

/// Models that are placed several times are made once.
std::vector<Instance> withKdTrees(std::span<const Instance> instances,
                                  std::map<ModelPtr, ModelPtr>& made) {
    std::vector<Instance> result(instances.begin(), instances.end());
    for (Instance& instance : result) {
        if (!instance.model) continue;
        ModelPtr& model = made[instance.model];
        if (!model) {
            std::vector<Instance> children;
            for (const InstanceView& child : instance.model->children.instances())
                children.push_back(asGiven(child));
            model = makeModel(instance.model->triangles, withKdTrees(children, made),
                              BuildQuality::KdTree);
        }
        instance.model = model;
    }
    return result;
}

} // namespace

std::vector<Instance> withKdTrees(std::span<const Instance> instances) {
    std::map<ModelPtr, ModelPtr> made;
    return withKdTrees(instances, made);
}

Instance place(ModelPtr model, const glm::dmat4x3& toParent) {
    Instance instance;
    instance.model = std::move(model);
    instance.toParent = toParent;
    return instance;
}

TracedScene::TracedScene(std::vector<Instance> instances, Precision precision)
    : scene_(withKdTrees(instances), precision, 1), wide_(std::move(instances), precision, 1) {
    std::vector<uint32_t> path;
    std::vector<Matrix34> chain;
    for (const InstanceView& instance : scene_.group().instances()) {
        path.push_back(uint32_t(&instance - scene_.group().instances().data()));
        addToReference(instance, path, chain);
        path.pop_back();
    }
}

void TracedScene::addToReference(const InstanceView& instance, std::vector<uint32_t>& path,
                                 std::vector<Matrix34>& chain) {
    const glm::dmat4x3 matrix = toParent(instance);
    const bool identity = matrix == glm::dmat4x3(1.0);
    if (!identity) {
        Matrix34 rows;
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 4; ++column) {
                rows[std::size_t(4 * row + column)] = matrix[column][row];
            }
        }
        chain.push_back(rows);
    }
    firstNumber_[path] = reference_.add(instance.traits->model->triangles, chain);
    const std::span<const InstanceView> children = instance.traits->model->children.instances();
    for (uint32_t child = 0; child < children.size(); ++child) {
        path.push_back(child);
        addToReference(children[child], path, chain);
        path.pop_back();
    }
    if (!identity) chain.pop_back();
}

Claim TracedScene::claim(const Hit& hit) const {
    if (hit.triangle == kNoHit) return {};
    const uint32_t levels = std::min(hit.levels, uint32_t(kMaxLevels));
    const auto first = firstNumber_.find(std::vector<uint32_t>(hit.path, hit.path + levels));
    const uint32_t number =
        first == firstNumber_.end() ? reference_.count() : first->second + hit.triangle;
    return {number, hit.t, hit.u, hit.v};
}

std::vector<ExactAnswer> TracedScene::truth(std::span<const Ray> rays) const {
    std::vector<ExactAnswer> answers;
    answers.reserve(rays.size());
    for (const Ray& ray : rays) answers.push_back(reference_.nearest(ray));
    return answers;
}

VerdictCounts TracedScene::judgeAll(std::span<const Ray> rays, std::span<const ExactAnswer> truth,
                                    std::span<const Hit> hits) const {
    VerdictCounts counts;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        counts.add(reference_, truth[i], rays[i], claim(hits[i]));
    }
    return counts;
}

} // namespace smart::test

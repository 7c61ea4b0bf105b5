// SPDX-License-Identifier: MIT
// One scene twice: as the library traverses it and as the exact reference sees it.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "libsmart/geometry/model.h"
#include "libsmart/scene/scene.h"
#include "tests/support/exact_reference.h"
#include "tests/support/verdict.h"

namespace smart::test {

ModelPtr makeModel(std::vector<Triangle> triangles, std::vector<Instance> children = {},
                   BuildQuality quality = BuildQuality::Nicest);
Instance place(ModelPtr model, const glm::dmat4x3& toParent = glm::dmat4x3(1.0));
/// The same with kd-trees in all models, nested ones too.
std::vector<Instance> withKdTrees(std::span<const Instance> instances);

class TracedScene {
public:
    explicit TracedScene(std::vector<Triangle> triangles,
                         Precision precision = Precision::Watertight)
        : TracedScene({place(makeModel(std::move(triangles)))}, precision) {}
    explicit TracedScene(std::vector<Instance> instances,
                         Precision precision = Precision::Watertight);

    /// With kd-trees in all models.
    const ModelView& view() const { return scene_.view(); }
    /// With the trees that the models were given with.
    const ModelView& wideView() const { return wide_.view(); }
    const Scene& scene() const { return scene_; }
    const Scene& wideScene() const { return wide_; }
    const ExactReference& reference() const { return reference_; }
    /// The hit in the reference's numbers; a path that does not exist gives a number out of range.
    Claim claim(const Hit& hit) const;
    /// Truth for many rays, to be used for many engines.
    std::vector<ExactAnswer> truth(std::span<const Ray> rays) const;
    VerdictCounts judgeAll(std::span<const Ray> rays, std::span<const ExactAnswer> truth,
                           std::span<const Hit> hits) const;

private:
    void addToReference(const InstanceView& instance, std::vector<uint32_t>& path,
                        std::vector<Matrix34>& chain);

    Scene scene_, wide_;
    ExactReference reference_;
    std::map<std::vector<uint32_t>, uint32_t> firstNumber_; ///< of the model at a path
};

} // namespace smart::test

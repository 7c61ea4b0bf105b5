// SPDX-License-Identifier: MIT
#include "libsmart/render/ray_offset.h"
#include "libsmart/scene/scene.h"
#include "tests/accuracy/engine.h"
#include "tests/support/kernel_runs.h"
#include "tests/support/one_sided_tree.h"
#include "tests/support/traced_scene.h"

namespace smart::test {
namespace {

/// The library's scene for a geometry, and the numbers of its triangles.
class OpenrtScene {
public:
    OpenrtScene(const Geometry& geometry, int mode, BuildQuality quality = BuildQuality::Nicest)
        : scene_(place(geometry, quality), Precision(mode), 2) {
        uint32_t next = 0;
        for (const Placement& placement : geometry.placements) {
            first_.push_back(next);
            next += uint32_t(geometry.meshes[placement.mesh].size());
        }
        end_ = next;
    }

    const Scene& scene() const { return scene_; }
    Claim claim(const Hit& hit) const {
        if (hit.triangle == kNoHit) return {};
        const bool real = hit.levels == 1 && hit.path[0] < first_.size();
        return {real ? first_[hit.path[0]] + hit.triangle : end_, hit.t, hit.u, hit.v};
    }

    /// The claim's chain of instances.
    HitChain chain(const Claim& claim) const {
        uint32_t instance = uint32_t(first_.size()) - 1;
        while (first_[instance] > claim.triangle) --instance;
        return resolve(scene_, &instance, 1, claim.triangle - first_[instance]);
    }

private:
    static std::vector<Instance> place(const Geometry& geometry, BuildQuality quality) {
        std::vector<ModelPtr> models;
        for (const auto& mesh : geometry.meshes) models.push_back(makeModel(mesh, {}, quality));
        std::vector<Instance> instances;
        for (const Placement& placement : geometry.placements) {
            glm::dmat4x3 matrix(1.0);
            for (int row = 0; row < 3; ++row) {
                for (int column = 0; column < 4; ++column) {
                    matrix[column][row] = placement.toWorld[std::size_t(4 * row + column)];
                }
            }
            instances.push_back(test::place(models[placement.mesh], matrix));
        }
        return instances;
    }

    Scene scene_;
    std::vector<uint32_t> first_;
    uint32_t end_ = 0;
};

enum class Form { Full, Sparse, Single };

class OpenrtEngine final : public Engine {
public:
    OpenrtEngine(std::shared_ptr<const OpenrtScene> scene, const KernelTable& table, int mode,
                 Form form)
        : scene_(std::move(scene)), table_(table), mode_(mode), form_(form) {}

    void trace(std::span<const Ray> rays, Claim* claims) const override {
        const ModelView& view = scene_->scene().view();
        const std::vector<Hit> hits =
            form_ == Form::Single
                ? traceSingles(table_, Precision(mode_), view, rays)
                : tracePackets(table_, Precision(mode_), view, rays,
                               form_ == Form::Full ? Filling::Full : Filling::Sparse);
        for (std::size_t i = 0; i < hits.size(); ++i) claims[i] = scene_->claim(hits[i]);
    }

    /// As the library's shaders do it.
    void leaveSurface(const Ray& incoming, const Claim& hit, const double point[3],
                      const double normal[3], Ray& ray) const override {
        float position[3], unit[3];
        for (int k = 0; k < 3; ++k) {
            position[k] = float(point[k]);
            unit[k] = float(normal[k]);
        }
        const float error = surfaceError(scene_->chain(hit), position, hit.u, hit.v);
        const glm::vec3 direction(ray.dir[0], ray.dir[1], ray.dir[2]);
        const glm::vec3 origin =
            smart::leaveSurface(position, unit, incoming.dir, direction, error);
        for (int k = 0; k < 3; ++k) ray.org[k] = origin[k];
    }

private:
    const std::shared_ptr<const OpenrtScene> scene_;
    const KernelTable& table_;
    const int mode_;
    const Form form_;
};

class OneSidedEngine final : public Engine {
public:
    explicit OneSidedEngine(const Geometry& geometry)
        : whole_(geometry, int(Precision::Watertight), BuildQuality::KdTree),
          broken_(whole_.scene()) {}

    void trace(std::span<const Ray> rays, Claim* claims) const override {
        const std::vector<Hit> hits =
            tracePackets(kernels(), Precision::Watertight, broken_.scene, rays, Filling::Full);
        for (std::size_t i = 0; i < hits.size(); ++i) claims[i] = whole_.claim(hits[i]);
    }

private:
    const OpenrtScene whole_;
    const OneSidedTree broken_;
};

} // namespace

const char* modeName(int mode) {
    static const char* const names[] = {"fast", "watertight", "precise"};
    return names[mode];
}

std::vector<EngineKind> openrtKinds() {
    std::vector<EngineKind> kinds;
    for (int mode = 0; mode < kPrecisionCount; ++mode) {
        const auto make = [mode](const Geometry& geometry) -> EnginePtr {
            return std::make_unique<OpenrtEngine>(
                std::make_shared<const OpenrtScene>(geometry, mode), kernels(), mode, Form::Full);
        };
        kinds.push_back({std::string("openrt-") + modeName(mode), make, mode});
    }
    return kinds;
}

std::vector<Variant> openrtVariants(const Geometry& geometry, int mode) {
    const auto scene = std::make_shared<const OpenrtScene>(geometry, mode);
    const auto inKdTrees =
        std::make_shared<const OpenrtScene>(geometry, mode, BuildQuality::KdTree);
    std::vector<Variant> variants;
    for (const KernelTable* table : availableKernels()) {
        const std::pair<Form, const char*> forms[] = {
            {Form::Full, " packets"}, {Form::Sparse, " sparse packets"}, {Form::Single, " single"}};
        for (const auto& [form, name] : forms) {
            variants.push_back({std::string(table->name) + name,
                                std::make_unique<OpenrtEngine>(scene, *table, mode, form)});
        }
        variants.push_back({std::string(table->name) + " kd-tree",
                            std::make_unique<OpenrtEngine>(inKdTrees, *table, mode, Form::Full)});
    }
    return variants;
}

EngineKind oneSidedKind() {
    return {"defect-one-sided", [](const Geometry& geometry) -> EnginePtr {
                if (!geometry.plain()) return nullptr;
                return std::make_unique<OneSidedEngine>(geometry);
            }};
}

std::vector<EngineKind> engineKinds() {
    std::vector<EngineKind> kinds = openrtKinds();
    for (const auto& more : {embreeKinds(), yardstickKinds(), {oneSidedKind()}}) {
        kinds.insert(kinds.end(), more.begin(), more.end());
    }
    return kinds;
}

} // namespace smart::test

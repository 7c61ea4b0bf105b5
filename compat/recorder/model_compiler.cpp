// SPDX-License-Identifier: MIT
#include "compat/recorder/model_compiler.h"

#include <utility>

#include "libsmart/geometry/model_update.h"

namespace smart::compat {

template <class Build>
ModelPtr ModelCompiler::counted(Build&& build) {
    auto place = std::make_shared<CountedPlace<const Model>>(memory_);
    KdBuildOptions options;
    options.threads = threads_;
    ModelPtr model = build(options);
    ++modelsBuilt_;
    buildSeconds_ += model->buildSeconds;
    const std::size_t bytes = model->bytes();
    return CountedPlace<const Model>::put(std::move(place), std::move(model), bytes);
}

ModelPtr ModelCompiler::compile(GeometryRecording& recording) {
    return counted([&](const KdBuildOptions& options) { return recording.compile(options); });
}

ModelPtr ModelCompiler::update(const Model& old, uint32_t first, uint32_t count,
                               const float* positions) {
    return counted([&](const KdBuildOptions& options) {
        return updateModel(old, first, count, positions, options);
    });
}

ScenePtr ModelCompiler::makeScene(std::vector<Instance> instances, Precision precision,
                                  bool lastOfEqual) {
    auto place = std::make_shared<CountedPlace<const Scene>>(memory_);
    ScenePtr scene = std::make_shared<const Scene>(std::move(instances), precision, threads_, lastOfEqual);
    buildSeconds_ += scene->buildSeconds();
    const std::size_t bytes = scene->group().bytes();
    return CountedPlace<const Scene>::put(std::move(place), std::move(scene), bytes);
}

} // namespace smart::compat

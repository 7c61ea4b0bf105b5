// SPDX-License-Identifier: MIT
#include "compat/recorder/model_compiler.h"

#include <utility>

namespace smart::compat {

ModelPtr ModelCompiler::compile(GeometryRecording& recording) {
    auto place = std::make_shared<CountedPlace<const Model>>(memory_);
    KdBuildOptions options;
    options.threads = threads_;
    ModelPtr model = recording.compile(options);
    ++modelsBuilt_;
    buildSeconds_ += model->buildSeconds;
    const std::size_t bytes = model->bytes();
    return CountedPlace<const Model>::put(std::move(place), std::move(model), bytes);
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

// SPDX-License-Identifier: MIT
#include "compat/recorder/model_compiler.h"

#include <utility>

#include "libsmart/geometry/model_update.h"

namespace smart::compat {

template <class Build>
ModelPtr ModelCompiler::counted(Build&& build, BuildQuality quality, bool lazy) {
    ModelPtr model = build(ModelBuildOptions{quality, lazy, threads_, memory_});
    ++modelsBuilt_;
    buildSeconds_ += model->buildSeconds;
    return model;
}

ModelPtr ModelCompiler::compile(GeometryRecording& recording, BuildQuality quality, bool lazy) {
    return counted([&](const ModelBuildOptions& options) { return recording.compile(options); },
                   quality, lazy);
}

ModelPtr ModelCompiler::update(const Model& old, uint32_t first, uint32_t count,
                               const float* positions, BuildQuality quality, bool lazy) {
    return counted(
        [&](const ModelBuildOptions& options) {
            return updateModel(old, first, count, positions, options);
        },
        quality, lazy);
}

ScenePtr ModelCompiler::makeScene(InstanceList instances, Precision precision,
                                  bool lastOfEqual) {
    struct CountedScene {
        CountedScene(std::shared_ptr<MemoryCounter> counter, InstanceList all,
                     Precision exactness, unsigned threads, bool last)
            : scene(std::move(all), exactness, threads, last),
              bytes(std::move(counter), sizeof(Scene) + scene.group().bytes()) {}
        Scene scene;
        CountedBytes bytes;
    };
    const auto made = std::make_shared<CountedScene>(memory_, std::move(instances), precision,
                                                     threads_, lastOfEqual);
    buildSeconds_ += made->scene.buildSeconds();
    return ScenePtr(made, &made->scene);
}

} // namespace smart::compat

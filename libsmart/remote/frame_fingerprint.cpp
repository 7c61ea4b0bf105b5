// SPDX-License-Identifier: MIT
#include "libsmart/remote/frame_fingerprint.h"

#include <bit>
#include <cstring>
#include <type_traits>

namespace smart {
namespace {

class Mixer {
public:
    template <class Number>
        requires std::is_arithmetic_v<Number> || std::is_enum_v<Number>
    void add(Number number) {
        uint64_t word = 0;
        std::memcpy(&word, &number, sizeof number);
        sum_ = std::rotl((sum_ ^ word) * 0x9E3779B97F4A7C15u, 29);
    }
    template <class Number, std::size_t count>
    void add(const Number (&numbers)[count]) {
        for (const Number& number : numbers) add(number);
    }
    void add(const Viewport& v) { add(v.x), add(v.y), add(v.width), add(v.height); }
    void add(const std::optional<Viewport>& v) {
        add(v.has_value());
        if (v) add(*v);
    }
    void add(const glm::vec4& v) {
        for (int i = 0; i < 4; ++i) add(v[i]);
    }
    template <int columns, int rows>
    void add(const glm::mat<columns, rows, double>& m) {
        for (int i = 0; i < columns; ++i)
            for (int j = 0; j < rows; ++j) add(m[i][j]);
    }
    uint64_t sum() const { return sum_; }

private:
    uint64_t sum_ = 0;
};

void addTarget(Mixer& mixer, const PixelTarget& target) {
    const AuxBuffers& aux = target.aux;
    mixer.add(target.width), mixer.add(target.height);
    mixer.add(target.format), mixer.add(target.srgb);
    const bool wanted[] = {aux.depth != nullptr,    aux.distance != nullptr,
                           aux.normal != nullptr,   aux.objectId != nullptr,
                           aux.instanceId != nullptr, aux.primitiveId != nullptr};
    mixer.add(wanted);
}

void addLayer(Mixer& mixer, const Frame& layer) {
    addTarget(mixer, layer.target);
    mixer.add(layer.samples), mixer.add(layer.seed);
    mixer.add(layer.recursionLimit), mixer.add(layer.weightCutoff);
    mixer.add(layer.clearColor), mixer.add(layer.clearDepth), mixer.add(layer.clears.size());
    mixer.add(layer.matrixCamera.projection);
    mixer.add(layer.viewport), mixer.add(layer.scissor);
    mixer.add(layer.depthNear), mixer.add(layer.depthFar);
    mixer.add(layer.drawsColor), mixer.add(layer.lights.size());
    const bool special[] = {layer.camera != nullptr, layer.environment != nullptr,
                            layer.renderingObject != nullptr, layer.primitives != nullptr};
    mixer.add(special);
    for (const InstanceView& instance : layer.scene->group().instances()) {
        mixer.add(instance.toParent), mixer.add(instance.objectId);
        const Model* const model = instance.traits->model.get();
        mixer.add(model ? model->triangles.size() : 0);
    }
}

} // namespace

uint64_t frameFingerprint(const Frame& frame) {
    Mixer mixer;
    addTarget(mixer, frame.target);
    if (frame.scene) addLayer(mixer, frame);
    for (const std::shared_ptr<const Frame>& layer : frame.below) addLayer(mixer, *layer);
    return mixer.sum();
}

} // namespace smart

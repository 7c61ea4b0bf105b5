// SPDX-License-Identifier: MIT
#include "samples/common/gltf_accessor.h"

#include <algorithm>
#include <cstring>
#include <type_traits>

#include "samples/common/scene_description.h"

namespace samples {
namespace {

template <class T>
T load(const uint8_t* at) {
    T value;
    std::memcpy(&value, at, sizeof value);
    return value;
}

/// glTF 2.0, 3.6.2.2: signed integers are clamped, as -128 and -127 both mean -1.
template <class T>
float number(const uint8_t* at, bool normalized) {
    const float value = float(load<T>(at));
    if (!normalized) return value;
    const float scaled = value / float(std::numeric_limits<T>::max());
    return std::is_signed_v<T> ? std::max(scaled, -1.0f) : scaled;
}

} // namespace

std::span<const uint8_t> bufferViewBytes(const tinygltf::Model& model, int view) {
    const std::string name = "buffer view " + std::to_string(view);
    if (view < 0 || std::size_t(view) >= model.bufferViews.size()) {
        throw LoadError("there is no " + name);
    }
    const tinygltf::BufferView& range = model.bufferViews[std::size_t(view)];
    if (range.buffer < 0 || std::size_t(range.buffer) >= model.buffers.size()) {
        throw LoadError(name + " lies in no buffer");
    }
    const auto& data = model.buffers[std::size_t(range.buffer)].data;
    if (range.byteOffset > data.size() || range.byteLength > data.size() - range.byteOffset) {
        throw LoadError(name + " reaches beyond its buffer");
    }
    return {data.data() + range.byteOffset, range.byteLength};
}

GltfAccessor::GltfAccessor(const tinygltf::Model& model, int index,
                           std::initializer_list<int> types, std::string what) {
    what = "accessor " + std::to_string(index) + " (" + what + ")";
    if (index < 0 || std::size_t(index) >= model.accessors.size()) {
        throw LoadError(what + " does not exist");
    }
    const tinygltf::Accessor& accessor = model.accessors[std::size_t(index)];
    if (accessor.sparse.isSparse) throw LoadError(what + " is sparse, which is not supported");
    if (std::find(types.begin(), types.end(), accessor.type) == types.end()) {
        throw LoadError(what + " has the wrong number of components");
    }
    const int componentBytes =
        tinygltf::GetComponentSizeInBytes(uint32_t(accessor.componentType));
    if (componentBytes <= 0 || accessor.componentType == TINYGLTF_COMPONENT_TYPE_DOUBLE ||
        accessor.componentType == TINYGLTF_COMPONENT_TYPE_INT) {
        throw LoadError(what + " has a wrong component type");
    }
    const std::span<const uint8_t> view = bufferViewBytes(model, accessor.bufferView);
    components_ = tinygltf::GetNumComponentsInType(uint32_t(accessor.type));
    componentType_ = accessor.componentType;
    componentBytes_ = std::size_t(componentBytes);
    normalized_ = accessor.normalized;
    count_ = accessor.count;

    const std::size_t element = componentBytes_ * std::size_t(components_);
    const std::size_t stride = model.bufferViews[std::size_t(accessor.bufferView)].byteStride;
    stride_ = stride == 0 ? element : stride;
    if (stride_ < element) throw LoadError(what + " has a stride smaller than its elements");
    if (count_ == 0) return;
    if (accessor.byteOffset > view.size() || element > view.size() - accessor.byteOffset ||
        count_ - 1 > (view.size() - accessor.byteOffset - element) / stride_) {
        throw LoadError(what + " reaches beyond its buffer view");
    }
    bytes_ = view.subspan(accessor.byteOffset);
}

float GltfAccessor::value(std::size_t i, int c) const {
    const uint8_t* at = bytes_.data() + i * stride_ + std::size_t(c) * componentBytes_;
    switch (componentType_) {
    case TINYGLTF_COMPONENT_TYPE_BYTE: return number<int8_t>(at, normalized_);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return number<uint8_t>(at, normalized_);
    case TINYGLTF_COMPONENT_TYPE_SHORT: return number<int16_t>(at, normalized_);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return number<uint16_t>(at, normalized_);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: return number<uint32_t>(at, normalized_);
    default: return load<float>(at);
    }
}

bool GltfAccessor::holdsIndices() const {
    return componentType_ == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
           componentType_ == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
           componentType_ == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

uint32_t GltfAccessor::index(std::size_t i) const {
    const uint8_t* at = bytes_.data() + i * stride_;
    switch (componentType_) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return *at;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return load<uint16_t>(at);
    default: return load<uint32_t>(at);
    }
}

} // namespace samples

// SPDX-License-Identifier: MIT
#include "samples/common/gltf_accessor.h"

#include <algorithm>
#include <array>
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

/// The bytes of a view from `offset` on, where `count` elements must lie.
std::span<const uint8_t> elements(std::span<const uint8_t> view, std::size_t offset,
                                  std::size_t count, std::size_t element, std::size_t stride,
                                  const std::string& what) {
    if (count == 0) return {};
    if (offset > view.size() || element > view.size() - offset ||
        count - 1 > (view.size() - offset - element) / stride) {
        throw LoadError(what + " reaches beyond its buffer view");
    }
    return view.subspan(offset);
}

bool isIndexType(int componentType) {
    return componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
           componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
           componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

uint32_t indexAt(const uint8_t* at, int componentType) {
    switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return *at;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return load<uint16_t>(at);
    default: return load<uint32_t>(at);
    }
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
    if (std::find(types.begin(), types.end(), accessor.type) == types.end()) {
        throw LoadError(what + " has the wrong number of components");
    }
    const int componentBytes =
        tinygltf::GetComponentSizeInBytes(uint32_t(accessor.componentType));
    if (componentBytes <= 0 || accessor.componentType == TINYGLTF_COMPONENT_TYPE_DOUBLE ||
        accessor.componentType == TINYGLTF_COMPONENT_TYPE_INT) {
        throw LoadError(what + " has a wrong component type");
    }
    components_ = tinygltf::GetNumComponentsInType(uint32_t(accessor.type));
    componentType_ = accessor.componentType;
    componentBytes_ = std::size_t(componentBytes);
    normalized_ = accessor.normalized;
    count_ = accessor.count;

    const std::size_t element = componentBytes_ * std::size_t(components_);
    const bool zeros = accessor.sparse.isSparse && accessor.bufferView < 0;
    if (!zeros) {
        const std::span<const uint8_t> view = bufferViewBytes(model, accessor.bufferView);
        const std::size_t stride = model.bufferViews[std::size_t(accessor.bufferView)].byteStride;
        stride_ = stride == 0 ? element : stride;
        if (stride_ < element) throw LoadError(what + " has a stride smaller than its elements");
        bytes_ = elements(view, accessor.byteOffset, count_, element, stride_, what);
    }
    if (accessor.sparse.isSparse) readReplacements(model, accessor, element, what);
}

void GltfAccessor::readReplacements(const tinygltf::Model& model,
                                    const tinygltf::Accessor& accessor, std::size_t element,
                                    const std::string& what) {
    const auto& [count, isSparse, indices, values] = accessor.sparse;
    if (!isIndexType(indices.componentType)) {
        throw LoadError(what + " has sparse indices of a wrong component type");
    }
    // A negative count or offset becomes one that is beyond any buffer view.
    const auto size =
        std::size_t(tinygltf::GetComponentSizeInBytes(uint32_t(indices.componentType)));
    const auto at = elements(bufferViewBytes(model, indices.bufferView),
                             std::size_t(indices.byteOffset), std::size_t(count), size, size, what);
    replacements_ = elements(bufferViewBytes(model, values.bufferView),
                             std::size_t(values.byteOffset), std::size_t(count), element, element,
                             what);
    for (std::size_t i = 0; i < std::size_t(count); ++i) {
        const uint32_t index = indexAt(at.data() + i * size, indices.componentType);
        if (index >= count_ || (i > 0 && index <= replaced_.back())) {
            throw LoadError(what + " has sparse indices out of order");
        }
        replaced_.push_back(index);
    }
}

const uint8_t* GltfAccessor::element(std::size_t i) const {
    static constexpr std::array<uint8_t, 64> kZeros{}; // as many as a matrix has
    const auto at = std::lower_bound(replaced_.begin(), replaced_.end(), i);
    if (at != replaced_.end() && *at == i) {
        return replacements_.data() +
               std::size_t(at - replaced_.begin()) * componentBytes_ * std::size_t(components_);
    }
    return bytes_.empty() ? kZeros.data() : bytes_.data() + i * stride_;
}

float GltfAccessor::value(std::size_t i, int c) const {
    const uint8_t* at = element(i) + std::size_t(c) * componentBytes_;
    switch (componentType_) {
    case TINYGLTF_COMPONENT_TYPE_BYTE: return number<int8_t>(at, normalized_);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return number<uint8_t>(at, normalized_);
    case TINYGLTF_COMPONENT_TYPE_SHORT: return number<int16_t>(at, normalized_);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return number<uint16_t>(at, normalized_);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: return number<uint32_t>(at, normalized_);
    default: return load<float>(at);
    }
}

bool GltfAccessor::holdsIndices() const { return isIndexType(componentType_); }

uint32_t GltfAccessor::index(std::size_t i) const { return indexAt(element(i), componentType_); }

} // namespace samples

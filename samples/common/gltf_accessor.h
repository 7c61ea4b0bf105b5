// SPDX-License-Identifier: MIT
#pragma once

#include <tiny_gltf.h>

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

namespace samples {

/// The bytes of a buffer view, checked against its buffer; throws LoadError.
std::span<const uint8_t> bufferViewBytes(const tinygltf::Model& model, int view);

/// Reads an accessor's elements, sparse ones too. All ranges are checked when it is made; throws
/// LoadError.
class GltfAccessor {
public:
    /// types: the TINYGLTF_TYPE_* that are meant to be here. `what` names it in errors.
    GltfAccessor(const tinygltf::Model& model, int index, std::initializer_list<int> types,
                 std::string what);

    std::size_t count() const { return count_; }
    int components() const { return components_; }
    /// Component c of element i; integers are scaled if the accessor is normalised.
    float value(std::size_t i, int c) const;
    /// Element i of an accessor of unsigned integers.
    uint32_t index(std::size_t i) const;
    bool holdsIndices() const;

private:
    void readReplacements(const tinygltf::Model& model, const tinygltf::Accessor& accessor,
                          std::size_t element, const std::string& what);
    const uint8_t* element(std::size_t i) const;

    std::span<const uint8_t> bytes_;        ///< empty: zeros
    std::vector<uint32_t> replaced_;        ///< elements of a sparse accessor, in order
    std::span<const uint8_t> replacements_; ///< packed, one for each of these
    std::size_t count_ = 0, stride_ = 0, componentBytes_ = 0;
    int components_ = 0, componentType_ = 0;
    bool normalized_ = false;
};

} // namespace samples

// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "openrt/rts.h"

namespace smart {

inline constexpr std::size_t kMaxVertexBlock = 256 * sizeof(float);
inline constexpr std::size_t kMaxShaderAlignment = 64;
inline constexpr std::size_t kBlockAlignment = 16; ///< of per-triangle and per-vertex blocks

/// A class of shaders: a copy of its descriptor, and whatever keeps its code loaded. Immutable.
class ShaderClass {
public:
    /// Bytes of a shader's or triangle's parameters together.
    static constexpr std::size_t kMaxBlock = std::size_t(1) << 20;

    /// Checks the descriptor (sizes, version, kind, functions that the kind needs, parameters
    /// inside their blocks, sizes that fit the types, unique names) and asks it for its defaults;
    /// throws Error with the reason. `module` is released after the class.
    ShaderClass(const RTshaderclass& descriptor, std::shared_ptr<const void> module);
    ~ShaderClass() = default;
    ShaderClass(const ShaderClass&) = delete;
    ShaderClass& operator=(const ShaderClass&) = delete;

    const RTshaderclass& descriptor() const { return descriptor_; } ///< strings and arrays are ours
    RTenum kind() const { return descriptor_.kind; }
    const std::string& name() const { return name_; }
    /// Index of a parameter by name; -1 if there is none.
    int findParameter(std::string_view name) const;
    const RTSparameter& parameter(uint32_t index) const { return parameters_[index]; }
    uint32_t parameterCount() const { return uint32_t(parameters_.size()); }
    /// Blocks of per-triangle and per-vertex parameters with the class's defaults.
    const std::vector<std::byte>& triangleDefaults() const { return triangleDefaults_; }
    const std::vector<std::byte>& vertexDefaults() const { return vertexDefaults_; }

private:
    std::shared_ptr<const void> module_; // first: outlives everything that may call its code
    RTshaderclass descriptor_ = {};
    std::string name_;
    std::vector<RTSparameter> parameters_;
    std::vector<std::string> parameterNames_;
    std::vector<std::byte> triangleDefaults_, vertexDefaults_;
};

using ShaderClassPtr = std::shared_ptr<const ShaderClass>;

/// Bytes of a parameter's value as a caller gives it: 4 for a bool, which is given as an int.
/// 0 for a string, whose length is free.
std::size_t valueSize(const RTSparameter& parameter);

/// Writes a value of valueSize() bytes, no string, to its place in the block of its scope.
void writeValue(const RTSparameter& parameter, std::span<const std::byte> value, std::byte* block);

} // namespace smart

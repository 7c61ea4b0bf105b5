// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "libsmart/shading/shader_class.h"

namespace smart {

/// Values of per-shader parameters by index; see Shader::set.
using ParameterValues = std::map<uint32_t, std::vector<std::byte>>;

/// A shader as frames see it: a constructed block with its parameters written. Immutable, shared
/// by threads without locks; it keeps its class's code loaded.
class ShaderObject {
public:
    /// Throws Error when the class's constructor fails.
    ShaderObject(ShaderClassPtr shaderClass, const ParameterValues& values);
    ~ShaderObject();
    ShaderObject(const ShaderObject&) = delete;
    ShaderObject& operator=(const ShaderObject&) = delete;

    const ShaderClass& shaderClass() const { return *class_; }
    const RTshaderclass& functions() const { return class_->descriptor(); }
    const void* block() const { return block_; }
    /// What a surface reads of a point: RTS_READS_...
    uint32_t reads() const { return reads_; }

private:
    ShaderClassPtr class_;
    std::vector<std::string> strings_;
    std::vector<std::byte> storage_;
    std::byte* block_ = nullptr;
    uint32_t reads_ = RTS_READS_EVERYTHING;
};

/// Shaders by index as one frame sees them. An index without a shader holds nullptr.
using ShaderTable = std::vector<std::shared_ptr<const ShaderObject>>;

} // namespace smart

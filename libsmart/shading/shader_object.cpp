// SPDX-License-Identifier: MIT
#include "libsmart/shading/shader_object.h"

#include <cstring>
#include <memory>

#include "libsmart/base/error.h"

namespace smart {

ShaderObject::ShaderObject(ShaderClassPtr shaderClass, const ParameterValues& values)
    : class_(std::move(shaderClass)) {
    const RTshaderclass& d = class_->descriptor();

    // Copy the strings first: the block will point into them.
    strings_.reserve(values.size());
    for (const auto& [index, bytes] : values)
        if (class_->parameter(index).type == RTS_STRING)
            strings_.emplace_back(reinterpret_cast<const char*>(bytes.data()), bytes.size());

    if (d.shaderSize) {
        storage_.resize(d.shaderSize + kMaxShaderAlignment);
        void* aligned = storage_.data();
        std::size_t space = storage_.size();
        block_ = static_cast<std::byte*>(
            std::align(kMaxShaderAlignment, d.shaderSize, aligned, space));
    }
    // The class's constructor fills all three blocks; only the shader's is wanted here.
    alignas(kBlockAlignment) std::byte vertexBlock[kMaxVertexBlock] = {};
    std::vector<std::byte> triangleBlock(d.triangleSize);
    if (d.construct(block_, d.triangleSize ? triangleBlock.data() : nullptr,
                    d.vertexSize ? vertexBlock : nullptr) != 0)
        throw Error(ErrorCode::InvalidOperation,
                    "the constructor of shader class '" + class_->name() + "' failed");

    auto string = strings_.begin();
    for (const auto& [index, bytes] : values) {
        const RTSparameter& p = class_->parameter(index);
        if (p.type == RTS_STRING) {
            const char* characters = (string++)->c_str();
            std::memcpy(block_ + p.offset, &characters, sizeof(characters));
        } else {
            writeValue(p, bytes, block_);
        }
    }
    if (d.kind == RT_SURFACE_SHADER && d.reads) reads_ = d.reads(block_);
}

ShaderObject::~ShaderObject() {
    if (class_->descriptor().destroy) class_->descriptor().destroy(block_);
}

} // namespace smart

// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "libsmart/shading/shader_registry.h"

namespace smart::compat {

/// A shader by its id, with what it latches into triangles and vertices.
struct BoundShader {
    uint32_t id = 0;
    uint32_t classId = 0; ///< under which it was made
    std::shared_ptr<Shader> shader;
    /// Current per-triangle and per-vertex parameters, and numbers that name their contents:
    /// equal numbers, equal contents.
    std::vector<std::byte> triangleBlock, vertexBlock;
    uint64_t triangleStamp = 0, vertexStamp = 0;

    bool isSurface = false;

    RTenum kind() const { return shader->shaderClass()->kind(); }
};
using BoundShaderPtr = std::shared_ptr<BoundShader>;

/// A parameter value as a call gives it.
struct ParameterValue {
    RTStype type;
    std::span<const std::byte> bytes; ///< of a string its characters without the zero
};

/// The classes, shaders and parameter handles of one context, and which are bound. Ids and
/// handles count from 1 and are never used again; shader 0 is the default surface, class 0 none.
/// A function that throws has changed nothing.
class ShaderCatalog {
public:
    ShaderCatalog();

    /// Makes a class known by its name and adds it; the newest of a name is found first.
    uint32_t registerClass(ShaderClassPtr shaderClass);
    /// Registered or built-in class; nullptr: none such.
    ShaderClassPtr findClass(std::string_view name) const;

    uint32_t addClass(ShaderClassPtr shaderClass);
    void bindClass(uint32_t id);
    void removeClass(uint32_t id);
    uint32_t boundClass() const { return boundClass_; }
    /// Throws Error (InvalidValue) for an unknown id.
    const ShaderClassPtr& shaderClass(uint32_t id) const;

    uint32_t newShader();
    void bindShader(uint32_t id);
    void removeShader(uint32_t id);
    /// Throws Error (InvalidValue) for an unknown id.
    const BoundShaderPtr& shader(uint32_t id) const;
    const BoundShader& bound() const { return *bound_; }

    uint32_t parameterHandle(std::string_view name);
    void setParameter(uint32_t handle, const ParameterValue& value);

    std::shared_ptr<const ShaderTable> freeze() { return registry_.freeze(); }

private:
    struct Handle {
        std::weak_ptr<const ShaderClass> shaderClass; ///< a handle keeps no library loaded
        uint32_t parameter;
    };
    BoundShaderPtr makeShader(uint32_t id, uint32_t classId, std::shared_ptr<Shader> shader);

    ShaderRegistry registry_;
    std::vector<ShaderClassPtr> registered_;
    std::map<uint32_t, ShaderClassPtr> classes_;
    std::map<uint32_t, BoundShaderPtr> shaders_;
    std::vector<Handle> handles_; ///< by handle - 1
    std::map<std::pair<const ShaderClass*, uint32_t>, uint32_t> handleOf_;
    uint32_t lastClass_ = 0, lastShader_ = 0;
    uint64_t lastStamp_ = 0;
    uint32_t boundClass_ = 0;
    BoundShaderPtr bound_;
};

} // namespace smart::compat

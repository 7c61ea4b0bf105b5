// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "openrt/rts.h"

namespace smart {

/// A class of shaders: a copy of its descriptor, and whatever keeps its code loaded. Immutable.
class ShaderClass {
public:
    /// Checks the descriptor (sizes, version, kind, functions that the kind needs, parameters
    /// inside their blocks, sizes that fit the types, unique names); throws Error with the reason.
    /// `module` is released after the class.
    ShaderClass(const RTshaderclass& descriptor, std::shared_ptr<const void> module);

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
    RTshaderclass descriptor_;
    std::string name_;
    std::vector<RTSparameter> parameters_;
    std::vector<std::string> parameterNames_;
    std::vector<std::byte> triangleDefaults_, vertexDefaults_;
};

using ShaderClassPtr = std::shared_ptr<const ShaderClass>;

/// A shader as frames see it: a constructed block with its parameters written. Immutable.
class ShaderObject {
public:
    /// Throws Error when the class's constructor fails.
    ShaderObject(ShaderClassPtr shaderClass, const std::map<uint32_t, std::vector<std::byte>>& values);
    ~ShaderObject();
    ShaderObject(const ShaderObject&) = delete;
    ShaderObject& operator=(const ShaderObject&) = delete;

    const ShaderClass& shaderClass() const { return *class_; }
    const RTshaderclass& functions() const { return class_->descriptor(); }
    const void* block() const { return block_; }

private:
    ShaderClassPtr class_;
    std::vector<std::string> strings_;
    std::vector<std::byte> storage_;
    void* block_ = nullptr;
};

/// Shaders by index as one frame sees them. An index without a shader holds nullptr.
using ShaderTable = std::vector<std::shared_ptr<const ShaderObject>>;

class ShaderRegistry;

/// A shader of the application: a class and the parameter values set so far. Belongs to one
/// context's thread; its index is never used again after it is gone.
class Shader {
public:
    Shader(ShaderRegistry& registry, ShaderClassPtr shaderClass, uint32_t index);
    ~Shader();
    const ShaderClassPtr& shaderClass() const { return class_; }
    uint32_t index() const { return index_; }
    /// Sets a per-shader parameter; seen by frames frozen from then on. `bytes` as the
    /// parameter's type wants them (a string: its characters without the terminating zero).
    void set(uint32_t parameter, std::vector<std::byte> bytes);

private:
    friend class ShaderRegistry;
    ShaderRegistry& registry_;
    ShaderClassPtr class_;
    uint32_t index_;
    std::map<uint32_t, std::vector<std::byte>> values_;
    std::shared_ptr<const ShaderObject> frozen_; // reset by set()
};

/// Makes shaders and freezes them for frames. Belongs to one context's thread, except that the
/// last owner of a Shader may be any thread.
class ShaderRegistry {
public:
    ShaderRegistry();
    ~ShaderRegistry();
    /// Index 0 is the default surface (class "FixedFunction"), made with the registry.
    std::shared_ptr<Shader> create(ShaderClassPtr shaderClass);
    const std::shared_ptr<Shader>& defaultSurface() const { return defaultSurface_; }
    /// Immutable objects of all living shaders. The same table again if nothing changed since.
    std::shared_ptr<const ShaderTable> freeze();

private:
    friend class Shader;
    struct State; // shared with living shaders; guards the list of those that exist
    std::shared_ptr<State> state_;
    std::shared_ptr<Shader> defaultSurface_;
};

/// Built-in class by SMART's or our name; nullptr: none such.
ShaderClassPtr findBuiltinClass(std::string_view name);
/// Names of all built-in classes.
std::vector<std::string> builtinClassNames();

} // namespace smart

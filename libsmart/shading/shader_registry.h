// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "libsmart/shading/shader_class.h"
#include "libsmart/shading/shader_object.h"

namespace smart {

/// A shader of the application: a class and the parameter values set so far. Belongs to one
/// context's thread, except that its last owner may be any thread, and may outlive the registry.
/// Whatever refers to a shader by its index keeps it alive: once it is gone another one gets the
/// index. Made by ShaderRegistry.
class Shader : public std::enable_shared_from_this<Shader> {
public:
    ~Shader();
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;

    const ShaderClassPtr& shaderClass() const { return class_; }
    uint32_t index() const { return index_; }
    /// Sets a per-shader parameter; seen by frames frozen from then on. `bytes`: valueSize() of
    /// them; for a string its characters without the terminating zero. Throws Error if the
    /// parameter does not exist, is not per shader or has another size; nothing changes then.
    void set(uint32_t parameter, std::vector<std::byte> bytes);

private:
    friend class ShaderRegistry;
    struct Registered; // the list of living shaders, shared with the registry
    Shader(std::shared_ptr<Registered> registered, ShaderClassPtr shaderClass);

    std::shared_ptr<Registered> registered_;
    ShaderClassPtr class_;
    uint32_t index_ = 0;
    ParameterValues values_;
    std::shared_ptr<const ShaderObject> frozen_; // reset by set()
};

/// Makes shaders and freezes them for frames. Belongs to one context's thread.
class ShaderRegistry {
public:
    ShaderRegistry();
    ~ShaderRegistry();
    ShaderRegistry(const ShaderRegistry&) = delete;
    ShaderRegistry& operator=(const ShaderRegistry&) = delete;

    std::shared_ptr<Shader> create(ShaderClassPtr shaderClass);
    /// The shader of index 0: class "FixedFunction", made with the registry.
    const std::shared_ptr<Shader>& defaultSurface() const { return defaultSurface_; }
    /// Immutable objects of all living shaders; a shader that did not change keeps its object.
    /// The same table again if nothing changed since. A shader whose constructor fails has no
    /// object in it, and is tried again the next time.
    std::shared_ptr<const ShaderTable> freeze();

private:
    static std::shared_ptr<const ShaderTable> freeze(
        const std::vector<std::shared_ptr<Shader>>& shaders, bool& failed);

    std::shared_ptr<Shader::Registered> registered_;
    std::shared_ptr<Shader> defaultSurface_;
};

/// Built-in class by SMART's or our name; nullptr: none such. From any thread.
ShaderClassPtr findBuiltinClass(std::string_view name);
/// Names of all built-in classes, in alphabetical order.
std::vector<std::string> builtinClassNames();

} // namespace smart

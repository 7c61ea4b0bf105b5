// SPDX-License-Identifier: MIT
#include "libsmart/shading/shader_registry.h"

#include <algorithm>
#include <mutex>

#include "libsmart/base/error.h"

namespace smart {

/// Shaders leave it from any thread; everything else happens on the context's.
struct Shader::Registered {
    std::mutex mutex;
    std::vector<Shader*> living; // by index; nullptr: free
    std::size_t freeIndices = 0;
    bool changed = true;         // since `table` was made
    std::shared_ptr<const ShaderTable> table;

    void change() {
        const std::lock_guard lock(mutex);
        changed = true;
    }
};

Shader::Shader(std::shared_ptr<Registered> registered, ShaderClassPtr shaderClass)
    : registered_(std::move(registered)), class_(std::move(shaderClass)) {
    const std::lock_guard lock(registered_->mutex);
    std::vector<Shader*>& living = registered_->living;
    const auto place = registered_->freeIndices != 0
                           ? std::find(living.begin(), living.end(), nullptr)
                           : living.end();
    index_ = uint32_t(place - living.begin());
    if (place == living.end()) {
        living.push_back(this);
    } else {
        *place = this;
        --registered_->freeIndices;
    }
    registered_->changed = true;
}

Shader::~Shader() {
    const std::lock_guard lock(registered_->mutex);
    registered_->living[index_] = nullptr;
    ++registered_->freeIndices;
    registered_->changed = true;
}

void Shader::set(uint32_t parameter, std::vector<std::byte> bytes) {
    const auto refuse = [&](const std::string& reason) {
        throw Error(ErrorCode::InvalidOperation,
                    "shader class '" + class_->name() + "': " + reason);
    };
    if (parameter >= class_->parameterCount()) refuse("no such parameter");
    const RTSparameter& p = class_->parameter(parameter);
    const std::string name = "parameter '" + std::string(p.name) + "' ";
    if (p.scope != RTS_PER_SHADER) refuse(name + "is not per shader");
    if (p.type != RTS_STRING && bytes.size() != valueSize(p))
        refuse(name + "takes " + std::to_string(valueSize(p)) + " bytes, not " +
               std::to_string(bytes.size()));
    const auto [entry, isNew] = values_.try_emplace(parameter);
    if (!isNew && entry->second == bytes) return;
    entry->second = std::move(bytes);
    frozen_.reset();
    registered_->change();
}

ShaderRegistry::ShaderRegistry() : registered_(std::make_shared<Shader::Registered>()) {
    defaultSurface_ = create(findBuiltinClass("FixedFunction"));
}

ShaderRegistry::~ShaderRegistry() = default;

std::shared_ptr<Shader> ShaderRegistry::create(ShaderClassPtr shaderClass) {
    return std::shared_ptr<Shader>(new Shader(registered_, std::move(shaderClass)));
}

// Constructors and destructors of shaders are the application's code, which may call the library:
// they run while nothing is locked.
std::shared_ptr<const ShaderTable> ShaderRegistry::freeze() {
    std::vector<std::shared_ptr<Shader>> living; // until the table is made none of them leaves
    {
        const std::lock_guard lock(registered_->mutex);
        if (!registered_->changed) return registered_->table;
        living.reserve(registered_->living.size());
        for (Shader* shader : registered_->living)
            living.push_back(shader ? shader->weak_from_this().lock() : nullptr);
        registered_->changed = false;
    }
    try {
        bool failed = false;
        std::shared_ptr<const ShaderTable> table = freeze(living, failed);
        if (failed) registered_->change(); // tried again next time
        const std::lock_guard lock(registered_->mutex);
        registered_->table.swap(table);
        return registered_->table;
    } catch (...) {
        registered_->change();
        throw;
    }
}

std::shared_ptr<const ShaderTable> ShaderRegistry::freeze(
    const std::vector<std::shared_ptr<Shader>>& shaders, bool& failed) {
    auto table = std::make_shared<ShaderTable>(shaders.size());
    for (std::size_t i = 0; i < shaders.size(); ++i) {
        if (!shaders[i]) continue;
        Shader& shader = *shaders[i];
        if (!shader.frozen_) {
            try {
                const ParameterValues values = shader.values_; // which its constructor may set
                shader.frozen_ = std::make_shared<const ShaderObject>(shader.class_, values);
            } catch (const Error&) {
                failed = true; // without an object only what uses this shader suffers
                continue;
            }
        }
        (*table)[i] = shader.frozen_;
    }
    return table;
}

} // namespace smart

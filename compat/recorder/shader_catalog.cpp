// SPDX-License-Identifier: MIT
#include "compat/recorder/shader_catalog.h"

#include <string>

#include "libsmart/base/error.h"

namespace smart::compat {

ShaderCatalog::ShaderCatalog() {
    bound_ = makeShader(0, 0, registry_.defaultSurface());
    shaders_.emplace(0, bound_);
}

BoundShaderPtr ShaderCatalog::makeShader(uint32_t id, uint32_t classId,
                                         std::shared_ptr<Shader> shader) {
    auto entry = std::make_shared<BoundShader>();
    entry->id = id;
    entry->classId = classId;
    entry->triangleBlock = shader->shaderClass()->triangleDefaults();
    entry->vertexBlock = shader->shaderClass()->vertexDefaults();
    entry->triangleStamp = ++lastStamp_;
    entry->vertexStamp = ++lastStamp_;
    entry->shader = std::move(shader);
    entry->isSurface = entry->kind() == RT_SURFACE_SHADER;
    return entry;
}

uint32_t ShaderCatalog::registerClass(ShaderClassPtr shaderClass) {
    registered_.push_back(shaderClass);
    try {
        return addClass(std::move(shaderClass));
    } catch (...) {
        registered_.pop_back();
        throw;
    }
}

ShaderClassPtr ShaderCatalog::findClass(std::string_view name) const {
    for (auto c = registered_.rbegin(); c != registered_.rend(); ++c)
        if ((*c)->name() == name) return *c;
    return findBuiltinClass(name);
}

uint32_t ShaderCatalog::addClass(ShaderClassPtr shaderClass) {
    classes_.emplace(lastClass_ + 1, std::move(shaderClass));
    bindClass(++lastClass_);
    return lastClass_;
}

const ShaderClassPtr& ShaderCatalog::shaderClass(uint32_t id) const {
    const auto found = classes_.find(id);
    if (found == classes_.end())
        throw Error(ErrorCode::InvalidValue, "no shader class has the id " + std::to_string(id));
    return found->second;
}

void ShaderCatalog::bindClass(uint32_t id) {
    if (id != 0) shaderClass(id);
    boundClass_ = id;
    bound_ = shaders_.at(0);
}

void ShaderCatalog::removeClass(uint32_t id) {
    shaderClass(id);
    classes_.erase(id);
    if (boundClass_ == id) boundClass_ = 0;
}

uint32_t ShaderCatalog::newShader() {
    if (boundClass_ == 0) throw Error(ErrorCode::InvalidOperation, "no shader class is bound");
    auto entry = makeShader(lastShader_ + 1, boundClass_, registry_.create(shaderClass(boundClass_)));
    shaders_.emplace(entry->id, entry);
    bound_ = std::move(entry);
    return ++lastShader_;
}

const BoundShaderPtr& ShaderCatalog::shader(uint32_t id) const {
    const auto found = shaders_.find(id);
    if (found == shaders_.end())
        throw Error(ErrorCode::InvalidValue, "no shader has the id " + std::to_string(id));
    return found->second;
}

void ShaderCatalog::bindShader(uint32_t id) {
    bound_ = shader(id);
    boundClass_ = classes_.contains(bound_->classId) ? bound_->classId : 0;
}

void ShaderCatalog::removeShader(uint32_t id) {
    if (id == 0) throw Error(ErrorCode::InvalidValue, "shader 0 can not be removed");
    shader(id);
    shaders_.erase(id);
    if (bound_->id == id) bound_ = shaders_.at(0);
}

uint32_t ShaderCatalog::parameterHandle(std::string_view name) {
    if (boundClass_ == 0) throw Error(ErrorCode::InvalidOperation, "no shader class is bound");
    const ShaderClassPtr& bound = shaderClass(boundClass_);
    const int parameter = bound->findParameter(name);
    if (parameter < 0)
        throw Error(ErrorCode::InvalidValue,
                    "class " + bound->name() + " has no parameter '" + std::string(name) + "'");
    const auto entry = handleOf_.try_emplace({bound.get(), uint32_t(parameter)}, 0).first;
    const bool known = entry->second != 0 &&
                       handles_[entry->second - 1].shaderClass.lock() == bound; // not its successor
    if (!known) {
        handles_.push_back({bound, uint32_t(parameter)});
        entry->second = uint32_t(handles_.size());
    }
    return entry->second;
}

void ShaderCatalog::setParameter(uint32_t handle, const ParameterValue& value) {
    if (handle == 0 || handle > handles_.size())
        throw Error(ErrorCode::InvalidValue,
                    "no parameter has the handle " + std::to_string(handle));
    const Handle& target = handles_[handle - 1];
    const ShaderClassPtr owner = target.shaderClass.lock();
    if (!owner) throw Error(ErrorCode::InvalidOperation, "the class of the handle is gone");
    const RTSparameter& parameter = owner->parameter(target.parameter);
    if (bound_->shader->shaderClass() != owner)
        throw Error(ErrorCode::InvalidOperation,
                    "the bound shader is not of class " + owner->name());
    if (parameter.type != value.type ||
        (value.type != RTS_STRING && valueSize(parameter) != value.bytes.size()))
        throw Error(ErrorCode::InvalidOperation,
                    std::string("parameter '") + parameter.name + "' is of another type");
    switch (parameter.scope) {
    case RTS_PER_SHADER:
        bound_->shader->set(target.parameter, {value.bytes.begin(), value.bytes.end()});
        break;
    case RTS_PER_TRIANGLE:
        writeValue(parameter, value.bytes, bound_->triangleBlock.data());
        bound_->triangleStamp = ++lastStamp_;
        break;
    case RTS_PER_VERTEX:
        writeValue(parameter, value.bytes, bound_->vertexBlock.data());
        bound_->vertexStamp = ++lastStamp_;
        break;
    }
}

} // namespace smart::compat

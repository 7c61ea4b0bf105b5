// SPDX-License-Identifier: MIT
#include "libsmart/shading/shader_class.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>
#include <set>

#include "libsmart/base/error.h"

namespace smart {

namespace {

constexpr std::size_t kMaxParameters = 4096;
/// Bytes of the descriptor as it first was; what was added at its end since then is optional.
constexpr std::size_t kFirstDescriptor = offsetof(RTshaderclass, shadePacket);

[[noreturn]] void refuse(const std::string& shaderClass, const std::string& reason) {
    throw Error(ErrorCode::InvalidValue, "shader class '" + shaderClass + "': " + reason);
}

/// Of an enumeration that another program has set: perhaps none of its values, which may not be
/// read as such.
template <class Enumeration>
int numberOf(const Enumeration& value) {
    static_assert(sizeof(Enumeration) == sizeof(int));
    int number = 0;
    std::memcpy(&number, &value, sizeof(number));
    return number;
}

/// Bytes that the type asks for; 0: any number of them (RTS_RAW). Not a type: refused.
std::size_t sizeOfType(const std::string& shaderClass, const RTSparameter& p) {
    switch (numberOf(p.type)) {
    case RTS_INT1: return p.size == 1 ? 1 : 4;
    case RTS_INT2: return 8;
    case RTS_INT3: return 12;
    case RTS_FLOAT1: return 4;
    case RTS_FLOAT2: return 8;
    case RTS_FLOAT3: return 12;
    case RTS_FLOAT4: return 16;
    case RTS_FLOAT16: return 64;
    case RTS_RAW: return 0;
    case RTS_STRING: return sizeof(const char*);
    default:
        refuse(shaderClass, "parameter '" + std::string(p.name) + "' has the unknown type " +
                                std::to_string(numberOf(p.type)));
    }
}

bool isFloat(RTStype type) { return type >= RTS_FLOAT1 && type <= RTS_FLOAT16; }

void checkFunctions(const RTshaderclass& d, const std::string& name) {
    const auto need = [&](bool there, const char* function) {
        if (!there) refuse(name, std::string("its kind needs the function ") + function);
    };
    need(d.construct != nullptr, "construct");
    switch (d.kind) {
    case RT_SURFACE_SHADER:
    case RT_ENV_SHADER: need(d.shade != nullptr, "shade"); break;
    case RT_LIGHT_SHADER:
        need(d.illuminate || d.illuminateSample, "illuminate or illuminateSample");
        break;
    case RT_CAMERA_SHADER: need(d.cameraRay != nullptr, "cameraRay"); break;
    case RT_RENDERING_OBJECT_SHADER: need(d.renderPixel != nullptr, "renderPixel"); break;
    default: refuse(name, "unknown kind " + std::to_string(d.kind));
    }
}

void checkBlocks(const RTshaderclass& d, const std::string& name) {
    if (d.shaderSize > ShaderClass::kMaxBlock || d.triangleSize > ShaderClass::kMaxBlock)
        refuse(name, "a parameter block is larger than 1 MiB");
    if (d.vertexSize > kMaxVertexBlock)
        refuse(name, "the per-vertex block holds more than 256 floats");
    if (d.vertexSize % sizeof(float) != 0)
        refuse(name, "the per-vertex block's size is no multiple of a float's");
    if (d.alignment == 0 || (d.alignment & (d.alignment - 1)) != 0 ||
        d.alignment > kMaxShaderAlignment)
        refuse(name, "the alignment " + std::to_string(d.alignment) +
                         " is no power of two from 1 to 64");
    if ((d.triangleSize || d.vertexSize) && d.kind != RT_SURFACE_SHADER)
        refuse(name, "only surfaces have parameters per triangle and per vertex");
    if (d.parameterCount > kMaxParameters) refuse(name, "more than 4096 parameters");
    if (d.parameterCount && !d.parameters) refuse(name, "the list of parameters is missing");
}

void checkParameter(const RTshaderclass& d, const std::string& name, const RTSparameter& p) {
    if (!p.name || !*p.name) refuse(name, "a parameter has no name");
    const std::string parameter = "parameter '" + std::string(p.name) + "'";
    std::size_t block = 0;
    switch (numberOf(p.scope)) {
    case RTS_PER_SHADER: block = d.shaderSize; break;
    case RTS_PER_TRIANGLE: block = d.triangleSize; break;
    case RTS_PER_VERTEX: block = d.vertexSize; break;
    default:
        refuse(name,
               parameter + " has the unknown scope " + std::to_string(numberOf(p.scope)));
    }
    const std::size_t size = sizeOfType(name, p);
    if (size ? p.size != size : p.size == 0)
        refuse(name, parameter + " has " + std::to_string(p.size) + " bytes, its type " +
                         (size ? "has " + std::to_string(size) : "needs one at least"));
    if (p.offset > block || p.size > block - p.offset)
        refuse(name, parameter + " lies outside the block of its scope");
    const std::size_t alignment = p.type == RTS_RAW      ? 1
                                  : p.type == RTS_STRING ? alignof(const char*)
                                  : p.size == 1          ? 1
                                                         : 4;
    if (p.offset % alignment != 0 || (p.scope == RTS_PER_SHADER && d.alignment < alignment))
        refuse(name, parameter + " is not aligned");
    if (p.type == RTS_STRING && p.scope != RTS_PER_SHADER)
        refuse(name, parameter + ": a string can only be a parameter per shader");
    if (p.scope == RTS_PER_VERTEX && !isFloat(p.type))
        refuse(name, parameter + ": per vertex only floats can be interpolated");
}

std::string checkedName(const RTshaderclass& d) {
    if (d.interfaceVersion != RTS_INTERFACE_VERSION)
        throw Error(ErrorCode::InvalidValue,
                    "shader class for version " + std::to_string(d.interfaceVersion) +
                        " of the shader interface; this library has version " +
                        std::to_string(RTS_INTERFACE_VERSION));
    if (d.structSize < kFirstDescriptor)
        throw Error(ErrorCode::InvalidValue,
                    "shader class descriptor of " + std::to_string(d.structSize) +
                        " bytes; at least " + std::to_string(kFirstDescriptor) + " are needed");
    if (!d.name || !*d.name)
        throw Error(ErrorCode::InvalidValue, "shader class without a name");
    return d.name;
}

struct AlignedDelete {
    void operator()(std::byte* p) const {
        ::operator delete(p, std::align_val_t(kMaxShaderAlignment));
    }
};

} // namespace

ShaderClass::ShaderClass(const RTshaderclass& descriptor, std::shared_ptr<const void> module)
    : module_(std::move(module)), name_(checkedName(descriptor)) {
    std::memcpy(&descriptor_, &descriptor,
                std::min<std::size_t>(descriptor.structSize, sizeof(descriptor_)));
    descriptor_.structSize = sizeof(RTshaderclass);
    checkFunctions(descriptor_, name_);
    checkBlocks(descriptor, name_);

    std::set<std::string_view> names;
    for (uint32_t i = 0; i < descriptor.parameterCount; ++i) {
        const RTSparameter& p = descriptor.parameters[i];
        checkParameter(descriptor, name_, p);
        if (!names.insert(p.name).second)
            refuse(name_, "two parameters are named '" + std::string(p.name) + "'");
        parameters_.push_back(p);
        parameterNames_.emplace_back(p.name);
    }
    for (std::size_t i = 0; i < parameters_.size(); ++i)
        parameters_[i].name = parameterNames_[i].c_str();
    descriptor_.name = name_.c_str();
    descriptor_.parameters = parameters_.data();

    // A trial construction yields the defaults, and shows here whether the constructor works.
    triangleDefaults_.resize(descriptor.triangleSize);
    vertexDefaults_.resize(descriptor.vertexSize);
    std::unique_ptr<std::byte, AlignedDelete> block(
        descriptor.shaderSize ? static_cast<std::byte*>(::operator new(
                                    descriptor.shaderSize, std::align_val_t(kMaxShaderAlignment)))
                              : nullptr);
    if (block) std::memset(block.get(), 0, descriptor.shaderSize);
    const auto orNull = [](std::vector<std::byte>& bytes) {
        return bytes.empty() ? nullptr : bytes.data();
    };
    if (descriptor.construct(block.get(), orNull(triangleDefaults_), orNull(vertexDefaults_)) != 0)
        refuse(name_, "its constructor failed");
    if (descriptor.destroy) descriptor.destroy(block.get());
}

int ShaderClass::findParameter(std::string_view name) const {
    for (std::size_t i = 0; i < parameterNames_.size(); ++i)
        if (parameterNames_[i] == name) return int(i);
    return -1;
}

std::size_t valueSize(const RTSparameter& parameter) {
    if (parameter.type == RTS_STRING) return 0;
    return parameter.type == RTS_INT1 ? sizeof(RTint) : parameter.size;
}

void writeValue(const RTSparameter& parameter, std::span<const std::byte> value, std::byte* block) {
    if (parameter.type == RTS_INT1 && parameter.size == 1) {
        RTint number = 0;
        std::memcpy(&number, value.data(), sizeof(number));
        block[parameter.offset] = std::byte(number != 0);
        return;
    }
    std::memcpy(block + parameter.offset, value.data(), parameter.size);
}

} // namespace smart

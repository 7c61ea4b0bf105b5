// SPDX-License-Identifier: MIT
#include <map>

#include "libsmart/shading/builtin/ambient_occlusion.h"
#include "libsmart/shading/builtin/area_lights.h"
#include "libsmart/shading/builtin/cameras.h"
#include "libsmart/shading/builtin/environments.h"
#include "libsmart/shading/builtin/glass.h"
#include "libsmart/shading/builtin/lights.h"
#include "libsmart/shading/builtin/matrix_camera.h"
#include "libsmart/shading/builtin/metallic_roughness.h"
#include "libsmart/shading/builtin/panorama.h"
#include "libsmart/shading/builtin/rendering_objects.h"
#include "libsmart/shading/builtin/surfaces.h"
#include "libsmart/shading/builtin/thin_lens.h"
#include "libsmart/shading/shader_registry.h"

namespace smart {

namespace {

using Classes = std::map<std::string, ShaderClassPtr, std::less<>>;

template <class T>
void add(Classes& classes, const char* name) {
    classes.emplace(name, std::make_shared<ShaderClass>(*openrt::shaderClass<T>(name), nullptr));
}

Classes makeClasses() {
    using namespace builtin;
    Classes classes;
    add<FixedFunction>(classes, "FixedFunction");
    add<ConstantShader>(classes, "ConstantShader");
    add<DiffuseShader>(classes, "DiffuseShader");
    add<TexturedDiffuseShader>(classes, "TexturedDiffuseShader");
    add<TextureShader>(classes, "TextureShader");
    add<MirrorShader>(classes, "MirrorShader");
    add<Phong>(classes, "Phong");
    add<MetallicRoughness>(classes, "MetallicRoughness");
    add<Glass>(classes, "Glass");
    add<AmbientOcclusion>(classes, "AmbientOcclusion");
    add<PointLight>(classes, "PointLight");
    add<SpotLightShader>(classes, "SpotLightShader");
    add<PunctualLight>(classes, "PunctualLight");
    add<DirectionalLight>(classes, "DirectionalLight");
    add<QuadLight>(classes, "QuadLight");
    add<SphereLight>(classes, "SphereLight");
    add<ConstantEnvironment>(classes, "ConstantEnvironment");
    add<ImageEnvironment>(classes, "ImageEnvironment");
    add<PinholeCameraShader>(classes, "PinholeCameraShader");
    add<PinholeCameraShader>(classes, "Pinhole");
    add<Orthographic>(classes, "Orthographic");
    add<ThinLens>(classes, "ThinLens");
    add<Panorama>(classes, "Panorama");
    add<Matrix>(classes, "Matrix");
    add<Default>(classes, "Default");
    add<Antialias>(classes, "Antialias");
    add<PathTracer>(classes, "PathTracer");
    return classes;
}

const Classes& classes() {
    static const Classes all = makeClasses();
    return all;
}

} // namespace

ShaderClassPtr findBuiltinClass(std::string_view name) {
    const auto found = classes().find(name);
    return found == classes().end() ? nullptr : found->second;
}

std::vector<std::string> builtinClassNames() {
    std::vector<std::string> names;
    for (const auto& entry : classes()) names.push_back(entry.first);
    return names;
}

} // namespace smart

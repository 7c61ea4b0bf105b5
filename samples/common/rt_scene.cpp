// SPDX-License-Identifier: MIT
#include "samples/common/rt_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <stdexcept>

namespace samples {
namespace {

RTuint newShader(const char* name) {
    if (rtGenNewShaderClass(name, nullptr) == RT_INVALID) checkRt();
    return rtGenNewShader();
}

void set(const char* name, int value) { rtParameter1i(rtParameterHandle(name), value); }
void set(const char* name, float value) { rtParameter1f(rtParameterHandle(name), value); }
void set(const char* name, const glm::vec3& v) { rtParameter3fv(rtParameterHandle(name), &v.x); }
void set(const char* name, const glm::vec4& v) { rtParameter4fv(rtParameterHandle(name), &v.x); }

int wrapToken(Wrap wrap) {
    switch (wrap) {
    case Wrap::ClampToEdge: return RT_CLAMP_TO_EDGE;
    case Wrap::MirroredRepeat: return RT_MIRRORED_REPEAT;
    default: return RT_REPEAT;
    }
}

/// A shader for the light; of a simpler class where that does.
RTuint newLight(const LightDescription& light) {
    if (light.kind == LightKind::Directional) {
        const RTuint shader = newShader("DirectionalLight");
        set("direction", light.direction);
        return shader;
    }
    if (light.kind == LightKind::Point && !std::isfinite(light.range)) {
        const RTuint shader = newShader("PointLight");
        set("position", light.position);
        return shader;
    }
    const RTuint shader = newShader("PunctualLight");
    set("position", light.position);
    set("range", light.range);
    if (light.kind == LightKind::Spot) {
        set("direction", light.direction);
        set("cutoff", glm::degrees(light.outerConeRadians));
        set("innerCutoff", glm::degrees(light.innerConeRadians));
    }
    return shader;
}

/// glTF files have no sky: a clear one, pale at the horizon, over brown ground.
const Environment& plainSky() {
    static const Environment kSky = [] {
        constexpr uint32_t kRows = 128;
        constexpr glm::vec3 kGround{0.16f, 0.14f, 0.12f}, kHorizon{0.64f, 0.69f, 0.74f};
        constexpr glm::vec3 kZenith{0.12f, 0.24f, 0.45f};
        Environment made{1, kRows, {}};
        for (uint32_t row = 0; row < kRows; ++row) {
            const float elevation = glm::pi<float>() * ((float(row) + 0.5f) / kRows - 0.5f);
            const float height = std::sin(elevation);
            const float haze = std::exp(-4.0f * std::max(height, 0.0f));
            const glm::vec3 sky = kZenith + (kHorizon - kZenith) * haze;
            const float ground = std::clamp(-height * 12.0f, 0.0f, 1.0f);
            const glm::vec3 color = sky + (kGround - sky) * ground;
            made.rgb.insert(made.rgb.end(), {color.x, color.y, color.z});
        }
        return made;
    }();
    return kSky;
}

} // namespace

void checkRt() {
    if (rtGetError() != RT_NO_ERROR) {
        const char* text = rtGetErrorText();
        throw std::runtime_error(text && *text ? text : "a call of the OpenRT library failed");
    }
}

void endFrame() {
    checkRt();
    rtEndRendering();
    RTint badPixels = 0;
    rtGetIntegerv(RT_STAT_BAD_PIXELS, &badPixels);
    if (badPixels > 0) {
        rtGetError();
    } else {
        checkRt();
    }
}

RtScene::RtScene(const SceneDescription& scene, const Bounds& bounds, const View& view,
                 const Lighting& lighting)
    : textures_(scene.textures.size(), std::array<RTuint, 2>{0, 0}), exposure_(lighting.exposure) {
    std::vector<RTuint> shaders;
    for (const MaterialDescription& material : scene.materials) {
        shaders.push_back(surface(scene, material));
    }
    MaterialDescription plain;
    plain.baseColor = {0.55f, 0.55f, 0.55f, 1.0f};
    shaders.push_back(surface(scene, plain)); // the last one: for parts without a material
    std::vector<bool> mirrored(scene.meshes.size(), false);
    for (const InstanceDescription& instance : scene.instances) {
        if (glm::determinant(glm::dmat3(instance.transform)) < 0.0) mirrored[instance.mesh] = true;
    }
    std::vector<RTuint> objects;
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
        objects.push_back(object(scene.meshes[i], mirrored[i], shaders));
    }
    for (const InstanceDescription& description : scene.instances) {
        Instance& instance = instances_.emplace_back();
        instance.object = objects[description.mesh];
        for (int i = 0; i < 16; ++i) {
            instance.matrix[i] = description.transform[i / 4][i % 4];
        }
    }
    addLights(scene, bounds, view, lighting);
    addSky(lighting.environment);
    perspective_ = newShader("PinholeCameraShader");
    orthographic_ = newShader("Orthographic");
    checkRt();
}

RTuint RtScene::texture(const SceneDescription& scene, int index, bool srgb) {
    if (index < 0) return 0;
    RTuint& id = textures_[std::size_t(index)][srgb ? 1 : 0];
    if (id != 0) return id;
    const TextureDescription& description = scene.textures[std::size_t(index)];
    const Image& image = scene.images[description.image];
    rtGenTextures(1, &id);
    rtBindTexture(RT_TEXTURE_2D, id);
    rtTexParameteri(RT_TEXTURE_2D, RT_TEXTURE_WRAP_S, wrapToken(description.wrapS));
    rtTexParameteri(RT_TEXTURE_2D, RT_TEXTURE_WRAP_T, wrapToken(description.wrapT));
    rtTexParameteri(RT_TEXTURE_2D, RT_TEXTURE_MAG_FILTER,
                    description.nearest ? RT_NEAREST : RT_LINEAR);
    rtTexParameteri(RT_TEXTURE_2D, RT_TEXTURE_MIN_FILTER, RT_LINEAR_MIPMAP_LINEAR);
    rtTexParameteri(RT_TEXTURE_2D, RT_GENERATE_MIPMAP, RT_TRUE);
    // The upper row first: t = 0 is then the upper edge, as texture coordinates here have it.
    rtTexImage2D(RT_TEXTURE_2D, 0, srgb ? RT_SRGB8_ALPHA8 : RT_RGBA8, RTsizei(image.width),
                 RTsizei(image.height), 0, RT_RGBA, RT_UNSIGNED_BYTE, image.rgba.data());
    return id;
}

RTuint RtScene::surface(const SceneDescription& scene, const MaterialDescription& material) {
    const RTuint color = texture(scene, material.baseColorTexture, true);
    const RTuint roughness = texture(scene, material.metallicRoughnessTexture, false);
    const RTuint emission = texture(scene, material.emissiveTexture, true);
    const RTuint shader = newShader("MetallicRoughness");
    // An unlit colour is light.
    const float gain = material.unlit ? exposure_ : 1.0f;
    set("baseColor", material.baseColor * glm::vec4(glm::vec3(gain), 1.0f));
    set("metallic", material.metallic);
    set("roughness", material.roughness);
    set("emissive", material.emissive * exposure_);
    set("baseColorTexture", int(color));
    set("metallicRoughnessTexture", int(roughness));
    set("emissiveTexture", int(emission));
    set("alphaMode", int(material.alphaMode));
    set("alphaCutoff", material.alphaCutoff);
    set("doubleSided", material.doubleSided ? 1 : 0);
    set("unlit", material.unlit ? 1 : 0);
    return shader;
}

RTuint RtScene::object(const MeshDescription& mesh, bool mirrored,
                       const std::vector<RTuint>& shaders) {
    const bool needsNormals =
        mirrored || std::any_of(mesh.parts.begin(), mesh.parts.end(),
                                [](const MeshPart& p) { return !p.normals.empty(); });
    const RTuint id = rtNewObject(RT_DEFINE);
    for (const MeshPart& part : mesh.parts) {
        rtBindShader(part.material < 0 ? shaders.back() : shaders[std::size_t(part.material)]);
        rtColor4f(1, 1, 1, 1);
        rtTexCoord2f(0, 0);
        const auto vertexAt = [&](std::size_t corner) -> std::size_t {
            return part.indices.empty() ? corner : part.indices[corner];
        };
        rtBegin(RT_TRIANGLES);
        for (std::size_t corner = 0; corner < 3 * part.triangleCount(); ++corner) {
            if (part.normals.empty() && needsNormals && corner % 3 == 0) {
                // The normal of an earlier part would stay current; and without one a mirrored
                // instance shows its other side.
                const glm::vec3& a = part.positions[vertexAt(corner)];
                const glm::vec3 n = glm::cross(part.positions[vertexAt(corner + 1)] - a,
                                               part.positions[vertexAt(corner + 2)] - a);
                rtNormal3fv(&n.x);
            }
            const std::size_t vertex = vertexAt(corner);
            if (!part.normals.empty()) rtNormal3fv(&part.normals[vertex].x);
            if (!part.texCoords.empty()) rtTexCoord2fv(&part.texCoords[vertex].x);
            if (!part.colors.empty()) rtColor4fv(&part.colors[vertex].x);
            rtVertex3fv(&part.positions[vertex].x);
        }
        rtEnd();
    }
    rtEndObject();
    checkRt();
    return id;
}

void RtScene::addLights(const SceneDescription& scene, const Bounds& bounds, const View& view,
                        const Lighting& lighting) {
    // glTF gives the light that arrives; a white diffuse surface shows 1/pi of it.
    const float toRadiance = exposure_ / glm::pi<float>();
    for (const LightDescription& light : scene.lights) {
        lights_.push_back(newLight(light));
        set("radiance", light.radiance * toRadiance);
    }
    for (const glm::vec3& position : lighting.pointLights) {
        // So strong that all together light the scene's middle with radiance 1.
        const glm::vec3 middle = bounds.empty() ? glm::vec3(0.0f) : bounds.centre();
        const glm::vec3 way = position - middle;
        const float distance2 = std::max(glm::dot(way, way), 1e-12f);
        lights_.push_back(newShader("PointLight"));
        set("position", position);
        set("radiance",
            glm::vec3(exposure_ * distance2 / float(lighting.pointLights.size())));
    }
    if (!lights_.empty()) return;
    // From behind the viewer's left shoulder.
    const glm::vec3 forward = glm::normalize(view.target - view.eye);
    const glm::vec3 side = glm::normalize(glm::cross(forward, view.up));
    const glm::vec3 above = glm::cross(side, forward);
    lights_.push_back(newShader("DirectionalLight"));
    set("direction", forward + side * 0.6f - above * 0.7f);
    set("radiance", glm::vec3(0.9f * exposure_));
}

void RtScene::addSky(const Environment& environment) {
    const Environment& sky = environment.rgb.empty() ? plainSky() : environment;
    RTuint id = 0;
    rtGenTextures(1, &id);
    rtBindTexture(RT_TEXTURE_2D, id);
    rtTexParameteri(RT_TEXTURE_2D, RT_TEXTURE_WRAP_T, RT_CLAMP_TO_EDGE);
    rtTexImage2D(RT_TEXTURE_2D, 0, RT_RGB, RTsizei(sky.width), RTsizei(sky.height), 0, RT_RGB,
                 RT_FLOAT, sky.rgb.data());
    sky_ = newShader("ImageEnvironment");
    set("texture", int(id));
    set("scale", exposure_);
}

void RtScene::describeWorld(const FrameShaders& shaders) const {
    rtMatrixMode(RT_MODELVIEW);
    for (const Instance& instance : instances_) {
        rtLoadMatrixd(instance.matrix);
        if (shaders.surface) {
            rtInstantiateObjectShader(instance.object, shaders.surface);
        } else {
            rtInstantiateObject(instance.object);
        }
    }
    rtLoadIdentity();
    for (RTuint light : lights_) rtUseLight(light);
    for (RTuint light : shaders.lights) rtUseLight(light);
    rtUseEnvironmentShader(shaders.environment ? shaders.environment : sky_);
    if (shaders.renderingObject) rtUseRenderingObject(shaders.renderingObject);
}

void RtScene::describeFrame(const View& view, float aspect, const FrameShaders& shaders) const {
    describeWorld(shaders);
    if (shaders.camera) {
        rtUseCamera(shaders.camera);
    } else {
        useCamera(view, aspect);
    }
}

void RtScene::useCamera(const View& view, float aspect) const {
    const glm::vec3 forward = glm::normalize(view.target - view.eye);
    // Looking along `up` leaves the horizon open; any will do.
    glm::vec3 side = glm::cross(forward, view.up);
    if (glm::length(side) < 1e-6f) side = glm::cross(forward, glm::vec3(0.0f, 0.0f, 1.0f));
    if (glm::length(side) < 1e-6f) side = glm::vec3(1.0f, 0.0f, 0.0f);
    side = glm::normalize(side);
    const glm::vec3 above = glm::cross(side, forward);
    const bool parallel = view.height > 0.0f;
    const float height =
        parallel ? view.height : 2.0f * std::tan(glm::radians(view.fovDegrees) * 0.5f);
    const glm::vec3 horizontal = side * (height * aspect), vertical = above * height;
    const RTuint camera = parallel ? orthographic_ : perspective_;
    rtBindShader(camera);
    if (parallel) {
        set("direction", forward);
    } else {
        set("origin", view.eye);
    }
    set("lowerLeft",
        (parallel ? view.eye : forward) - horizontal * 0.5f - vertical * 0.5f);
    set("horizontal", horizontal);
    set("vertical", vertical);
    rtUseCamera(camera);
}

} // namespace samples

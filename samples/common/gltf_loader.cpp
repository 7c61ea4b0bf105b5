// SPDX-License-Identifier: MIT
#include "samples/common/gltf_loader.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "samples/common/gltf_accessor.h"
#include "samples/common/gltf_file.h"
#include "samples/common/gltf_meshes.h"
#include "samples/common/image_file.h"

namespace samples {
namespace {

glm::vec3 vec3From(const std::vector<double>& values, float missing) {
    glm::vec3 v(missing);
    for (int c = 0; c < 3 && std::size_t(c) < values.size(); ++c) v[c] = float(values[c]);
    return v;
}

bool isFinite(const glm::dmat4& m) {
    for (int c = 0; c < 4; ++c) {
        for (int r = 0; r < 4; ++r) {
            // What single precision can not hold is of no use either.
            if (!std::isfinite(float(m[c][r]))) return false;
        }
    }
    return true;
}

double numberOr(const tinygltf::Value& object, const char* key, double missing) {
    if (!object.IsObject() || !object.Has(key)) return missing;
    const tinygltf::Value& value = object.Get(key);
    return value.IsNumber() ? value.GetNumberAsDouble() : missing;
}

glm::vec2 vec2Or(const tinygltf::Value& object, const char* key, float missing) {
    glm::vec2 v(missing);
    if (!object.IsObject() || !object.Has(key)) return v;
    const tinygltf::Value& values = object.Get(key);
    for (int c = 0; c < 2 && values.IsArray() && std::size_t(c) < values.ArrayLen(); ++c) {
        if (values.Get(c).IsNumber()) v[c] = float(values.Get(c).GetNumberAsDouble());
    }
    return v;
}

/// KHR_texture_transform: scaled, turned anticlockwise on an image whose t points down, shifted.
template <class Info>
TextureCoordinates coordinatesOf(const Info& info) {
    TextureCoordinates coordinates{info.texCoord, glm::mat3(1.0f)};
    const auto extension = info.extensions.find("KHR_texture_transform");
    if (extension == info.extensions.end()) return coordinates;
    const tinygltf::Value& values = extension->second;
    coordinates.set = int(std::clamp(numberOr(values, "texCoord", info.texCoord), 0.0, 1e6));
    const glm::vec2 offset = vec2Or(values, "offset", 0.0f), scale = vec2Or(values, "scale", 1.0f);
    const auto angle = float(numberOr(values, "rotation", 0.0));
    const float c = std::cos(angle), s = std::sin(angle);
    coordinates.transform = glm::mat3(glm::vec3(c, -s, 0.0f) * scale.x,
                                      glm::vec3(s, c, 0.0f) * scale.y, glm::vec3(offset, 1.0f));
    return coordinates;
}

glm::dmat4 localTransform(const tinygltf::Node& node) {
    glm::dmat4 m(1.0);
    if (node.matrix.size() == 16) {
        for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = node.matrix[std::size_t(i)];
        return m;
    }
    if (node.translation.size() == 3) {
        const auto& t = node.translation;
        m = glm::translate(m, {t[0], t[1], t[2]});
    }
    if (node.rotation.size() == 4) {
        const auto& q = node.rotation;
        m *= glm::mat4_cast(glm::normalize(glm::dquat(q[3], q[0], q[1], q[2])));
    }
    if (node.scale.size() == 3) {
        const auto& s = node.scale;
        m = glm::scale(m, {s[0], s[1], s[2]});
    }
    return m;
}

class GltfReader {
public:
    explicit GltfReader(const GltfFile& file) : file_(file), model_(file.model) {}

    SceneDescription read() {
        readMaterials();
        scene_.meshes = readGltfMeshes(file_, coordinates_, scene_.notes);
        readNodes();
        if (!model_.animations.empty()) note("animations are left out");
        if (!model_.skins.empty()) note("skins are left out");
        noteExtensions();
        std::set<std::string> once(scene_.notes.begin(), scene_.notes.end());
        scene_.notes.assign(once.begin(), once.end());
        return std::move(scene_);
    }

private:
    void note(const char* text) { scene_.notes.emplace_back(text); }

    void noteExtensions() {
        std::string unknown;
        for (const std::string& name : model_.extensionsUsed) {
            if (!knowsGltfExtension(name)) unknown += (unknown.empty() ? "" : ", ") + name;
        }
        if (!unknown.empty()) scene_.notes.push_back("extensions that are left out: " + unknown);
    }

    /// Index of the description's texture for a texture of the file; decodes its image once.
    /// `shared`: the coordinates of the material's textures before this one.
    template <class Info>
    int texture(const Info& info, std::optional<TextureCoordinates>& shared) {
        if (info.index < 0) return -1;
        if (std::size_t(info.index) >= model_.textures.size()) {
            throw LoadError("there is no texture " + std::to_string(info.index));
        }
        const TextureCoordinates coordinates = coordinatesOf(info);
        if (shared && *shared != coordinates) {
            note("textures with other coordinates than their material's first are left out");
            return -1;
        }
        if (model_.textures[std::size_t(info.index)].source < 0) {
            note("textures without an image that is PNG or JPEG are left out");
            return -1;
        }
        shared = coordinates;
        const auto [at, added] = textureIndex_.try_emplace(info.index, int(scene_.textures.size()));
        if (!added) return at->second;
        const tinygltf::Texture& source = model_.textures[std::size_t(info.index)];
        TextureDescription description;
        description.image = image(source.source);
        if (source.sampler >= 0) {
            if (std::size_t(source.sampler) >= model_.samplers.size()) {
                throw LoadError("there is no sampler " + std::to_string(source.sampler));
            }
            const tinygltf::Sampler& sampler = model_.samplers[std::size_t(source.sampler)];
            description.wrapS = wrap(sampler.wrapS);
            description.wrapT = wrap(sampler.wrapT);
            description.nearest = sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
        }
        scene_.textures.push_back(description);
        return at->second;
    }

    static Wrap wrap(int token) {
        switch (token) {
        case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE: return Wrap::ClampToEdge;
        case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT: return Wrap::MirroredRepeat;
        default: return Wrap::Repeat;
        }
    }

    uint32_t image(int index) {
        if (index < 0 || std::size_t(index) >= model_.images.size()) {
            throw LoadError("there is no image " + std::to_string(index));
        }
        const auto [at, added] = imageIndex_.try_emplace(index, uint32_t(scene_.images.size()));
        if (!added) return at->second;
        const tinygltf::Image& source = model_.images[std::size_t(index)];
        try {
            scene_.images.push_back(decodeImage(
                source.bufferView >= 0 ? bufferViewBytes(model_, source.bufferView)
                                       : std::span<const uint8_t>(source.image),
                budget_));
        } catch (const LoadError& error) {
            throw LoadError("image " + std::to_string(index) + ": " + error.what());
        }
        return at->second;
    }

    void readMaterials() {
        for (const tinygltf::Material& source : model_.materials) {
            const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
            MaterialDescription m;
            m.baseColor = glm::vec4(vec3From(pbr.baseColorFactor, 1.0f), 1.0f);
            if (pbr.baseColorFactor.size() == 4) m.baseColor.a = float(pbr.baseColorFactor[3]);
            m.metallic = float(pbr.metallicFactor);
            m.roughness = float(pbr.roughnessFactor);
            m.emissive = vec3From(source.emissiveFactor, 0.0f);
            const auto strength = source.extensions.find("KHR_materials_emissive_strength");
            if (strength != source.extensions.end()) {
                m.emissive *= float(numberOr(strength->second, "emissiveStrength", 1.0));
            }
            m.unlit = source.extensions.count("KHR_materials_unlit") != 0;
            std::optional<TextureCoordinates> coordinates;
            m.baseColorTexture = texture(pbr.baseColorTexture, coordinates);
            m.metallicRoughnessTexture = texture(pbr.metallicRoughnessTexture, coordinates);
            m.emissiveTexture = texture(source.emissiveTexture, coordinates);
            coordinates_.push_back(coordinates.value_or(TextureCoordinates()));
            if (source.normalTexture.index >= 0) note("normal maps are left out");
            if (source.occlusionTexture.index >= 0) note("occlusion maps are left out");
            m.doubleSided = source.doubleSided;
            m.alphaCutoff = float(source.alphaCutoff);
            if (source.alphaMode == "MASK") m.alphaMode = AlphaMode::Mask;
            if (source.alphaMode == "BLEND") m.alphaMode = AlphaMode::Blend;
            scene_.materials.push_back(m);
        }
    }

    /// Visits the scene's trees without recursion, each node once: glTF allows one parent only.
    void readNodes() {
        std::vector<std::pair<int, glm::dmat4>> open;
        for (int root : rootNodes()) open.emplace_back(root, glm::dmat4(1.0));
        std::reverse(open.begin(), open.end());
        std::vector<bool> visited(model_.nodes.size(), false);
        while (!open.empty()) {
            const auto [index, parent] = open.back();
            open.pop_back();
            if (index < 0 || std::size_t(index) >= model_.nodes.size()) {
                throw LoadError("there is no node " + std::to_string(index));
            }
            if (visited[std::size_t(index)]) {
                throw LoadError("node " + std::to_string(index) +
                                " is reached twice; nodes must form trees");
            }
            visited[std::size_t(index)] = true;
            const tinygltf::Node& node = model_.nodes[std::size_t(index)];
            const glm::dmat4 transform = parent * localTransform(node);
            readNode(node, transform);
            for (auto child = node.children.rbegin(); child != node.children.rend(); ++child) {
                open.emplace_back(*child, transform);
            }
        }
    }

    /// Those of the default scene, or of the first; without scenes every node without a parent.
    std::vector<int> rootNodes() const {
        if (!model_.scenes.empty()) {
            const int scene = std::max(model_.defaultScene, 0);
            if (std::size_t(scene) >= model_.scenes.size()) {
                throw LoadError("there is no scene " + std::to_string(scene));
            }
            return model_.scenes[std::size_t(scene)].nodes;
        }
        std::vector<bool> isChild(model_.nodes.size(), false);
        for (const tinygltf::Node& node : model_.nodes) {
            for (int child : node.children) {
                if (child >= 0 && std::size_t(child) < isChild.size()) {
                    isChild[std::size_t(child)] = true;
                }
            }
        }
        std::vector<int> roots;
        for (std::size_t i = 0; i < isChild.size(); ++i) {
            if (!isChild[i]) roots.push_back(int(i));
        }
        return roots;
    }

    void readNode(const tinygltf::Node& node, const glm::dmat4& transform) {
        const bool finite = isFinite(transform);
        if (node.mesh >= 0) {
            if (std::size_t(node.mesh) >= model_.meshes.size()) {
                throw LoadError("there is no mesh " + std::to_string(node.mesh));
            }
            if (finite) {
                scene_.instances.push_back({uint32_t(node.mesh), transform});
            } else {
                ++scene_.skippedInstances;
            }
        }
        if (!finite) return;
        if (node.camera >= 0) readCamera(node.camera, transform);
        const auto light = node.extensions.find("KHR_lights_punctual");
        if (light != node.extensions.end()) {
            readLight(numberOr(light->second, "light", -1.0), transform);
        }
    }

    void readCamera(int index, const glm::dmat4& transform) {
        if (std::size_t(index) >= model_.cameras.size()) {
            throw LoadError("there is no camera " + std::to_string(index));
        }
        const tinygltf::Camera& source = model_.cameras[std::size_t(index)];
        const bool parallel = source.type == "orthographic";
        const double fov = glm::degrees(source.perspective.yfov), half = source.orthographic.ymag;
        CameraDescription camera;
        camera.eye = glm::vec3(transform[3]);
        camera.direction = -glm::vec3(transform[2]);
        camera.up = glm::vec3(transform[1]);
        if (parallel) {
            camera.height = float(2.0 * half);
        } else {
            camera.fovDegrees = float(fov);
        }
        const bool possible = parallel ? half > 0.0 && std::isfinite(camera.height)
                                       : fov > 0.0 && fov < 180.0;
        if (!possible || glm::length(camera.direction) == 0.0f) {
            throw LoadError("camera " + std::to_string(index) + " has an impossible view");
        }
        scene_.cameras.push_back(camera);
    }

    void readLight(double number, const glm::dmat4& transform) {
        if (!(number >= 0.0 && number < double(model_.lights.size()))) {
            throw LoadError("there is no light " + std::to_string(number));
        }
        const tinygltf::Light& source = model_.lights[std::size_t(number)];
        LightDescription light;
        light.position = glm::vec3(transform[3]);
        light.direction = -glm::vec3(transform[2]);
        if (glm::length(light.direction) > 0.0f) light.direction = glm::normalize(light.direction);
        light.radiance = vec3From(source.color, 1.0f) * float(source.intensity);
        if (source.range > 0.0) light.range = float(source.range);
        if (source.type == "directional") light.kind = LightKind::Directional;
        if (source.type == "spot") {
            light.kind = LightKind::Spot;
            light.innerConeRadians = float(source.spot.innerConeAngle);
            light.outerConeRadians = float(source.spot.outerConeAngle);
        }
        scene_.lights.push_back(light);
    }

    const GltfFile& file_;
    const tinygltf::Model& model_;
    SceneDescription scene_;
    std::vector<TextureCoordinates> coordinates_; ///< of each material
    std::map<int, int> textureIndex_;
    std::map<int, uint32_t> imageIndex_;
    PixelBudget budget_;
};

} // namespace

SceneDescription loadGltf(const std::filesystem::path& path) {
    const GltfFile file = readGltf(path);
    return GltfReader(file).read();
}

} // namespace samples

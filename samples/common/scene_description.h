// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace samples {

/// Why a file can not be used: one line, for people.
class LoadError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// 8-bit RGBA, rows from the top.
struct Image {
    uint32_t width = 0, height = 0;
    std::vector<uint8_t> rgba;
};

enum class Wrap : uint8_t { Repeat, ClampToEdge, MirroredRepeat };

struct TextureDescription {
    uint32_t image = 0;
    Wrap wrapS = Wrap::Repeat, wrapT = Wrap::Repeat;
    bool nearest = false;
};

enum class AlphaMode : uint8_t { Opaque, Mask, Blend };

/// glTF's metallic-roughness material; textures by index, -1 = none.
struct MaterialDescription {
    glm::vec4 baseColor{1.0f};
    glm::vec3 emissive{0.0f};
    float metallic = 0.0f, roughness = 1.0f;
    float alphaCutoff = 0.5f;
    AlphaMode alphaMode = AlphaMode::Opaque;
    bool unlit = false;
    bool doubleSided = true;
    int baseColorTexture = -1, metallicRoughnessTexture = -1, emissiveTexture = -1;
};

/// Triangles of one material. Texture coordinate (0, 0) is the image's upper left corner.
struct MeshPart {
    int material = -1; ///< -1: the default material
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;   ///< empty or one for each position
    std::vector<glm::vec2> texCoords; ///< likewise
    std::vector<glm::vec4> colors;    ///< likewise, linear RGBA
    std::vector<uint32_t> indices;    ///< three for each triangle; empty: the positions in order

    std::size_t triangleCount() const {
        return (indices.empty() ? positions.size() : indices.size()) / 3;
    }
};

struct MeshDescription {
    std::vector<MeshPart> parts;
};

struct InstanceDescription {
    uint32_t mesh = 0;
    glm::dmat4 transform{1.0};
};

struct CameraDescription {
    glm::vec3 eye{0.0f}, direction{0.0f, 0.0f, -1.0f}, up{0.0f, 1.0f, 0.0f};
    float fovDegrees = 45.0f; ///< vertical
    float height = 0.0f;      ///< of what an orthographic camera sees; 0: perspective
};

enum class LightKind : uint8_t { Point, Directional, Spot };

struct LightDescription {
    LightKind kind = LightKind::Point;
    glm::vec3 position{0.0f};
    glm::vec3 direction{0.0f, 0.0f, -1.0f}; ///< in which it shines
    glm::vec3 radiance{1.0f};               ///< colour times intensity
    float range = std::numeric_limits<float>::infinity();
    float innerConeRadians = 0.0f, outerConeRadians = 0.785398f; ///< half angles
};

/// What a scene file says, independent of who renders it.
struct SceneDescription {
    std::vector<Image> images;
    std::vector<TextureDescription> textures;
    std::vector<MaterialDescription> materials;
    std::vector<MeshDescription> meshes;
    std::vector<InstanceDescription> instances;
    std::vector<CameraDescription> cameras;
    std::vector<LightDescription> lights;
    uint64_t skippedInstances = 0;  ///< with a matrix that is not finite
    std::vector<std::string> notes; ///< what the file has and these programs leave out
};

} // namespace samples

// SPDX-License-Identifier: MIT
#include "samples/common/mesh_loader.h"

#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <cmath>
#include <cstring>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "samples/common/confined_folder.h"
#include "samples/common/image_file.h"
#include "samples/common/ply_header.h"

namespace samples {
namespace {

constexpr uint64_t kMaxFileBytes = uint64_t(4) << 30;

class MemoryStream final : public Assimp::IOStream {
public:
    explicit MemoryStream(std::vector<uint8_t> bytes) : bytes_(std::move(bytes)) {}

    std::size_t Read(void* to, std::size_t size, std::size_t count) override {
        if (size == 0) return 0;
        const std::size_t items = std::min(count, (bytes_.size() - position_) / size);
        std::memcpy(to, bytes_.data() + position_, items * size);
        position_ += items * size;
        return items;
    }
    std::size_t Write(const void*, std::size_t, std::size_t) override { return 0; }
    aiReturn Seek(std::size_t offset, aiOrigin origin) override {
        const std::size_t base = origin == aiOrigin_SET   ? 0
                                 : origin == aiOrigin_CUR ? position_
                                                          : bytes_.size();
        if (offset > bytes_.size() - base) return aiReturn_FAILURE;
        position_ = base + offset;
        return aiReturn_SUCCESS;
    }
    std::size_t Tell() const override { return position_; }
    std::size_t FileSize() const override { return bytes_.size(); }
    void Flush() override {}

private:
    std::vector<uint8_t> bytes_;
    std::size_t position_ = 0;
};

/// A material library from its first material on: assimp follows a null pointer where a property
/// belongs to none.
std::vector<uint8_t> fromFirstMaterial(const std::vector<uint8_t>& bytes) {
    constexpr std::string_view kKeyword = "newmtl ";
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    for (std::size_t line = 0; line < text.size();) {
        const std::size_t end = std::min(text.find_first_of("\r\n", line), text.size());
        const bool named = end - line > kKeyword.size() && text[line + kKeyword.size()] > ' ';
        if (named && text.substr(line).starts_with(kKeyword)) {
            return {bytes.begin() + std::ptrdiff_t(line), bytes.end()};
        }
        line = end + 1;
    }
    return {};
}

/// An obj file whose numbers of vertices do not begin with their point: assimp counts a line's
/// numbers by digits and signs.
std::vector<uint8_t> withLeadingZeros(const std::vector<uint8_t>& bytes) {
    std::vector<uint8_t> file;
    file.reserve(bytes.size());
    bool ofVertex = false;
    uint8_t before = '\n';
    for (const uint8_t c : bytes) {
        if (before == '\n' || before == '\r') ofVertex = c == 'v';
        if (c == '.' && ofVertex && (before == ' ' || before == '\t')) file.push_back('0');
        file.push_back(c);
        before = c;
    }
    return file;
}

/// What assimp may open: the scene file itself, already read, and files of its folder.
class ConfinedSystem final : public Assimp::IOSystem {
public:
    ConfinedSystem(const std::filesystem::path& scene, std::vector<uint8_t> bytes)
        : name_(scene.filename().string()), bytes_(std::move(bytes)), folder_(scene) {}

    bool Exists(const char* file) const override {
        if (file == name_) return true;
        try {
            folder_.resolve(file);
            return true;
        } catch (const RefusedName& error) {
            if (!refusal_) refusal_ = error;
        } catch (const LoadError&) {
        }
        return false;
    }
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* file, const char*) override {
        if (file == name_) return new MemoryStream(bytes_);
        try {
            // The only other files that assimp asks for are material libraries.
            auto* library = new MemoryStream(fromFirstMaterial(folder_.read(file)));
            ++libraries_;
            return library;
        } catch (const RefusedName& error) {
            if (!refusal_) refusal_ = error;
        } catch (const LoadError& error) {
            if (missing_.empty()) missing_ = error.what();
        }
        return nullptr;
    }
    void Close(Assimp::IOStream* stream) override { delete stream; }

    const std::string& name() const { return name_; }
    ConfinedFolder& folder() { return folder_; }
    const std::optional<RefusedName>& refusal() const { return refusal_; }
    /// Why there are no materials, although the scene names a library; empty: there are, or it does
    /// not. Where a library is missing, assimp asks for one with the name of the scene.
    std::string missingLibrary() const { return libraries_ == 0 ? missing_ : std::string(); }

private:
    std::string name_;
    std::vector<uint8_t> bytes_;
    ConfinedFolder folder_;
    mutable std::optional<RefusedName> refusal_;
    std::string missing_;
    unsigned libraries_ = 0;
};

class MeshReader {
public:
    MeshReader(const aiScene& source, ConfinedFolder& folder) : source_(source), folder_(folder) {}

    SceneDescription read() {
        for (unsigned i = 0; i < source_.mNumMaterials; ++i) readMaterial(*source_.mMaterials[i]);
        MeshDescription whole;
        for (unsigned i = 0; i < source_.mNumMeshes; ++i) {
            MeshPart part = readPart(*source_.mMeshes[i]);
            if (!part.indices.empty()) whole.parts.push_back(std::move(part));
        }
        if (!whole.parts.empty()) {
            scene_.meshes.push_back(std::move(whole));
            scene_.instances.emplace_back();
        }
        return std::move(scene_);
    }

private:
    static glm::vec3 vec3(const aiVector3D& v) { return {v.x, v.y, v.z}; }
    /// Neither format says so, but who writes colours of vertices means sRGB.
    static float linear(float c) {
        return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
    }

    MeshPart readPart(const aiMesh& mesh) const {
        MeshPart part;
        part.material = mesh.mMaterialIndex < scene_.materials.size() ? int(mesh.mMaterialIndex)
                                                                      : -1;
        for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
            part.positions.push_back(vec3(mesh.mVertices[i]));
            if (mesh.HasNormals()) part.normals.push_back(vec3(mesh.mNormals[i]));
            if (mesh.HasTextureCoords(0)) {
                // Assimp counts t from the lower edge.
                const aiVector3D& t = mesh.mTextureCoords[0][i];
                part.texCoords.emplace_back(t.x, 1.0f - t.y);
            }
            if (mesh.HasVertexColors(0)) {
                const aiColor4D& c = mesh.mColors[0][i];
                part.colors.emplace_back(linear(c.r), linear(c.g), linear(c.b), c.a);
            }
        }
        for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
            const aiFace& face = mesh.mFaces[i];
            if (face.mNumIndices != 3) continue;
            part.indices.insert(part.indices.end(), face.mIndices, face.mIndices + 3);
        }
        return part;
    }

    void readMaterial(const aiMaterial& source) {
        MaterialDescription m;
        aiColor3D diffuse(0.8f, 0.8f, 0.8f), emissive(0, 0, 0);
        source.Get(AI_MATKEY_COLOR_DIFFUSE, diffuse);
        source.Get(AI_MATKEY_COLOR_EMISSIVE, emissive);
        float opacity = 1.0f, shininess = 0.0f;
        source.Get(AI_MATKEY_OPACITY, opacity);
        source.Get(AI_MATKEY_SHININESS, shininess);
        m.baseColor = {diffuse.r, diffuse.g, diffuse.b, opacity};
        m.emissive = {emissive.r, emissive.g, emissive.b};
        // The width of a Blinn-Phong highlight as GGX roughness (Walter et al. 2007, eq. 8).
        m.roughness = std::sqrt(std::sqrt(2.0f / (std::max(shininess, 0.0f) + 2.0f)));
        if (opacity < 1.0f) m.alphaMode = AlphaMode::Blend;
        aiString file;
        if (source.GetTexture(aiTextureType_DIFFUSE, 0, &file) == aiReturn_SUCCESS) {
            m.baseColorTexture = texture(file.C_Str());
        }
        scene_.materials.push_back(m);
    }

    int texture(std::string name) {
        // Many files were written on Windows.
        std::replace(name.begin(), name.end(), '\\', '/');
        const auto [at, added] = textures_.try_emplace(name, -1);
        if (!added) return at->second;
        try {
            scene_.images.push_back(decodeImage(folder_.read(name), budget_));
        } catch (const RefusedName&) {
            throw;
        } catch (const LoadError& error) {
            scene_.notes.push_back("a texture is left out: " + std::string(error.what()));
            return -1;
        }
        TextureDescription description;
        description.image = uint32_t(scene_.images.size() - 1);
        at->second = int(scene_.textures.size());
        scene_.textures.push_back(description);
        return at->second;
    }

    const aiScene& source_;
    ConfinedFolder& folder_;
    SceneDescription scene_;
    std::map<std::string, int> textures_;
    PixelBudget budget_;
};

bool allFinite(const aiScene& scene) {
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
        const aiMesh& mesh = *scene.mMeshes[i];
        if (!std::all_of(mesh.mVertices, mesh.mVertices + mesh.mNumVertices, [](const auto& v) {
                return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
            })) {
            return false;
        }
    }
    return true;
}

/// Assimp's later steps follow indices without a look at them.
void checkFaces(const aiScene& scene) {
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
        const aiMesh& mesh = *scene.mMeshes[i];
        for (unsigned k = 0; k < mesh.mNumFaces; ++k) {
            const aiFace& face = mesh.mFaces[k];
            if (face.mNumIndices == 0) throw LoadError("a face has no vertices");
            if (*std::max_element(face.mIndices, face.mIndices + face.mNumIndices) >=
                mesh.mNumVertices) {
                throw LoadError("a face refers to a vertex that is not there");
            }
        }
    }
}

} // namespace

SceneDescription loadMesh(const std::filesystem::path& path) {
    std::vector<uint8_t> bytes = readWholeFile(path, kMaxFileBytes);
    if (endingOf(path) == ".ply") {
        checkPlyHeader(bytes);
    } else {
        bytes = withLeadingZeros(bytes);
    }
    Assimp::Importer importer;
    auto* system = new ConfinedSystem(path, std::move(bytes)); // the importer's from here on
    importer.SetIOHandler(system);
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                                aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, 45.0f);
    const aiScene* scene = importer.ReadFile(system->name(), 0);
    if (system->refusal()) throw *system->refusal();
    if (!scene) throw LoadError(importer.GetErrorString());
    checkFaces(*scene);
    scene = importer.ApplyPostProcessing(aiProcess_Triangulate | aiProcess_SortByPType);
    if (!scene) throw LoadError(importer.GetErrorString());
    // Sorting by place, which smooth normals take, needs numbers.
    if (allFinite(*scene)) {
        scene = importer.ApplyPostProcessing(aiProcess_GenSmoothNormals);
        if (!scene) throw LoadError(importer.GetErrorString());
    }
    SceneDescription description = MeshReader(*scene, system->folder()).read();
    if (const std::string why = system->missingLibrary(); !why.empty()) {
        description.notes.push_back("its materials are left out: " + why);
    }
    return description;
}

} // namespace samples

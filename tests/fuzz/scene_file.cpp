// SPDX-License-Identifier: MIT
#include "tests/fuzz/scene_file.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "samples/common/image_file.h"
#include "samples/common/scene_loader.h"
#include "samples/common/view.h"

namespace openrt::test {
namespace {

class Folder {
public:
    Folder() {
        char memory[] = "/dev/shm/openrt_fuzz_XXXXXX", disk[] = "/tmp/openrt_fuzz_XXXXXX";
        const char* made = mkdtemp(memory);
        if (!made) made = mkdtemp(disk);
        if (!made) std::abort();
        path_ = made;
        const std::vector<uint8_t> pixels = {255, 0, 0, 0, 0, 255};
        const std::vector<uint8_t> png = samples::encodePng(1, 2, 3, pixels);
        write("t.png", png.data(), png.size());
        const std::string materials = "newmtl m\nKd 1 0.5 0\nmap_Kd t.png\nNs 20\n";
        write("a.mtl", reinterpret_cast<const uint8_t*>(materials.data()), materials.size());
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::filesystem::path write(const std::string& name, const uint8_t* data,
                                std::size_t size) const {
        const std::filesystem::path file = path_ / name;
        std::ofstream(file, std::ios::binary)
            .write(reinterpret_cast<const char*>(data), std::streamsize(size));
        return file;
    }

private:
    std::filesystem::path path_;
};

void require(bool promise) {
    if (!promise) std::abort();
}

/// What users of a description rely on: every number that names something is within its table.
void check(const samples::SceneDescription& scene) {
    for (const samples::Image& image : scene.images)
        require(image.rgba.size() == std::size_t(4) * image.width * image.height);
    for (const samples::TextureDescription& texture : scene.textures)
        require(texture.image < scene.images.size());
    const auto isTexture = [&](int index) {
        return index >= -1 && index < int(scene.textures.size());
    };
    for (const samples::MaterialDescription& material : scene.materials)
        require(isTexture(material.baseColorTexture) && isTexture(material.emissiveTexture) &&
                isTexture(material.metallicRoughnessTexture));
    for (const samples::MeshDescription& mesh : scene.meshes)
        for (const samples::MeshPart& part : mesh.parts) {
            const std::size_t count = part.positions.size();
            require(part.material >= -1 && part.material < int(scene.materials.size()));
            require(part.normals.empty() || part.normals.size() == count);
            require(part.texCoords.empty() || part.texCoords.size() == count);
            require(part.colors.empty() || part.colors.size() == count);
            for (const uint32_t index : part.indices) require(index < count);
        }
    for (const samples::InstanceDescription& instance : scene.instances)
        require(instance.mesh < scene.meshes.size());
    const samples::Bounds bounds = samples::boundsOf(scene);
    (void)samples::defaultView(scene, bounds, 1);
}

} // namespace

void loadSceneFile(const std::string& ending, const uint8_t* data, std::size_t size) {
    static const Folder folder;
    try {
        check(samples::loadScene(folder.write("scene" + ending, data, size)));
    } catch (const samples::LoadError&) { // a refusal
    }
}

} // namespace openrt::test

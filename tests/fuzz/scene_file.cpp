// SPDX-License-Identifier: MIT
#include "tests/fuzz/scene_file.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "openrt/rt.h"
#include "samples/common/image_file.h"
#include "samples/common/rt_scene.h"
#include "samples/common/scene_loader.h"

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

void render(const samples::SceneDescription& description) {
    static RTubyte pixels[4 * 4 * 4];
    rtInit(nullptr, nullptr);
    rtThreads(1);
    rtSetFrameBuffer(pixels, 4, 4, RT_RGBA_8);
    const samples::Bounds bounds = samples::boundsOf(description);
    const samples::View view = samples::defaultView(description, bounds, 1);
    const samples::RtScene scene(description, bounds, view, {});
    scene.describeFrame(view, 1);
    rtStartRendering();
    samples::endFrame();
}

} // namespace

void loadSceneFile(const std::string& ending, const uint8_t* data, std::size_t size) {
    static const Folder folder;
    try {
        const samples::SceneDescription scene =
            samples::loadScene(folder.write("scene" + ending, data, size));
        render(scene);
    } catch (const std::runtime_error&) { // a refusal
    }
    rtExit();
}

} // namespace openrt::test

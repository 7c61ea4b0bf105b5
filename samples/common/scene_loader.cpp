// SPDX-License-Identifier: MIT
#include "samples/common/scene_loader.h"

#include <cctype>
#include <new>

#ifdef SAMPLES_HAVE_GLTF
#    include "samples/common/gltf_loader.h"
#endif
#ifdef SAMPLES_HAVE_ASSIMP
#    include "samples/common/mesh_loader.h"
#endif
#include "samples/common/confined_folder.h"
#include "samples/common/tri_loader.h"

namespace samples {
namespace {

SceneDescription dispatch(const std::filesystem::path& path) {
    const std::string ending = endingOf(path);
    if (ending == ".tri") return loadTri(path);
    if (ending == ".glb" || ending == ".gltf") {
#ifdef SAMPLES_HAVE_GLTF
        return loadGltf(path);
#else
        throw LoadError("this program was built without tinygltf, so it reads no glTF");
#endif
    }
    if (ending == ".obj" || ending == ".ply") {
#ifdef SAMPLES_HAVE_ASSIMP
        return loadMesh(path);
#else
        throw LoadError("this program was built without assimp, so it reads no obj and ply");
#endif
    }
    throw LoadError("its name ends in none of .glb .gltf .obj .ply .tri");
}

} // namespace

std::string oneLine(const std::string& text) {
    constexpr std::size_t kMaxLength = 300;
    std::string line;
    for (unsigned char c : text) {
        const char printable = std::iscntrl(c) ? ' ' : char(c);
        if (printable == ' ' && (line.empty() || line.back() == ' ')) continue;
        line += printable;
        if (line.size() == kMaxLength) return line + "...";
    }
    while (!line.empty() && line.back() == ' ') line.pop_back();
    return line;
}

SceneDescription loadScene(const std::filesystem::path& path) {
    try {
        return dispatch(path);
    } catch (const LoadError& error) {
        throw LoadError(oneLine(error.what()));
    } catch (const std::bad_alloc&) {
        throw LoadError("there is not enough memory for it");
    } catch (const std::exception& error) {
        throw LoadError(oneLine(std::string("it can not be read: ") + error.what()));
    }
}

} // namespace samples

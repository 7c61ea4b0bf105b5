// SPDX-License-Identifier: MIT
#include "samples/common/gltf_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "samples/common/confined_folder.h"
#include "samples/common/scene_description.h"

namespace samples {
namespace {

using nlohmann::json;

constexpr uint64_t kMaxFileBytes = uint64_t(2) << 30;
constexpr uint64_t kMaxJsonBytes = uint64_t(256) << 20;
constexpr int kMaxJsonDepth = 64;

constexpr std::array kKnownExtensions = {"KHR_lights_punctual", "KHR_materials_emissive_strength",
                                         "KHR_materials_unlit", "KHR_mesh_quantization",
                                         "KHR_texture_transform"};

/// The JSON text of a file: all of a .gltf, the first chunk of a .glb.
std::string_view jsonText(std::span<const uint8_t> bytes, bool binary) {
    const auto text = [&](std::size_t offset, std::size_t size) {
        if (size > kMaxJsonBytes) throw LoadError("its JSON text is too long");
        return std::string_view(reinterpret_cast<const char*>(bytes.data()) + offset, size);
    };
    if (!binary) return text(0, bytes.size());

    constexpr std::size_t kHeader = 12, kChunkHeader = 8;
    constexpr uint32_t kJson = 0x4E4F534A;
    const auto word = [&](std::size_t offset) {
        uint32_t value;
        std::memcpy(&value, bytes.data() + offset, sizeof value);
        return value;
    };
    if (bytes.size() < kHeader + kChunkHeader) throw LoadError("it is cut off in its header");
    if (word(4) != 2) throw LoadError("it is glTF version " + std::to_string(word(4)) + ", not 2");
    if (word(8) != bytes.size()) {
        throw LoadError("its header says " + std::to_string(word(8)) + " bytes, but it has " +
                        std::to_string(bytes.size()));
    }
    // Every chunk must lie inside the file, whether it is used or not.
    for (std::size_t offset = kHeader; offset < bytes.size();) {
        if (bytes.size() - offset < kChunkHeader ||
            bytes.size() - offset - kChunkHeader < word(offset)) {
            throw LoadError("one of its chunks reaches beyond its end");
        }
        offset += kChunkHeader + word(offset);
    }
    if (word(16) != kJson) throw LoadError("its first chunk is not JSON");
    return text(kHeader + kChunkHeader, word(12));
}

/// tinygltf and its values recurse into JSON without a limit.
void checkDepth(std::string_view text) {
    int depth = 0;
    bool inString = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (inString) {
            if (c == '\\') ++i;
            if (c == '"') inString = false;
        } else if (c == '"') {
            inString = true;
        } else if (c == '[' || c == '{') {
            if (++depth > kMaxJsonDepth) throw LoadError("its JSON is nested too deeply");
        } else if (c == ']' || c == '}') {
            --depth;
        }
    }
}

json parseJson(std::string_view text) {
    checkDepth(text);
    try {
        json root = json::parse(text.begin(), text.end());
        if (!root.is_object()) throw LoadError("its JSON is not an object");
        return root;
    } catch (const json::exception& error) {
        throw LoadError(std::string("its JSON is broken: ") + error.what());
    }
}

const json* member(const json& object, const char* key) {
    const auto found = object.find(key);
    return found == object.end() ? nullptr : &*found;
}

/// tinygltf reads beyond the end of an URI that ends within a percent escape.
void checkUri(const json& owner) {
    const json* uri = owner.is_object() ? member(owner, "uri") : nullptr;
    if (!uri) return;
    if (!uri->is_string()) throw LoadError("one of its URIs is not a string");
    const auto& text = uri->get_ref<const std::string&>();
    if (text.starts_with("data:")) return;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') continue;
        if (i + 2 >= text.size() || !std::isxdigit(static_cast<unsigned char>(text[i + 1])) ||
            !std::isxdigit(static_cast<unsigned char>(text[i + 2]))) {
            throw LoadError("it refers to '" + text + "', whose percent escapes are broken");
        }
        i += 2;
    }
}

/// What tinygltf takes on trust: one binary buffer, images inside their buffer, sane URIs.
void checkDocument(const json& root, bool binary) {
    const auto list = [&](const char* key) -> const json& {
        static const json kEmpty = json::array();
        const json* found = member(root, key);
        if (found && !found->is_array()) {
            throw LoadError(std::string("its ") + key + " are not an array");
        }
        return found ? *found : kEmpty;
    };
    const auto number = [](const json& object, const char* key) -> uint64_t {
        const json* found = object.is_object() ? member(object, key) : nullptr;
        return found && found->is_number_unsigned() ? found->get<uint64_t>() : 0;
    };
    const json& buffers = list("buffers");
    for (std::size_t i = 0; i < buffers.size(); ++i) {
        checkUri(buffers[i]);
        if (binary && i > 0 && buffers[i].is_object() && !member(buffers[i], "uri")) {
            throw LoadError("buffer " + std::to_string(i) + " has no URI; only buffer 0 may");
        }
    }
    const json& views = list("bufferViews");
    for (const json& image : list("images")) {
        checkUri(image);
        if (!image.is_object() || !member(image, "bufferView")) continue;
        const uint64_t view = number(image, "bufferView");
        if (view >= views.size()) throw LoadError("an image lies in no buffer view");
        const uint64_t buffer = number(views[view], "buffer");
        if (buffer >= buffers.size() ||
            number(views[view], "byteOffset") >= number(buffers[buffer], "byteLength")) {
            throw LoadError("an image lies outside its buffer");
        }
    }
    if (const json* required = member(root, "extensionsRequired"); required) {
        for (const json& name : *required) {
            if (!name.is_string() || !knowsGltfExtension(name.get_ref<const std::string&>())) {
                throw LoadError("it requires extension " + name.dump(-1, ' ', true) +
                                ", which is not supported");
            }
        }
    }
}

/// The confined file access that tinygltf calls; keeps the first refusal, of which tinygltf
/// itself would only say that there is no such file.
struct FileAccess {
    ConfinedFolder folder;
    std::optional<LoadError> refusal;
};

bool fileExists(const std::string& name, void* user) {
    auto& access = *static_cast<FileAccess*>(user);
    if (name.starts_with("./")) return false; // tinygltf's second try in another folder
    try {
        access.folder.resolve(name);
        return true;
    } catch (const LoadError& error) {
        if (!access.refusal) access.refusal = error;
        return false;
    }
}

std::string sameName(const std::string& name, void*) { return name; }

bool readFile(std::vector<unsigned char>* out, std::string* error, const std::string& name,
              void* user) {
    auto& access = *static_cast<FileAccess*>(user);
    try {
        *out = access.folder.read(name);
        return true;
    } catch (const LoadError& failure) {
        *error = failure.what();
        if (!access.refusal) access.refusal = failure;
        return false;
    }
}

/// Keeps an image encoded. The bytes of one in a buffer view are read later, when its range has
/// been checked; tinygltf does not check it.
bool keepEncoded(tinygltf::Image* image, int, std::string*, std::string*, int, int,
                 const unsigned char* bytes, int size, void*) {
    if (image->bufferView < 0) image->image.assign(bytes, bytes + size);
    image->as_is = true;
    return true;
}

} // namespace

bool knowsGltfExtension(std::string_view name) {
    return std::find(kKnownExtensions.begin(), kKnownExtensions.end(), name) !=
           kKnownExtensions.end();
}

GltfFile readGltf(const std::filesystem::path& path) {
    const std::vector<uint8_t> bytes = readWholeFile(path, kMaxFileBytes);
    const bool binary = bytes.size() >= 4 && std::memcmp(bytes.data(), "glTF", 4) == 0;
    checkDocument(parseJson(jsonText(bytes, binary)), binary);

    FileAccess access{ConfinedFolder(path), std::nullopt};
    tinygltf::TinyGLTF parser;
    parser.SetFsCallbacks({&fileExists, &sameName, &readFile, nullptr, &access});
    parser.SetImageLoader(&keepEncoded, nullptr);
    GltfFile file;
    std::string error, warning;
    const unsigned size = unsigned(bytes.size());
    const bool loaded =
        binary ? parser.LoadBinaryFromMemory(&file.model, &error, &warning, bytes.data(), size, "")
               : parser.LoadASCIIFromString(&file.model, &error, &warning,
                                            reinterpret_cast<const char*>(bytes.data()), size, "");
    if (access.refusal) throw *access.refusal;
    if (!loaded) throw LoadError(error.empty() ? "it is broken" : error);
    for (const tinygltf::Buffer& buffer : file.model.buffers) {
        file.bufferBytes += buffer.data.size();
    }
    return file;
}

} // namespace samples

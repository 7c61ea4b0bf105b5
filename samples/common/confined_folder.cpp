// SPDX-License-Identifier: MIT
#include "samples/common/confined_folder.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <system_error>

namespace samples {
namespace {

namespace fs = std::filesystem;

constexpr uint64_t kMaxReferencedBytes = uint64_t(2) << 30;

bool hasScheme(const std::string& name) {
    const std::size_t colon = name.find(':');
    return colon != std::string::npos && name.find('/') > colon;
}

} // namespace

std::string endingOf(const fs::path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return char(std::tolower(c)); });
    return ending;
}

std::vector<uint8_t> readWholeFile(const fs::path& path, uint64_t maxBytes) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) throw LoadError("there is no such file");
    if (fs::is_directory(status)) throw LoadError("this is a folder, not a file");
    if (!fs::is_regular_file(status)) throw LoadError("this is not a regular file");
    const uint64_t size = fs::file_size(path, error);
    if (error) throw LoadError("its size can not be read: " + error.message());
    if (size > maxBytes) {
        throw LoadError("it has " + std::to_string(size) + " bytes, more than " +
                        std::to_string(maxBytes) + " are not accepted");
    }
    std::ifstream in(path, std::ios::binary);
    if (!in) throw LoadError("it can not be opened for reading");
    std::vector<uint8_t> bytes(size);
    in.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(size));
    if (uint64_t(in.gcount()) != size) throw LoadError("it can not be read to its end");
    return bytes;
}

ConfinedFolder::ConfinedFolder(const fs::path& sceneFile) : bytesLeft_(kMaxReferencedBytes) {
    std::error_code error;
    root_ = fs::canonical(fs::absolute(sceneFile, error).parent_path(), error);
    if (error) throw LoadError("its folder can not be read: " + error.message());
}

fs::path ConfinedFolder::resolve(const std::string& name) const {
    const auto refuse = [&](const char* why) {
        return RefusedName("it refers to '" + name + "', which is refused: " + why);
    };
    if (name.empty()) throw refuse("an empty name");
    if (std::any_of(name.begin(), name.end(), [](unsigned char c) { return std::iscntrl(c); })) {
        throw refuse("control characters");
    }
    if (hasScheme(name)) throw refuse("only files are read, no addresses");
    if (name.find('\\') != std::string::npos) throw refuse("a backslash");
    const fs::path relative(name);
    if (relative.is_absolute()) throw refuse("an absolute path");
    for (const fs::path& component : relative) {
        if (component == "..") throw refuse("a path that leaves the scene's folder");
    }
    std::error_code error;
    const fs::path real = fs::canonical(root_ / relative, error);
    if (error) throw LoadError("it refers to '" + name + "', which does not exist");
    const auto [rootEnd, unused] =
        std::mismatch(root_.begin(), root_.end(), real.begin(), real.end());
    if (rootEnd != root_.end()) throw refuse("a link that leaves the scene's folder");
    return real;
}

std::vector<uint8_t> ConfinedFolder::read(const std::string& name) {
    const fs::path path = resolve(name);
    try {
        std::vector<uint8_t> bytes = readWholeFile(path, bytesLeft_);
        bytesLeft_ -= bytes.size();
        return bytes;
    } catch (const LoadError& error) {
        throw LoadError("it refers to '" + name + "', which can not be read: " + error.what());
    }
}

} // namespace samples

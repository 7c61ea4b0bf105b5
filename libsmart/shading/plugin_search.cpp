// SPDX-License-Identifier: MIT
#include "libsmart/shading/plugin_search.h"

#include <dlfcn.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>
#include <system_error>

#include "libsmart/base/error.h"

namespace smart {

namespace {

/// The file from which an address of this process was loaded; empty if that can not be told.
std::string fileOf(const void* address) {
    Dl_info info = {};
    if (dladdr(address, &info) && info.dli_fname && info.dli_fname[0] == '/') return info.dli_fname;
    // A program as it was called, or a library found by a relative path: relative to where this
    // process was then.
    const auto wanted = reinterpret_cast<uintptr_t>(address);
    std::ifstream maps("/proc/self/maps");
    for (std::string line; std::getline(maps, line);) {
        unsigned long first = 0, end = 0;
        if (std::sscanf(line.c_str(), "%lx-%lx", &first, &end) != 2) break;
        const std::size_t path = line.find('/');
        if (first <= wanted && wanted < end && path != line.npos) return line.substr(path);
    }
    return {};
}

/// openrt/shaders beside the file that holds this code; empty if that can not be told.
std::string installedFolder() {
    const std::string name = fileOf(reinterpret_cast<const void*>(&installedFolder));
    std::error_code failed;
    const std::filesystem::path file = std::filesystem::canonical(name, failed);
    return failed ? std::string() : (file.parent_path() / "openrt" / "shaders").string();
}

/// The path, or the path with ".so", or neither is there.
std::optional<std::string> existing(const std::string& path) {
    std::error_code failed;
    const auto status = std::filesystem::status(path, failed);
    const bool folder = std::filesystem::is_directory(status);
    if (!folder && std::filesystem::exists(status)) return path;
    if (std::filesystem::exists(path + ".so", failed)) return path + ".so";
    if (folder) return path;
    return std::nullopt;
}

[[noreturn]] void notFound(const std::string& text) {
    throw Error(ErrorCode::InvalidValue, text);
}

} // namespace

std::vector<std::string> shaderFolders() {
    std::vector<std::string> folders;
    const char* const variable = secure_getenv("OPENRT_SHADER_PATH");
    std::string_view rest = variable ? variable : "";
    while (!rest.empty()) {
        const std::string_view folder = rest.substr(0, rest.find(':'));
        if (!folder.empty()) folders.emplace_back(folder);
        rest.remove_prefix(std::min(rest.size(), folder.size() + 1));
    }
    static const std::string installed = installedFolder();
    if (!installed.empty()) folders.push_back(installed);
    return folders;
}

std::string findShaderLibrary(const std::string& name, const std::vector<std::string>& folders) {
    if (name.empty()) notFound("the name of the shader library is empty");
    if (name.find('/') != std::string::npos) {
        if (auto path = existing(name)) return *path;
        notFound(name + ": there is no such file, nor one with .so added");
    }
    std::string looked;
    for (const std::string& folder : folders) {
        if (auto path = existing(folder + '/' + name)) return *path;
        looked += (looked.empty() ? "" : ", ") + folder;
    }
    const std::optional<std::string> here = existing(name);
    notFound(name + ": no such shader library in " + (looked.empty() ? "any folder" : looked) +
             " (the folders of OPENRT_SHADER_PATH and the installed one)" +
             (here ? "; a file here needs a slash: ./" + *here : ""));
}

} // namespace smart

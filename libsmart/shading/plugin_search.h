// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace smart {

/// Folders in which shader libraries are looked for by a name without a slash: those of the
/// environment variable OPENRT_SHADER_PATH, separated by colons (ignored in set-uid programs;
/// empty entries are skipped, so that the current folder is meant by "." only), then the folder
/// openrt/shaders beside the file that holds this code, wherever that was moved.
std::vector<std::string> shaderFolders();

/// File of a shader library. A name with a slash is a path; any other is looked for in
/// `folders`, never in the current folder by itself. Where there is no file of the name, ".so" is
/// added to it. Throws Error (InvalidValue) that says where it was looked for.
std::string findShaderLibrary(const std::string& name, const std::vector<std::string>& folders);

} // namespace smart

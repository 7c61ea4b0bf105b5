// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "libsmart/shading/shader_class.h"

namespace smart {

/// A class of a shader library, which stays loaded as long as the class lives. `path` names the
/// file, with a slash in it. It is examined before any of its code runs (plugin_file.h), loaded
/// with all its symbols resolved and none of them visible to others, and asked for the class. The
/// same class of the same file is the same object while it lives. Throws Error (InvalidValue)
/// with the file and the reason; nothing stays loaded then. From any thread.
ShaderClassPtr loadShaderClass(std::string_view className, const std::string& path);

/// Names of the classes of a shader library, in alphabetical order. Throws as loadShaderClass.
std::vector<std::string> shaderClassNames(const std::string& path);

} // namespace smart

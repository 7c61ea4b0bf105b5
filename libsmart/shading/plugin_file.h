// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "openrt/rts_plugin_format.h"

namespace smart {

/// Reads what a shader library says of itself from the file, none of whose code runs. Throws
/// Error (InvalidValue), naming the file and the reason, unless it is a complete shared library
/// for this machine whose descriptor checkPlugin() accepts.
void examinePluginFile(const std::string& path);

/// Throws Error (InvalidValue) where this library can not serve a plug-in with this descriptor.
/// Looks at its numbers only, not at the classes.
void checkPlugin(const std::string& path, const RTSplugin& plugin);

} // namespace smart

// SPDX-License-Identifier: MIT
#pragma once

#include <dlfcn.h>

#include <string>

namespace plugin_test {

/// Whether a library of the tests is in the process now.
inline bool isLoaded(const std::string& fileName) {
    void* const handle = dlopen((TEST_PLUGINS "/" + fileName).c_str(), RTLD_LAZY | RTLD_NOLOAD);
    if (handle) dlclose(handle);
    return handle != nullptr;
}

} // namespace plugin_test

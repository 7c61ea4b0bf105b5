// SPDX-License-Identifier: MIT
#include "tests/conformance/tested_library.h"

#include <dlfcn.h>

namespace conformance {

std::string faultOfLibrary(const std::string& file) {
    const std::string path = std::filesystem::canonical(file);
    if (path.find_first_of(" :") != std::string::npos)
        return path + ": LD_PRELOAD takes no path with a space or a colon";
    void* const library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    void* const function = library ? dlsym(library, "rtInit") : nullptr;
    if (!function) return dlerror();
    Dl_info place{};
    if (!dladdr(function, &place) || path != place.dli_fname)
        return path + ": rtInit is in a library that it needs, not in itself";
    return {};
}

std::vector<std::string> withLibrary(const Settings& settings, std::vector<std::string> others) {
    if (!settings.library.empty()) others.push_back("LD_PRELOAD=" + settings.library.string());
    return others;
}

} // namespace conformance

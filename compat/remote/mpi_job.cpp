// SPDX-License-Identifier: MIT
#include "compat/remote/mpi_job.h"

#include <dlfcn.h>

#include <cstdlib>
#include <cstring>

namespace smart::compat {
namespace {

constexpr const char* kLibrary = "libOpenRT-mpi.so.0";

bool isMoreThanOne(const char* variable) {
    const char* const text = secure_getenv(variable);
    return text && std::atoi(text) > 1;
}

/// Beside this library, or where the system looks. This library stays until the process ends then:
/// the end of MPI unloads what nobody holds any more, while this library waits for it.
void* openLibrary() {
    Dl_info info;
    if (dladdr(reinterpret_cast<void*>(&openMpi), &info) != 0 && info.dli_fname) {
        const std::string own = info.dli_fname;
        dlopen(own.c_str(), RTLD_NOW | RTLD_NOLOAD | RTLD_NODELETE);
        const std::size_t slash = own.rfind('/');
        if (slash != std::string::npos)
            if (void* library = dlopen((own.substr(0, slash + 1) + kLibrary).c_str(), RTLD_NOW))
                return library;
    }
    return dlopen(kLibrary, RTLD_NOW);
}

} // namespace

bool isMpiAskedFor() {
    if (const char* const wish = secure_getenv("OPENRT_MPI"); wish && *wish)
        return std::strcmp(wish, "0") != 0;
    // Open MPI; MPICH and Slurm's pmi2; Slurm's and others' PMIx, which does not say how many.
    return isMoreThanOne("OMPI_COMM_WORLD_SIZE") || isMoreThanOne("PMI_SIZE") ||
           (!secure_getenv("OMPI_COMM_WORLD_SIZE") && secure_getenv("PMIX_RANK"));
}

MpiRanks* openMpi(std::string& problem) {
    void* const library = openLibrary();
    if (!library) {
        const char* const why = dlerror();
        problem = why ? why : kLibrary;
        return nullptr;
    }
    const auto* const component = static_cast<const char*>(dlsym(library, "openrtMpiComponent"));
    const auto open = reinterpret_cast<MpiOpen>(dlsym(library, "openrtMpiOpen"));
    if (!component || !open || std::strcmp(component, OPENRT_MPI_COMPONENT) != 0) {
        problem = std::string(kLibrary) + " is not of this version";
        return nullptr;
    }
    char text[256] = "";
    MpiRanks* const ranks = open(text, sizeof text);
    if (!ranks) problem = text;
    return ranks;
}

} // namespace smart::compat

// SPDX-License-Identifier: MIT
#include "libsmart/remote/build_id.h"

#include <elf.h>
#include <link.h>

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace smart {
namespace {

/// What is to be found, and in which of the loaded libraries: the one with this address.
struct Search {
    uintptr_t address = 0;
    std::string found;
};

std::string buildIdIn(const std::byte* notes, std::size_t size) {
    const auto padded = [](std::size_t n) { return (n + 3) & ~std::size_t(3); };
    while (size >= sizeof(ElfW(Nhdr))) {
        ElfW(Nhdr) note;
        std::memcpy(&note, notes, sizeof note);
        const std::size_t whole = sizeof note + padded(note.n_namesz) + padded(note.n_descsz);
        if (whole > size) break;
        const std::byte* const name = notes + sizeof note;
        if (note.n_type == NT_GNU_BUILD_ID && note.n_namesz == 4 &&
            std::memcmp(name, "GNU", 4) == 0) {
            std::string text;
            for (std::size_t i = 0; i < note.n_descsz; ++i) {
                const auto value = unsigned(name[padded(note.n_namesz) + i]);
                text += "0123456789abcdef"[value >> 4];
                text += "0123456789abcdef"[value & 15];
            }
            return text;
        }
        notes += whole;
        size -= whole;
    }
    return {};
}

int look(dl_phdr_info* info, std::size_t, void* data) {
    Search& search = *static_cast<Search*>(data);
    bool isThis = false;
    for (int i = 0; i < info->dlpi_phnum; ++i) {
        const ElfW(Phdr)& part = info->dlpi_phdr[i];
        isThis |= part.p_type == PT_LOAD &&
                  search.address - (info->dlpi_addr + part.p_vaddr) < part.p_memsz;
    }
    if (!isThis) return 0;
    for (int i = 0; i < info->dlpi_phnum && search.found.empty(); ++i) {
        const ElfW(Phdr)& part = info->dlpi_phdr[i];
        if (part.p_type == PT_NOTE)
            search.found = buildIdIn(
                reinterpret_cast<const std::byte*>(info->dlpi_addr + part.p_vaddr), part.p_memsz);
    }
    return 1;
}

} // namespace

std::string buildId() {
    Search search;
    search.address = reinterpret_cast<uintptr_t>(&buildId);
    dl_iterate_phdr(&look, &search);
    return search.found;
}

} // namespace smart

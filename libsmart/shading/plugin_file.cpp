// SPDX-License-Identifier: MIT
#include "libsmart/shading/plugin_file.h"

#include <elf.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <bit>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>
#include <type_traits>
#include <vector>

#include "libsmart/base/error.h"

namespace smart {

namespace {

// Not <link.h>, whose RT_ADD is a macro of ours.
constexpr bool k64 = sizeof(void*) == 8;
using FileHeader = std::conditional_t<k64, Elf64_Ehdr, Elf32_Ehdr>;
using Segment = std::conditional_t<k64, Elf64_Phdr, Elf32_Phdr>;
using Dynamic = std::conditional_t<k64, Elf64_Dyn, Elf32_Dyn>;
using Symbol = std::conditional_t<k64, Elf64_Sym, Elf32_Sym>;

constexpr uint16_t kMachine =
#if defined(__x86_64__)
    EM_X86_64;
#elif defined(__aarch64__)
    EM_AARCH64;
#else
    EM_NONE; // not compared; loading would fail
#endif
constexpr unsigned char kClass = k64 ? ELFCLASS64 : ELFCLASS32;
constexpr unsigned char kByteOrder =
    std::endian::native == std::endian::little ? ELFDATA2LSB : ELFDATA2MSB;
constexpr uint32_t kMaxSymbolsOfHash = 1u << 12; // in one bucket; a handful is usual

[[noreturn]] void refuse(const std::string& path, const std::string& reason) {
    throw Error(ErrorCode::InvalidValue, path + ": " + reason);
}

std::string machineName(uint16_t machine) {
    switch (machine) {
    case EM_386: return "32-bit x86";
    case EM_X86_64: return "x86-64";
    case EM_ARM: return "32-bit ARM";
    case EM_AARCH64: return "AArch64";
    case EM_RISCV: return "RISC-V";
    case EM_PPC64: return "64-bit PowerPC";
    default: return "machine type " + std::to_string(machine);
    }
}

/// A file that is read piece by piece: unlike a mapping, it may shrink meanwhile.
class File {
public:
    explicit File(const std::string& path) : path_(path) {
        // Not blocking: a named pipe without a writer would wait forever.
        descriptor_ = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
        if (descriptor_ < 0) refuse(path, std::string("can not be read: ") + std::strerror(errno));
        struct stat status = {};
        const bool known = fstat(descriptor_, &status) == 0;
        if (!known || !S_ISREG(status.st_mode)) {
            close(descriptor_);
            refuse(path, known && S_ISDIR(status.st_mode) ? "is a folder" : "is no regular file");
        }
        size_ = uint64_t(status.st_size);
    }
    ~File() { close(descriptor_); }
    File(const File&) = delete;
    File& operator=(const File&) = delete;

    const std::string& path() const { return path_; }
    bool contains(uint64_t offset, uint64_t bytes) const {
        return offset <= size_ && bytes <= size_ - offset;
    }
    bool read(uint64_t offset, void* to, std::size_t bytes) const {
        if (!contains(offset, bytes)) return false;
        auto* at = static_cast<char*>(to);
        while (bytes > 0) {
            const ssize_t got = pread(descriptor_, at, bytes, off_t(offset));
            if (got < 0 && errno == EINTR) continue;
            if (got <= 0) return false;
            at += got;
            offset += uint64_t(got);
            bytes -= std::size_t(got);
        }
        return true;
    }

private:
    std::string path_;
    int descriptor_ = -1;
    uint64_t size_ = 0;
};

/// A shared library as the dynamic linker will see it: segments and the dynamic symbol table.
class SharedLibrary {
public:
    explicit SharedLibrary(const std::string& path) : file_(path) {
        FileHeader header = {};
        if (!file_.read(0, &header, sizeof(header)) ||
            std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0)
            refuse(path, "is no shared library");
        checkMachine(header);
        if (header.e_type != ET_DYN) refuse(path, "is no shared library, but another ELF file");
        if (header.e_phentsize != sizeof(Segment)) refuse(path, "is damaged");
        segments_.resize(header.e_phnum);
        if (!file_.read(header.e_phoff, segments_.data(), segments_.size() * sizeof(Segment)))
            refuse(path, "is cut off");
        for (const Segment& s : segments_)
            if (!file_.contains(s.p_offset, s.p_filesz)) refuse(path, "is cut off");
        readDynamic();
    }

    /// Copies the first bytes of a data symbol; false: the library defines none of that name.
    bool readObject(const char* name, void* to, std::size_t bytes) const {
        const std::optional<Symbol> symbol = gnuHash_ ? findByGnuHash(name) : findByHash(name);
        if (!symbol || symbol->st_shndx == SHN_UNDEF) return false;
        return (symbol->st_info & 0xF) == STT_OBJECT && read(symbol->st_value, to, bytes);
    }

private:
    void checkMachine(const FileHeader& header) const {
        if (header.e_ident[EI_CLASS] == kClass && header.e_ident[EI_DATA] == kByteOrder &&
            (header.e_machine == kMachine || kMachine == EM_NONE))
            return;
        const bool readable = header.e_ident[EI_DATA] == kByteOrder; // e_machine lies the same
        refuse(file_.path(), "is for another processor" +
                                 (readable ? ": " + machineName(header.e_machine)
                                           : std::string(" of the other byte order")) +
                                 ", not for " + machineName(kMachine));
    }

    void readDynamic() {
        for (const Segment& segment : segments_) {
            if (segment.p_type != PT_DYNAMIC) continue;
            const uint64_t count = segment.p_filesz / sizeof(Dynamic);
            for (uint64_t i = 0; i < count; ++i) {
                Dynamic entry = {};
                if (!file_.read(segment.p_offset + i * sizeof(Dynamic), &entry, sizeof(entry)))
                    refuse(file_.path(), "is cut off");
                switch (entry.d_tag) {
                case DT_NULL: return;
                case DT_SYMTAB: symbols_ = entry.d_un.d_ptr; break;
                case DT_STRTAB: names_ = entry.d_un.d_ptr; break;
                case DT_HASH: hash_ = entry.d_un.d_ptr; break;
                case DT_GNU_HASH: gnuHash_ = entry.d_un.d_ptr; break;
                default: break;
                }
            }
        }
    }

    /// Bytes at an address of the loaded library; false where the file holds none for it.
    bool read(uint64_t address, void* to, std::size_t bytes) const {
        for (const Segment& s : segments_)
            if (s.p_type == PT_LOAD && address >= s.p_vaddr && address - s.p_vaddr <= s.p_filesz &&
                bytes <= s.p_filesz - (address - s.p_vaddr))
                return file_.read(s.p_offset + (address - s.p_vaddr), to, bytes);
        return false;
    }
    template <class T>
    std::optional<T> read(uint64_t address) const {
        static_assert(std::is_trivially_copyable_v<T>);
        T value = {};
        return read(address, &value, sizeof(value)) ? std::optional<T>(value) : std::nullopt;
    }

    std::optional<Symbol> symbolNamed(uint32_t index, std::string_view name) const {
        const auto symbol = read<Symbol>(symbols_ + uint64_t(index) * sizeof(Symbol));
        if (!symbol) return std::nullopt;
        std::string found(name.size() + 1, '?');
        if (!read(names_ + symbol->st_name, found.data(), found.size())) return std::nullopt;
        return found.c_str() == name ? symbol : std::nullopt;
    }

    /// The hash table of System V's ABI.
    std::optional<Symbol> findByHash(const char* name) const {
        uint32_t hash = 0;
        for (const char* c = name; *c; ++c) {
            hash = (hash << 4) + uint32_t(static_cast<unsigned char>(*c));
            const uint32_t high = hash & 0xF0000000u;
            hash = (hash ^ (high >> 24)) & ~high;
        }
        const auto buckets = hash_ ? read<uint32_t>(hash_) : std::nullopt;
        if (!buckets || *buckets == 0) return std::nullopt;
        const uint64_t first = hash_ + 2 * sizeof(uint32_t);
        auto index = read<uint32_t>(first + uint64_t(hash % *buckets) * sizeof(uint32_t));
        const uint64_t chain = first + uint64_t(*buckets) * sizeof(uint32_t);
        for (uint32_t i = 0; i < kMaxSymbolsOfHash && index && *index != STN_UNDEF; ++i) {
            if (auto symbol = symbolNamed(*index, name)) return symbol;
            index = read<uint32_t>(chain + uint64_t(*index) * sizeof(uint32_t));
        }
        return std::nullopt;
    }

    /// GNU's: symbols of one hash follow each other, the last one's value is odd.
    std::optional<Symbol> findByGnuHash(const char* name) const {
        uint32_t hash = 5381;
        for (const char* c = name; *c; ++c)
            hash = hash * 33 + uint32_t(static_cast<unsigned char>(*c));
        const auto buckets = read<uint32_t>(gnuHash_);
        const auto firstSymbol = read<uint32_t>(gnuHash_ + 4);
        const auto bloomWords = read<uint32_t>(gnuHash_ + 8);
        if (!buckets || *buckets == 0 || !firstSymbol || !bloomWords) return std::nullopt;
        const uint64_t first = gnuHash_ + 16 + uint64_t(*bloomWords) * sizeof(void*);
        const uint64_t values = first + uint64_t(*buckets) * sizeof(uint32_t);
        const auto start = read<uint32_t>(first + uint64_t(hash % *buckets) * sizeof(uint32_t));
        if (!start || *start < *firstSymbol) return std::nullopt;
        for (uint32_t i = 0; i < kMaxSymbolsOfHash; ++i) {
            const uint64_t index = uint64_t(*start) + i;
            const auto value = read<uint32_t>(values + (index - *firstSymbol) * sizeof(uint32_t));
            if (!value || index > UINT32_MAX) return std::nullopt;
            if ((*value | 1u) == (hash | 1u))
                if (auto symbol = symbolNamed(uint32_t(index), name)) return symbol;
            if (*value & 1u) return std::nullopt;
        }
        return std::nullopt;
    }

    File file_;
    std::vector<Segment> segments_;
    uint64_t symbols_ = 0, names_ = 0, hash_ = 0, gnuHash_ = 0; // addresses; 0: none
};

} // namespace

void checkPlugin(const std::string& path, const RTSplugin& plugin) {
    if (std::memcmp(plugin.magic, RTS_PLUGIN_MAGIC, sizeof(plugin.magic)) != 0)
        refuse(path, "its symbol " RTS_PLUGIN_SYMBOL " is no descriptor of a shader library");
    if (plugin.interfaceVersion != RTS_INTERFACE_VERSION)
        refuse(path, "is made for version " + std::to_string(plugin.interfaceVersion) +
                         " of the shader interface; this library has version " +
                         std::to_string(RTS_INTERFACE_VERSION));
    if (plugin.neededRevision > RTS_INTERFACE_REVISION)
        refuse(path, "needs revision " + std::to_string(plugin.neededRevision) +
                         " of the shader interface; this library has revision " +
                         std::to_string(RTS_INTERFACE_REVISION));
    if (plugin.structSize < sizeof(RTSplugin))
        refuse(path, "its descriptor has " + std::to_string(plugin.structSize) +
                         " bytes; at least " + std::to_string(sizeof(RTSplugin)) + " are needed");
}

void examinePluginFile(const std::string& path) {
    const SharedLibrary library(path);
    RTSplugin plugin = {}; // what follows the numbers are addresses, set when it is loaded
    if (!library.readObject(RTS_PLUGIN_SYMBOL, &plugin, offsetof(RTSplugin, first)))
        refuse(path, "is no shader library: it has no data symbol " RTS_PLUGIN_SYMBOL);
    checkPlugin(path, plugin);
}

} // namespace smart

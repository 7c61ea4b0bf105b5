// SPDX-License-Identifier: MIT
// openrt-info: what the library and the machine have, and what is in shader libraries.
#include <link.h> // before OpenRT's: it has a constant that is called RT_ADD

#include <openrt/rt.h>
#include <openrt/rts_plugin_format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

#include "samples/common/standard_output.h"
#include "samples/tools/packet_check.h"
#include "samples/tools/reads_check.h"

namespace {

constexpr int kFailure = 1, kWrongCommandLine = 2;

std::vector<std::string> split(const char* text, char separator) {
    std::vector<std::string> parts;
    std::istringstream stream(text ? text : "");
    for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
    return parts;
}

const char* text(RTenum name) {
    return reinterpret_cast<const char*>(rtGetString(name));
}

const char* kindName(RTenum kind) {
    switch (kind) {
        case RT_SURFACE_SHADER:
            return "surface";
        case RT_ENV_SHADER:
            return "environment";
        case RT_LIGHT_SHADER:
            return "light";
        case RT_CAMERA_SHADER:
            return "camera";
        case RT_RENDERING_OBJECT_SHADER:
            return "rendering object";
        default:
            return "unknown kind";
    }
}

std::string typeName(const RTSparameter& p) {
    switch (p.type) {
        case RTS_INT1:
            return p.size == 1 ? "bool" : "int";
        case RTS_INT2:
            return "2 ints";
        case RTS_INT3:
            return "3 ints";
        case RTS_FLOAT1:
            return "float";
        case RTS_FLOAT2:
            return "2 floats";
        case RTS_FLOAT3:
            return "3 floats";
        case RTS_FLOAT4:
            return "4 floats";
        case RTS_FLOAT16:
            return "16 floats";
        case RTS_RAW:
            return std::to_string(p.size) + " bytes";
        case RTS_STRING:
            return "string";
    }
    return "?";
}

const char* scopeName(RTSscope scope) {
    return scope == RTS_PER_VERTEX     ? "per vertex"
           : scope == RTS_PER_TRIANGLE ? "per triangle"
                                       : "per shader";
}

/// nullptr, and a line on the error output, where the class can not be made.
const RTshaderclass* describe(const std::string& name, const char* file) {
    const RTuint id = rtGenNewShaderClass(name.c_str(), file);
    if (id == RT_INVALID) {
        std::cerr << "openrt-info: " << rtGetErrorText() << '\n';
        rtGetError();
        return nullptr;
    }
    return rtGetShaderClassDescriptor(id);
}

void printClass(const std::string& name, const RTshaderclass& c) {
    std::cout << "  " << name << ": " << kindName(c.kind);
    if (c.shadePacket) std::cout << ", shades packets";
    std::cout << '\n';
    for (RTuint i = 0; i < c.parameterCount; ++i) {
        const RTSparameter& p = c.parameters[i];
        std::cout << "    " << p.name << ": " << typeName(p) << ", " << scopeName(p.scope) << '\n';
    }
}

/// All classes of a library, or of the program (nullptr); false: some can not be used.
bool printClasses(const char* file) {
    const char* const names = rtGetShaderClassNames(file);
    if (!names) {
        std::cerr << "openrt-info: " << rtGetErrorText() << '\n';
        rtGetError();
        return false;
    }
    bool good = true;
    for (const std::string& name : split(names, '\n')) {
        const RTshaderclass* const c = describe(name, file);
        if (c) printClass(name, *c);
        good = good && c;
    }
    return good;
}

/// What a check says of a class.
struct Finding {
    bool good;
    std::string text;
};

Finding findingOfPackets(const RTshaderclass& c) {
    if (!c.shadePacket || !c.shade) return {true, "shades no packets"};
    const samples::PacketVerdict verdict = samples::checkPackets(c);
    const std::string points = std::to_string(verdict.points);
    if (verdict.different == 0) return {true, "both forms agree at " + points + " points"};
    return {false, std::to_string(verdict.different) + " of " + points +
                       " points differ: " + verdict.example};
}

Finding findingOfReads(const RTshaderclass& c) {
    if (!c.reads || !c.shade) return {true, "does not say what it reads"};
    std::string names;
    for (const std::string& name : samples::undeclaredReads(c))
        names += (names.empty() ? "" : ", ") + name;
    if (names.empty()) return {true, "reads nothing but what it says"};
    return {false, "reads what it does not say: " + names};
}

bool checkClasses(const std::string& file, Finding (*find)(const RTshaderclass&)) {
    const char* const names = rtGetShaderClassNames(file.c_str());
    if (!names) {
        std::cerr << "openrt-info: " << rtGetErrorText() << '\n';
        rtGetError();
        return false;
    }
    bool good = true;
    for (const std::string& name : split(names, '\n')) {
        const RTshaderclass* const c = describe(name, file.c_str());
        const Finding finding = c ? find(*c) : Finding{false, "can not be made"};
        std::cout << file << ", " << name << ": " << finding.text << '\n';
        good = good && finding.good;
    }
    return good;
}

/// Whether a thread of the process is one that renders: those are called openrt-0, openrt-1 ...
bool renders(const std::filesystem::directory_entry& thread) {
    std::string name;
    std::getline(std::ifstream(thread.path() / "comm"), name);
    const std::string_view prefix = "openrt-";
    return name.starts_with(prefix) && name.size() > prefix.size() &&
           std::isdigit(static_cast<unsigned char>(name[prefix.size()]));
}

/// How many threads the first frame starts; 0 where the system does not tell.
std::size_t threadsThatRender() {
    RTubyte pixel[4];
    rtSetFrameBuffer(pixel, 1, 1, RT_RGBA_8);
    rtRender();
    std::error_code failed;
    const std::filesystem::directory_iterator threads("/proc/self/task", failed);
    return failed ? 0 : std::size_t(std::ranges::count_if(threads, renders));
}

/// The shared libraries of the process, which are those of the library and this program.
void printLinkedLibraries() {
    const auto print = [](dl_phdr_info* object, std::size_t, void*) {
        if (std::strchr(object->dlpi_name, '/')) std::cout << "  " << object->dlpi_name << '\n';
        return 0;
    };
    dl_iterate_phdr(print, nullptr);
}

void printLibrary() {
    const std::string version = text(RT_VERSION); // OpenGL's comes first
    std::cout << version.substr(version.find("OpenRT")) << ", this program "
              << OPENRT_VERSION_STRING << ", shader interface " << RTS_INTERFACE_VERSION << '.'
              << RTS_INTERFACE_REVISION << '\n'
              << "instruction set: " << text(RT_ISA) << " (available: " << text(RT_ISA_NAMES)
              << ")\n"
              << "cores: " << std::thread::hardware_concurrency();
    if (const std::size_t threads = threadsThatRender())
        std::cout << ", threads that render: " << threads;
    if (const char* const threads = std::getenv("OPENRT_THREADS"))
        std::cout << ", OPENRT_THREADS=" << threads;
    std::cout << "\nlinked libraries:\n";
    printLinkedLibraries();
    std::cout << "shader folders:\n";
    for (const std::string& folder : split(text(RT_SHADER_FOLDERS), ':'))
        std::cout << "  " << folder << '\n';
    std::cout << "built-in classes:\n";
    printClasses(nullptr);
}

/// The libraries in the shader folders; one that can not be used is told and passed over.
void printInstalled() {
    for (const std::string& folder : split(text(RT_SHADER_FOLDERS), ':')) {
        std::vector<std::string> files;
        std::error_code failed;
        for (std::filesystem::directory_iterator entry(folder, failed), end;
             !failed && entry != end; entry.increment(failed))
            if (entry->path().extension() == ".so") files.push_back(entry->path().string());
        std::sort(files.begin(), files.end());
        for (const std::string& file : files) {
            std::cout << file << ":\n";
            printClasses(file.c_str());
        }
    }
}

int run(int argc, char* argv[]) {
    CLI::App app(
        "Tells what the library and this machine have, and what is in shader libraries: "
        "those given, or all in the shader folders. The exit status is 1 if a library "
        "that is given can not be used, or fails a check.",
        "openrt-info");
    std::vector<std::string> files, packets, reads;
    app.add_option("FILE", files, "shader libraries, by the names that rtGenNewShaderClass takes");
    app.add_option("--check-packets", packets,
                   "compares, bit for bit, what each class of these libraries gives for single "
                   "points and for packets")
        ->type_name("FILE");
    app.add_option("--check-reads", reads,
                   "tests that each class of these libraries reads of a point what it says that "
                   "it reads, and nothing else")
        ->type_name("FILE");
    app.set_version_flag("--version", "openrt-info " OPENRT_VERSION_STRING);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error); // --help, --version
        std::cerr << "openrt-info: " << error.what() << '\n';
        return kWrongCommandLine;
    }

    bool good = true;
    rtInit(nullptr, nullptr);
    try {
        for (const std::string& file : files) {
            std::cout << file << ":\n";
            good = printClasses(file.c_str()) && good;
        }
        for (const std::string& file : packets) good = checkClasses(file, findingOfPackets) && good;
        for (const std::string& file : reads) good = checkClasses(file, findingOfReads) && good;
        if (files.empty() && packets.empty() && reads.empty()) {
            printLibrary();
            printInstalled();
        }
    } catch (const std::exception& error) {
        std::cerr << "openrt-info: " << error.what() << '\n';
        good = false;
    }
    rtExit();
    return good ? 0 : kFailure;
}

} // namespace

int main(int argc, char* argv[]) {
    return samples::finishOutput("openrt-info", run(argc, argv), kFailure);
}

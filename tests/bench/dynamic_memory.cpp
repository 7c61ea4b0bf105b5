// SPDX-License-Identifier: MIT
#include "tests/bench/dynamic_memory.h"

#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <functional>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "openrt/rt.h"

namespace smart::bench {
namespace {

enum Attribute : unsigned { kNormals = 1, kTextures = 2, kColors = 4, kStrips = 8 };

double heapBytes() {
    const struct mallinfo2 info = mallinfo2();
    return double(info.uordblks) + double(info.hblkhd);
}

/// A line of /proc/self/status, in bytes.
double statusBytes(const char* name) {
    std::ifstream file("/proc/self/status");
    for (std::string word; file >> word;) {
        double kilobytes = 0;
        if (word == name && file >> kilobytes) return 1024 * kilobytes;
    }
    return 0;
}

double countedBytes() {
    RTint64 bytes = 0;
    rtGetInteger64v(RT_STAT_BYTES, &bytes);
    return double(bytes);
}

/// Runs `work` in a child. It is given what was there before and returns what it found.
MemoryFigures inProcess(const std::function<MemoryFigures()>& work) {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe");
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("no process");
    if (child == 0) {
        const MemoryFigures found = work();
        const bool sent = rtGetError() == RT_NO_ERROR &&
                          write(ends[1], &found, sizeof found) == ssize_t(sizeof found);
        _exit(sent ? 0 : 1);
    }
    close(ends[1]);
    MemoryFigures found;
    const bool received = read(ends[0], &found, sizeof found) == ssize_t(sizeof found);
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    if (!received || status != 0) throw std::runtime_error("the measuring process failed");
    return found;
}

void vertex(double x, double z, unsigned attributes) {
    if (attributes & kNormals) rtNormal3d(0.1 * std::sin(9 * x), 1, 0.1 * std::cos(9 * z));
    if (attributes & kTextures) rtTexCoord2d(x, z);
    if (attributes & kColors) rtColor3d(0.5 + 0.5 * x, 0.5 + 0.5 * z, 0.5);
    rtVertex3d(x, 0.1 * std::sin(7 * x) * std::cos(5 * z) + 0.02 * std::sin(40 * x + 31 * z), z);
}

/// Hills on the square from -1 to 1; returns how many triangles there are.
unsigned defineHills(unsigned triangles, unsigned attributes, RTuint& object) {
    const unsigned side = unsigned(std::fmax(1, std::round(std::sqrt(triangles / 2.0))));
    const auto at = [side](unsigned i) { return 2.0 * i / side - 1; };
    object = rtNewObject(RT_DEFINE);
    if (!(attributes & kStrips)) rtBegin(RT_TRIANGLES);
    for (unsigned row = 0; row < side; ++row) {
        if (attributes & kStrips) rtBegin(RT_QUAD_STRIP);
        for (unsigned column = 0; column < side + (attributes & kStrips ? 1 : 0); ++column) {
            const double x0 = at(column), x1 = at(column + 1), z0 = at(row), z1 = at(row + 1);
            vertex(x0, z0, attributes);
            vertex(x0, z1, attributes);
            if (attributes & kStrips) continue;
            vertex(x1, z1, attributes);
            vertex(x0, z0, attributes);
            vertex(x1, z1, attributes);
            vertex(x1, z0, attributes);
        }
        if (attributes & kStrips) rtEnd();
    }
    if (!(attributes & kStrips)) rtEnd();
    rtEndObject();
    return 2 * side * side;
}

void start(RTubyte* pixels, unsigned size) {
    rtInit(nullptr, nullptr);
    rtThreads(2);
    rtSetFrameBuffer(pixels, size, size, RT_RGBA_8);
    rtMatrixMode(RT_PROJECTION);
    rtPerspective(40, 1, 0.1, 1000);
    rtMatrixMode(RT_MODELVIEW);
    rtLookAt(0, 3, 0.5, 0, 0, 0, 0, 1, 0);
}

constexpr unsigned kSize = 256;
RTubyte pixels[kSize * kSize * 4];

/// An object as it is compiled, or after so many frames have shown it.
MemoryFigures objectFigures(unsigned triangles, unsigned attributes, unsigned frames) {
    return inProcess([=] {
        start(pixels, kSize);
        rtRender(); // threads and tables exist
        const double counted = countedBytes(), heap = heapBytes(), resident = statusBytes("VmRSS:");
        const auto begin = std::chrono::steady_clock::now();
        RTuint object = 0;
        defineHills(triangles, attributes, object);
        for (unsigned i = 0; i < frames; ++i) {
            rtInstantiateObject(object);
            rtRender();
        }
        MemoryFigures figures;
        figures.seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        figures.counted = countedBytes() - counted;
        figures.heap = heapBytes() - heap;
        figures.peak = statusBytes("VmHWM:") - resident;
        return figures;
    });
}

/// So many instances of one object, in a compiled scene and no longer in the recorded one.
MemoryFigures instanceFigures(unsigned instances) {
    return inProcess([=] {
        start(pixels, kSize);
        RTuint object = 0;
        defineHills(200, 0, object);
        const double counted = countedBytes(), heap = heapBytes(), resident = statusBytes("VmRSS:");
        const RTuint scene = rtGenScene();
        rtBindScene(scene);
        const auto begin = std::chrono::steady_clock::now();
        const unsigned side = unsigned(std::ceil(std::sqrt(double(instances))));
        for (unsigned i = 0; i < instances; ++i) {
            rtPushMatrix();
            rtTranslated(2.0 * (i % side), 0, 2.0 * (i / side));
            rtInstantiateObject(object);
            rtPopMatrix();
        }
        rtCompileScene();
        MemoryFigures figures;
        figures.seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        rtDeleteScene(scene);
        figures.counted = countedBytes() - counted;
        figures.heap = heapBytes() - heap;
        figures.peak = statusBytes("VmHWM:") - resident;
        return figures;
    });
}

/// From the definition of the first object to the picture; the objects lie in a row, of which the
/// camera sees a tenth.
MemoryFigures firstPicture(unsigned objects, unsigned triangles, bool lazy) {
    return inProcess([=] {
        start(pixels, kSize);
        rtObjectHint(RT_LAZY_BUILD, lazy ? RT_TRUE : RT_FALSE);
        rtRender();
        const double counted = countedBytes(), heap = heapBytes(), resident = statusBytes("VmRSS:");
        const auto begin = std::chrono::steady_clock::now();
        const unsigned seen = (objects + 9) / 10;
        for (unsigned i = 0; i < objects; ++i) {
            RTuint object = 0;
            defineHills(triangles, kNormals, object);
            rtPushMatrix();
            const double size = 2.0 / seen;
            rtTranslated(size * i - 1 + 0.5 * size + (i >= seen ? 20 : 0), 0, 0);
            rtScaled(0.49 * size, 0.49 * size, 0.49 * size);
            rtInstantiateObject(object);
            rtPopMatrix();
        }
        rtRender();
        MemoryFigures figures;
        figures.seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        figures.counted = countedBytes() - counted;
        figures.heap = heapBytes() - heap;
        figures.peak = statusBytes("VmHWM:") - resident;
        return figures;
    });
}

nlohmann::json rowsOf(const std::vector<MemoryRow>& rows) {
    nlohmann::json list = nlohmann::json::array();
    for (const MemoryRow& row : rows)
        list.push_back({{"what", row.what},
                        {"per", row.per},
                        {"counted", row.figures.counted},
                        {"heap", row.figures.heap},
                        {"peak", row.figures.peak},
                        {"seconds", row.figures.seconds}});
    return list;
}

void print(std::ostream& out, const std::string& title, const std::vector<MemoryRow>& rows) {
    out << title << "\n                                       counted   allocator       peak   "
                    "  seconds\n";
    for (const MemoryRow& row : rows)
        out << "  " << std::left << std::setw(34) << row.what << std::right << std::setprecision(1)
            << std::setw(10) << row.figures.counted / row.per << std::setw(12)
            << row.figures.heap / row.per << std::setw(11) << row.figures.peak / row.per
            << std::setprecision(3) << std::setw(12) << row.figures.seconds << '\n';
}

} // namespace

MemoryReport measureMemory(unsigned triangles, unsigned objects) {
    struct Case {
        const char* what;
        unsigned attributes, frames;
    };
    constexpr Case kCases[] = {
        {"positions", 0, 0},
        {"positions, strips", kStrips, 0},
        {"+ normals", kNormals, 0},
        {"+ normals, strips", kNormals | kStrips, 0},
        {"+ texture coordinates", kNormals | kTextures, 0},
        {"+ colours", kNormals | kTextures | kColors, 0},
        {"+ colours, strips", kNormals | kTextures | kColors | kStrips, 0},
        {"positions, after three frames", 0, 3},
    };
    MemoryReport report;
    const unsigned side = unsigned(std::fmax(1, std::round(std::sqrt(triangles / 2.0))));
    report.triangles = 2 * side * side;
    for (const Case& c : kCases)
        report.objectRows.push_back(
            {c.what, double(report.triangles), objectFigures(triangles, c.attributes, c.frames)});
    for (const unsigned count : {1u, 1000u, 100000u})
        report.instanceRows.push_back(
            {std::to_string(count) + " instances", double(count), instanceFigures(count)});
    report.objects = objects;
    report.seen = (objects + 9) / 10;
    for (const bool lazy : {false, true})
        report.firstPictures.push_back({lazy ? "with RT_LAZY_BUILD" : "without RT_LAZY_BUILD", 1e6,
                                        firstPicture(objects, triangles / 40, lazy)});
    return report;
}

nlohmann::json MemoryReport::json() const {
    return {{"triangles", triangles},
            {"objects", objects},
            {"seen", seen},
            {"objectRows", rowsOf(objectRows)},
            {"instanceRows", rowsOf(instanceRows)},
            {"firstPictures", rowsOf(firstPictures)}};
}

std::ostream& operator<<(std::ostream& out, const MemoryReport& report) {
    out << std::fixed;
    print(out, "bytes a triangle, an object of " + std::to_string(report.triangles) + " triangles",
          report.objectRows);
    print(out, "bytes an instance", report.instanceRows);
    print(out,
          "megabytes and seconds to the first picture, " + std::to_string(report.objects) +
              " objects of which " + std::to_string(report.seen) + " are seen",
          report.firstPictures);
    return out;
}

} // namespace smart::bench

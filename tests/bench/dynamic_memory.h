// SPDX-License-Identifier: MIT
// What objects and instances take, and what it is worth to build only what is seen.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <ostream>
#include <string>
#include <vector>

namespace smart::bench {

/// Measured in a process of its own.
struct MemoryFigures {
    double counted = 0; ///< bytes by RT_STAT_BYTES
    double heap = 0;    ///< bytes by the allocator
    double peak = 0;    ///< most bytes resident at once, above the start
    double seconds = 0;
};

struct MemoryRow {
    std::string what;
    double per = 1; ///< triangles, or instances
    MemoryFigures figures;
};

struct MemoryReport {
    unsigned triangles = 0, objects = 0, seen = 0;
    std::vector<MemoryRow> objectRows;   ///< bytes a triangle
    std::vector<MemoryRow> instanceRows; ///< bytes an instance
    std::vector<MemoryRow> firstPictures; ///< with and without RT_LAZY_BUILD

    nlohmann::json json() const;
};
std::ostream& operator<<(std::ostream& out, const MemoryReport& report);

/// Objects of about `triangles` triangles; first pictures of `objects` objects, of which a tenth
/// is seen. No thread of the library may have been started in this process.
MemoryReport measureMemory(unsigned triangles, unsigned objects);

} // namespace smart::bench

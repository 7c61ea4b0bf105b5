// SPDX-License-Identifier: MIT
#include "samples/common/ply_header.h"

#include <algorithm>
#include <map>
#include <sstream>
#include <string>

#include "samples/common/scene_description.h"

namespace samples {
namespace {

uint64_t bytesOf(const std::string& type) {
    static const std::map<std::string, uint64_t> kSizes = {
        {"char", 1},  {"uchar", 1},  {"int8", 1},  {"uint8", 1},  {"short", 2},   {"ushort", 2},
        {"int16", 2}, {"uint16", 2}, {"int", 4},   {"uint", 4},   {"int32", 4},   {"uint32", 4},
        {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
    const auto found = kSizes.find(type);
    if (found == kSizes.end()) throw LoadError("its header has an unknown type");
    return found->second;
}

} // namespace

void checkPlyHeader(std::span<const uint8_t> bytes) {
    constexpr std::string_view kEnd = "end_header";
    const std::size_t searched = std::min<std::size_t>(bytes.size(), std::size_t(1) << 16);
    const std::string head(bytes.begin(), bytes.begin() + std::ptrdiff_t(searched));
    const std::size_t end = head.find(kEnd);
    if (!head.starts_with("ply")) throw LoadError("it does not begin as a PLY file does");
    if (end == std::string::npos) throw LoadError("its header has no end");
    const uint64_t available = bytes.size() - end - kEnd.size();

    std::istringstream lines(head.substr(0, end));
    std::string line;
    bool ascii = true;
    uint64_t count = 0, smallest = 0, wanted = 0;
    const auto finishElement = [&] {
        // In text an element has a digit and a separator for each property; none is free.
        smallest = std::max<uint64_t>(smallest, 1);
        if (count > available / smallest || count * smallest > available - wanted) {
            throw LoadError("its header announces more than the file holds");
        }
        wanted += count * smallest;
        count = smallest = 0;
    };
    while (std::getline(lines, line)) {
        std::istringstream words(line);
        std::string first, second, third;
        words >> first >> second >> third;
        if (first == "format") {
            ascii = second == "ascii";
        } else if (first == "element") {
            finishElement();
            const bool digits = std::all_of(third.begin(), third.end(),
                                            [](char c) { return c >= '0' && c <= '9'; });
            if (third.empty() || third.size() > 15 || !digits) {
                throw LoadError("its header has a count that is no number");
            }
            count = std::stoull(third);
        } else if (first == "property") {
            const uint64_t size = bytesOf(second == "list" ? third : second);
            smallest += ascii ? 2 : size;
        }
    }
    // The last separator of a text may be missing.
    if (ascii && count > 0 && smallest > 1) --smallest;
    finishElement();
}

} // namespace samples

// SPDX-License-Identifier: MIT
#include "samples/common/ply_header.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "samples/common/scene_description.h"

namespace samples {
namespace {

using Words = std::vector<std::string>;

const std::map<std::string, uint64_t>& typeSizes() {
    static const std::map<std::string, uint64_t> kSizes = {
        {"char", 1},  {"uchar", 1},  {"int8", 1},    {"uint8", 1},   {"short", 2},  {"ushort", 2},
        {"int16", 2}, {"uint16", 2}, {"int", 4},     {"uint", 4},    {"int32", 4},  {"uint32", 4},
        {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
    return kSizes;
}

bool isName(const std::string& word) {
    return std::all_of(word.begin(), word.end(),
                       [](unsigned char c) { return std::isalnum(c) || c == '_'; });
}

Words wordsOf(const std::string& line) {
    std::istringstream in(line);
    Words words;
    for (std::string word; in >> word;) words.push_back(word);
    return words;
}

class HeaderCheck {
public:
    /// Takes one line after the first; false: it was the last.
    bool take(const Words& words) {
        if (words.empty() || words[0] == "comment" || words[0] == "obj_info") return true;
        if (words[0] == "end_header" && words.size() == 1) return false;
        if (words[0] == "format" && words.size() == 3 && elements_.empty()) {
            ascii_ = words[1] == "ascii";
            if (ascii_ || words[1].starts_with("binary_")) return true;
        } else if (words[0] == "element" && words.size() == 3 && isName(words[1])) {
            finishElement();
            if (!elements_.insert(words[1]).second) throw LoadError("its header repeats itself");
            count_ = countFrom(words[2]);
            return true;
        } else if (words[0] == "property" && words.size() >= 3 && !elements_.empty() &&
                   isName(words.back())) {
            const bool list = words.size() == 5 && words[1] == "list";
            const std::string& type = list ? words[2] : words[1];
            const auto size = typeSizes().find(type);
            const bool known = size != typeSizes().end() &&
                               (list ? typeSizes().count(words[3]) && type[0] != 'f' &&
                                           type[0] != 'd'
                                     : words.size() == 3);
            // In text a property takes a digit and a separator.
            if (known) smallest_ += ascii_ ? 2 : size->second;
            if (known) return true;
        }
        throw LoadError("its header has a line that is none of PLY");
    }

    void finish(uint64_t available) {
        finishElement();
        if (ascii_) ++available; // the last separator may be missing
        uint64_t wanted = 0;
        for (const auto& [count, smallest] : demands_) {
            if (count > available / smallest || count * smallest > available - wanted) {
                throw LoadError("its header announces more than the file holds");
            }
            wanted += count * smallest;
        }
        if (!elements_.count("vertex")) throw LoadError("its header knows no vertices");
    }

private:
    static uint64_t countFrom(const std::string& word) {
        constexpr std::size_t kMaxDigits = 15;
        const bool digits = std::all_of(word.begin(), word.end(),
                                        [](unsigned char c) { return std::isdigit(c); });
        if (!digits || word.size() > kMaxDigits) {
            throw LoadError("its header has a count that is no number");
        }
        return std::stoull(word);
    }
    void finishElement() {
        // Nothing is free, not even an element without properties.
        if (!elements_.empty()) demands_.emplace_back(count_, std::max<uint64_t>(smallest_, 1));
        count_ = smallest_ = 0;
    }

    bool ascii_ = false;
    std::set<std::string> elements_;
    uint64_t count_ = 0, smallest_ = 0;
    std::vector<std::pair<uint64_t, uint64_t>> demands_; ///< elements, least bytes of one
};

} // namespace

void checkPlyHeader(std::span<const uint8_t> bytes) {
    constexpr std::size_t kMaxHeader = std::size_t(1) << 16;
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()),
                                std::min(bytes.size(), kMaxHeader));
    HeaderCheck check;
    std::size_t at = 0;
    for (bool first = true, more = true; more; first = false) {
        const std::size_t end = text.find('\n', at);
        if (end == std::string_view::npos) throw LoadError("its header has no end");
        const std::string line(text.substr(at, end - at));
        at = end + 1;
        if (line.find('\0') != std::string::npos) throw LoadError("its header is no text");
        if (!first) {
            more = check.take(wordsOf(line));
        } else if (wordsOf(line) != Words{"ply"}) {
            throw LoadError("it does not begin as a PLY file does");
        }
    }
    check.finish(bytes.size() - at);
}

} // namespace samples

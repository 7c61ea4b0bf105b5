// SPDX-License-Identifier: MIT
// docs/builtin-shaders.md says of each built-in class what the class itself says: its parameters,
// how they are set, their defaults; and it shows a picture of it.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "openrt/shader.hpp"
#include "tests/libsmart/shading/fake_tracer.h"

namespace smart {
namespace {

namespace fs = std::filesystem;

constexpr uintmax_t kMaxPicture = 40000; ///< bytes

struct Row {
    std::string call, value;
    bool operator==(const Row&) const = default;
};

struct Section {
    std::map<std::string, Row> parameters;
    std::string picture;
};

/// The cells of a table's row without blanks at their ends and backquotes.
std::vector<std::string> cellsOf(const std::string& line) {
    std::vector<std::string> cells;
    std::stringstream stream(line.substr(1));
    for (std::string cell; std::getline(stream, cell, '|');) {
        std::erase(cell, '`');
        const auto first = cell.find_first_not_of(' '), last = cell.find_last_not_of(' ');
        cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
    }
    return cells;
}

std::map<std::string, Section> sectionsOf(const std::string& text) {
    std::map<std::string, Section> sections;
    Section* current = nullptr;
    std::stringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        if (line.starts_with("## ")) current = &sections[line.substr(3)];
        if (!current) continue;
        if (line.starts_with("![")) {
            const auto open = line.find('('), close = line.rfind(')');
            if (open < close) current->picture = line.substr(open + 1, close - open - 1);
        }
        if (line.starts_with("| `")) {
            const auto cells = cellsOf(line);
            if (cells.size() >= 5 && !cells[3].empty() && !cells[4].empty())
                current->parameters[cells[0]] = {cells[1], cells[2]};
        }
    }
    return sections;
}

std::string textOf(float value) {
    if (std::isinf(value)) return "infinity";
    char text[32];
    std::snprintf(text, sizeof text, "%g", double(value));
    return text;
}
std::string textOf(const std::vector<float>& values) {
    if (values.size() == 1) return textOf(values[0]);
    std::string text;
    for (const float value : values) text += (text.empty() ? "(" : ", ") + textOf(value);
    return text + ")";
}

/// How a parameter is set, and its value in a block that the class has constructed.
Row rowOf(const RTSparameter& parameter, const std::byte* block) {
    const std::byte* const at = block + parameter.offset;
    const auto floats = [&](std::size_t count) {
        std::vector<float> values(count);
        std::memcpy(values.data(), at, count * sizeof(float));
        return values;
    };
    switch (parameter.type) {
    case RTS_INT1: {
        if (parameter.size == 1) return {"1i", at[0] != std::byte(0) ? "true" : "false"};
        int value = 0;
        std::memcpy(&value, at, sizeof value);
        return {"1i", std::to_string(value)};
    }
    case RTS_FLOAT1: return {"1f", textOf(floats(1))};
    case RTS_FLOAT2: return {"2f", textOf(floats(2))};
    case RTS_FLOAT3: return {"3f", textOf(floats(3))};
    case RTS_FLOAT4: return {"4f", textOf(floats(4))};
    case RTS_FLOAT16:
        return {"16f", std::memcmp(at, openrt::Mat4().m, 64) == 0 ? "identity" : "a matrix"};
    default: return {"unknown", ""};
    }
}

std::vector<std::string> problemsOf(const std::string& text) {
    std::vector<std::string> found;
    const fs::path folder(OPENRT_DOCS);
    std::map<std::string, Section> sections = sectionsOf(text);
    for (const std::string& name : builtinClassNames()) {
        const auto section = sections.find(name);
        if (section == sections.end()) {
            found.push_back(name + " has no section");
            continue;
        }
        const auto object = test::MadeShader(name.c_str()).make();
        const ShaderClass& shaderClass = *findBuiltinClass(name);
        std::map<std::string, Row>& rows = section->second.parameters;
        for (uint32_t i = 0; i < shaderClass.parameterCount(); ++i) {
            const RTSparameter& parameter = shaderClass.parameter(i);
            const Row wanted =
                rowOf(parameter, static_cast<const std::byte*>(object->block()));
            if (const auto row = rows.find(parameter.name); row == rows.end())
                found.push_back(name + ": no row for " + parameter.name);
            else if (row->second != wanted)
                found.push_back(name + ": " + parameter.name + " is " + wanted.call + " " +
                                wanted.value);
            rows.erase(parameter.name);
        }
        for (const auto& [parameter, row] : rows)
            found.push_back(name + " has no parameter " + parameter);
        const fs::path picture = folder / section->second.picture;
        std::error_code error;
        const uintmax_t size = fs::file_size(picture, error);
        if (picture.filename() != name + ".png" || error || size > kMaxPicture)
            found.push_back(name + ": no picture of at most 40000 bytes");
        sections.erase(section);
    }
    for (const auto& [name, section] : sections) found.push_back(name + " is no built-in class");
    return found;
}

std::string pages() {
    std::ifstream file(fs::path(OPENRT_DOCS) / "builtin-shaders.md");
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

TEST(BuiltinPagesTest, SayWhatTheClassesSay) {
    for (const std::string& problem : problemsOf(pages())) ADD_FAILURE() << problem;
}

TEST(BuiltinPagesTest, ThePlantedFaultsAreFound) {
    const std::string good = pages();
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string text = good;
        const auto at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        if (at != std::string::npos) text.replace(at, from.size(), to);
        return problemsOf(text).size();
    };
    const std::size_t before = problemsOf(good).size();
    EXPECT_GT(with("## Glass\n", "## Glas\n"), before);
    EXPECT_GT(with("`index` | `1f` | 1.5", "`index` | `1f` | 1.33"), before);
    EXPECT_GT(with("`index` | `1f` | 1.5", "`index` | `1i` | 1.5"), before);
    EXPECT_GT(with("| `index`", "| `indices`"), before);
    EXPECT_GT(with("shaders/Glass.png", "shaders/Phong.png"), before);
    EXPECT_GT(with("shaders/Glass.png", "shader/Glass.png"), before);
}

} // namespace
} // namespace smart

// SPDX-License-Identifier: MIT
#include "tests/bench/json_file.h"

#include <nlohmann/json.hpp>

#include "samples/common/output_file.h"

namespace smart::bench {

void addJson(CLI::App& app, std::string& file) {
    app.add_option("--json", file, "also write the figures to this file")
        ->check([](const std::string& path) {
            const samples::OutputFile canBeWritten(path);
            return std::string();
        });
}

void writeJson(const std::string& file, const nlohmann::json& root) {
    if (file.empty()) return;
    const std::string text = root.dump(2) + '\n';
    samples::OutputFile(file).write(
        {reinterpret_cast<const uint8_t*>(text.data()), text.size()});
}

} // namespace smart::bench

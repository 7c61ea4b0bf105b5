// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace smart::bench {

/// --json: a file that can not be written is told before anything is measured, by an exception as
/// of writeJson.
void addJson(CLI::App& app, std::string& file);

/// "" writes nothing. Throws std::runtime_error.
void writeJson(const std::string& file, const nlohmann::json& root);

} // namespace smart::bench

// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/conformance/conformance_case.h"

namespace conformance {

// {"library":..., "cases":N, "passed":N, "failed":N, "results":[...]}
std::string jsonReport(const std::string& library, const std::vector<Result>& results);

// index.html beside the pictures of the results.
void writeHtmlReport(const std::filesystem::path& folder, const std::string& library,
                     const std::vector<Result>& results);

} // namespace conformance

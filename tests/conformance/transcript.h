// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

namespace conformance {

// What a program printed: sections, each begun by a line "case NAME".
using Transcript = std::map<std::string, std::vector<std::string>>;

Transcript parseTranscript(const std::string& text);

// Empty if equal. Words are compared as text, or as numbers where both are: then they may differ by
// 1e-5 of the larger, or 1e-6. A word of the expected line may be a choice, "left|right".
std::string firstDifference(const std::vector<std::string>& expected,
                            const std::vector<std::string>& found);

} // namespace conformance

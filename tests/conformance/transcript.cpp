// SPDX-License-Identifier: MIT
#include "tests/conformance/transcript.h"

#include <cmath>
#include <cstdlib>
#include <sstream>

namespace conformance {
namespace {

bool numberOf(const std::string& word, double& number) {
    char* end = nullptr;
    number = std::strtod(word.c_str(), &end);
    return !word.empty() && end == word.c_str() + word.size();
}

bool sameWord(const std::string& expected, const std::string& found) {
    if (expected == found) return true;
    double a = 0, b = 0;
    if (!numberOf(expected, a) || !numberOf(found, b)) return false;
    return std::abs(a - b) <= std::max(1e-6, 1e-5 * std::max(std::abs(a), std::abs(b)));
}

bool allowed(const std::string& expected, const std::string& found) {
    std::istringstream choices(expected);
    std::string choice;
    while (std::getline(choices, choice, '|'))
        if (sameWord(choice, found)) return true;
    return false;
}

bool sameLine(const std::string& expected, const std::string& found) {
    std::istringstream a(expected), b(found);
    std::string wordA, wordB;
    while (a >> wordA)
        if (!(b >> wordB) || !allowed(wordA, wordB)) return false;
    return !(b >> wordB);
}

} // namespace

Transcript parseTranscript(const std::string& text) {
    Transcript transcript;
    std::vector<std::string>* section = nullptr;
    std::istringstream lines(text);
    std::string line;
    while (std::getline(lines, line)) {
        if (line.rfind("case ", 0) == 0)
            section = &transcript[line.substr(5)];
        else if (section)
            section->push_back(line);
    }
    return transcript;
}

std::string firstDifference(const std::vector<std::string>& expected,
                            const std::vector<std::string>& found) {
    for (std::size_t i = 0; i < std::max(expected.size(), found.size()); ++i) {
        const std::string a = i < expected.size() ? expected[i] : "nothing";
        const std::string b = i < found.size() ? found[i] : "nothing";
        if (!sameLine(a, b)) return "OpenGL: " + a + "; the library: " + b;
    }
    return {};
}

} // namespace conformance

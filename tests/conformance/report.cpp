// SPDX-License-Identifier: MIT
#include "tests/conformance/report.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace conformance {
namespace {

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '<')
            result += "&lt;";
        else if (c == '&')
            result += "&amp;";
        else
            result += c;
    }
    return result;
}

std::string numbersOf(const Result& result) {
    std::string text = result.reference.empty() ? "" : result.reference + "<br>";
    for (const auto& [name, value] : result.numbers) {
        char number[96];
        std::snprintf(number, sizeof number, "%s %.4g<br>", name.c_str(), value);
        text += number;
    }
    return text;
}

std::string imagesOf(const Result& result) {
    if (result.picture.empty()) return {};
    std::string text;
    for (const char* which : {"gl", "rt", "difference"})
        text += "<img src=\"" + result.picture + "-" + which + "-000.png\" alt=\"" + which +
                "\" width=\"240\"> ";
    return text;
}

long failed(const std::vector<Result>& results) {
    return long(std::count_if(results.begin(), results.end(),
                              [](const Result& result) { return !result.passed(); }));
}

} // namespace

std::string jsonReport(const std::string& library, const std::vector<Result>& results) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Result& result : results) {
        nlohmann::ordered_json entry;
        entry["name"] = result.name;
        entry["passed"] = result.passed();
        if (!result.reference.empty()) entry["reference"] = result.reference;
        if (!result.numbers.empty()) entry["numbers"] = result.numbers;
        if (!result.passed()) entry["failures"] = result.failures;
        list.push_back(std::move(entry));
    }
    nlohmann::ordered_json report;
    report["library"] = library;
    report["cases"] = results.size();
    report["passed"] = long(results.size()) - failed(results);
    report["failed"] = failed(results);
    report["results"] = std::move(list);
    // Texts of other programs may hold anything.
    return report.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

void writeHtmlReport(const std::filesystem::path& folder, const std::string& library,
                     const std::vector<Result>& results) {
    std::ofstream file(folder / "index.html");
    file << "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
            "<title>openrt-conformance</title><style>body{font-family:sans-serif}"
            "td{vertical-align:top;border-top:1px solid #ccc;padding:4px}"
            ".failed{background:#fdd}</style></head><body>\n<h1>openrt-conformance</"
            "h1>\n<p>Library: "
         << escaped(library) << "</p>\n<p>" << results.size() << " cases, " << failed(results)
         << " failed</p>\n<p>Pictures: OpenGL, the library, eight times the difference.</p>\n"
            "<table>\n";
    for (const Result& result : results) {
        file << "<tr" << (result.passed() ? "" : " class=\"failed\"") << "><td>"
             << escaped(result.name) << "</td><td>" << (result.passed() ? "passed" : "failed")
             << "</td><td>";
        for (const std::string& failure : result.failures) file << escaped(failure) << "<br>";
        file << "</td><td>" << numbersOf(result) << "</td><td>" << imagesOf(result)
             << "</td></tr>\n";
    }
    file << "</table></body></html>\n";
    file.close();
    if (!file) throw std::runtime_error((folder / "index.html").string() + ": not written");
}

} // namespace conformance

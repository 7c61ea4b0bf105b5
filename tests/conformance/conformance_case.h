// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace conformance {

struct Settings {
    std::filesystem::path openGlPrograms; // compiled against OSMesa
    std::filesystem::path openRtPrograms; // the same sources with openrt/gl.h
    std::filesystem::path openGlPictures; // kept there and used again; empty: not kept
    std::filesystem::path library;        // instead of the one the programs were linked with
    std::filesystem::path work;           // pictures; emptied case by case unless kept
    bool keepPictures = false;
    bool quick = false;
    int seconds = 120; // that a program may take
};

struct Result {
    std::string name;
    std::vector<std::string> failures; // none: passed
    std::map<std::string, double> numbers;
    std::string picture = {}; // base name of the files in the work folder, or empty
    std::string reference = {}; // which of OpenGL's pictures it was compared with

    bool passed() const { return failures.empty(); }
};

struct Case {
    std::string name;
    std::function<Result()> run;
};

// Pictures of the sample ports, and the controls that a comparison must fail.
std::vector<Case> pictureCases(const Settings& settings);

// What programs that ask OpenGL and the library the same questions print, section by section.
std::vector<Case> transcriptCases(const Settings& settings);

} // namespace conformance
